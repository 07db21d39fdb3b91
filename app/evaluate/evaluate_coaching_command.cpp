#include "app/evaluate/evaluate_coaching_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/evaluate/filmed_students.h"
#include "app/pose_options.h"
#include "app/progress_bar.h"
#include "core/base/file.h"
#include "core/pipeline/event_bench.h"
#include "core/pipeline/fault_bench.h"

namespace posecoach {
namespace {

struct Arguments {
  std::string through = "joints", filmed_coach, poses, json;
  std::vector<std::string> bodies, faults;
  std::vector<double> frame_rates = {30}, parts = {0.75, 1, 1.5}, camera_turns = {0};
  bool lists_cases = false;
};

SimulatedStudentOptions film_of(const BenchCase& one) {
  SimulatedStudentOptions film = bench_film(
      one.motion, make_standard_body(one.body.proportions), one.hand,
      {one.eye == BenchEye::FaceOn ? CameraView::FaceOn : CameraView::DownTheLine, one.camera_turned_deg},
      one.frames_per_second);
  film.name = name_of(one);
  film.body_name = one.body.name;
  if (one.fault) film.faults.push_back({one.fault, one.amount});
  return film;
}

// The eye of the camera.
Result<StudentInput> see_film(const BenchCase& one, FilmedStudents& films) {
  const Result<PoseTrack> track = films.track(name_of(one), film_of(one));
  if (!track) return tl::unexpected(track.error());
  const Result<LiftedStudent> lifted = lift(*track);
  if (!lifted) return tl::unexpected(lifted.error());
  return student_from_film(name_of(one), *track, *lifted);
}

// The faultless stroke of another golfer, filmed as the student is.
Result<Motion> filmed_coach(BenchCase one, const BenchBody& coach, FilmedStudents& films) {
  one.fault = nullptr;
  one.amount = 0;
  one.hand = Handedness::Right;
  one.body = coach;
  Result<StudentInput> seen = see_film(one, films);
  if (!seen) return fail(seen.error().code, "the coach: " + seen.error().message);
  return std::move(seen->motion);
}

std::string percent(int part, int whole) {
  if (whole == 0) return "-";
  char text[16];
  std::snprintf(text, sizeof text, "%.0f %%", 100.0 * part / whole);
  return text;
}

void print(const std::vector<BenchRow>& rows) {
  std::printf("%-14s %-6s %-24s %6s %8s %8s %8s %11s %8s %8s\n", "through", "motion", "fault", "cases",
              "refused", "first", "top 3", "within 25 %", "alarms", "score");
  for (const BenchRow& row : rows) {
    const bool faultless = row.fault.empty();
    std::printf("%-14s %-6s %-24s %6d %8d %8s %8s %11s %8s %8.1f\n", std::string(to_string(row.eye)).c_str(),
                row.motion.c_str(), faultless ? "none" : row.fault.c_str(), row.cases, row.refused,
                faultless ? "" : percent(row.first, row.cases).c_str(),
                faultless ? "" : percent(row.top_three, row.cases).c_str(),
                faultless ? "" : percent(row.amount_right, row.top_three).c_str(),
                faultless ? percent(row.false_alarms, row.cases).c_str() : "", row.percent_mean);
  }
}

// True joints leave no doubt, so there is no plus-minus that scores could lie within.
void print(const std::vector<BenchAgreement>& rows) {
  if (rows.empty()) return;
  std::printf("\n%-14s %-6s %12s %12s %14s %22s\n", "through", "motion", "of two rates", "same first",
              "score within", "metrics within +-");
  for (const BenchAgreement& row : rows)
    std::printf("%-14s %-6s %12d %12s %14s %14d of %d\n", std::string(to_string(row.eye)).c_str(),
                row.motion.c_str(), row.pairs, percent(row.same_first, row.pairs).c_str(),
                row.eye == BenchEye::TrueJoints ? "-" : percent(row.scores_within, row.pairs).c_str(),
                row.metrics_within, row.metrics);
}

void print(const std::vector<BenchEventRow>& rows) {
  std::printf("\n%-14s %-6s %-18s %8s %13s %8s %8s\n", "through", "motion", "event", "strokes",
              "within 1/30 s", "late s", "spread");
  for (const BenchEventRow& row : rows)
    std::printf("%-14s %-6s %-18s %8d %13s %+8.3f %8.3f\n", std::string(to_string(row.eye)).c_str(),
                row.motion.c_str(), row.event.c_str(), row.strokes, percent(row.within, row.strokes).c_str(),
                row.late_s, row.spread_s);
}

// What scripts/film-error-table makes the pose stage's usual errors of.
void add(nlohmann::ordered_json& one, const StageGaps& film) {
  const auto values = [](const Vec3& v) { return nlohmann::json::array({v.x, v.y, v.z}); };
  one["sight"] = values(film.sight);
  for (const StageGaps::Gap& gap : film.gaps)
    one["stage_gaps"].push_back(
        {{"joint", gap.joint}, {"stage", gap.stage}, {"offset_legs", values(gap.offset)}});
}

nlohmann::ordered_json json_of(const std::vector<BenchRow>& rows, const std::vector<BenchAnswer>& answers,
                               bool lists_cases) {
  nlohmann::ordered_json json = {
      {"schema", "posecoach.evaluate/1"}, {"task", "coaching"}, {"rows", nlohmann::json::array()}};
  for (const BenchRow& row : rows)
    json["rows"].push_back({{"through", to_string(row.eye)},
                            {"motion", row.motion},
                            {"fault", row.fault},
                            {"cases", row.cases},
                            {"refused", row.refused},
                            {"first", row.first},
                            {"top_three", row.top_three},
                            {"amount_within_25_percent", row.amount_right},
                            {"false_alarms", row.false_alarms},
                            {"score_mean", row.percent_mean},
                            {"score_least", row.percent_least}});
  for (const BenchAgreement& row : agreement_of_frame_rates(answers))
    json["frame_rates"].push_back({{"through", to_string(row.eye)},
                                   {"motion", row.motion},
                                   {"pairs", row.pairs},
                                   {"same_first", row.same_first},
                                   {"scores_within", row.scores_within},
                                   {"metrics", row.metrics},
                                   {"metrics_within", row.metrics_within}});
  for (const BenchEventRow& row : tally_events(answers))
    json["events"].push_back({{"through", to_string(row.eye)},
                              {"motion", row.motion},
                              {"event", row.event},
                              {"strokes", row.strokes},
                              {"within_a_frame", row.within},
                              {"late_s", row.late_s},
                              {"spread_s", row.spread_s}});
  if (!lists_cases) return json;
  json["cases"] = nlohmann::json::array();
  for (const BenchAnswer& answer : answers) {
    nlohmann::ordered_json one = {{"name", name_of(answer.asked)},
                                  {"refusal", answer.refusal},
                                  {"score", answer.percent},
                                  {"plus_minus", answer.plus_minus},
                                  {"rank", answer.rank},
                                  {"amount_told", answer.amount_told},
                                  {"amount_true", answer.amount_true},
                                  {"events_late_s", answer.events_late},
                                  {"advice", nlohmann::json::array()}};
    for (const Advice& advice : answer.advice)
      one["advice"].push_back(
          {{"text", advice.text}, {"fault", advice.fault}, {"severity", advice.severity}});
    if (!answer.stage_gaps.gaps.empty()) add(one, answer.stage_gaps);
    json["cases"].push_back(std::move(one));
  }
  return json;
}

BenchPlan plan_of(const Arguments& arguments) {
  BenchPlan plan{
      {}, arguments.frame_rates, arguments.parts, arguments.bodies, arguments.faults, arguments.camera_turns};
  if (arguments.through != "film") plan.eyes.push_back(BenchEye::TrueJoints);
  if (arguments.through != "joints") {
    plan.eyes.push_back(BenchEye::FaceOn);
    plan.eyes.push_back(BenchEye::DownTheLine);
  }
  return plan;
}

Result<void> run(const Arguments& arguments, const PoseTrackerOptions& pose) {
  const auto cases = make_bench_cases(plan_of(arguments));
  if (!cases) return tl::unexpected(cases.error());
  PoseTrackerOptions unsmoothed = pose;
  unsmoothed.smoothing = Smoothing::Off;
  Result<FilmedStudents> films = FilmedStudents::make(arguments.poses, std::move(unsmoothed));
  if (!films) return tl::unexpected(films.error());
  listen_to_interrupts();
  const auto see = [&films](const BenchCase& one) {
    return one.eye == BenchEye::TrueJoints ? see_true_joints(one) : see_film(one, *films);
  };
  const std::vector<BenchBody> bodies = bench_bodies();
  const auto coach = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const BenchBody& body) { return body.name == arguments.filmed_coach; });
  if (!arguments.filmed_coach.empty() && coach == bodies.end())
    return fail(ErrorCode::InvalidArgument, "there is no body \"" + arguments.filmed_coach + "\"");
  const auto coach_of = [&](const BenchCase& one) {
    return one.eye == BenchEye::TrueJoints || coach == bodies.end() ? bundled_coach(one)
                                                                    : filmed_coach(one, *coach, *films);
  };
  ProgressBar bar;
  const auto answers = run_fault_bench(*cases, see, coach_of, bar.progress());
  if (!answers) return tl::unexpected(answers.error());
  const std::vector<BenchRow> rows = tally(*answers);
  if (arguments.json != "-") {
    print(rows);
    print(tally_events(*answers));
    print(agreement_of_frame_rates(*answers));
  }
  if (arguments.json.empty()) return {};
  return write_file_atomically(arguments.json, json_of(rows, *answers, arguments.lists_cases).dump(1) + "\n");
}

}  // namespace

void add_evaluate_coaching_command(CLI::App& evaluate, Action& action) {
  CLI::App* command = evaluate.add_subcommand(
      "coaching", "Which of the known faults are named, on simulated strokes of many bodies");
  auto arguments = std::make_shared<Arguments>();
  command
      ->add_option("--through", arguments->through,
                   "What the coach sees: the true joints, films through the pose networks, or both")
      ->capture_default_str()
      ->check(CLI::IsMember({"joints", "film", "both"}));
  command->add_option("--bodies", arguments->bodies, "Only these bodies (default: all)")
      ->delimiter(',')
      ->type_name("NAME,...");
  command->add_option("--faults", arguments->faults, "Only these faults (default: all)")
      ->delimiter(',')
      ->type_name("NAME,...");
  command
      ->add_option(
          "--filmed-coach", arguments->filmed_coach,
          "Of films: the coach is not the bundled motion but a film of this body, from the same side")
      ->type_name("NAME");
  command
      ->add_option("--turned", arguments->camera_turns,
                   "How many degrees the camera stands beside its place, for films")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(-45.0, 45.0));
  command->add_option("--fps", arguments->frame_rates, "Frame rates")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(10.0, 480.0));
  command->add_option("--parts", arguments->parts, "Amounts, as parts of each fault's usual one")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(0.0, 3.0));
  command
      ->add_option("--poses", arguments->poses, "Keep what the pose networks saw here, and use what is there")
      ->type_name("DIR");
  command->add_flag("--cases", arguments->lists_cases, "List every case in the JSON");
  command->add_option("--json", arguments->json, "Write the table as JSON; - for standard output")
      ->type_name("FILE");
  const auto pose = add_pose_options(*command);
  command->callback(
      [&action, arguments, pose] { action = [arguments, pose] { return run(*arguments, *pose); }; });
}

}  // namespace posecoach
