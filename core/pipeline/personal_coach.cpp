#include "core/pipeline/personal_coach.h"

#include <algorithm>
#include <cmath>

#include "core/coaching/posture.h"

namespace posecoach {
namespace {

constexpr double kAddress_s = 0.2;

std::optional<SwingEvents> stroke_of(const Motion& motion) {
  const Result<JointTrack> track = JointTrack::from_motion(motion);
  if (!track) return std::nullopt;
  Result<SwingEvents> events = find_swing_events(*track);
  return events ? std::optional(*std::move(events)) : std::nullopt;
}

Result<PersonalCoach> personal_coach(Motion motion, const std::optional<SwingEvents>& events) {
  Result<JointTrack> track = JointTrack::from_motion(motion);
  if (!track) return tl::unexpected(track.error());
  const TimeWindow stroke = events ? TimeWindow{events->events.front().time_s, events->events.back().time_s}
                                   : TimeWindow{0, track->duration()};
  PersonalCoach made{std::move(motion), nullptr, *std::move(track), stroke, {}, {}, {}};
  made.body = std::make_shared<const Skeleton>(made.motion.skeleton());
  if (events) made.kind = events->kind;
  const JointTrack address = made.address();
  made.feet = middle_of(address, 0, HumanoidJoint::LeftAnkle, HumanoidJoint::RightAnkle);
  made.axes = body_axes(address, 0, 0);
  return made;
}

}  // namespace

std::vector<Vec3> PersonalCoach::positions(double time_s) const {
  const double frame = std::clamp(track.fractional_frame(time_s), 0.0, motion.frame_count() - 1.0);
  const int before = std::min(static_cast<int>(frame), std::max(0, motion.frame_count() - 2));
  const int after = std::min(before + 1, motion.frame_count() - 1);
  std::vector<Vec3> result;
  for (int j = 0; j < motion.joint_count(); ++j)
    result.push_back(glm::mix(motion.position(before, j), motion.position(after, j), frame - before));
  return result;
}

std::vector<double> PersonalCoach::confidence(double time_s) const {
  std::vector<double> result(static_cast<std::size_t>(motion.joint_count()), 1.0);
  const int frame = track.nearest_frame(time_s);
  for (int j = 0; is_flat && j < motion.joint_count(); ++j)
    result[static_cast<std::size_t>(j)] = motion.confidence(frame, j);
  return result;
}

JointTrack PersonalCoach::address() const {
  return track.averaged(stroke.begin_s - kAddress_s, stroke.begin_s);
}

Result<PersonalCoach> personal_coach_from(Motion motion) {
  const std::optional<SwingEvents> events = stroke_of(motion);
  return personal_coach(std::move(motion), events);
}

Result<PersonalCoach> make_personal_coach(const Motion& coach, const Skeleton& body, Handedness hand,
                                          const RetargetOptions& options) {
  const std::optional<SwingEvents> events = stroke_of(coach);
  const Handedness coach_hand = events ? events->hand : Handedness::Right;
  // Personalised right-handed, as the analysis does it.
  const Motion right_coach = coach_hand == Handedness::Left ? mirrored(coach) : coach;
  const bool is_left = hand == Handedness::Left;
  const Skeleton right_body = is_left ? mirrored(body) : body;
  Result<Motion> personal(right_coach);
  if (!(right_coach.skeleton() == right_body)) {
    Result<RetargetResult> carried = retarget(right_coach, right_body, options);
    if (!carried) return tl::unexpected(carried.error());
    personal = std::move(carried->motion);
  }
  return personal_coach(is_left ? mirrored(*personal) : *std::move(personal), events);
}

}  // namespace posecoach
