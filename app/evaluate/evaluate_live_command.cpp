#include "app/evaluate/evaluate_live_command.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "app/evaluate/live_bench.h"
#include "app/pose_options.h"
#include "app/progress_bar.h"
#include "core/base/file.h"
#include "core/body/named_body.h"

namespace posecoach {
namespace {

struct Arguments {
  std::vector<std::string> motions = {"swing", "putt"}, bodies = {"average", "tall", "short", "woman"};
  std::vector<std::string> views = {"face-on", "down-the-line"}, hands = {"right", "left"};
  std::vector<double> frame_rates = {30}, lengths = {1};
  double slower = 1;
  std::string poses, json;
};

constexpr const char* kPrintedEvents[] = {"takeaway", "top", "impact", "end", "finish"};

void print_stroke(const LiveOutcome& o) {
  std::printf("%-44s %5d %5d %5s %5s %7.2f %7.2f %6.1f %6.2f %6.2f %6.2f", o.asked.name().c_str(), o.found,
              o.false_starts, o.is_kind_right ? "right" : "-", o.is_hand_right ? "right" : "-", o.begin_late,
              o.told_late, o.score, o.ghost_median, o.ghost_worst, o.ghost_takeaway);
  for (const char* event : kPrintedEvents)
    if (const auto late = o.events_late.find(event); late != o.events_late.end())
      std::printf(" %s %+.3f", event, late->second);
  std::printf(" %s %s\n", o.message.c_str(), o.film_message.c_str());
}

// Where no stroke is alike another: motion, view, frame rate and length.
std::string group_of(const LiveCase& one) {
  LiveCase group = one;
  group.body = group.hand = "*";
  return group.name();
}

// How many of a group's strokes were found once and begun falsely, and how many of its films have their
// events within a frame at 30 frames a second.
void print_groups(const std::vector<LiveOutcome>& outcomes) {
  constexpr double kFrame_s = 1.0 / 30;
  struct Group {
    int strokes = 0, found = 0, false_starts = 0, divided = 0;
    std::map<std::string, int> within;
  };
  std::map<std::string, Group> groups;
  for (const LiveOutcome& outcome : outcomes) {
    Group& group = groups[group_of(outcome.asked)];
    ++group.strokes;
    group.found += outcome.found == 1 ? 1 : 0;
    group.false_starts += outcome.false_starts;
    group.divided += outcome.events_late.empty() ? 0 : 1;
    for (const auto& [event, late] : outcome.events_late)
      group.within[event] += std::abs(late) <= kFrame_s * outcome.asked.slower ? 1 : 0;
  }
  std::printf("\n%-44s %7s %7s %7s %7s  events within 1/30 s\n", "strokes", "strokes", "found", "false",
              "divided");
  for (const auto& [name, group] : groups) {
    std::printf("%-44s %7d %7d %7d %7d ", name.c_str(), group.strokes, group.found, group.false_starts,
                group.divided);
    for (const char* event : kPrintedEvents)
      if (const auto within = group.within.find(event); within != group.within.end())
        std::printf(" %s %d", event, within->second);
    std::printf("\n");
  }
}

void print(const std::vector<LiveOutcome>& outcomes) {
  std::printf("%-44s %5s %5s %5s %5s %7s %7s %6s %20s  events of the film, s late\n", "stroke", "found",
              "false", "kind", "hand", "begun s", "told s", "score", "ghost off s, early");
  for (const LiveOutcome& outcome : outcomes) print_stroke(outcome);
  print_groups(outcomes);
}

std::string json_of(const std::vector<LiveOutcome>& outcomes) {
  nlohmann::ordered_json json = {
      {"schema", "posecoach.evaluate/1"}, {"task", "live"}, {"rows", nlohmann::json::array()}};
  for (const LiveOutcome& o : outcomes)
    json["rows"].push_back({{"motion", o.asked.motion},
                            {"body", o.asked.body},
                            {"view", o.asked.view},
                            {"hand", o.asked.hand},
                            {"fps", o.asked.fps},
                            {"length", o.asked.length},
                            {"found", o.found},
                            {"false_starts", o.false_starts},
                            {"kind_right", o.is_kind_right},
                            {"hand_right", o.is_hand_right},
                            {"begun_after_takeaway_s", o.begin_late},
                            {"told_after_finish_s", o.told_late},
                            {"score", o.score},
                            {"message", o.message},
                            {"ghost_off_median_s", o.ghost_median},
                            {"ghost_off_90_percent_s", o.ghost_worst},
                            {"ghost_after_at_takeaway_s", o.ghost_takeaway},
                            {"film_events_late_s", o.events_late},
                            {"film_message", o.film_message}});
  return json.dump(1) + "\n";
}

Result<void> run(const Arguments& arguments, const PoseTrackerOptions& pose) {
  for (const std::string& body : arguments.bodies)
    if (!find_named_body(body)) return fail(ErrorCode::InvalidArgument, "there is no body \"" + body + "\"");
  Result<FilmedStudents> films = FilmedStudents::make(arguments.poses, pose);
  if (!films) return tl::unexpected(films.error());
  listen_to_interrupts();
  std::vector<LiveCase> cases;
  for (const std::string& motion : arguments.motions)
    for (const std::string& view : arguments.views)
      for (const double fps : arguments.frame_rates)
        for (const double length : arguments.lengths)
          for (const std::string& hand : arguments.hands)
            for (const std::string& body : arguments.bodies)
              cases.push_back({motion, body, view, hand, fps, length, arguments.slower});
  LiveBench bench(*films);
  ProgressBar bar;
  const Progress progress = bar.progress();
  std::vector<LiveOutcome> outcomes;
  for (const LiveCase& one : cases) {
    if (!report(progress, one.name(),
                static_cast<double>(outcomes.size()) / static_cast<double>(cases.size())))
      return fail(ErrorCode::Cancelled, "stopped");
    const Result<LiveOutcome> outcome = bench.run(one);
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
  command->add_option("--fps", arguments->frame_rates, "Poses a second")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(5.0, 240.0));
  command->add_option("--slower", arguments->slower, "Play the strokes so many times as slowly")
      ->capture_default_str()
      ->check(CLI::Range(0.25, 8.0));
  command
      ->add_option("--lengths", arguments->lengths,
                   "Give the strokes so much of their way: 0.5 is half as long, in the same time")
      ->delimiter(',')
      ->capture_default_str()
      ->check(CLI::Range(0.1, 2.0));
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
