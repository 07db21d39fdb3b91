#include "core/pipeline/analyze.h"

#include <algorithm>
#include <cmath>

#include "core/body/landmark_body.h"
#include "core/coaching/body_axes.h"
#include "core/coaching/compare.h"
#include "core/coaching/posture.h"
#include "core/coaching/text/advice_text.h"
#include "core/coaching/text/set_up_text.h"
#include "core/retarget/doubt.h"

namespace posecoach {
namespace {

// A grip that stays open by less is not worth a word.
constexpr double kReachWorthTelling_m = 0.01;
constexpr double kAddress_s = 0.2;

// Middle of the ankles over a short time before the stroke, and how low they are.
Vec3 feet_at_address(const JointTrack& track, double address_s) {
  Vec3 sum(0);
  const int first = track.nearest_frame(address_s - kAddress_s), last = track.nearest_frame(address_s);
  for (int frame = first; frame <= last; ++frame)
    sum += middle_of(track, frame, HumanoidJoint::LeftAnkle, HumanoidJoint::RightAnkle);
  return sum / static_cast<double>(last - first + 1);
}

Motion moved(const Motion& motion, double yaw, const Vec3& from, const Vec3& to) {
  const std::vector<MediaTime> times(motion.times().begin(), motion.times().end());
  std::vector<Vec3> positions;
  positions.reserve(static_cast<std::size_t>(motion.frame_count()) *
                    static_cast<std::size_t>(motion.joint_count()));
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    for (const Vec3& p : motion.positions(frame)) positions.push_back(turned(p - from, yaw) + to);
  return Motion::from_positions(motion.skeleton(), times, std::move(positions)).value();
}

Motion placed_on_student(const Motion& coach, const StudentInput& student, const Analysis& analysis) {
  const JointTrack coach_track = JointTrack::from_motion(coach).value();
  const JointTrack student_track = JointTrack::from_motion(student.motion).value();
  const auto& [student_frame, coach_frame] = analysis.path.front();
  return moved(coach, analysis.coach_yaw, feet_at_address(coach_track, coach_track.time(coach_frame)),
               feet_at_address(student_track, student_track.time(student_frame)));
}

void count_in_film_frames(Analysis& analysis, const StudentInput& student) {
  const auto shift = [&](int& frame) { frame += student.first_frame; };
  for (auto& [student_frame, coach_frame] : analysis.path) shift(student_frame);
  for (FramePair& pair : analysis.worst_frames) shift(pair.student_frame);
  for (SpatialAdvice& advice : analysis.spatial) shift(advice.student_frame);
  for (Advice& advice : analysis.advice) shift(advice.student_frame);
  for (PoseMatch& match : analysis.poses) shift(match.student_frame);
  for (SwingEvent& event : analysis.student_events) {
    shift(event.frame);
    event.time_s += student.first_time_s;
  }
  analysis.student_takeaway_s += student.first_time_s;
  analysis.student.frames = student.frames;
  analysis.student.seconds = student.seconds;
  analysis.student.joints = student.joints;
}

// Of a coach who was filmed himself: what lift() made of his film says from where, since its camera stands
// towards +Z.
struct Seen {
  Viewpoint view = Viewpoint::AllSides;
  Sight sight;
};

Seen seen_from(const Motion& coach) {
  if (!is_landmark_body(coach.skeleton()) || !is_seen_by_camera(coach)) return {};
  const Vec3 to_camera(0, 0, 1);
  Seen seen{Viewpoint::Between, {-to_camera}};
  const Result<JointTrack> track = JointTrack::from_motion(coach);
  if (!track) return seen;
  const Result<SwingEvents> events = find_swing_events(*track, {{}, seen.sight});
  if (!events) return seen;
  Vec3 front(0);
  const double address_s = events->time_of("address");
  for (int frame = track->nearest_frame(address_s - kAddress_s); frame <= track->nearest_frame(address_s);
       ++frame)
    front += facing_in(coach, frame);
  seen.view = judged_from(camera_side(front, to_camera));
  return seen;
}

// A coach who has the student's body already is compared as he is: nothing is carried over, so nothing needs
// mending.
Result<RetargetResult> in_body(const Motion& coach, const Skeleton& body, const RetargetOptions& options) {
  if (coach.skeleton() == body) return RetargetResult{coach, bone_length_error(coach), {}, {}};
  return retarget(coach, body, options);
}

// As geometry puts it on `body`, with the pose model's errors in it and nothing mended: what was filmed from
// one side alike is wrong alike.
Result<Motion> as_filmed(const Motion& motion, const Skeleton& body) {
  Result<RetargetResult> carried = retarget(motion, body, {RetargetMethod::Rotation, Contacts::Off});
  if (!carried) return tl::unexpected(carried.error());
  std::vector<Vec3> positions;
  std::vector<double> confidence;
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    for (int joint = 0; joint < body.size(); ++joint) {
      positions.push_back(carried->motion.position(frame, joint));
      confidence.push_back(motion.confidence(frame, joint));
    }
  return Motion::from_positions(body, {motion.times().begin(), motion.times().end()}, std::move(positions),
                                std::move(confidence));
}

struct Pair {
  Motion student, coach;
};

Result<Pair> pair_to_compare(const StudentInput& student, const Motion& coach, const Seen& seen,
                             const Motion& personal) {
  if (!is_filmed_alike({student.view, seen.view})) return Pair{student.motion, personal};
  Result<Motion> his = as_filmed(student.motion, student.body);
  if (!his) return tl::unexpected(his.error());
  Result<Motion> coachs = as_filmed(coach, personal.skeleton());
  if (!coachs) return tl::unexpected(coachs.error());
  return Pair{*std::move(his), *std::move(coachs)};
}

}  // namespace

// compare() says later, and better, why no stroke was found.
Handedness hand_of(const Motion& motion, const Sight& sight) {
  const Result<JointTrack> track = JointTrack::from_motion(motion);
  if (!track) return Handedness::Right;
  const Result<SwingEvents> events = find_swing_events(*track, {{}, sight});
  return events ? events->hand : Handedness::Right;
}

StudentInput student_from_motion(std::string source, const Motion& motion) {
  return {std::move(source),
          motion,
          motion.skeleton(),
          Viewpoint::AllSides,
          {},
          {},
          0,
          0,
          motion.frame_count(),
          to_seconds(motion.duration()),
          motion.joint_count()};
}

StudentInput student_from_film(std::string source, const PoseTrack& track, const LiftedStudent& lifted) {
  const MediaTime begin = track.frames.front().time;
  return {std::move(source),
          lifted.motion,
          lifted.body,
          judged_from(lifted.side()),
          {glm::normalize(Vec3(0, 0, 1) * lifted.camera.rotation_camera_from_world)},
          lifted.side(),
          lifted.first_frame,
          to_seconds(lifted.motion.time(0) - begin),
          static_cast<int>(track.frames.size()),
          to_seconds(track.frames.back().time - begin),
          static_cast<int>(kLandmarkCount)};
}

Result<AnalyzedPair> analyze(const StudentInput& student, const CoachInput& coach,
                             const AnalyzeOptions& options) {
  // Everything up to the drawing happens right-handed, so that a mirrored pair gives the same numbers.
  const Handedness hand = options.hand.value_or(hand_of(student.motion, student.sight));
  const bool is_left = hand == Handedness::Left;
  // A camera in front and one on the target line stand the same in the mirror.
  const Seen seen = seen_from(coach.motion);
  const Motion right_coach =
      hand_of(coach.motion, seen.sight) == Handedness::Left ? mirrored(coach.motion) : coach.motion;
  const Result<RetargetResult> personal =
      in_body(right_coach, is_left ? mirrored(student.body) : student.body, options.retarget);
  if (!personal) return fail(personal.error().code, coach.source + ": " + personal.error().message);
  std::vector<MovedEvent> moved = options.moved_events;
  for (MovedEvent& event : moved) event.frame -= student.first_frame;
  const Result<Pair> pair = pair_to_compare(student, right_coach, seen, personal->motion);
  if (!pair) return fail(pair.error().code, coach.source + ": " + pair.error().message);
  Result<Analysis> analysis = compare(pair->student, pair->coach,
                                      {.hand = hand,
                                       .views = {student.view, seen.view},
                                       .sight = student.sight,
                                       .coach_sight = seen.sight,
                                       .strictness = options.strictness,
                                       .coach_himself = &right_coach,
                                       .moved_events = std::move(moved),
                                       .student_name = student.source,
                                       .coach_name = coach.source});
  if (!analysis) return tl::unexpected(analysis.error());

  Motion drawn =
      placed_on_student(is_left ? mirrored(personal->motion) : personal->motion, student, *analysis);
  analysis->coach.source = coach.source;
  analysis->coach.joints = coach.motion.joint_count();
  analysis->student.source = student.source;
  analysis->retarget_method = to_string(options.retarget.method);
  analysis->bone_length_error_max = personal->bone_length_error_max;
  analysis->contacts = options.retarget.contacts == Contacts::On;
  analysis->grip_error_p95_m = personal->contacts.grip_error_p95_m;
  analysis->reach_deficit_max_m = personal->contacts.reach_deficit_max_m;
  if (analysis->reach_deficit_max_m > kReachWorthTelling_m)
    analysis->notes.push_back(text::out_of_reach(analysis->reach_deficit_max_m));
  if (student.camera && student.camera->view != View::Between && !student.camera->is_square())
    analysis->notes.push_back(
        text::camera_stood_aside(viewpoint_of(student.camera->view), student.camera->aside_deg));
  count_in_film_frames(*analysis, student);
  return AnalyzedPair{*std::move(analysis), std::move(drawn)};
}

}  // namespace posecoach
