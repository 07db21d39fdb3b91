#include "capture/simulated_source.h"

#include <charconv>
#include <filesystem>

#include "core/body/named_body.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"

namespace posecoach {
namespace {

constexpr std::string_view kPrefix = "simulated:";
// The bundled motions begin when the swing does; who practises stands at his ball first, and a program that
// sees a few poses a second needs that to see him rest.
constexpr double kStands_s = 1.5;

template <typename Number>
bool parse_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

tl::unexpected<Error> wrong(std::string_view key, const std::string& value, const std::string& hint) {
  return fail(ErrorCode::InvalidArgument,
              "\"" + value + "\" is no " + std::string(key) + " for the simulated student: " + hint);
}

Result<Skeleton> body_from(const std::string& value) {
  if (const auto body = find_named_body(value)) return *body;
  std::error_code ignored;
  if (std::filesystem::exists(value, ignored)) {
    const Result<SkeletonFile> file = read_skeleton_file(value);
    if (!file) return tl::unexpected(file.error());
    return file->skeleton;
  }
  std::string known;
  for (const NamedBody& body : named_bodies()) known += std::string(body.name) + ", ";
  return wrong("body", value, "use " + known + "or a .body.json or motion file that exists");
}

}  // namespace

bool is_simulated_source(std::string_view source) {
  return source.starts_with(kPrefix);
}

Result<void> set_simulated_option(SimulatedStudentOptions& options, std::string_view key,
                                  const std::string& value) {
  if (key == "motion") {
    for (const std::string& name : bundled_motion_names()) {
      if (name != value) continue;
      options.motion = value;
      return {};
    }
    return wrong(key, value, "use swing or putt");
  }
  if (key == "body") {
    Result<Skeleton> body = body_from(value);
    if (!body) return tl::unexpected(body.error());
    options.body = *std::move(body);
    options.body_name = value;
  } else if (key == "fault") {
    const Result<FaultChoice> fault = fault_from_string(value);
    if (!fault) return tl::unexpected(fault.error());
    options.faults.push_back(*fault);
  } else if (key == "amount") {
    double amount = 0;
    if (!parse_number(value, amount)) return wrong(key, value, "it is a number");
    if (options.faults.empty()) return wrong(key, value, "name a fault before its amount");
    const Result<FaultChoice> fault = choose_fault(options.faults.back().fault->name, amount);
    if (!fault) return tl::unexpected(fault.error());
    options.faults.back() = *fault;
  } else if (key == "hand") {
    if (value != "left" && value != "right") return wrong(key, value, "use left or right");
    options.hand = value == "left" ? Handedness::Left : Handedness::Right;
  } else if (key == "view") {
    const Result<CameraPlace> view = camera_place_from_string(value);
    if (!view) return tl::unexpected(view.error());
    options.view = *view;
  } else if (key == "fps") {
    if (!parse_number(value, options.frames_per_second) || !(options.frames_per_second >= 1) ||
        options.frames_per_second > 1000)
      return wrong(key, value, "it is a number from 1 to 1000");
  } else if (key == "size") {
    const std::size_t cross = value.find('x');
    const std::string_view text = value;
    if (cross == std::string::npos || !parse_number(text.substr(0, cross), options.width) ||
        !parse_number(text.substr(cross + 1), options.height))
      return wrong(key, value, "write it as 1280x720");
  } else {
    return wrong("setting", std::string(key), "there are fault, amount, body, view, hand, fps and size");
  }
  return {};
}

Result<SimulatedStudentOptions> simulated_student_from_source(const std::string& source) {
  SimulatedStudentOptions options;
  options.name = source;
  options.stands_s = kStands_s;
  std::string_view rest = source;
  if (is_simulated_source(rest)) rest.remove_prefix(kPrefix.size());
  const std::size_t question = rest.find('?');
  if (auto set = set_simulated_option(options, "motion", std::string(rest.substr(0, question))); !set)
    return tl::unexpected(set.error());
  rest = question == std::string_view::npos ? std::string_view() : rest.substr(question + 1);
  while (!rest.empty()) {
    const std::size_t end = rest.find('&');
    const std::string_view setting = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    if (setting.empty()) continue;
    const std::size_t equals = setting.find('=');
    const std::string value(equals == std::string_view::npos ? std::string_view()
                                                             : setting.substr(equals + 1));
    if (auto set = set_simulated_option(options, setting.substr(0, equals), value); !set)
      return tl::unexpected(set.error());
  }
  return options;
}

}  // namespace posecoach
