#include "capture/simulated_student.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>

#include "capture/bar_code.h"
#include "core/motion/bundled_motion.h"

namespace posecoach {

std::string_view to_string(CameraView view) {
  return view == CameraView::FaceOn ? "face-on" : "down-the-line";
}

std::string to_string(const CameraPlace& place) {
  std::ostringstream name;
  name.imbue(std::locale::classic());
  name << to_string(place.view);
  if (place.turned_deg != 0) name << (place.turned_deg > 0 ? "+" : "") << place.turned_deg;
  return name.str();
}

Result<CameraPlace> camera_place_from_string(std::string_view name) {
  const auto wrong = fail(ErrorCode::InvalidArgument,
                          "there is no view \"" + std::string(name) +
                              "\": use face-on or down-the-line, and +20 or -20 behind it for a camera that "
                              "stands as many degrees beside it, at most 90");
  for (const CameraView view : {CameraView::FaceOn, CameraView::DownTheLine}) {
    if (!name.starts_with(to_string(view))) continue;
    std::string_view turned = name.substr(to_string(view).size());
    if (turned.empty()) return CameraPlace{view, 0};
    if (turned.front() != '+' && turned.front() != '-') return wrong;
    if (turned.front() == '+') turned.remove_prefix(1);
    double degrees = 0;
    const auto [end, error] = std::from_chars(turned.data(), turned.data() + turned.size(), degrees);
    if (error != std::errc{} || end != turned.data() + turned.size() || !(std::abs(degrees) <= 90))
      return wrong;
    return CameraPlace{view, degrees};
  }
  return wrong;
}

PinholeCamera make_view_camera(const CameraPlace& place, Handedness hand, int width_px, int height_px) {
  constexpr double kDistance = 3.9, kHandHeight = 0.90;
  // Room above and beside a tall golfer for his club in landscape; in portrait as wide as the golfer.
  const double aspect = static_cast<double>(width_px) / height_px;
  const double seen_height = std::max(4.0, 2.2 / aspect);
  const double angle = 2 * std::atan(0.5 * seen_height / kDistance);
  const double middle_height = 1.02;
  const double right = hand == Handedness::Right ? 1 : -1;
  const bool is_face_on = place.view == CameraView::FaceOn;
  const Vec3 aim(0, middle_height, is_face_on ? 0.1 : 0.28);
  const Vec3 away = is_face_on ? Vec3(0, 0, kDistance) : Vec3(-right * kDistance, 0, 0);
  const double turn = right * radians_from_degrees(place.turned_deg), c = std::cos(turn), s = std::sin(turn);
  const Vec3 eye(aim.x + c * away.x + s * away.z, kHandHeight, aim.z - s * away.x + c * away.z);
  return make_camera_looking_at(eye, aim, angle, width_px, height_px);
}

Result<std::unique_ptr<SimulatedStudent>> SimulatedStudent::make(const SimulatedStudentOptions& options) {
  for (const int side : {options.width, options.height})
    if (side < 64 || side > 8192)
      return fail(ErrorCode::InvalidArgument, "a simulated film is 64 to 8192 pixels wide and high");
  Result<GolfScript> script = bundled_script(options.motion);
  if (!script) return tl::unexpected(script.error());
  if (!(options.length >= 0.1 && options.length <= 2))
    return fail(ErrorCode::InvalidArgument, "a simulated stroke is 0.1 to 2 times as long as usual");
  script->lengthen(options.length);
  script->stand_first(options.stands_s);
  for (const FaultChoice& fault : options.faults)
    if (auto applied = apply_fault(*script, fault); !applied) return tl::unexpected(applied.error());
  Result<AuthoredMotion> authored =
      make_authored_motion(*script, options.body, options.frames_per_second, options.hand);
  if (!authored) return tl::unexpected(authored.error());
  return std::unique_ptr<SimulatedStudent>(
      new SimulatedStudent(options, *std::move(authored), script->club().head == "putter"));
}

SimulatedStudent::SimulatedStudent(const SimulatedStudentOptions& options, AuthoredMotion authored,
                                   bool is_putter)
    : info_{options.name, options.width, options.height, options.frames_per_second,
            static_cast<std::size_t>(authored.motion.frame_count())},
      authored_(std::move(authored)),
      camera_(make_view_camera(options.view, options.hand, options.width, options.height)),
      figure_(authored_.motion.skeleton()),
      background_(draw_ground_and_sky(camera_)),
      is_putter_(is_putter),
      target_(options.hand == Handedness::Right ? 1 : -1) {}

std::optional<Vec3> SimulatedStudent::ball_at(double time_s) const {
  constexpr double kRadius = 0.0214;
  // In front of the club's face.
  Vec3 ball = authored_.ball + Vec3(target_ * 0.040, 0, 0);
  ball.y = kRadius;
  const double since = time_s - authored_.time_of("impact");
  if (since <= 0) return ball;
  if (!is_putter_) return std::nullopt;            // gone within a frame
  constexpr double kStart = 1.9, kSlowing = 0.55;  // m/s, m/s2: a rolling ball
  const double rolling = std::min(since, kStart / kSlowing);
  ball.x += target_ * (kStart * rolling - 0.5 * kSlowing * rolling * rolling);
  return ball;
}

GolferFigure::Posed SimulatedStudent::posed(int frame, std::vector<Quat>& rotations) const {
  const Motion& motion = authored_.motion;
  rotations.resize(static_cast<std::size_t>(motion.joint_count()));
  global_rotations(motion.skeleton(), motion.rotations(frame), rotations);
  return {motion.positions(frame), rotations, authored_.club[static_cast<std::size_t>(frame)], is_putter_,
          ball_at(to_seconds(motion.time(frame)))};
}

Image SimulatedStudent::draw(int frame) const {
  std::vector<Quat> rotations;
  Image image = draw_scene(figure_.scene(posed(frame, rotations)), camera_, background_);
  write_bar_code(image, static_cast<std::uint32_t>(frame));
  return image;
}

LandmarkArray<Vec3> SimulatedStudent::landmarks(int frame) const {
  std::vector<Quat> rotations;
  return figure_.landmarks(posed(frame, rotations));
}

Result<std::optional<Frame>> SimulatedStudent::next(std::stop_token) {
  if (next_ >= authored_.motion.frame_count()) return std::optional<Frame>();
  const int frame = next_++;
  return Frame{static_cast<std::size_t>(frame),
               authored_.motion.time(frame),
               {},
               std::make_shared<const Image>(draw(frame))};
}

}  // namespace posecoach
