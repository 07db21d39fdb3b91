#include "capture/v4l2/camera_name.h"

#include <charconv>

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPrefix = "camera:";

template <typename Number>
bool parse_number(std::string_view text, Number& number) {
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
  return failed == std::errc{} && end == text.data() + text.size();
}

Result<void> set(CameraWish& wish, std::string_view setting) {
  const std::size_t equals = setting.find('=');
  const std::string_view key = setting.substr(0, equals);
  const std::string_view value =
      equals == std::string_view::npos ? std::string_view() : setting.substr(equals + 1);
  const auto wrong = [&](std::string_view range) {
    return fail(ErrorCode::InvalidArgument, "a camera's " + std::string(key) + " is " + std::string(range) +
                                                ", not \"" + std::string(value) + "\"");
  };
  if (key == "width" || key == "height") {
    int& size = key == "width" ? wish.width : wish.height;
    return parse_number(value, size) && size >= 16 && size <= 8192 ? Result<void>()
                                                                   : wrong("a number from 16 to 8192");
  }
  if (key == "fps")
    return parse_number(value, wish.fps) && wish.fps >= 1 && wish.fps <= 1000
               ? Result<void>()
               : wrong("a number from 1 to 1000");
  if (key == "format") {
    wish.format = value;
    return value.size() <= 4 && !value.empty() ? Result<void>() : wrong("four letters, such as MJPG or YUYV");
  }
  return fail(ErrorCode::InvalidArgument, "a camera has no setting \"" + std::string(key) +
                                              "\"; there are width, height, fps and format");
}

}  // namespace

bool is_camera_name(std::string_view name) {
  if (name.starts_with(kPrefix)) return true;
  std::error_code ignored;
  return fs::is_character_file(name.substr(0, name.find('?')), ignored);
}

Result<CameraName> parse_camera_name(const std::string& name) {
  std::string_view rest = name;
  if (rest.starts_with(kPrefix)) rest.remove_prefix(kPrefix.size());
  const std::size_t question = rest.find('?');
  CameraName camera;
  camera.path = fs::path(rest.substr(0, question));
  rest = question == std::string_view::npos ? std::string_view() : rest.substr(question + 1);
  while (!rest.empty()) {
    const std::size_t end = rest.find('&');
    const std::string_view setting = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    if (setting.empty()) continue;
    if (auto done = set(camera.wish, setting); !done) return tl::unexpected(done.error());
  }
  return camera;
}

std::string stable_camera_name(const std::string& name, const CameraListOptions& options) {
  if (!is_camera_name(name)) return name;
  const Result<CameraName> camera = parse_camera_name(name);
  if (!camera) return name;
  fs::path path;
  if (camera->path.empty()) {
    for (const CameraDescription& described : list_cameras(options))
      if (path.empty() && described.problem.empty()) path = described.path;
    if (path.empty()) return name;
  } else {
    path = stable_camera_path(camera->path, options.device_folder);
  }
  const std::size_t question = name.find('?');
  return std::string(kPrefix) + path.string() + (question == std::string::npos ? "" : name.substr(question));
}

}  // namespace posecoach
