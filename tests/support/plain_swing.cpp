#include "tests/support/plain_swing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "capture/simulated_student.h"
#include "core/base/assert.h"

namespace posecoach {
namespace {

constexpr int kLate = 5;  // frames by which the student runs behind his coach from the top on

class DrawnPictures : public PictureStore {
 public:
  explicit DrawnPictures(std::unique_ptr<SimulatedStudent> student) : student_(std::move(student)) {}
  std::size_t count() const override { return *student_->info().frame_count; }
  MediaTime time(std::size_t index) const override {
    return student_->authored().motion.time(static_cast<int>(index));
  }
  Result<std::shared_ptr<const Image>> picture(std::size_t index) override {
    if (index >= count()) return fail(ErrorCode::InvalidArgument, "no such picture");
    return std::make_shared<const Image>(student_->draw(static_cast<int>(index)));
  }

 private:
  std::unique_ptr<SimulatedStudent> student_;
};

std::unique_ptr<SimulatedStudent> play(const std::string& fault, double height_m) {
  SimulatedStudentOptions options;
  options.body = make_standard_body({.height_m = height_m});
  options.frames_per_second = 30;
  options.width = 640;
  options.height = 360;
  std::istringstream faults(fault);
  for (std::string one; std::getline(faults, one, ',');)
    options.faults.push_back(fault_from_string(one).value());
  Result<std::unique_ptr<SimulatedStudent>> student = SimulatedStudent::make(options);
  POSECOACH_ASSERT(student.has_value());
  return *std::move(student);
}

Analysis describe(const AuthoredMotion& student) {
  Analysis analysis;
  const Motion& motion = student.motion;
  const int last = motion.frame_count() - 1;
  const double seconds = to_seconds(motion.duration());
  analysis.student = {"film.mp4", last + 1, seconds, 25, Handedness::Right};
  analysis.coach = {"bundled:swing", last + 1, seconds, 25, Handedness::Right};
  analysis.stroke = "full swing";
  analysis.score.percent = 78.4;
  analysis.score.plus_minus = 2.6;
  analysis.score.raw = 143.2;
  analysis.score.mean_joint_error_m = 0.041;
  int top = last / 2;
  constexpr std::array<std::string_view, 8> kNames = {
      "address", "toe_up", "mid_backswing", "top", "mid_downswing", "impact", "mid_follow_through", "finish"};
  for (const auto& event : student.events) {
    if (std::find(kNames.begin(), kNames.end(), event.name) == kNames.end()) continue;
    const int frame = std::clamp(static_cast<int>(std::lround(event.time_s * 30)), 0, last);
    analysis.student_events.push_back({event.name, frame, event.time_s});
    analysis.coach_events.push_back({event.name, std::max(0, frame - kLate), event.time_s});
    if (event.name == "top") top = frame;
  }
  for (int frame = 0; frame <= last; ++frame) {
    const int late = frame < top ? 0 : std::min(kLate, frame - top);
    analysis.path.emplace_back(frame, frame - late);
    analysis.path_error_m.push_back(0.02 + 0.001 * (frame % 40));
  }
  analysis.advice = {
      {AdviceKind::Spatial, "At the top, your hips are 14 cm too far from the target.", top, top, 2},
      {AdviceKind::Timing, "Your downswing takes too long: start down with more speed.", top + 2, top, 1.4},
      {AdviceKind::Spatial, "At the top, your left elbow is bent by 60° more.", top, top, 1.1}};
  SpatialAdvice spatial;
  spatial.joint = "pelvis";
  spatial.event = "top";
  spatial.student_frame = top;
  spatial.coach_frame = top;
  analysis.spatial = {spatial};
  const auto metric = [](const char* name, double value, const char* unit, double coach) {
    Metric made;
    made.name = name;
    made.value = value;
    made.unit = unit;
    made.available = true;
    made.coach = coach;
    return made;
  };
  analysis.metrics = {metric("tempo_ratio", 2.4, "", 3.0), metric("backswing_s", 0.84, "s", 0.8),
                      metric("shoulder_turn_top_deg", 91.7, "deg", 88.2)};
  return analysis;
}

}  // namespace

std::shared_ptr<const AnalyzedSwing> make_plain_swing(const std::string& fault, double height_m) {
  std::unique_ptr<SimulatedStudent> student = play(fault, height_m);
  const std::unique_ptr<SimulatedStudent> coach = play({}, height_m);
  const Motion& motion = student->authored().motion;
  PoseTrack track{"film.mp4", 640, 360, {}};
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    track.frames.push_back({static_cast<std::size_t>(frame), motion.time(frame), {}});
  LiftedStudent lifted{motion, motion.skeleton(), student->camera(), View::FaceOn, 0, 0};
  AnalyzedPair pair{describe(student->authored()), coach->authored().motion};
  return std::make_shared<const AnalyzedSwing>(
      AnalyzedSwing{std::move(track), std::move(lifted), std::move(pair),
                    std::make_shared<DrawnPictures>(std::move(student))});
}

}  // namespace posecoach
