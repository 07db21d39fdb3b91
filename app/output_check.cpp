#include "app/output_check.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>

#include "core/base/atomic_file.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

Result<void> check_place(const std::string& name) {
  std::error_code ignored;
  if (fs::is_directory(name, ignored))
    return fail(ErrorCode::InvalidArgument, name + " is a folder; name a file to write");
  const fs::path parent = behind_links(name).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  if (!fs::is_directory(folder, ignored))
    return fail(ErrorCode::NotFound, "cannot write " + name + ": there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return fail(ErrorCode::Unreadable,
                "cannot write " + name + ": folder " + folder.string() + ": " + std::strerror(errno));
  return {};
}

}  // namespace

Result<void> check_output_files(const std::vector<std::string>& outputs,
                                const std::vector<std::string>& inputs) {
  std::set<std::string> seen;
  for (const std::string& name : outputs) {
    if (name.empty() || is_special_file(name)) continue;
    if (!seen.insert(fs::path(name).lexically_normal().string()).second)
      return fail(ErrorCode::InvalidArgument,
                  (name == "-" ? "standard output" : name) + " is named for two outputs");
    if (name == "-") continue;
    if (const Result<void> checked = check_place(name); !checked) return checked;
    for (const std::string& input : inputs) {
      std::error_code failed;
      if (!fs::equivalent(name, input, failed) || failed) continue;
      return fail(ErrorCode::InvalidArgument, name + " is also what is read; name another file to write");
    }
  }
  return {};
}

}  // namespace posecoach
