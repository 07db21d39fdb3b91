#include "tests/support/compared_motions.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace posecoach {
namespace {

constexpr double kSeconds = 2;

Motion raise_arms(int frames, double late_s) {
  const Skeleton body = make_standard_body();
  std::vector<MediaTime> times;
  std::vector<Vec3> roots;
  std::vector<Quat> rotations;
  for (int i = 0; i < frames; ++i) {
    const double seconds = kSeconds * i / std::max(1, frames - 1);
    const double angle =
        -1.2 + 1.5 * std::sin(kPi * std::clamp((seconds - late_s) / (kSeconds - late_s), 0.0, 1.0));
    times.push_back(media_time_from_seconds(seconds));
    roots.push_back(body.joint(0).offset);
    for (int joint = 0; joint < body.size(); ++joint) {
      const auto& role = body.joint(joint).role;
      const double turn = role == HumanoidJoint::LeftShoulder    ? angle
                          : role == HumanoidJoint::RightShoulder ? -angle
                                                                 : 0;
      rotations.push_back(glm::angleAxis(turn, Vec3(0, 0, 1)));
    }
  }
  Result<Motion> made = Motion::from_rotations(body, times, roots, rotations);
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

}  // namespace

ComparedMotions make_compared_motions(int frames, double late_s) {
  ComparedMotions made{raise_arms(frames, late_s), raise_arms(frames, 0), {}};
  Analysis& analysis = made.analysis;
  analysis.student = {"/films/my swing.mp4", frames, kSeconds, 25, Handedness::Right};
  analysis.coach = {"bundled:swing", frames, kSeconds, 25, {}};
  analysis.retarget_method = "rotation";
  analysis.score.raw = 12.5;
  analysis.score.mean_joint_error_m = 0.064;
  analysis.score.percent = 81.4;
  analysis.stroke = "full swing";
  for (int i = 0; i < frames; ++i) {
    analysis.path.emplace_back(i, i);
    analysis.path_error_m.push_back(0.05 + 0.001 * (i % 7));
  }
  const auto frame = [&](double share) { return static_cast<int>(share * (frames - 1)); };
  int k = 0;
  for (const char* name : {"address", "top", "impact", "finish"}) {
    const int at = frame(0.1 + 0.25 * k++);
    analysis.student_events.push_back({name, at, kSeconds * at / std::max(1, frames - 1)});
    analysis.coach_events.push_back(analysis.student_events.back());
  }
  analysis.worst_frames = {{frame(0.5), frame(0.5), 0.06}, {frame(0.8), frame(0.8), 0.055}};
  analysis.joint_errors = {{"left_wrist", 0.12, 0.2}, {"right_wrist", 0.1, 0.18}, {"head", 0.01, 0.02}};
  TimingAdvice timing;
  timing.from = "top";
  timing.to = "impact";
  timing.coach_s = 0.30;
  timing.student_s = 0.20;
  timing.ratio = 0.67;
  timing.advice = "Take more time on the way down.";
  analysis.timing = {timing};
  SpatialAdvice spatial;
  spatial.joint = "left_elbow";
  spatial.event = "top";
  spatial.student_frame = spatial.coach_frame = frame(0.35);
  spatial.distance_m = 0.1;
  spatial.advice = "Raise the left elbow.";
  analysis.spatial = {spatial};
  Metric tempo, sway;
  tempo.name = "tempo_ratio";
  tempo.value = 3.0;
  tempo.plus_minus = 0.5;
  tempo.available = true;
  tempo.coach = 2.9;
  tempo.definition = "Time up over time down.";
  sway.name = "pelvis_sway";
  sway.unit = "cm";
  sway.reason = "not visible from down the line";
  analysis.metrics = {tempo, sway};
  analysis.advice = {{AdviceKind::Spatial, "Raise the left elbow at the top.", frame(0.35), frame(0.35), 2},
                     {AdviceKind::Timing, "Start down more slowly.", frame(0.6), frame(0.6), 1}};
  analysis.notes = {"30 frames per second: events are known to 17 ms."};
  return made;
}

}  // namespace posecoach
