#include "ui/report/report_page.h"

#include <cmath>

#include "core/base/embedded.h"
#include "ui/render/words.h"
#include "ui/report/html.h"
#include "ui/report/replay.h"
#include "ui/report/report_sections.h"
#include "ui/report/timeline_figure.h"

namespace posecoach {
namespace {

POSECOACH_EMBEDDED(report_css)
POSECOACH_EMBEDDED(report_js)

constexpr int kMostSteps = 240;

// Joints in units of 5 mm, flat: x, y, z of each joint of each step.
std::string positions_array(const Replay& replay, const std::vector<Vec3> ReplayStep::*who) {
  std::string array = "[";
  for (const ReplayStep& step : replay.steps)
    for (const Vec3& p : step.*who)
      for (const double value : {p.x, p.y, p.z}) {
        if (array.size() > 1) array += ',';
        array += std::to_string(std::lround(200 * value));
      }
  return array + "]";
}

// What the page's script draws from. The names are read by ui/report/report.js.
std::string replay_script(const Analysis& analysis, const Replay& replay) {
  const report::TimelineAxis axis = report::timeline_axis(replay);
  std::string steps, bones;
  for (const ReplayStep& step : replay.steps) {
    steps += steps.empty() ? "[" : ",[";
    steps += std::to_string(step.student_frame) + "," + std::to_string(step.coach_frame) + "," +
             decimal(step.student_s, 3) + "," + decimal(step.coach_s, 3) + "," +
             decimal(100 * step.apart_m, 1) + "," + decimal(step.speed, 2) + "," +
             decimal(axis.student_x(step.student_s), 1) + "," + decimal(axis.coach_x(step.coach_s), 1) + "," +
             html::script_string(student_phase(analysis, step.student_frame)) + "]";
  }
  for (const auto& [a, b] : replay.bones)
    bones += (bones.empty() ? "[" : ",[") + std::to_string(a) + "," + std::to_string(b) + "]";
  int head = -1;
  for (std::size_t i = 0; i < replay.joints.size(); ++i)
    if (replay.joints[i] == HumanoidJoint::Head) head = static_cast<int>(i);
  return "<script>const replay={joints:" + std::to_string(replay.joints.size()) +
         ",head:" + std::to_string(head) + ",bones:[" + bones + "],steps:[" + steps +
         "],student:" + positions_array(replay, &ReplayStep::student) +
         ",coach:" + positions_array(replay, &ReplayStep::coach) +
         ",axis:{student:" + decimal(axis.student_y, 1) + ",coach:" + decimal(axis.coach_y, 1) + "}};\n" +
         std::string(report_js()) + "</script>\n";
}

std::string proportion_note(const Replay& replay) {
  if (!replay.is_in_proportion()) return {};
  return "<br>The colours compare in proportion: your whole motion takes " +
         decimal(1 / replay.overall_speed, 1) + " times as long as the coach’s.";
}

std::string replay_section(const Analysis& analysis, const Replay& replay) {
  if (replay.steps.empty()) return {};
  return "<section id=\"replay\"><h2>Moment by moment</h2><p class=\"lead\">Which moment of <span "
         "class=\"student\">you</span> answers which moment of <span class=\"coach\">the coach</span>. Move "
         "over the "
         "time line or drag the slider.</p><div class=\"stage\"><figure><canvas "
         "id=\"front\"></canvas><figcaption>Front"
         "</figcaption></figure><figure><canvas "
         "id=\"side\"></canvas><figcaption>Side</figcaption></figure><div "
         "class=\"readout\"><p id=\"phase\"></p><dl><dt>You</dt><dd "
         "id=\"student-time\"></dd><dt>Coach</dt><dd "
         "id=\"coach-time\"></dd><dt>Apart</dt><dd id=\"apart\"></dd><dt>Your speed</dt><dd "
         "id=\"speed\"></dd></dl><button "
         "type=\"button\" id=\"play\">Play</button></div></div><input id=\"scrub\" type=\"range\" min=\"0\" "
         "max=\"" +
         std::to_string(replay.steps.size() - 1) +
         "\" value=\"0\" aria-label=\"Moment\"><div class=\"scroll\">" +
         report::timeline_figure(analysis, replay) +
         "</div><p class=\"key\"><span class=\"swatch slower\"></span>you are slower than the coach<span "
         "class=\"swatch same\"></span>the same<span class=\"swatch faster\"></span>faster" +
         proportion_note(replay) + "</p></section>\n";
}

}  // namespace

std::string make_report_page(const Comparison& comparison, std::span<const ReportPicture> pictures,
                             const Block& block) {
  const Analysis& analysis = comparison.analysis;
  const Replay replay = make_replay(comparison, kMostSteps);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><meta name=\"color-scheme\" content=\"light "
      "dark\"><title>Swing "
      "report: " +
      html::escape(short_source(analysis.student.source)) + "</title>\n<style>\n" +
      std::string(report_css()) + "</style></head>\n<body" +
      (comparison.palette == Palette::ColourBlindSafe ? " class=\"colour-blind\"" : "") +
      "><main>\n<header><p class=\"brand\">Virtual Pose Coach</p><h1>" +
      html::escape(short_source(analysis.student.source)) + "</h1><p class=\"quiet\">" +
      html::escape(analysis.stroke.empty() ? "Compared with "
                                           : title_from_name(analysis.stroke) + ", compared with ") +
      html::escape(short_source(analysis.coach.source)) + "</p></header>\n";
  page += report::summary_section(analysis, replay);
  page += report::parts_section(analysis);
  page += report::block_section(block);
  page += report::pictures_section(analysis, pictures, replay, comparison.palette);
  page += report::poses_section(analysis, replay);
  page += replay_section(analysis, replay);
  page += report::timing_section(analysis, replay);
  page += report::spatial_section(analysis, replay);
  page += report::joints_section(analysis);
  page += report::metrics_section(analysis);
  page += report::method_section(analysis);
  page +=
      "<footer>Made on your own machine by Virtual Pose Coach. This page needs no network.</footer></main>\n";
  if (!replay.steps.empty()) page += replay_script(analysis, replay);
  return page + "</body></html>\n";
}

}  // namespace posecoach
