#include "core/pipeline/ghost_driver.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/body/landmark_body.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// A student whose hands are slower than this is not in the middle of a swing.
constexpr double kQuietHands = 0.8;
constexpr double kFeetSteadied_s = 0.25, kFrontSteadied_s = 0.5;
// Further away than this he has walked.
constexpr double kWalked_m = 0.35;
// Played, the coach stands at his address and at his finish for a while.
constexpr double kPauseBefore_s = 0.8, kPauseAfter_s = 1.2;
constexpr double kLeastConfidence = 0.3;

Vec3 level(const Vec3& v) {
  const Vec3 flat(v.x, 0, v.z);
  const double length = glm::length(flat);
  return length > 1e-6 ? flat / length : Vec3(0);
}

Vec3 front_of(const JointMoment& student) {
  const Vec3 left = level(student.at(LeftHip) - student.at(RightHip)) +
                    level(student.at(LeftShoulder) - student.at(RightShoulder)) +
                    level(student.at(LeftAnkle) - student.at(RightAnkle));
  return glm::cross(level(left), Vec3(0, 1, 0));
}

double yaw_of(const Vec3& from, const Vec3& to) {
  return std::atan2(from.z * to.x - from.x * to.z, from.x * to.x + from.z * to.z);
}

}  // namespace

bool has_hands_down(const JointMoment& student) {
  return student.middle(LeftWrist, RightWrist).y <
         0.5 * (student.middle(LeftShoulder, RightShoulder).y + student.middle(LeftHip, RightHip).y);
}

JointMoment joint_moment(std::span<const Vec3, kLandmarkBodyJointCount> positions,
                         std::span<const double, kLandmarkBodyJointCount> confidence) {
  JointMoment moment;
  const auto joints = landmark_body_joints();
  for (std::size_t j = 0; j < kLandmarkBodyJointCount; ++j)
    if (joints[j].role) moment.set(*joints[j].role, positions[j], confidence[j]);
  return moment;
}

void GhostDriver::set_coach(std::shared_ptr<const PersonalCoach> coach) {
  coach_ = std::move(coach);
  follow_.reset();
  if (coach_) follow_.emplace(coach_->track, coach_->stroke);
}

void GhostDriver::set_pace(Pace pace, double speed) {
  if (pace != pace_) played_s_ = 0;
  pace_ = pace;
  speed_ = speed;
}

void GhostDriver::reset() {
  if (follow_) follow_->start_over();
  played_s_ = 0;
  last_time_.reset();
  feet_.reset();
  front_ = Vec3(0);
}

std::optional<Ghost> GhostDriver::step(MediaTime time, const JointMoment& student, const Sight& sight,
                                       const HandSpeed& hands) {
  place(time, student, hands);
  std::optional<Ghost> ghost;
  if (coach_) {
    ghost = ghost_at(coach_time(time, student, sight));
    add_closeness(*ghost, student, sight);
  }
  last_time_ = time;
  return ghost;
}

void GhostDriver::place(MediaTime time, const JointMoment& student, const HandSpeed& hands) {
  const Vec3 feet = student.middle(LeftAnkle, RightAnkle), front = front_of(student);
  if (!feet_ || glm::distance(feet, *feet_) > kWalked_m) {
    feet_ = feet;
    front_ = front;
    return;
  }
  if (hands.hands() > kQuietHands || !has_hands_down(student)) return;
  const double seconds = last_time_ ? std::max(0.0, to_seconds(time - *last_time_)) : 0.0;
  *feet_ += (feet - *feet_) * (1 - std::exp(-seconds / kFeetSteadied_s));
  front_ += (front - front_) * (1 - std::exp(-seconds / kFrontSteadied_s));
}

double GhostDriver::coach_time(MediaTime time, const JointMoment& student, const Sight& sight) {
  if (pace_ == Pace::Play) return play(time);
  return follow_->step(time, student, yaw(), sight);
}

double GhostDriver::yaw() const {
  return coach_->is_flat ? 0.0 : yaw_of(coach_->axes.front, front_);
}

double GhostDriver::play(MediaTime time) {
  if (last_time_) played_s_ += speed_ * std::max(0.0, to_seconds(time - *last_time_));
  const double length = coach_->stroke.end_s - coach_->stroke.begin_s;
  played_s_ = std::fmod(played_s_, kPauseBefore_s + length + kPauseAfter_s);
  return coach_->stroke.begin_s + std::clamp(played_s_ - kPauseBefore_s, 0.0, length);
}

Ghost GhostDriver::ghost_at(double coach_time_s) const {
  Ghost ghost;
  ghost.body.skeleton = coach_->body;
  for (const Vec3& p : coach_->positions(coach_time_s))
    ghost.body.positions.push_back(turned(p - coach_->feet, yaw()) + *feet_);
  ghost.body.confidence = coach_->confidence(coach_time_s);
  ghost.coach_frame = coach_->track.nearest_frame(coach_time_s);
  const double duration = coach_->track.duration();
  ghost.fraction = duration > 0 ? std::clamp(coach_time_s / duration, 0.0, 1.0) : 0.0;
  return ghost;
}

void GhostDriver::add_closeness(Ghost& ghost, const JointMoment& student, const Sight& sight) const {
  const Skeleton& body = *ghost.body.skeleton;
  const int wrist = body.find(LeftWrist);
  const double forearm = std::max(0.1, wrist == kNoJoint ? 0.25 : body.bone_length(wrist));
  for (const HumanoidJoint joint : kHumanoidJoints) {
    const int j = body.find(joint);
    const bool is_known = j != kNoJoint && student.confidence(joint) >= kLeastConfidence &&
                          ghost.body.confidence[static_cast<std::size_t>(j)] >= kLeastConfidence;
    const double apart =
        is_known
            ? glm::length(sight.seen(student.at(joint) - ghost.body.positions[static_cast<std::size_t>(j)]))
            : 0;
    ghost.closeness[static_cast<std::size_t>(joint)] = is_known ? std::max(0.0, 1 - apart / forearm) : -1.0;
  }
}

}  // namespace posecoach
