#include "ui/report/replay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <optional>
#include <set>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "ui/render/coach_placement.h"
#include "ui/report/stills.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// Chains of a figure of lines; a joint that either body lacks is passed over.
const std::vector<std::vector<HumanoidJoint>> kChains = {
    {Pelvis, Neck, Head, HeadTop},
    {Neck, LeftShoulder, LeftElbow, LeftWrist},
    {Neck, RightShoulder, RightElbow, RightWrist},
    {Pelvis, LeftHip, LeftKnee, LeftAnkle, LeftToe},
    {Pelvis, RightHip, RightKnee, RightAnkle, RightToe},
};

constexpr double kSpeedWindow_s = 0.12;  // on either side

int position_of(std::vector<HumanoidJoint>& joints, HumanoidJoint role) {
  const auto found = std::find(joints.begin(), joints.end(), role);
  if (found != joints.end()) return static_cast<int>(found - joints.begin());
  joints.push_back(role);
  return static_cast<int>(joints.size()) - 1;
}

void choose_joints(const Comparison& comparison, Replay& replay) {
  for (const std::vector<HumanoidJoint>& chain : kChains) {
    int previous = -1;
    for (const HumanoidJoint role : chain) {
      if (!comparison.student.skeleton().has(role) || !comparison.coach.skeleton().has(role)) continue;
      const int joint = position_of(replay.joints, role);
      if (previous >= 0) replay.bones.emplace_back(previous, joint);
      previous = joint;
    }
  }
}

// Turn about +Y that brings the student's front at the beginning to +Z.
double turn_to_front(const Motion& student, int frame) {
  const int left = student.skeleton().find(LeftHip), right = student.skeleton().find(RightHip);
  if (left == kNoJoint || right == kNoJoint) return 0;
  const Vec3 across = student.position(frame, left) - student.position(frame, right);
  const Vec3 front = glm::cross(across, Vec3(0, 1, 0));
  return -std::atan2(front.x, front.z);
}

std::vector<Vec3> picked(const Skeleton& skeleton, std::span<const Vec3> positions, const Replay& replay,
                         double yaw, const Vec3& origin) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  std::vector<Vec3> result;
  for (const HumanoidJoint role : replay.joints) {
    const Vec3 p = positions[index(skeleton.find(role))] - origin;
    result.emplace_back(c * p.x + s * p.z, p.y, -s * p.x + c * p.z);
  }
  return result;
}

double speed_at(const Motion& student, const Motion& coach, const std::vector<double>& coach_frame, int frame,
                int path_begin, int path_end) {
  const auto coach_time = [&](int student_frame) {
    const double at = coach_frame[index(student_frame)];
    const int first = static_cast<int>(std::clamp(std::floor(at), 0.0, coach.frame_count() - 1.0));
    const int second = std::min(first + 1, coach.frame_count() - 1);
    const double a = to_seconds(coach.time(first)), b = to_seconds(coach.time(second));
    return a + (at - first) * (b - a);
  };
  int begin = frame, end = frame;
  const auto seconds = [&](int other) {
    return std::abs(to_seconds(student.time(other) - student.time(frame)));
  };
  while (begin > path_begin && seconds(begin - 1) <= kSpeedWindow_s) --begin;
  while (end < path_end && seconds(end + 1) <= kSpeedWindow_s) ++end;
  const double elapsed = to_seconds(student.time(end) - student.time(begin));
  return elapsed > 0 ? (coach_time(end) - coach_time(begin)) / elapsed : 1;
}

using Path = std::vector<std::pair<int, int>>;

// Indices into the path.
std::set<std::size_t> chosen_pairs(const Comparison& comparison, const Path& path, int most_steps) {
  const int count = static_cast<int>(path.size()), kept = std::min(count, most_steps);
  std::set<std::size_t> chosen;
  for (int i = 0; i < kept; ++i)
    chosen.insert(index(kept == 1 ? 0 : static_cast<int>(std::lround(1.0 * i * (count - 1) / (kept - 1)))));
  const auto add = [&](int student_frame, std::optional<int> coach_frame) {
    const auto distance = [&](const std::pair<int, int>& pair) {
      return std::pair(std::abs(pair.first + comparison.first_frame - student_frame),
                       coach_frame ? std::abs(pair.second - *coach_frame) : 0);
    };
    const auto nearest = std::min_element(
        path.begin(), path.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    chosen.insert(static_cast<std::size_t>(nearest - path.begin()));
  };
  const Analysis& analysis = comparison.analysis;
  for (const Advice& advice : analysis.advice) add(advice.student_frame, advice.coach_frame);
  for (const SpatialAdvice& spatial : analysis.spatial) add(spatial.student_frame, spatial.coach_frame);
  for (const PoseMatch& match : analysis.poses) add(match.student_frame, match.coach_frame);
  for (const FramePair& pair : analysis.worst_frames) add(pair.student_frame, pair.coach_frame);
  for (const StillMoment& still : still_moments(analysis)) add(still.student_frame, still.coach_frame);
  for (const SwingEvent& event : analysis.student_events) add(event.frame, std::nullopt);
  return chosen;
}

}  // namespace

Replay make_replay(const Comparison& comparison, int most_steps) {
  POSECOACH_ASSERT(most_steps > 1);
  const Motion& student = comparison.student;
  const Motion& coach = comparison.coach;
  Replay replay;
  choose_joints(comparison, replay);

  Path path;
  std::vector<double> errors;
  for (std::size_t i = 0; i < comparison.analysis.path.size(); ++i) {
    const auto& [his, coachs] = comparison.analysis.path[i];
    const int frame = his - comparison.first_frame;
    if (frame < 0 || frame >= student.frame_count() || coachs < 0 || coachs >= coach.frame_count()) continue;
    path.emplace_back(frame, coachs);
    errors.push_back(i < comparison.analysis.path_error_m.size() ? comparison.analysis.path_error_m[i] : 0);
  }
  if (path.empty()) return replay;
  const CoachPlacement placement = stand_on_feet(student, coach, path);
  const double yaw = turn_to_front(student, path.front().first);
  Vec3 origin(0);
  for (const HumanoidJoint role : {LeftAnkle, RightAnkle})
    if (const int joint = student.skeleton().find(role); joint != kNoJoint)
      origin += 0.5 * student.position(path.front().first, joint);
  origin.y = 0;

  for (const std::size_t at : chosen_pairs(comparison, path, most_steps)) {
    const auto& [his, coachs] = path[at];
    ReplayStep step;
    step.student_frame = his + comparison.first_frame;
    step.coach_frame = coachs;
    step.student_s = to_seconds(student.time(his));
    step.coach_s = to_seconds(coach.time(coachs));
    step.apart_m = errors[at];
    step.speed = speed_at(student, coach, placement.coach_frame, his, path.front().first, path.back().first);
    step.student = picked(student.skeleton(), student.positions(his), replay, yaw, origin);
    const std::vector<Vec3> stood = placement.positions(coach, coachs, his);
    step.coach = picked(coach.skeleton(), stood, replay, yaw, origin);
    replay.steps.push_back(std::move(step));
  }
  const double his_time = replay.steps.back().student_s - replay.steps.front().student_s;
  const double coachs_time = replay.steps.back().coach_s - replay.steps.front().coach_s;
  if (his_time > 0 && coachs_time > 0) replay.overall_speed = coachs_time / his_time;
  return replay;
}

bool Replay::is_in_proportion() const {
  return overall_speed > 1.25 || overall_speed < 0.8;
}

double Replay::speed_in_proportion(const ReplayStep& step) const {
  return is_in_proportion() ? step.speed / overall_speed : step.speed;
}

int step_at(const Replay& replay, int student_frame, int coach_frame) {
  POSECOACH_ASSERT(!replay.steps.empty());
  const auto distance = [&](const ReplayStep& step) {
    return std::pair(std::abs(step.student_frame - student_frame), std::abs(step.coach_frame - coach_frame));
  };
  const auto nearest =
      std::min_element(replay.steps.begin(), replay.steps.end(),
                       [&](const ReplayStep& a, const ReplayStep& b) { return distance(a) < distance(b); });
  return static_cast<int>(nearest - replay.steps.begin());
}

}  // namespace posecoach
