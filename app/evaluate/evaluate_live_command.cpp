#include "app/evaluate/evaluate_live_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>

#include "app/evaluate/filmed_students.h"
#include "app/pose_options.h"
#include "app/progress_bar.h"
#include "core/base/file.h"
#include "core/body/named_body.h"
#include "core/motion/bundled_motion.h"
#include "core/pipeline/coach_pipeline.h"

namespace posecoach {
namespace {

struct Arguments {
  std::vector<std::string> motions = {"swing", "putt"}, bodies = {"average", "tall", "short", "woman"};
  std::vector<std::string> views = {"face-on", "down-the-line"}, hands = {"right", "left"};
  double fps = 30, slower = 1, length = 1;
  std::string poses, json;
};

struct Case {
  std::string motion, body, view, hand;
  std::string name() const { return motion + "-" + body + "-" + view + "-" + hand; }
};

// What the loop made of one stroke. Times in seconds.
struct Outcome {
  Case asked;
  int found = 0;
  bool is_kind_right = false, is_hand_right = false;
  double begin_late = 0;                     // the takeaway that was found, after the true one
  double told_late = 0;                      // when the stroke was known to be over, after its true finish
  double score = 0;                          // of the answer
  std::string message;                       // why there is none
  double ghost_median = 0, ghost_worst = 0;  // how far off the ghost is in time; worst: of nine in ten
  double ghost_takeaway = 0;                 // the same, in the first half of the backswing
};

constexpr double kStanding_s = 5, kHolding_s = 1.5, kLeaving_s = 1.5;
// What still moves in the pose stage's answers when nobody does.
constexpr double kTremble_px = 0.15, kTremble_m = 0.0007;

class RememberedPoses : public PoseEstimator {
 public:
  explicit RememberedPoses(std::vector<PoseObservation> all) : all_(std::move(all)) {}
  Result<PoseObservation> estimate(const Frame& frame) override { return all_[frame.index]; }
  void reset() override {}

 private:
  std::vector<PoseObservation> all_;
};

class LiveBench {
 public:
  LiveBench(const Arguments& arguments, FilmedStudents& films) : arguments_(arguments), films_(films) {}

  Result<Outcome> run(const Case& one) {
    const Result<CameraPlace> camera = camera_place_from_string(one.view);
    if (!camera) return tl::unexpected(camera.error());
    const SimulatedStudentOptions options = bench_film(
        one.motion, *find_named_body(one.body), one.hand == "left" ? Handedness::Left : Handedness::Right,
        *camera, arguments_.fps * arguments_.slower);
    const auto student = SimulatedStudent::make(options);
    if (!student) return tl::unexpected(student.error());
    const Result<PoseTrack> track = films_.track(film_name(one), options);
    if (!track) return tl::unexpected(track.error());
    Result<Motion> coach = bundled_motion(one.motion);
    if (!coach) return tl::unexpected(coach.error());
    const Result<AuthoredMotion> coach_truth = bundled_authored_motion(one.motion);
    if (!coach_truth) return tl::unexpected(coach_truth.error());
    return judge(one, *track, (*student)->authored(), *std::move(coach), *coach_truth);
  }

 private:
  std::string film_name(const Case& one) const {
    char rate[16];
    std::snprintf(rate, sizeof rate, "%g", arguments_.fps * arguments_.slower);
    return one.name() + "-" + rate + "fps";
  }

  // Stands at address, plays the stroke, holds its end, and is gone.
  std::vector<PoseObservation> scene(const PoseTrack& track) const {
    std::vector<PoseObservation> all;
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto add = [&](std::optional<SeenPerson> person) {
      all.push_back({all.size(), media_time_from_seconds(static_cast<double>(all.size()) / arguments_.fps),
                     std::move(person)});
    };
    const auto hold = [&](const std::optional<SeenPerson>& person, double seconds) {
      for (int f = 0; f < seconds * arguments_.fps; ++f) {
        std::optional<SeenPerson> trembling = person;
        for (std::size_t i = 0; trembling && i < kLandmarkCount; ++i) {
          trembling->image[i].position_px += kTremble_px * Vec2(normal(random), normal(random));
          trembling->world[i].position_m += kTremble_m * Vec3(normal(random), normal(random), normal(random));
        }
        add(trembling);
      }
    };
    hold(track.frames.front().person, kStanding_s);
    for (const PoseObservation& frame : track.frames) add(shortened(track.frames.front(), frame));
    hold(shortened(track.frames.front(), track.frames.back()), kHolding_s);
    hold(std::nullopt, kLeaving_s);
    return all;
  }

  // The same stroke with less way, back and through.
  std::optional<SeenPerson> shortened(const PoseObservation& address, const PoseObservation& frame) const {
    std::optional<SeenPerson> person = frame.person;
    for (std::size_t i = 0; person && address.person && i < kLandmarkCount; ++i) {
      Vec2& image = person->image[i].position_px;
      Vec3& world = person->world[i].position_m;
      image = glm::mix(address.person->image[i].position_px, image, arguments_.length);
      world = glm::mix(address.person->world[i].position_m, world, arguments_.length);
    }
    return person;
  }

  Result<Outcome> judge(const Case& one, const PoseTrack& track, const AuthoredMotion& truth, Motion coach,
                        const AuthoredMotion& coach_truth) const {
    const double slower = arguments_.slower;
    const std::vector<PoseObservation> all = scene(track);
    const auto picture = std::make_shared<const Image>(Image::black(track.width, track.height));
    const std::string last = one.motion == "putt" ? "end" : "finish";
    const double takeaway = kStanding_s + slower * truth.time_of("takeaway");
    const double top = kStanding_s + slower * truth.time_of("top");
    const double finish = kStanding_s + slower * truth.time_of(last);
    const double coach_rate =
        coach.frame_count() > 1
            ? (coach.frame_count() - 1) / to_seconds(coach.times().back() - coach.times().front())
            : 1;
    InlineWork work;
    CoachPipeline pipeline(std::make_unique<RememberedPoses>(all), work);
    pipeline.set_coach(std::move(coach), "bundled:" + one.motion);
    // As chosen in the set-up.
    pipeline.set_person({.hand = one.hand == "left" ? Handedness::Left : Handedness::Right});
    pipeline.arm();
    Outcome outcome;
    outcome.asked = one;
    std::vector<double> off, off_early;
    std::shared_ptr<const AnalyzedSwing> shown;
    LoopState before = LoopState::Off;
    std::optional<double> begun;
    for (const PoseObservation& seen : all) {
      const auto snapshot = pipeline.step({seen.frame_index, seen.time, {}, picture});
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
        const double apart = ghost_s - same_moment((now - kStanding_s) / slower, truth, coach_truth);
        off.push_back(std::abs(apart));
        if (now < 0.5 * (takeaway + top)) off_early.push_back(apart);
      }
    }
    const auto at = [](std::vector<double>& values, double part) {
      std::sort(values.begin(), values.end());
      return values.empty() ? -1
                            : values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
    };
    outcome.ghost_median = at(off, 0.5);
    outcome.ghost_worst = at(off, 0.9);
    outcome.ghost_takeaway = at(off_early, 0.5);
    return outcome;
  }

  // The coach's time that answers the student's, from event to event.
  static double same_moment(double time_s, const AuthoredMotion& student, const AuthoredMotion& coach) {
    for (std::size_t k = 1; k < student.events.size(); ++k) {
      const double begin = student.events[k - 1].time_s, end = student.events[k].time_s;
      if (time_s > end) continue;
      const double part = end > begin ? (time_s - begin) / (end - begin) : 1;
      return coach.events[k - 1].time_s + part * (coach.events[k].time_s - coach.events[k - 1].time_s);
    }
    return coach.events.back().time_s;
  }

  const Arguments& arguments_;
  FilmedStudents& films_;
};

void print(const std::vector<Outcome>& outcomes) {
  std::printf("%-36s %5s %5s %5s %9s %9s %7s %22s %9s\n", "stroke", "found", "kind", "hand", "begun s",
              "told s", "score", "ghost off s (of 9/10)", "takeaway");
  for (const Outcome& o : outcomes)
    std::printf("%-36s %5d %5s %5s %9.2f %9.2f %7.1f %12.2f %9.2f %9.2f %s\n", o.asked.name().c_str(),
                o.found, o.is_kind_right ? "right" : "-", o.is_hand_right ? "right" : "-", o.begin_late,
                o.told_late, o.score, o.ghost_median, o.ghost_worst, o.ghost_takeaway, o.message.c_str());
}

std::string json_of(const std::vector<Outcome>& outcomes) {
  nlohmann::ordered_json json = {
      {"schema", "posecoach.evaluate/1"}, {"task", "live"}, {"rows", nlohmann::json::array()}};
  for (const Outcome& o : outcomes)
    json["rows"].push_back({{"motion", o.asked.motion},
                            {"body", o.asked.body},
                            {"view", o.asked.view},
                            {"hand", o.asked.hand},
                            {"found", o.found},
                            {"kind_right", o.is_kind_right},
                            {"hand_right", o.is_hand_right},
                            {"begun_after_takeaway_s", o.begin_late},
                            {"told_after_finish_s", o.told_late},
                            {"score", o.score},
                            {"message", o.message},
                            {"ghost_off_median_s", o.ghost_median},
                            {"ghost_off_90_percent_s", o.ghost_worst},
                            {"ghost_after_at_takeaway_s", o.ghost_takeaway}});
  return json.dump(1) + "\n";
}

Result<void> run(const Arguments& arguments, const PoseTrackerOptions& pose) {
  for (const std::string& body : arguments.bodies)
    if (!find_named_body(body)) return fail(ErrorCode::InvalidArgument, "there is no body \"" + body + "\"");
  Result<FilmedStudents> films = FilmedStudents::make(arguments.poses, pose);
  if (!films) return tl::unexpected(films.error());
  listen_to_interrupts();
  std::vector<Case> cases;
  for (const std::string& motion : arguments.motions)
    for (const std::string& view : arguments.views)
      for (const std::string& hand : arguments.hands)
        for (const std::string& body : arguments.bodies) cases.push_back({motion, body, view, hand});
  LiveBench bench(arguments, *films);
  ProgressBar bar;
  const Progress progress = bar.progress();
  std::vector<Outcome> outcomes;
  for (const Case& one : cases) {
    if (!report(progress, one.name(),
                static_cast<double>(outcomes.size()) / static_cast<double>(cases.size())))
      return fail(ErrorCode::Cancelled, "stopped");
    const Result<Outcome> outcome = bench.run(one);
    if (!outcome) return tl::unexpected(outcome.error());
    outcomes.push_back(*outcome);
  }
  if (arguments.json != "-") print(outcomes);
  return arguments.json.empty() ? Result<void>() : write_file_atomically(arguments.json, json_of(outcomes));
}

}  // namespace

void add_evaluate_live_command(CLI::App& evaluate, Action& action) {
  CLI::App* command = evaluate.add_subcommand(
      "live", "How the hands-free loop and the ghost do with simulated strokes of several bodies");
  auto arguments = std::make_shared<Arguments>();
  const auto list = [&](const char* option, std::vector<std::string>& values, const char* help) {
    return command->add_option(option, values, help)->delimiter(',')->capture_default_str();
  };
  list("--motions", arguments->motions, "Strokes")->check(CLI::IsMember({"swing", "putt"}));
  list("--bodies", arguments->bodies, "Named bodies");
  list("--views", arguments->views, "Where the camera stands")
      ->check(CLI::IsMember({"face-on", "down-the-line"}));
  list("--hands", arguments->hands, "From which side he plays")->check(CLI::IsMember({"right", "left"}));
  command->add_option("--fps", arguments->fps, "Poses a second")
      ->capture_default_str()
      ->check(CLI::Range(5.0, 240.0));
  command->add_option("--slower", arguments->slower, "Play the strokes so many times as slowly")
      ->capture_default_str()
      ->check(CLI::Range(0.25, 8.0));
  command
      ->add_option("--length", arguments->length,
                   "Give the strokes so much of their way: 0.5 is half as long")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 1.0));
  command
      ->add_option("--poses", arguments->poses, "Keep what the pose networks saw here, and use what is there")
      ->type_name("DIR");
  command->add_option("--json", arguments->json, "Write the table as JSON; - for standard output")
      ->type_name("FILE");
  const auto pose = add_pose_options(*command);
  command->callback(
      [&action, arguments, pose] { action = [arguments, pose] { return run(*arguments, *pose); }; });
}

}  // namespace posecoach
