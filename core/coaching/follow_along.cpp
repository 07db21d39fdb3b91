#include "core/coaching/follow_along.h"

#include <algorithm>
#include <cmath>

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
constexpr double kTurnWorthLooking = radians_from_degrees(1);

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

PoseSequence sequence_of(const JointTrack& coach, const std::vector<HumanoidJoint>& joints, double yaw,
                         const Sight& sight) {
  PoseSequence poses(coach.frame_count(), static_cast<int>(joints.size()));
  for (int frame = 0; frame < coach.frame_count(); ++frame)
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const Vec3 p = coach.position(frame, joints[k]) - coach.position(frame, HumanoidJoint::Pelvis);
      set_pose(poses, frame, static_cast<int>(k), sight.seen(turned(p, yaw)),
               coach.confidence(frame, joints[k]) > 0 ? 1 : kLeastConfidence);
    }
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

PoseSequence FollowAlong::pose_of(const JointMoment& student) const {
  PoseSequence pose(1, static_cast<int>(joints_.size()));
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const Vec3 p = student.at(joints_[k]) - student.at(HumanoidJoint::Pelvis);
    const double confidence = student.confidence(joints_[k]);
    set_pose(pose, 0, static_cast<int>(k), sight_.seen(p),
             confidence < 0 ? 0 : std::max(confidence, kLeastConfidence));
  }
  return pose;
}

void FollowAlong::look_from(double yaw, const Sight& sight) {
  const bool is_same_sight =
      sight.direction.has_value() == sight_.direction.has_value() &&
      (!sight.direction || glm::dot(*sight.direction, *sight_.direction) > std::cos(kTurnWorthLooking));
  if (is_same_sight && std::abs(std::remainder(yaw - yaw_, 2 * kPi)) < kTurnWorthLooking) return;
  yaw_ = yaw;
  sight_ = sight;
  warp_ = OnlineWarp(coach_poses(), kLookAhead);
}

double FollowAlong::coach_time_s() const {
  return coach_.time(warp_.position());
}

void FollowAlong::start_over() {
  warp_.reset();
  is_following_ = false;
}

double FollowAlong::step(MediaTime time, const JointMoment& student, double yaw, const Sight& sight) {
  if (last_time_ && to_seconds(time - *last_time_) > kLongestGap_s) {
    start_over();
    last_time_.reset();
  }
  speed_.step(time, student, sight);
  const bool is_still = speed_.still_s() >= kStillAtAddress_s;
  if (is_still && (warp_.position() == 0 || is_following_)) {
    if (!is_following_) look_from(yaw, sight);
    const PoseSequence pose = pose_of(student);
    const double from_address = warp_.distance_m(pose, 0);
    // Standing still elsewhere in the stroke is waiting, not a new beginning.
    if (from_address < kNearAddress_m && from_address <= warp_.distance_m(pose, warp_.position()) + 0.01) {
      warp_.reset();
      look_from(yaw, sight);
      is_following_ = true;
      last_time_ = time;
      last_ = student;
      fed_s_ = 0;
    }
  }
  if (is_following_) follow(time, student);
  last_time_ = time;
  last_ = student;
  return coach_time_s();
}

void FollowAlong::follow(MediaTime time, const JointMoment& student) {
  constexpr double kStep_s = 1 / kAlignmentRate;
  const double seconds = to_seconds(time - *last_time_);
  if (seconds <= 0) {
    warp_.step(pose_of(student));
    return;
  }
  double next = kStep_s - fed_s_;
  for (; next <= seconds; next += kStep_s) warp_.step(pose_of(between(last_, student, next / seconds)));
  fed_s_ = seconds - (next - kStep_s);
}

}  // namespace posecoach
