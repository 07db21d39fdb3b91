#include "core/coaching/alignment.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/coaching/body_axes.h"
#include "core/coaching/dtw.h"

namespace posecoach {
namespace {

// Every fourth frame is enough to find the turn to start from.
constexpr int kCoarseStep = 4;
constexpr int kCoarseRounds = 3;
constexpr int kFineRounds = 6;
constexpr double kYawTolerance = 1e-4;
// How far the turn that is seen may be from the one that all directions give, and when it is settled.
constexpr double kSeenYawReach = radians_from_degrees(20), kSeenYawTolerance = 1e-3;
// Nobody is believed less than this: a hidden arm is still somewhere near.
constexpr double kConfidenceFloor = 0.05;
// Distances below it do not pull harder on the turn, metres.
constexpr double kNear = 0.02;

PoseSequence pose_sequence(const JointTrack& track, const std::vector<HumanoidJoint>& joints, int step,
                           double yaw, const Sight& sight = {}) {
  PoseSequence poses((track.frame_count() + step - 1) / step, static_cast<int>(joints.size()));
  for (int row = 0, frame = 0; frame < track.frame_count(); ++row, frame += step) {
    const Vec3& root = track.position(frame, HumanoidJoint::Pelvis);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      Vec3 p = track.position(frame, joints[k]) - root;
      if (yaw != 0) p = turned(p, yaw);
      p = sight.seen(p);
      poses.set(row, static_cast<int>(k), static_cast<float>(p.x), static_cast<float>(p.y),
                static_cast<float>(p.z),
                static_cast<float>(std::max(track.confidence(frame, joints[k]), kConfidenceFloor)));
    }
  }
  return poses;
}

// The turn of the coach about +Y that brings the paired poses nearest; far joints count by distance, not by
// its square, as in the warp itself.
double best_yaw(const PoseSequence& student, const PoseSequence& coach, const Warp& warp, double yaw) {
  double cross = 0, dot = 0;
  for (int k = 0; k < student.joints(); ++k) {
    const auto sx = student.x(k), sy = student.y(k), sz = student.z(k), sw = student.weight(k);
    const auto cx = coach.x(k), cy = coach.y(k), cz = coach.z(k), cw = coach.weight(k);
    for (const auto& [row, column] : warp.path) {
      const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
      const Vec3 s(sx[i], sy[i], sz[i]), c(cx[j], cy[j], cz[j]);
      const double weight =
          static_cast<double>(sw[i] * cw[j]) / std::max(glm::distance(s, turned(c, yaw)), kNear);
      cross += weight * (s.x * c.z - s.z * c.x);
      dot += weight * (s.x * c.x + s.z * c.z);
    }
  }
  const double best = std::atan2(cross, dot);
  return std::abs(best) < 1e-9 ? 0 : best;
}

// The mean distance of the paired poses after a turn of the coach, as far as it is seen.
double seen_distance(const PoseSequence& student, const PoseSequence& coach, const Warp& warp,
                     const Sight& sight, double yaw) {
  double sum = 0, weights = 0;
  for (int k = 0; k < student.joints(); ++k) {
    const auto sx = student.x(k), sy = student.y(k), sz = student.z(k), sw = student.weight(k);
    const auto cx = coach.x(k), cy = coach.y(k), cz = coach.z(k), cw = coach.weight(k);
    for (const auto& [row, column] : warp.path) {
      const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
      const Vec3 apart = Vec3(sx[i], sy[i], sz[i]) - turned(Vec3(cx[j], cy[j], cz[j]), yaw);
      const double weight = static_cast<double>(sw[i] * cw[j]);
      sum += weight * glm::length(sight.seen(apart));
      weights += weight;
    }
  }
  return sum / weights;
}

// Golden section. A turn moves what is far or near to the side, where it is seen, so it needs no depth of the
// student's: guessed depths would turn the coach by their own errors.
double best_seen_yaw(const PoseSequence& student, const PoseSequence& coach, const Warp& warp,
                     const Sight& sight, double yaw) {
  constexpr double kGolden = 0.618033988749895;
  double low = yaw - kSeenYawReach, high = yaw + kSeenYawReach;
  const auto cost = [&](double at) { return seen_distance(student, coach, warp, sight, at); };
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double left_cost = cost(left), right_cost = cost(right);
  while (high - low > kYawTolerance) {
    if (left_cost < right_cost) {
      high = std::exchange(right, left);
      right_cost = left_cost;
      left = high - kGolden * (high - low);
      left_cost = cost(left);
    } else {
      low = std::exchange(left, right);
      left_cost = right_cost;
      right = low + kGolden * (high - low);
      right_cost = cost(right);
    }
  }
  return 0.5 * (low + high);
}

struct Start {
  double yaw = 0, cost = 0;
};

double find_yaw_to_start_from(const JointTrack& student, const JointTrack& coach,
                              const std::vector<HumanoidJoint>& joints, WarpEnds ends) {
  const PoseSequence s = pose_sequence(student, joints, kCoarseStep, 0);
  const PoseSequence unturned = pose_sequence(coach, joints, kCoarseStep, 0);
  const auto facing = [](const JointTrack& track) {
    return body_axes(track, track.time(0), track.time(track.frame_count() - 1));
  };
  const double first = yaw_between(facing(coach), facing(student));
  Start best{first, std::numeric_limits<double>::infinity()};
  for (int quarter = 0; quarter < 4; ++quarter) {
    double yaw = first + quarter * kPi / 2;
    for (int round = 0; round < kCoarseRounds; ++round) {
      const Warp found = warp(s, pose_sequence(coach, joints, kCoarseStep, yaw), ends);
      if (found.cost < best.cost) best = {yaw, found.cost};
      const double next = best_yaw(s, unturned, found, yaw);
      if (std::abs(std::remainder(next - yaw, 2 * kPi)) < kYawTolerance) break;
      yaw = next;
    }
  }
  return best.yaw;
}

JointTrack turned_track(const JointTrack& track, double yaw) {
  return yaw == 0 ? track : track.mapped([yaw](const Vec3& p) { return turned(p, yaw); });
}

// From frames at the common rate to the motions' own: repeated pairs merge, jumps are filled.
void add_own_path(Alignment& alignment, const JointTrack& student, const JointTrack& coach) {
  int merged = 0;
  for (std::size_t step = 0; step < alignment.steps.size(); ++step) {
    const auto& [i, j] = alignment.steps[step];
    const std::pair pair(student.nearest_frame(alignment.student.time(i)),
                         coach.nearest_frame(alignment.coach.time(j)));
    const double error = alignment.step_error_m[step];
    if (!alignment.path.empty() && alignment.path.back() == pair) {
      ++merged;
      alignment.path_error_m.back() += (error - alignment.path_error_m.back()) / merged;
      continue;
    }
    if (!alignment.path.empty()) {
      const auto last = alignment.path.back();
      const double last_error = alignment.path_error_m.back();
      const int gap = std::max(pair.first - last.first, pair.second - last.second);
      for (int filled = 1; filled < gap; ++filled) {
        const double part = static_cast<double>(filled) / gap;
        const auto between = [part](int a, int b) {
          return a + static_cast<int>(std::lround(part * (b - a)));
        };
        alignment.path.emplace_back(between(last.first, pair.first), between(last.second, pair.second));
        alignment.path_error_m.push_back((1 - part) * last_error + part * error);
      }
    }
    merged = 1;
    alignment.path.push_back(pair);
    alignment.path_error_m.push_back(error);
  }
}

Alignment align_tracks(const JointTrack& own_student, const JointTrack& own_coach, JointTrack student,
                       JointTrack coach, WarpEnds ends, const Sight& sight) {
  std::vector<HumanoidJoint> joints;
  for (const HumanoidJoint joint : student.joints())
    if (joint != HumanoidJoint::Pelvis && coach.has(joint)) joints.push_back(joint);
  double yaw = find_yaw_to_start_from(student, coach, joints, ends);
  const PoseSequence s = pose_sequence(student, joints, 1, 0);
  const PoseSequence unturned = pose_sequence(coach, joints, 1, 0);
  Warp found;
  double cost = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kFineRounds; ++round) {
    const double tried = round == 0 ? yaw : best_yaw(s, unturned, found, yaw);
    if (round > 0 && std::abs(std::remainder(tried - yaw, 2 * kPi)) < kYawTolerance) break;
    Warp next = warp(s, pose_sequence(coach, joints, 1, tried), ends);
    if (next.cost >= cost) break;
    cost = next.cost;
    yaw = tried;
    found = std::move(next);
  }
  // So far all directions counted alike, which finds the turn from anywhere; turn and pairing are settled by
  // what was seen.
  const PoseSequence seen = pose_sequence(student, joints, 1, 0, sight);
  PoseSequence seen_coach = pose_sequence(coach, joints, 1, yaw, sight);
  if (sight.direction) found = warp(seen, seen_coach, ends);
  for (int round = 0; sight.direction && round < kFineRounds; ++round) {
    const double tried = best_seen_yaw(s, unturned, found, sight, yaw);
    PoseSequence tried_coach = pose_sequence(coach, joints, 1, tried, sight);
    Warp next = warp(seen, tried_coach, ends);
    if (next.cost >= found.cost) break;
    const bool is_settled = std::abs(tried - yaw) < kSeenYawTolerance;
    yaw = tried;
    found = std::move(next);
    seen_coach = std::move(tried_coach);
    if (is_settled) break;
  }
  Alignment alignment{
      sight, yaw, std::move(student), turned_track(coach, yaw), std::move(joints), std::move(found.path), {},
      {},    {}};
  for (const auto& [i, j] : alignment.steps)
    alignment.step_error_m.push_back(pair_cost(seen, i, seen_coach, j) / seen.joints());
  add_own_path(alignment, own_student, own_coach);
  return alignment;
}

}  // namespace

Alignment align(const JointTrack& student, const JointTrack& coach, const TimeWindow& student_window,
                const TimeWindow& coach_window, const Sight& sight) {
  return align_tracks(
      student, coach, student.resampled(kAlignmentRate, student_window.begin_s, student_window.end_s),
      coach.resampled(kAlignmentRate, coach_window.begin_s, coach_window.end_s), WarpEnds::Closed, sight);
}

Alignment align_anywhere(const JointTrack& student, const JointTrack& coach, const TimeWindow& coach_window,
                         const Sight& sight) {
  return align_tracks(student, coach, student.resampled(kAlignmentRate, 0, student.duration()),
                      coach.resampled(kAlignmentRate, coach_window.begin_s, coach_window.end_s),
                      WarpEnds::OpenStudent, sight);
}

namespace {

// Piecewise linear through the path; where one side waits, the middle of its wait.
double answer(const std::vector<std::pair<double, double>>& pairs, double time_s) {
  double before = pairs.front().second, after = pairs.back().second;
  double before_at = pairs.front().first, after_at = pairs.back().first;
  std::size_t i = 0;
  while (i < pairs.size()) {
    std::size_t end = i;
    while (end + 1 < pairs.size() && pairs[end + 1].first == pairs[i].first) ++end;
    const double middle = 0.5 * (pairs[i].second + pairs[end].second);
    if (pairs[i].first <= time_s) {
      before_at = pairs[i].first;
      before = middle;
    } else {
      after_at = pairs[i].first;
      after = middle;
      break;
    }
    i = end + 1;
  }
  if (after_at <= before_at) return before;
  const double part = std::clamp((time_s - before_at) / (after_at - before_at), 0.0, 1.0);
  return before + part * (after - before);
}

}  // namespace

double Alignment::student_time(double coach_time_s) const {
  std::vector<std::pair<double, double>> pairs;
  for (const auto& [i, j] : steps) pairs.emplace_back(coach.time(j), student.time(i));
  return answer(pairs, coach_time_s);
}

double Alignment::coach_time(double student_time_s) const {
  std::vector<std::pair<double, double>> pairs;
  for (const auto& [i, j] : steps) pairs.emplace_back(student.time(i), coach.time(j));
  return answer(pairs, student_time_s);
}

}  // namespace posecoach
