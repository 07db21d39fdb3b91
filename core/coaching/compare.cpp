#include "core/coaching/compare.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/coaching/alignment.h"
#include "core/coaching/body_axes.h"
#include "core/coaching/film_gaps.h"
#include "core/coaching/film_habits.h"
#include "core/coaching/metrics.h"
#include "core/coaching/pose_alignment.h"
#include "core/coaching/score.h"
#include "core/coaching/spatial_advice.h"
#include "core/coaching/text/advice_text.h"
#include "core/coaching/text/refusal_text.h"
#include "core/coaching/timing_advice.h"

namespace posecoach {
namespace {

constexpr std::size_t kMostAdvice = 3;
constexpr double kWorstFramesApart_s = 0.1;
// The coach's window begins with his address.
constexpr double kAddress_s = 0.1;
// Below this score the coach's motion was not found in a film without events: it shows something else.
constexpr double kLeastPercentWithoutEvents = 40;

// A motion as a right-hander's, with its events; or why there are none.
struct Side {
  JointTrack track;
  Handedness hand = Handedness::Right;
  std::optional<SwingEvents> events;
  Error reason = {};
  Sight sight;
};

Result<Side> make_side(const Motion& motion, std::optional<Handedness> hand, const Sight& sight) {
  Result<JointTrack> track = JointTrack::from_motion(motion);
  if (!track) return tl::unexpected(track.error());
  Side side{*std::move(track), hand.value_or(Handedness::Right), std::nullopt, {}, sight};
  Result<SwingEvents> events = find_swing_events(side.track, {hand, sight});
  if (events) side.hand = events->hand;
  if (side.hand == Handedness::Left) {
    side.track = side.track.mirrored();
    if (sight.direction) side.sight.direction = mirrored(*sight.direction);
    events = find_swing_events(side.track, {Handedness::Right, side.sight});
  }
  if (events)
    side.events = *std::move(events);
  else
    side.reason = events.error();
  return side;
}

// Whether the moved events are there now.
bool move_events(Side& side, const std::vector<MovedEvent>& moved) {
  if (!side.events || moved.empty()) return false;
  std::optional<SwingEvents> put = with_moved(*side.events, moved, side.track);
  if (put) side.events = *std::move(put);
  return put.has_value();
}

TimeWindow stroke_window(const SwingEvents& events) {
  return {events.events.front().time_s, events.events.back().time_s};
}

void mirror_names(Analysis& analysis) {
  const auto mirror = [](std::string& joint) {
    if (const auto role = humanoid_joint_from_string(joint)) joint = to_string(mirrored(*role));
  };
  for (JointError& error : analysis.joint_errors) mirror(error.joint);
  for (SpatialAdvice& advice : analysis.spatial) {
    mirror(advice.joint);
    advice.offset_m.x = -advice.offset_m.x;
  }
  const auto mirror_gaps = [&](std::vector<JointGap>& gaps) {
    for (JointGap& gap : gaps) {
      mirror(gap.joint);
      gap.offset_m.x = -gap.offset_m.x;
    }
  };
  for (PoseMatch& match : analysis.poses) mirror_gaps(match.joints);
  for (FramePair& pair : analysis.worst_frames) mirror_gaps(pair.joints);
}

// The transition is part of the downswing: one of the two is told, the transition only when the time was lost
// there. A downswing that is quick throughout has a transition that is as quick.
bool is_told_by_another(const TimingResult& timing, std::size_t k) {
  constexpr double kTransitionIsCause = 1.4;
  const auto find = [&](std::string_view to) {
    return std::find_if(timing.phases.begin(), timing.phases.end(),
                        [&](const TimingAdvice& phase) { return phase.from == "top" && phase.to == to; });
  };
  const auto transition = find("mid_downswing"), downswing = find("impact");
  if (transition == timing.phases.end() || downswing == timing.phases.end()) return false;
  const double in_transition = std::log(transition->ratio / timing.pace),
               in_downswing = std::log(downswing->ratio / timing.pace);
  const bool is_cause = timing.severity[static_cast<std::size_t>(transition - timing.phases.begin())] >= 1 &&
                        in_transition * in_downswing > 0 &&
                        std::abs(in_transition) >= kTransitionIsCause * std::abs(in_downswing);
  return timing.phases[k].from == "top" && (timing.phases[k].to == "impact") == is_cause;
}

std::vector<Advice> most_important(const Analysis& analysis, const TimingResult& timing, const Side& student,
                                   const Side& coach) {
  std::vector<Advice> all;
  for (std::size_t k = 0; k < timing.phases.size(); ++k) {
    const TimingAdvice& phase = timing.phases[k];
    if (timing.severity[k] < 1 || is_told_by_another(timing, k)) continue;
    all.push_back({AdviceKind::Timing, phase.advice,
                   student.track.nearest_frame(student.events->time_of(phase.to)),
                   coach.track.nearest_frame(coach.events->time_of(phase.to)), timing.severity[k],
                   phase.fault, std::string(phase_name(phase.from, phase.to)), phase.to, phase.ratio - 1});
  }
  for (const SpatialAdvice& spatial : analysis.spatial)
    all.push_back({AdviceKind::Spatial, spatial.advice, spatial.student_frame, spatial.coach_frame,
                   spatial.severity, spatial.fault, spatial.measure, spatial.event, spatial.amount});
  std::stable_sort(all.begin(), all.end(),
                   [](const Advice& a, const Advice& b) { return a.severity > b.severity; });
  if (all.size() > kMostAdvice) all.resize(kMostAdvice);
  if (all.empty() && !analysis.path.empty())
    all.push_back({AdviceKind::None,
                   text::no_clear_difference(analysis.score.percent),
                   analysis.path.front().first,
                   analysis.path.front().second,
                   0,
                   {},
                   {},
                   {},
                   0});
  return all;
}

// What the camera saw, by where it truly stood, as the coach, turned to face as the student does, tells it.
std::optional<FilmGaps> film_gaps(const Alignment& alignment, const SwingEvents& coach,
                                  const Viewpoints& views) {
  if (!alignment.sight.direction) return std::nullopt;
  const double begin_s = alignment.coach.time(0);
  const BodyAxes axes = body_axes(alignment.coach, begin_s, begin_s + kAddress_s);
  UsualFilmError usual_error(coach.kind, camera_deg_of(*alignment.sight.direction, axes.left, axes.front));
  if (is_one_camera(views.coach)) usual_error = usual_error.between_films(is_filmed_alike(views));
  return FilmGaps(alignment, FilmStages(coach), axes, std::max(leg_length(alignment.student), 0.1),
                  usual_error);
}

StageGaps stage_gaps(const FilmGaps& film) {
  StageGaps gaps{film.sight(), {}};
  for (int stage = 0; stage < film.stages(); ++stage)
    for (std::size_t k = 0; k < film.joints().size(); ++k)
      gaps.gaps.push_back({std::string(to_string(film.joints()[k])), stage, film.seen(stage, k)});
  return gaps;
}

void add_aligned(Analysis& analysis, const Alignment& alignment, const JointTrack& student,
                 const JointTrack& coach, const std::optional<FilmGaps>& film) {
  analysis.score = score_of(alignment, film);
  analysis.score.groups = group_scores_of(alignment, film);
  if (film) analysis.stage_gaps = stage_gaps(*film);
  analysis.path = alignment.path;
  analysis.path_error_m = alignment.path_error_m;
  analysis.joint_errors = joint_errors_of(alignment);
  analysis.worst_frames = worst_frames_of(alignment, student, kWorstFramesApart_s);
  for (FramePair& pair : analysis.worst_frames)
    pair.joints = joints_apart(alignment, student.time(pair.student_frame), coach.time(pair.coach_frame));
}

void add_strokes(Analysis& analysis, const Side& student, const Side& coach, const Alignment& alignment,
                 const std::optional<FilmGaps>& film, const CompareOptions& options) {
  const Viewpoint view = options.views.student;
  const JointTrack turned_coach =
      coach.track.mapped([&](const Vec3& p) { return turned(p, alignment.coach_yaw); });
  std::optional<JointTrack> himself;
  if (options.coach_himself != nullptr)
    if (Result<JointTrack> track = JointTrack::from_motion(*options.coach_himself))
      himself = coach.hand == Handedness::Left ? track->mirrored() : *std::move(track);
  const ComparedSwings swings{
      student.track, *student.events, turned_coach,       *coach.events,
      options.views, student.sight,   options.strictness, himself ? &*himself : nullptr};
  analysis.student_events = student.events->events;
  analysis.student_takeaway_s = student.events->takeaway_s;
  TimingResult timing = find_timing_advice(swings, alignment);
  if (const std::string seen = text::seen_from(view, student.events->kind); !seen.empty())
    analysis.notes.push_back(seen);
  if (is_one_camera(options.views.coach) && !is_filmed_alike(options.views))
    analysis.notes.push_back(text::coach_seen_elsewhere());
  if (timing.in_proportion) analysis.notes.push_back(text::other_pace(timing.pace, is_one_camera(view)));
  analysis.spatial = find_spatial_advice(swings, kMostAdvice);
  analysis.poses = match_poses(swings, alignment);
  analysis.score.phases = phase_scores_of(alignment, *student.events, film);
  if (const std::string words = options.strictness.words(); !words.empty()) analysis.notes.push_back(words);
  analysis.metrics = measure_swing(swings);
  analysis.advice = most_important(analysis, timing, student, coach);
  analysis.timing = std::move(timing.phases);
}

}  // namespace

Result<Analysis> compare(const Motion& student_motion, const Motion& coach_motion,
                         const CompareOptions& options) {
  Result<Side> student = make_side(student_motion, options.hand, options.sight);
  if (!student) return fail(student.error().code, options.student_name + ": " + student.error().message);
  Result<Side> coach = make_side(coach_motion, std::nullopt, options.coach_sight);
  if (!coach) return fail(coach.error().code, options.coach_name + ": " + coach.error().message);
  if (!coach->events) return fail(ErrorCode::Incomplete, options.coach_name + ": " + coach->reason.message);
  if (student->reason.code == ErrorCode::Unsupported)
    return fail(ErrorCode::Unsupported, options.student_name + ": " + student->reason.message);
  if (student->events && student->events->kind != coach->events->kind)
    return fail(ErrorCode::Incomplete,
                text::strokes_differ(options.student_name, student->events->kind, options.coach_name));
  const bool is_moved = move_events(*student, options.moved_events);
  const TimeWindow coach_window = stroke_window(*coach->events);
  const Alignment alignment =
      student->events
          ? align(student->track, coach->track, stroke_window(*student->events), coach_window, student->sight)
          : align_anywhere(student->track, coach->track, coach_window, student->sight);
  if (student->events) {
    const double pace = pace_of(*student->events, *coach->events);
    const double answered_top_s = alignment.student_time(coach->events->time_of("top"));
    student->events = events_put_right(*student->events, student->track, options.views.student,
                                       student->sight, pace, answered_top_s);
    coach->events =
        events_put_right(*coach->events, coach->track, options.views.coach, coach->sight, 1 / pace);
  }
  if (is_moved) (void)move_events(*student, options.moved_events);
  Analysis analysis;
  if (!options.moved_events.empty()) analysis.notes.push_back(text::moved_by_hand(is_moved));
  analysis.stroke = to_string(coach->events->kind);
  analysis.coach.frames = coach_motion.frame_count();
  analysis.coach.seconds = to_seconds(coach_motion.duration());
  analysis.coach.joints = coach_motion.joint_count();
  analysis.coach.hand = coach->hand;
  analysis.student.frames = student_motion.frame_count();
  analysis.student.seconds = to_seconds(student_motion.duration());
  analysis.student.joints = student_motion.joint_count();
  analysis.student.hand = student->hand;
  analysis.coach_events = coach->events->events;
  analysis.coach_takeaway_s = coach->events->takeaway_s;
  analysis.coach_yaw = student->hand == Handedness::Left ? -alignment.coach_yaw : alignment.coach_yaw;
  const std::optional<FilmGaps> film = film_gaps(alignment, *coach->events, options.views);
  add_aligned(analysis, alignment, student->track, coach->track, film);
  if (student->events) {
    add_strokes(analysis, *student, *coach, alignment, film, options);
  } else if (analysis.score.percent < kLeastPercentWithoutEvents) {
    return fail(ErrorCode::Incomplete, options.student_name + ": " + student->reason.message);
  } else {
    analysis.notes.push_back(text::only_the_score(student->reason.message));
    analysis.advice = most_important(analysis, {}, *student, *coach);
  }
  if (student->hand == Handedness::Left) mirror_names(analysis);
  return analysis;
}

}  // namespace posecoach
