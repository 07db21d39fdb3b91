#include "core/coaching/follow_along.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/coaching/body_axes.h"

namespace posecoach {
namespace {

// The coach catches up at most this many times as fast as he moves himself.
constexpr int kLookAhead = 6;
constexpr double kStillAtAddress_s = 0.35;
// Mean distance a joint from the coach's address at which a pose may be one, metres: postures differ.
constexpr double kNearAddress_m = 0.22;
constexpr double kLongestGap_s = 0.5;
constexpr double kLeastConfidence = 0.05;
// Joints that hardly move tell little of the time, and their own errors would drown those that do.
constexpr double kLeastWeight = 0.1;
// How fast what is learned of the student's own address follows him.
constexpr double kAddressSteadied_s = 1.0;
// Mean distance a joint from his own address at which he has left it, however slowly; who then stands still
// for so long has a new one.
constexpr double kLeftAddress_m = 0.01, kNewAddress_s = 1.2;
// Who stands still this much nearer to address than to where the coach is, far apart, has stepped up again:
// to a new swing, or as his body is measured anew.
constexpr double kSteppedUpAgain = 0.5, kFarFromCoach_m = 0.08;
constexpr double kTurnWorthLooking = radians_from_degrees(1);
// Hands that rise by less than this part of the torso putt; their stroke is hidden where it goes this many
// times as far along the line of sight as across it.
constexpr double kPuttRise = 0.3, kHidden = 1.5;
constexpr double kNewSight = radians_from_degrees(10);
// How much the shoulder line trembles of somebody who stands still, as a camera shows it; more of it is seen
// of the coach.
constexpr double kTurnTremble_m = 0.004, kTurnTrembleOfCoach_m = 0.0055;
constexpr double kTurnAtAddress_m = 0.005;
constexpr double kWalking = 0.3;

std::vector<HumanoidJoint> compared_joints(const JointTrack& coach) {
  std::vector<HumanoidJoint> joints;
  for (const HumanoidJoint joint : coach.joints())
    if (joint != HumanoidJoint::Pelvis) joints.push_back(joint);
  return joints;
}

void set_pose(PoseSequence& poses, int frame, int joint, const Vec3& p, double weight) {
  poses.set(frame, joint, static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
            static_cast<float>(weight));
}

// As the camera sees it, relative to the pelvis; joints count as far as they move.
PoseSequence sequence_of(const JointTrack& coach, const std::vector<HumanoidJoint>& joints, double yaw,
                         const Sight& sight) {
  const auto place = [&](int frame, HumanoidJoint joint) {
    return sight.seen(
        turned(coach.position(frame, joint) - coach.position(frame, HumanoidJoint::Pelvis), yaw));
  };
  std::vector<double> way(joints.size(), 0.0);
  const auto is_seen = [&](int frame, HumanoidJoint joint) { return coach.confidence(frame, joint) > 0; };
  for (std::size_t k = 0; k < joints.size(); ++k) {
    std::optional<Vec3> first;
    for (int frame = 0; frame < coach.frame_count(); ++frame) {
      if (!is_seen(frame, joints[k])) continue;
      if (!first) first = place(frame, joints[k]);
      way[k] = std::max(way[k], glm::distance(place(frame, joints[k]), *first));
    }
  }
  const double longest = std::max(1e-6, *std::max_element(way.begin(), way.end()));
  PoseSequence poses(coach.frame_count(), static_cast<int>(joints.size()));
  for (int frame = 0; frame < coach.frame_count(); ++frame)
    for (std::size_t k = 0; k < joints.size(); ++k)
      set_pose(poses, frame, static_cast<int>(k), place(frame, joints[k]),
               is_seen(frame, joints[k]) ? std::max(kLeastWeight, way[k] / longest) : kLeastConfidence);
  return poses;
}

JointMoment between(const JointMoment& a, const JointMoment& b, double part) {
  JointMoment moment = b;
  for (std::size_t j = 0; j < kHumanoidJointCount; ++j)
    moment.positions[j] = glm::mix(a.positions[j], b.positions[j], part);
  return moment;
}

}  // namespace

FollowAlong::FollowAlong(const JointTrack& coach, const TimeWindow& stroke)
    : coach_(coach.resampled(kAlignmentRate, stroke.begin_s, stroke.end_s)),
      joints_(compared_joints(coach_)),
      begin_s_(coach_.time(0)),
      warp_(coach_poses(), kLookAhead) {}

PoseSequence FollowAlong::coach_poses() const {
  return sequence_of(coach_, joints_, yaw_, sight_);
}

PoseSequence FollowAlong::pose_of(const JointMoment& student, const std::vector<Vec3>& habit) const {
  PoseSequence pose(1, static_cast<int>(joints_.size()));
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const Vec3 p = student.at(joints_[k]) - student.at(HumanoidJoint::Pelvis);
    const double confidence = student.confidence(joints_[k]);
    set_pose(pose, 0, static_cast<int>(k), sight_.seen(p) - (habit.empty() ? Vec3(0) : habit[k]),
             confidence < 0 ? 0 : std::max(confidence, kLeastConfidence));
  }
  return pose;
}

// What differs from the coach at address differs all the way: his stance, and what the pose model gets wrong.
void FollowAlong::learn_habit(const PoseSequence& at_address, double seconds) {
  const double part = is_following_ ? 1 - std::exp(-seconds / kAddressSteadied_s) : 1;
  habit_.resize(joints_.size(), Vec3(0));
  const PoseSequence& coach = warp_.coach();
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const int joint = static_cast<int>(k);
    const Vec3 apart(at_address.x(joint)[0] - coach.x(joint)[0], at_address.y(joint)[0] - coach.y(joint)[0],
                     at_address.z(joint)[0] - coach.z(joint)[0]);
    habit_[k] += part * (apart - habit_[k]);
  }
}

void FollowAlong::look_from(double yaw, const Sight& sight) {
  const bool is_same_sight =
      sight.direction.has_value() == sight_.direction.has_value() &&
      (!sight.direction || glm::dot(*sight.direction, *sight_.direction) > std::cos(kTurnWorthLooking));
  if (is_same_sight && std::abs(std::remainder(yaw - yaw_, 2 * kPi)) < kTurnWorthLooking) return;
  yaw_ = yaw;
  sight_ = sight;
  warp_ = OnlineWarp(coach_poses(), kLookAhead);
  turn_warp_.reset();
  if (!hides_stroke()) return;
  if (glm::dot(turn_sight_, *sight_.direction) < std::cos(kNewSight)) {
    turn_sight_ = *sight_.direction;
    turn_.reset();
  }
  turn_warp_.emplace(coach_turns(), kLookAhead);
}

bool FollowAlong::hides_stroke() const {
  if (!sight_.direction) return false;
  const auto hands = [&](int frame) {
    return turned(0.5 * (coach_.position(frame, HumanoidJoint::LeftWrist) +
                         coach_.position(frame, HumanoidJoint::RightWrist)) -
                      coach_.position(frame, HumanoidJoint::Pelvis),
                  yaw_);
  };
  double along = 0, across = 0, rise = 0;
  for (int frame = 0; frame < coach_.frame_count(); ++frame) {
    const Vec3 away = hands(frame) - hands(0);
    const double hidden = glm::dot(away, *sight_.direction);
    along = std::max(along, std::abs(hidden));
    across = std::max(across, glm::length(away - hidden * *sight_.direction));
    rise = std::max(rise, away.y);
  }
  const double torso =
      glm::distance(coach_.position(0, HumanoidJoint::Neck), coach_.position(0, HumanoidJoint::Pelvis));
  return rise < kPuttRise * torso && along > kHidden * across;
}

double FollowAlong::turn_of(const Vec3& left_shoulder, const Vec3& right_shoulder) const {
  return glm::dot(left_shoulder - right_shoulder, glm::cross(Vec3(0, 1, 0), turn_sight_));
}

PoseSequence FollowAlong::coach_turns() const {
  PoseSequence turns(coach_.frame_count(), 1);
  ShoulderTurn turn;
  for (int frame = 0; frame < coach_.frame_count(); ++frame) {
    turn.step(media_time_from_seconds(coach_.time(frame)),
              turn_of(turned(coach_.position(frame, HumanoidJoint::LeftShoulder), yaw_),
                      turned(coach_.position(frame, HumanoidJoint::RightShoulder), yaw_)));
    if (frame == 0) turn.rest_here(1);
    set_pose(turns, frame, 0, turn.phase(kTurnTrembleOfCoach_m), 1);
  }
  return turns;
}

double FollowAlong::coach_time_s() const {
  return coach_.time(position());
}

void FollowAlong::start_over() {
  warp_.reset();
  if (turn_warp_) turn_warp_->reset();
  is_following_ = has_walked_ = false;
  habit_.clear();
  away_s_ = 0;
}

bool FollowAlong::is_at_address(const JointMoment& student, double yaw, const Sight& sight, double seconds) {
  if (speed_.still_s() < kStillAtAddress_s || (position() != 0 && !is_following_)) {
    away_s_ = 0;
    return false;
  }
  if (!is_following_) look_from(yaw, sight);
  if (warp_.distance_m(pose_of(student, {}), 0) > kNearAddress_m) return false;
  return turn_warp_ ? has_shoulders_at_address(seconds) : is_near_address(student, seconds);
}

// His hands seem to stand still all the way.
bool FollowAlong::has_shoulders_at_address(double seconds) {
  if (turn_.still_s() < kStillAtAddress_s) {
    away_s_ = 0;
    return false;
  }
  if (!is_following_) return true;
  if (!has_walked_ && std::abs(turn_.away_m()) < kTurnAtAddress_m) {
    away_s_ = 0;
    return true;
  }
  const Vec3 phase = turn_.phase(kTurnTremble_m);
  const auto at = static_cast<std::size_t>(position());
  const Vec3 of_coach(turn_warp_->coach().x(0)[at], turn_warp_->coach().y(0)[at], 0);
  if (!has_walked_ && glm::length(phase) > glm::distance(phase, of_coach)) return false;
  away_s_ += seconds;
  if (away_s_ < kNewAddress_s && !has_walked_) return false;
  start_over();
  return true;
}

bool FollowAlong::is_near_address(const JointMoment& student, double seconds) {
  const PoseSequence pose = pose_of(student, habit_);
  const double from_address = warp_.distance_m(pose, 0);
  // Standing still elsewhere in the stroke is waiting, not a new beginning.
  const double from_coach = warp_.distance_m(pose, warp_.position());
  if (from_address > from_coach + kLeftAddress_m) return false;
  if (!is_following_ || from_address < kLeftAddress_m) {
    away_s_ = 0;
    return true;
  }
  away_s_ += seconds;
  const bool has_stepped_up = from_coach > kFarFromCoach_m && from_address < kSteppedUpAgain * from_coach;
  if (away_s_ < kNewAddress_s && !has_stepped_up) return false;
  start_over();
  return true;
}

double FollowAlong::step(MediaTime time, const JointMoment& student, double yaw, const Sight& sight) {
  if (last_time_ && to_seconds(time - *last_time_) > kLongestGap_s) {
    start_over();
    last_time_.reset();
  }
  speed_.step(time, student, sight);
  if (turn_warp_) {
    turn_.step(time,
               turn_of(student.at(HumanoidJoint::LeftShoulder), student.at(HumanoidJoint::RightShoulder)));
    has_walked_ = has_walked_ || speed_.feet() > kWalking;
  }
  const double seconds = last_time_ ? to_seconds(time - *last_time_) : 0;
  if (is_at_address(student, yaw, sight, seconds)) {
    warp_.reset();
    if (turn_warp_) turn_warp_->reset();
    look_from(yaw, sight);
    turn_.rest_here(is_following_ ? 1 - std::exp(-seconds / kAddressSteadied_s) : 1);
    learn_habit(pose_of(student, {}), seconds);
    is_following_ = true;
    last_time_ = time;
    last_ = student;
    fed_s_ = 0;
  }
  if (is_following_) follow(time, student);
  last_turn_ = turn_.phase(kTurnTremble_m);
  last_time_ = time;
  last_ = student;
  return coach_time_s();
}

void FollowAlong::follow(MediaTime time, const JointMoment& student) {
  constexpr double kStep_s = 1 / kAlignmentRate;
  const double seconds = to_seconds(time - *last_time_);
  const auto step = [&](double part) {
    if (!turn_warp_) {
      warp_.step(pose_of(between(last_, student, part), habit_));
      return;
    }
    PoseSequence turn(1, 1);
    set_pose(turn, 0, 0, glm::mix(last_turn_, turn_.phase(kTurnTremble_m), part), 1);
    turn_warp_->step(turn);
  };
  if (seconds <= 0) {
    step(1);
    return;
  }
  double next = kStep_s - fed_s_;
  for (; next <= seconds; next += kStep_s) step(next / seconds);
  fed_s_ = seconds - (next - kStep_s);
}

}  // namespace posecoach
