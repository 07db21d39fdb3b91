#include "core/base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

namespace posecoach::log {
namespace {

spdlog::logger& logger() {
  static const auto instance = [] {
    auto made = std::make_shared<spdlog::logger>("posecoach",
                                                 std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
    // On a terminal a progress bar may stand in the line: it gives way.
    made->set_pattern(isatty(STDERR_FILENO) == 1 ? "\r\033[Kposecoach: %^%l%$: %v" : "posecoach: %^%l%$: %v");
    return made;
  }();
  return *instance;
}

}  // namespace

void info(std::string_view message) {
  logger().info(message);
}
void warning(std::string_view message) {
  logger().warn(message);
}
void error(std::string_view message) {
  logger().error(message);
}

}  // namespace posecoach::log
