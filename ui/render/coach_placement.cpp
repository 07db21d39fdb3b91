#include "ui/render/coach_placement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/base/median.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// A student who moves his feet less than this stands still, and so does his coach.
constexpr double kStandsStill_m = 0.10;
constexpr double kWalksAway_m = 0.25;
constexpr double kSmoothing_s = 0.35;  // standard deviation

struct Feet {
  Vec2 middle;        // x, z
  double height = 0;  // of the lowest joint
};

// Both bodies have the same joints, so the same mean of them compares like with like.
std::optional<Feet> feet_of(const Skeleton& skeleton, std::span<const Vec3> positions) {
  Feet feet{Vec2(0), 1e9};
  double count = 0;
  for (const HumanoidJoint role : {LeftAnkle, RightAnkle, LeftToe, RightToe}) {
    const int joint = skeleton.find(role);
    if (joint == kNoJoint) continue;
    const Vec3& p = positions[index(joint)];
    feet.middle += Vec2(p.x, p.z);
    feet.height = std::min(feet.height, p.y);
    ++count;
  }
  if (count < 1) return std::nullopt;
  feet.middle /= count;
  return feet;
}

// Gaussian in time; frames may be unevenly spaced.
std::vector<Vec2> smoothed(const std::vector<Vec2>& values, std::span<const MediaTime> times) {
  std::vector<Vec2> result(values.size());
  std::size_t begin = 0, end = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto seconds = [&](std::size_t j) { return to_seconds(times[j] - times[i]); };
    while (seconds(begin) < -3 * kSmoothing_s) ++begin;
    while (end < values.size() && seconds(end) <= 3 * kSmoothing_s) ++end;
    Vec2 sum(0);
    double weights = 0;
    for (std::size_t j = begin; j < end; ++j) {
      const double t = seconds(j) / kSmoothing_s;
      const double weight = std::exp(-0.5 * t * t);
      sum += weight * values[j];
      weights += weight;
    }
    result[i] = sum / weights;
  }
  return result;
}

std::vector<Vec3> interpolated(const Motion& motion, double frame) {
  const int first = std::clamp(static_cast<int>(std::floor(frame)), 0, motion.frame_count() - 1);
  const int second = std::min(first + 1, motion.frame_count() - 1);
  const double t = std::clamp(frame - first, 0.0, 1.0);
  std::vector<Vec3> positions(index(motion.joint_count()));
  for (int joint = 0; joint < motion.joint_count(); ++joint)
    positions[index(joint)] = (1 - t) * motion.position(first, joint) + t * motion.position(second, joint);
  return positions;
}

}  // namespace

std::vector<Vec3> CoachPlacement::positions(const Motion& coach, int student_frame) const {
  return positions(coach, coach_frame[index(student_frame)], student_frame);
}

std::vector<Vec3> CoachPlacement::positions(const Motion& coach, double at_coach_frame,
                                            int student_frame) const {
  std::vector<Vec3> positions = interpolated(coach, at_coach_frame);
  for (Vec3& p : positions) p += offset[index(student_frame)];
  return positions;
}

std::vector<double> follow_path(const std::vector<std::pair<int, int>>& path, int student_frames) {
  POSECOACH_ASSERT(!path.empty() && student_frames > 0);
  const auto count = index(student_frames);
  constexpr double kUnset = -1;
  std::vector<double> lowest(count, kUnset), highest(count, kUnset);
  for (const auto& [student, coach] : path) {
    if (student < 0 || student >= student_frames) continue;
    double& low = lowest[index(student)];
    if (low < 0) low = coach;
    highest[index(student)] = coach;
  }
  // Frames that the path skips take the last answer; those before it wait at its beginning.
  double last = path.front().second;
  std::vector<double> frames(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (lowest[i] < 0) lowest[i] = highest[i] = last;
    last = highest[i];
    frames[i] = 0.5 * (lowest[i] + highest[i]);
  }
  constexpr int kPasses = 12;
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<double> before = frames;
    for (std::size_t i = 1; i + 1 < count; ++i)
      frames[i] = std::clamp(0.25 * before[i - 1] + 0.5 * before[i] + 0.25 * before[i + 1], lowest[i] - 0.5,
                             highest[i] + 0.5);
  }
  return frames;
}

CoachPlacement stand_on_feet(const Motion& student, const Motion& coach,
                             const std::vector<std::pair<int, int>>& path) {
  CoachPlacement placement;
  placement.coach_frame = follow_path(path, student.frame_count());
  placement.offset.assign(index(student.frame_count()), Vec3(0));

  std::vector<Vec2> apart(index(student.frame_count()));
  std::vector<double> x, z, height;
  const int path_begin = path.front().first, path_end = path.back().first;
  for (int frame = 0; frame < student.frame_count(); ++frame) {
    const std::optional<Feet> his = feet_of(student.skeleton(), student.positions(frame));
    const std::optional<Feet> coachs = feet_of(coach.skeleton(), placement.positions(coach, frame));
    if (!his || !coachs) return placement;  // bodies without feet stand where they are
    apart[index(frame)] = his->middle - coachs->middle;
    if (frame < path_begin || frame > path_end) continue;
    x.push_back(apart[index(frame)].x);
    z.push_back(apart[index(frame)].y);
    height.push_back(his->height - coachs->height);
  }
  if (x.empty()) return placement;
  const Vec2 stance(median(x), median(z));
  const double floor = median(height);
  const std::vector<Vec2> slow = smoothed(apart, student.times());
  for (std::size_t i = 0; i < slow.size(); ++i) {
    const Vec2 drift = slow[i] - stance;
    const double t =
        std::clamp((glm::length(drift) - kStandsStill_m) / (kWalksAway_m - kStandsStill_m), 0.0, 1.0);
    const Vec2 used = stance + t * t * (3 - 2 * t) * drift;
    placement.offset[i] = {used.x, floor, used.y};
  }
  return placement;
}

}  // namespace posecoach
