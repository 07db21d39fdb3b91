#include "app/evaluate/live_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "core/body/named_body.h"
#include "core/motion/bundled_motion.h"
#include "core/pipeline/coach_pipeline.h"

namespace posecoach {
namespace {

constexpr double kStanding_s = 5, kHolding_s = 1.5, kLeaving_s = 1.5;
// What still moves in the pose stage's answers when nobody does.
constexpr double kTremble_px = 0.15, kTremble_m = 0.0007;
constexpr double kBeforeAddress_s = 0.1;
constexpr int kWaggles = 4;
// Of the backswing, and how much faster than it.
constexpr double kWaggle = 0.6, kWaggleQuicker = 2;

class RememberedPoses : public PoseEstimator {
 public:
  explicit RememberedPoses(FilmedStudents::Looks all) : all_(std::move(all)) {}
  Result<PoseObservation> estimate(const Frame& frame) override {
    now_ = frame.index;
    return all_.smoothed.frames[now_];
  }
  std::optional<SeenPerson> unsmoothed() const override { return all_.unsmoothed.frames[now_].person; }
  void reset() override {}

 private:
  FilmedStudents::Looks all_;
  std::size_t now_ = 0;
};

// Frames of a film in another order, with what trembles while nobody moves.
class Scene {
 public:
  Scene(const FilmedStudents::Looks& film, double fps) : film_(film), fps_(fps) {
    looks_.smoothed.width = looks_.unsmoothed.width = film.smoothed.width;
    looks_.smoothed.height = looks_.unsmoothed.height = film.smoothed.height;
  }

  void hold(std::size_t frame, double seconds) {
    for (int f = 0; f < seconds * fps_; ++f) {
      add(film_.smoothed.frames[frame].person, film_.unsmoothed.frames[frame].person);
      tremble(looks_.smoothed.frames.back());
      tremble(looks_.unsmoothed.frames.back());
    }
  }
  void play(std::size_t frame) {
    add(film_.smoothed.frames[frame].person, film_.unsmoothed.frames[frame].person);
  }
  void play_from(std::size_t first) {
    for (std::size_t f = first; f < film_.smoothed.frames.size(); ++f) play(f);
  }
  // Moved as a whole by so many pixels and metres: who walks is somewhere else in every frame.
  void play_aside(std::size_t frame, double px, double m) {
    play(frame);
    for (PoseTrack* track : {&looks_.smoothed, &looks_.unsmoothed}) {
      std::optional<SeenPerson>& person = track->frames.back().person;
      for (std::size_t i = 0; person && i < kLandmarkCount; ++i) {
        // The hips stay the middle of the world's joints; feet and hands swing about them.
        const double swing = std::sin(3.5 * static_cast<double>(looks_.smoothed.frames.size()) / fps_ +
                                      (i % 2 == 0 ? 0 : kPi));
        const bool is_leg = i >= 25, is_arm = i >= 13 && i < 23;
        person->image[i].position_px.x += px + (is_leg ? 0.1 : is_arm ? 0.06 : 0) * swing * std::abs(px);
        person->world[i].position_m.x += (is_leg ? 0.15 : is_arm ? 0.1 : 0) * swing * m;
      }
    }
  }
  void nobody(double seconds) {
    for (int f = 0; f < seconds * fps_; ++f) add(std::nullopt, std::nullopt);
  }

  const FilmedStudents::Looks& looks() const { return looks_; }

 private:
  void add(std::optional<SeenPerson> smoothed, std::optional<SeenPerson> unsmoothed) {
    const std::size_t index = looks_.smoothed.frames.size();
    const MediaTime time = media_time_from_seconds(static_cast<double>(index) / fps_);
    looks_.smoothed.frames.push_back({index, time, std::move(smoothed)});
    looks_.unsmoothed.frames.push_back({index, time, std::move(unsmoothed)});
  }
  void tremble(PoseObservation& frame) {
    for (std::size_t i = 0; frame.person && i < kLandmarkCount; ++i) {
      frame.person->image[i].position_px += kTremble_px * Vec2(normal_(random_), normal_(random_));
      frame.person->world[i].position_m +=
          kTremble_m * Vec3(normal_(random_), normal_(random_), normal_(random_));
    }
  }

  const FilmedStudents::Looks& film_;
  double fps_;
  FilmedStudents::Looks looks_;
  std::mt19937 random_{7};
  std::normal_distribution<double> normal_;
};

// Stands at address, plays the stroke, holds its end, and is gone.
FilmedStudents::Looks stroke_scene(const FilmedStudents::Looks& film, double fps, std::size_t still) {
  Scene scene(film, fps);
  scene.hold(still, kStanding_s);
  scene.play_from(still);
  scene.hold(film.smoothed.frames.size() - 1, kHolding_s);
  scene.nobody(kLeaving_s);
  return scene.looks();
}

// Steps up to the ball, stands, waggles, stands, and steps away: no stroke.
FilmedStudents::Looks idle_scene(const FilmedStudents::Looks& film, double fps, std::size_t still,
                                 double takeaway_s, double top_s) {
  Scene scene(film, fps);
  const double stepping_s = 2;
  const int steps = static_cast<int>(stepping_s * fps);
  for (int f = steps; f > 0; --f) scene.play_aside(still, 150.0 * f / steps, 1.0 * f / steps);
  scene.hold(still, kStanding_s);
  const auto at = [fps](double time_s) { return static_cast<std::size_t>(std::lround(time_s * fps)); };
  const double waggle_s = kWaggle * (top_s - takeaway_s);
  for (int waggle = 0; waggle < kWaggles; ++waggle) {
    for (double t = 0; t < 2 * waggle_s; t += kWaggleQuicker / fps)
      scene.play(at(takeaway_s + (t < waggle_s ? t : 2 * waggle_s - t)));
    scene.hold(still, 0.3);
  }
  scene.hold(still, kStanding_s);
  for (int f = 0; f < steps; ++f) scene.play_aside(still, 150.0 * f / steps, 1.0 * f / steps);
  scene.nobody(kLeaving_s);
  return scene.looks();
}

// The coach's time that answers the student's, from event to event.
double same_moment(double time_s, const AuthoredMotion& student, const AuthoredMotion& coach) {
  for (std::size_t k = 1; k < student.events.size(); ++k) {
    const double begin = student.events[k - 1].time_s, end = student.events[k].time_s;
    if (time_s > end) continue;
    const double part = end > begin ? (time_s - begin) / (end - begin) : 1;
    return coach.events[k - 1].time_s + part * (coach.events[k].time_s - coach.events[k - 1].time_s);
  }
  return coach.events.back().time_s;
}

double at_part(std::vector<double>& values, double part) {
  std::sort(values.begin(), values.end());
  return values.empty() ? -1
                        : values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

// A coach, and a loop that sees a scene.
struct Stage {
  InlineWork work;
  CoachPipeline pipeline;

  Stage(const FilmedStudents::Looks& scene, const Motion& coach, const LiveCase& one)
      : pipeline(std::make_unique<RememberedPoses>(scene), work) {
    pipeline.set_coach(coach, "bundled:" + one.motion);
    // As chosen in the set-up.
    pipeline.set_person({.hand = one.hand == "left" ? Handedness::Left : Handedness::Right});
    pipeline.arm();
  }
};

// Nobody looks at it.
std::shared_ptr<const Image> empty_picture(const FilmedStudents::Looks& scene) {
  return std::make_shared<const Image>(Image::black(scene.smoothed.width, scene.smoothed.height));
}

Result<void> watch_stroke(const LiveCase& one, const FilmedStudents::Looks& scene, double begin_s,
                          const Motion& coach, const AuthoredMotion& truth, const AuthoredMotion& coach_truth,
                          LiveOutcome& outcome) {
  const auto picture = empty_picture(scene);
  const double takeaway = begin_s + one.slower * truth.time_of("takeaway");
  const double top = begin_s + one.slower * truth.time_of("top");
  const double finish = begin_s + one.slower * truth.time_of(one.motion == "putt" ? "end" : "finish");
  const double coach_rate =
      (coach.frame_count() - 1) / to_seconds(coach.times().back() - coach.times().front());
  Stage stage(scene, coach, one);
  std::vector<double> off, off_early;
  std::shared_ptr<const AnalyzedSwing> shown;
  LoopState before = LoopState::Off;
  std::optional<double> begun;
  for (const PoseObservation& seen : scene.smoothed.frames) {
    const auto snapshot = stage.pipeline.step({seen.frame_index, seen.time, {}, picture});
    if (!snapshot) return tl::unexpected(snapshot.error());
    const double now = to_seconds(seen.time);
    if (snapshot->loop == LoopState::Swinging && before != LoopState::Swinging && !begun) begun = now;
    if (snapshot->loop == LoopState::Analyzing && before != LoopState::Analyzing) {
      ++outcome.found;
      outcome.told_late = now - finish;
      outcome.begin_late = begun.value_or(now) - takeaway;
    }
    before = snapshot->loop;
    if (snapshot->swing && snapshot->swing != shown) {
      shown = snapshot->swing;
      const Analysis& analysis = shown->pair.analysis;
      outcome.score = analysis.score.percent;
      outcome.is_kind_right = (analysis.stroke == "putt") == (one.motion == "putt");
      outcome.is_hand_right =
          analysis.student.hand == (one.hand == "left" ? Handedness::Left : Handedness::Right);
    }
    outcome.message = snapshot->swing_message;
    if (snapshot->ghost && now >= takeaway && now <= finish) {
      const double ghost_s = snapshot->ghost->coach_frame / coach_rate;
      const double apart = ghost_s - same_moment((now - begin_s) / one.slower, truth, coach_truth);
      off.push_back(std::abs(apart));
      if (now < 0.5 * (takeaway + top)) off_early.push_back(apart);
    }
  }
  outcome.ghost_median = at_part(off, 0.5);
  outcome.ghost_worst = at_part(off, 0.9);
  outcome.ghost_takeaway = at_part(off_early, 0.5);
  return {};
}

Result<void> watch_idling(const LiveCase& one, const FilmedStudents::Looks& scene, const Motion& coach,
                          LiveOutcome& outcome) {
  const auto picture = empty_picture(scene);
  Stage stage(scene, coach, one);
  LoopState before = LoopState::Off;
  for (const PoseObservation& seen : scene.smoothed.frames) {
    const auto snapshot = stage.pipeline.step({seen.frame_index, seen.time, {}, picture});
    if (!snapshot) return tl::unexpected(snapshot.error());
    if (snapshot->loop == LoopState::Analyzing && before != LoopState::Analyzing) ++outcome.false_starts;
    before = snapshot->loop;
  }
  return {};
}

void analyze_film(const LiveCase& one, const PoseTrack& film, const Motion& coach,
                  const AuthoredMotion& truth, LiveOutcome& outcome) {
  const Result<LiftedStudent> lifted = lift(film);
  if (!lifted) {
    outcome.film_message = lifted.error().message;
    return;
  }
  const Result<AnalyzedPair> pair =
      analyze(student_from_film(one.name(), film, *lifted), {"bundled:" + one.motion, coach});
  if (!pair) {
    outcome.film_message = pair.error().message;
    return;
  }
  if (pair->analysis.student_events.empty()) {
    outcome.film_message = pair->analysis.notes.empty() ? "no events" : pair->analysis.notes.back();
    return;
  }
  outcome.events_late["takeaway"] =
      pair->analysis.student_takeaway_s - one.slower * truth.time_of("takeaway");
  for (const SwingEvent& event : pair->analysis.student_events)
    outcome.events_late[event.name] = event.time_s - one.slower * truth.time_of(event.name);
}

}  // namespace

std::string LiveCase::name() const {
  char rest[48];
  std::snprintf(rest, sizeof rest, "-%gfps", fps);
  std::string name = motion + "-" + body + "-" + view + "-" + hand + rest;
  if (length != 1) {
    std::snprintf(rest, sizeof rest, "-%g_long", length);
    name += rest;
  }
  if (slower != 1) {
    std::snprintf(rest, sizeof rest, "-%g_slower", slower);
    name += rest;
  }
  return name;
}

Result<LiveOutcome> LiveBench::run(const LiveCase& one) {
  const Result<CameraPlace> camera = camera_place_from_string(one.view);
  if (!camera) return tl::unexpected(camera.error());
  SimulatedStudentOptions options =
      bench_film(one.motion, *find_named_body(one.body),
                 one.hand == "left" ? Handedness::Left : Handedness::Right, *camera, one.fps * one.slower);
  options.length = one.length;
  const auto student = SimulatedStudent::make(options);
  if (!student) return tl::unexpected(student.error());
  Result<FilmedStudents::Looks> film = films_.looks(one.name(), options);
  if (!film) return tl::unexpected(film.error());
  for (PoseTrack* track : {&film->smoothed, &film->unsmoothed})
    for (PoseObservation& frame : track->frames)
      frame.time = media_time_from_seconds(static_cast<double>(frame.frame_index) / one.fps);
  const Result<Motion> coach = bundled_motion(one.motion);
  if (!coach) return tl::unexpected(coach.error());
  const Result<AuthoredMotion> coach_truth = bundled_authored_motion(one.motion);
  if (!coach_truth) return tl::unexpected(coach_truth.error());
  const AuthoredMotion& truth = (*student)->authored();
  // The pose stage settles in the first tenths of a film; who has stood there for long is seen settled.
  const double still_s = one.slower * (truth.time_of("address") - kBeforeAddress_s);
  const auto still = static_cast<std::size_t>(std::lround(still_s * one.fps));
  const double begin_s = kStanding_s - static_cast<double>(still) / one.fps;
  LiveOutcome outcome;
  outcome.asked = one;
  if (const auto watched = watch_stroke(one, stroke_scene(*film, one.fps, still), begin_s, *coach, truth,
                                        *coach_truth, outcome);
      !watched)
    return tl::unexpected(watched.error());
  const double takeaway_s = one.slower * truth.time_of("takeaway"), top_s = one.slower * truth.time_of("top");
  if (const auto watched =
          watch_idling(one, idle_scene(*film, one.fps, still, takeaway_s, top_s), *coach, outcome);
      !watched)
    return tl::unexpected(watched.error());
  analyze_film(one, film->unsmoothed, *coach, truth, outcome);
  return outcome;
}

}  // namespace posecoach
