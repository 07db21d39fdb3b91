#include "core/coaching/pose_alignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/coaching/body_axes.h"
#include "core/coaching/posture.h"
#include "core/coaching/text/advice_text.h"
#include "core/coaching/timing_advice.h"

namespace posecoach {
namespace {

// A pose this much early or late is told, or later by as much as the events are known.
constexpr double kClear_s = 0.06;
constexpr double kClearSigmas = 2;

// Of what a picture may mark.
constexpr double kWorthMarking_m = 0.05, kWorthMarkingOneCamera_m = 0.08;
constexpr std::size_t kMostMarked = 3;

enum class Limb { Head, Shoulders, LeftElbow, RightElbow, Hands, Hips, LeftKnee, RightKnee };
constexpr std::array kMarked = {
    std::pair(HumanoidJoint::Head, Limb::Head),
    std::pair(HumanoidJoint::LeftShoulder, Limb::Shoulders),
    std::pair(HumanoidJoint::RightShoulder, Limb::Shoulders),
    std::pair(HumanoidJoint::LeftElbow, Limb::LeftElbow),
    std::pair(HumanoidJoint::RightElbow, Limb::RightElbow),
    std::pair(HumanoidJoint::LeftWrist, Limb::Hands),
    std::pair(HumanoidJoint::RightWrist, Limb::Hands),
    std::pair(HumanoidJoint::LeftHip, Limb::Hips),
    std::pair(HumanoidJoint::RightHip, Limb::Hips),
    std::pair(HumanoidJoint::LeftKnee, Limb::LeftKnee),
    std::pair(HumanoidJoint::RightKnee, Limb::RightKnee),
};

Vec3 feet(const JointTrack& track, int frame) {
  return middle_of(track, frame, HumanoidJoint::LeftAnkle, HumanoidJoint::RightAnkle);
}

// Mean distance of the joints where the path passes a time of the coach.
double apart_at(const Alignment& alignment, double coach_s) {
  double best_off = 1e9, apart = 0;
  for (std::size_t k = 0; k < alignment.steps.size(); ++k) {
    const double off = std::abs(alignment.coach.time(alignment.steps[k].second) - coach_s);
    if (off >= best_off) continue;
    best_off = off;
    apart = alignment.step_error_m[k];
  }
  return apart;
}

}  // namespace

std::vector<JointGap> joints_apart(const Alignment& alignment, double student_s, double coach_s) {
  const JointTrack& student = alignment.student;
  const JointTrack& coach = alignment.coach;
  const int i = student.nearest_frame(student_s), j = coach.nearest_frame(coach_s);
  const Vec3 stance = feet(student, 0) - feet(coach, 0);
  const BodyAxes axes = body_axes(coach, coach.time(0), coach.time(0));
  const double least = alignment.sight.direction ? kWorthMarkingOneCamera_m : kWorthMarking_m;
  std::vector<std::pair<JointGap, Limb>> found;
  for (const auto& [joint, limb] : kMarked) {
    if (!student.has(joint) || !coach.has(joint)) continue;
    const Vec3 apart = alignment.sight.seen(student.position(i, joint) - coach.position(j, joint) - stance);
    if (glm::length(apart) < least) continue;
    found.push_back({{std::string(to_string(joint)), in_axes(axes, apart), glm::length(apart)}, limb});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first.distance_m > b.first.distance_m; });
  std::vector<JointGap> gaps;
  std::vector<Limb> told;
  for (auto& [gap, limb] : found) {
    if (gaps.size() == kMostMarked || std::find(told.begin(), told.end(), limb) != told.end()) continue;
    told.push_back(limb);
    gaps.push_back(std::move(gap));
  }
  return gaps;
}

std::vector<PoseMatch> match_poses(const ComparedSwings& swings, const Alignment& alignment) {
  std::vector<PoseMatch> matches;
  const double student_start = swings.student_events.takeaway_s, coach_start = swings.coach_events.takeaway_s;
  const double pace = pace_of(swings.student_events, swings.coach_events);
  const auto off_s = [&](std::string_view event) {
    return event_uncertainty_s(swings.student, swings.views.student, swings.student_events.kind, event,
                               pace_of(swings.student_events, swings.coach_events));
  };
  const double clear = std::max(pace * kClear_s, kClearSigmas * std::hypot(off_s("takeaway"), off_s("top")));
  // The golfer's own moment of that name must be late, too; of a film, when the hands begin and come to rest
  // is not known well enough.
  const auto is_clear = [&](const SwingEvent& event, double late_s) {
    const bool is_end = event.name == "address" || event.name == "finish" || event.name == "end";
    if (is_one_camera(swings.views) && is_end) return false;
    const double own_s =
        swings.student_events.time_of(event.name) - student_start - pace * (event.time_s - coach_start);
    return std::abs(late_s) >= clear && std::abs(own_s) >= clear && own_s * late_s > 0;
  };
  for (const SwingEvent& event : swings.coach_events.events) {
    PoseMatch match;
    match.event = event.name;
    const double student_s = alignment.student_time(event.time_s);
    match.student_frame = swings.student.nearest_frame(student_s);
    match.coach_frame = event.frame;
    match.student_s = student_s - student_start;
    match.coach_s = event.time_s - coach_start;
    match.late_s = match.student_s - pace * match.coach_s;
    match.apart_m = apart_at(alignment, event.time_s);
    match.joints = joints_apart(alignment, student_s, event.time_s);
    match.advice = text::pose_match(event.name, match.late_s, is_clear(event, match.late_s));
    matches.push_back(std::move(match));
  }
  return matches;
}

}  // namespace posecoach
