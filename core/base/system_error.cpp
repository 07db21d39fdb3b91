#include "core/base/system_error.h"

#include <cerrno>
#include <cstring>

namespace posecoach {

Error system_error(const char* verb, const std::filesystem::path& path) {
  const int reason = errno;
  const ErrorCode code = reason == ENOENT ? ErrorCode::NotFound : ErrorCode::Unreadable;
  return Error{code, std::string(verb) + " " + path.string() + ": " + std::strerror(reason)};
}

}  // namespace posecoach
