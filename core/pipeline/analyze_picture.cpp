#include "core/pipeline/analyze_picture.h"

#include <algorithm>
#include <cmath>

#include "core/coaching/body_axes.h"
#include "core/coaching/joint_track.h"
#include "core/coaching/score.h"
#include "core/coaching/text/picture_text.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr std::array kCompared = {Head,       LeftShoulder, RightShoulder, LeftElbow, RightElbow, LeftWrist,
                                  RightWrist, LeftKnee,     RightKnee,     LeftAnkle, RightAnkle};
constexpr double kWorthTelling_m = 0.05;
constexpr std::size_t kMostAdvice = 3;
constexpr double kSeen = 0.5;
// With fewer joints of both than this, poses cannot be told apart.
constexpr int kFewestJoints = 6;
// In leg lengths: the film shows nothing like the picture.
constexpr double kUnlike = 0.25;

// Distances across the view of a camera that looks along `forward`.
struct PictureAxes {
  Vec3 right, up, forward;

  explicit PictureAxes(const std::optional<Vec3>& sight) : forward(sight.value_or(Vec3{0, 0, -1})) {
    right = glm::normalize(glm::cross(forward, Vec3{0, 1, 0}));
    up = glm::cross(right, forward);
  }
  Vec3 across(const Vec3& v) const { return v - glm::dot(v, forward) * forward; }
};

// Student minus coach with both pelvises in one place, across the view; nothing where one was not seen.
std::optional<Vec3> offset_of(const JointTrack& student, int frame, const JointTrack& coach,
                              HumanoidJoint joint, const PictureAxes& axes) {
  if (!student.has(joint) || !coach.has(joint)) return std::nullopt;
  if (student.confidence(frame, joint) < kSeen || coach.confidence(0, joint) < kSeen) return std::nullopt;
  return axes.across((student.position(frame, joint) - student.position(frame, Pelvis)) -
                     (coach.position(0, joint) - coach.position(0, Pelvis)));
}

struct Likeness {
  double mean_m = 0;
  int joints = 0;
};
Likeness likeness(const JointTrack& student, int frame, const JointTrack& coach, const PictureAxes& axes) {
  Likeness result;
  for (const HumanoidJoint joint : kCompared)
    if (const std::optional<Vec3> offset = offset_of(student, frame, coach, joint, axes)) {
      result.mean_m += glm::length(*offset);
      ++result.joints;
    }
  if (result.joints > 0) result.mean_m /= result.joints;
  return result;
}

std::vector<SpatialAdvice> spatial_advice(const JointTrack& student, int frame, const JointTrack& coach,
                                          const PictureAxes& axes, const Likeness& whole) {
  const BodyAxes facing = body_axes(student, student.time(frame), student.time(frame));
  std::vector<SpatialAdvice> all;
  for (const HumanoidJoint joint : kCompared) {
    const std::optional<Vec3> offset = offset_of(student, frame, coach, joint, axes);
    if (!offset || glm::length(*offset) < kWorthTelling_m) continue;
    SpatialAdvice advice;
    advice.joint = to_string(joint);
    advice.event = "picture";
    advice.student_frame = frame;
    advice.offset_m = in_axes(facing, *offset);
    advice.distance_m = glm::length(*offset);
    advice.advice = text::picture_offset(joint, glm::dot(*offset, axes.right), glm::dot(*offset, axes.up));
    advice.share = advice.distance_m / (whole.mean_m * whole.joints);
    advice.severity = advice.distance_m / kWorthTelling_m;
    all.push_back(std::move(advice));
  }
  std::stable_sort(all.begin(), all.end(), [](const SpatialAdvice& a, const SpatialAdvice& b) {
    return a.distance_m > b.distance_m;
  });
  if (all.size() > kMostAdvice) all.resize(kMostAdvice);
  return all;
}

std::vector<Advice> advice_from(const std::vector<SpatialAdvice>& spatial, int frame) {
  std::vector<Advice> all;
  for (const SpatialAdvice& one : spatial)
    all.push_back({AdviceKind::Spatial, one.advice, frame, 0, one.severity});
  if (all.empty()) all.push_back({AdviceKind::None, text::no_picture_difference(), frame, 0, 0});
  return all;
}

}  // namespace

Result<AnalyzedPair> analyze_picture(const StudentInput& student, const CoachInput& coach) {
  const Result<JointTrack> his = JointTrack::from_motion(student.motion),
                           picture = JointTrack::from_motion(coach.motion);
  if (!his) return fail(his.error().code, student.source + ": " + his.error().message);
  if (!picture) return fail(picture.error().code, coach.source + ": " + picture.error().message);
  const PictureAxes axes(student.sight.direction);
  int best = -1;
  Likeness most_alike;
  for (int frame = 0; frame < his->frame_count(); ++frame) {
    const Likeness here = likeness(*his, frame, *picture, axes);
    if (here.joints < kFewestJoints || (best >= 0 && here.mean_m >= most_alike.mean_m)) continue;
    best = frame;
    most_alike = here;
  }
  if (best < 0) return fail(ErrorCode::Incomplete, text::never_seen_together(student.source, coach.source));
  Analysis analysis;
  const int film_frame = best + student.first_frame;
  analysis.coach = {coach.source, 1, 0, coach.motion.joint_count(), std::nullopt};
  analysis.student = {student.source, student.frames, student.seconds, student.joints, std::nullopt};
  analysis.path = {{film_frame, 0}};
  analysis.path_error_m = {most_alike.mean_m};
  analysis.worst_frames = {{film_frame, 0, most_alike.mean_m}};
  const double leg = leg_length(*his);
  analysis.score = {most_alike.mean_m * most_alike.joints, most_alike.mean_m,
                    percent_from_error(most_alike.mean_m, leg), 0, most_alike.joints};
  for (const HumanoidJoint joint : kCompared)
    if (const std::optional<Vec3> offset = offset_of(*his, best, *picture, joint, axes))
      analysis.joint_errors.push_back(
          {std::string(to_string(joint)), glm::length(*offset), glm::length(*offset)});
  std::stable_sort(analysis.joint_errors.begin(), analysis.joint_errors.end(),
                   [](const JointError& a, const JointError& b) { return a.mean_m > b.mean_m; });
  analysis.spatial = spatial_advice(*his, best, *picture, axes, most_alike);
  for (SpatialAdvice& advice : analysis.spatial) advice.student_frame = film_frame;
  analysis.advice = advice_from(analysis.spatial, film_frame);
  analysis.notes.push_back(text::picture_and_frame(film_frame));
  if (most_alike.mean_m > kUnlike * leg) analysis.notes.push_back(text::no_frame_like_the_picture());
  return AnalyzedPair{std::move(analysis), coach.motion};
}

}  // namespace posecoach
