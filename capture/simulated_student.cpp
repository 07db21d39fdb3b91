#include "capture/simulated_student.h"

#include <algorithm>
#include <cmath>

#include "capture/bar_code.h"
#include "core/motion/bundled_motion.h"

namespace posecoach {

std::string_view to_string(CameraView view) {
  return view == CameraView::FaceOn ? "face-on" : "down-the-line";
}

Result<CameraView> camera_view_from_string(std::string_view name) {
  if (name == "face-on") return CameraView::FaceOn;
  if (name == "down-the-line") return CameraView::DownTheLine;
  return fail(ErrorCode::InvalidArgument,
              "there is no view \"" + std::string(name) + "\": use face-on or down-the-line");
}

PinholeCamera make_view_camera(CameraView view, Handedness hand, int width_px, int height_px) {
  constexpr double kDistance = 3.9, kHandHeight = 0.90;
  // Room above and beside a tall golfer for his club in landscape; in portrait as wide as the golfer.
  const double aspect = static_cast<double>(width_px) / height_px;
  const double seen_height = std::max(4.0, 2.2 / aspect);
  const double angle = 2 * std::atan(0.5 * seen_height / kDistance);
  const double middle_height = 1.02;
  const double right = hand == Handedness::Right ? 1 : -1;
  if (view == CameraView::FaceOn)
    return make_camera_looking_at({0, kHandHeight, kDistance + 0.1}, {0, middle_height, 0.1}, angle, width_px,
                                  height_px);
  return make_camera_looking_at({-right * kDistance, kHandHeight, 0.28}, {0, middle_height, 0.28}, angle,
                                width_px, height_px);
}

Result<std::unique_ptr<SimulatedStudent>> SimulatedStudent::make(const SimulatedStudentOptions& options) {
  for (const int side : {options.width, options.height})
    if (side < 64 || side > 8192)
      return fail(ErrorCode::InvalidArgument, "a simulated film is 64 to 8192 pixels wide and high");
  Result<GolfScript> script = bundled_script(options.motion);
  if (!script) return tl::unexpected(script.error());
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
