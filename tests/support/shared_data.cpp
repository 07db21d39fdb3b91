#include "tests/support/shared_data.h"

#include <cstdlib>

namespace posecoach {

std::optional<std::filesystem::path> shared_data(std::string_view name) {
  const char* given = std::getenv("POSECOACH_SHARED");
  const std::filesystem::path folder =
      given ? std::filesystem::path(given)
            : std::filesystem::path(POSECOACH_SOURCE_FOLDER).parent_path() / "shared";
  std::error_code ignored;
  if (!std::filesystem::exists(folder / name, ignored)) return std::nullopt;
  return folder / name;
}

}  // namespace posecoach
