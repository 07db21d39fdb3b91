#include "core/coaching/text/metric_text.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "core/coaching/text/fill.h"

namespace posecoach::text {
namespace {

constexpr UsualRange between(double low, double high) {
  return {low, high};
}

constexpr std::array kMetrics = {
    MetricText{"tempo_ratio", "Tempo", "", "time of the backswing over time of the downswing",
               between(2.2, 3.2), "Tour Tempo (Novosel); Grober & Cholewicki"},
    MetricText{"putt_tempo_ratio", "Tempo", "", "time of the backswing over time of the downswing",
               between(1.8, 2.2), "Mann; Tour Tempo"},
    MetricText{"backswing_s", "Backswing", "s", "takeaway to top", between(0.74, 0.96),
               "Grober & Cholewicki"},
    MetricText{"putt_backswing_s", "Backswing", "s", "takeaway to top", between(0.55, 0.75),
               "SAM PuttLab averages"},
    MetricText{"downswing_s", "Downswing", "s", "top to impact", between(0.23, 0.30), "Tour Tempo (Novosel)"},
    MetricText{"putt_downswing_s", "Top to ball", "s", "top to impact", between(0.27, 0.35),
               "Mann; Tour Tempo"},
    MetricText{"total_time_s", "Whole stroke", "s",
               "takeaway to impact; the same for every putt is a good drill", between(0.75, 1.3),
               "bargolfinstruction.com"},
    MetricText{"shoulder_turn_top_deg", "Shoulder turn at the top", "deg",
               "shoulder line on the ground at the top, from address", between(90, 100),
               "GOLFTEC; Sportsbox; Meister 2011"},
    MetricText{"shoulder_turn_impact_deg", "Shoulders open at impact", "deg",
               "shoulder line on the ground at impact, open to the target from address", between(19, 32),
               "Sportsbox"},
    MetricText{"hip_turn_top_deg", "Hip turn at the top", "deg",
               "hip line on the ground at the top, from address", between(40, 55),
               "Sportsbox; McTeigue 1994"},
    MetricText{"hip_turn_impact_deg", "Hips open at impact", "deg",
               "hip line on the ground at impact, open to the target from address", between(36, 45),
               "GOLFTEC SwingTRU"},
    MetricText{"x_factor_top_deg", "X-factor at the top", "deg",
               "shoulder turn less hip turn at the top; depends on its definition, here both lines on the "
               "ground",
               between(42, 60), "TPI; Penn State and Ulster papers"},
    MetricText{"x_factor_stretch_deg", "X-factor stretch", "deg",
               "largest shoulder turn less hip turn early in the downswing, over that at the top",
               between(0, 10), "Cheetham 2001"},
    MetricText{"shoulder_tilt_top_deg", "Shoulder tilt at the top", "deg",
               "how far the lead shoulder is below the trail shoulder at the "
               "top",
               between(30, 40), "GOLFTEC SwingTRU"},
    MetricText{"spine_forward_address_deg", "Forward bend at address", "deg",
               "mid-hips to mid-shoulders out of the vertical, towards the ball", between(30, 40),
               "Zheng 2008"},
    MetricText{"spine_forward_change_deg", "Change of forward bend", "deg",
               "forward bend at impact less at address; 0 keeps the posture"},
    MetricText{"spine_side_address_deg", "Side bend at address", "deg",
               "side bend away from the target at address", between(6, 8), "golf teaching texts"},
    MetricText{"spine_side_top_deg", "Side bend at the top", "deg",
               "side bend away from the target at the top; below 0 is a reverse spine angle"},
    MetricText{"spine_side_impact_deg", "Side bend at impact", "deg",
               "side bend away from the target at impact", between(20, 25), "golf teaching texts"},
    MetricText{"sway_top_cm", "Sway", "cm",
               "middle of the hips at the top, towards the target from address; its zero point matters",
               between(-5, 3), "golf.com; GOLFTEC"},
    MetricText{"slide_impact_cm", "Slide", "cm",
               "middle of the hips at impact, towards the target from address"},
    MetricText{"lift_top_cm", "Hip lift at the top", "cm", "middle of the hips at the top, up from address"},
    MetricText{"lift_impact_cm", "Hip lift at impact", "cm", "middle of the hips at impact, up from address"},
    MetricText{"thrust_impact_cm", "Hips to the ball at impact", "cm",
               "middle of the hips at impact, towards the ball from address; above 0 is early extension",
               between(-6, 1), "golf teaching texts"},
    MetricText{"lead_arm_bend_top_deg", "Lead arm bend at the top", "deg",
               "elbow of the lead arm at the top; 0 is straight"},
    MetricText{
        "hand_path_cm", "Hand path", "cm",
        "hands nearer the ball halfway down than halfway back (above 0: over the top); hands, not club"},
    MetricText{"kinematic_sequence",
               "Kinematic sequence",
               "",
               "what turns fastest first on the way down; from the ground up: pelvis, chest, lead arm",
               {},
               "Cheetham 2008"},
    MetricText{"pelvis_peak_deg_s", "Fastest hip turn", "deg/s",
               "fastest turn of the hip line on the way down", between(424, 530),
               "Cheetham 2008, 19 professionals"},
    MetricText{"chest_peak_deg_s", "Fastest shoulder turn", "deg/s",
               "fastest turn of the shoulder line on the way down", between(666, 788),
               "Cheetham 2008, 19 professionals"},
    MetricText{"lead_arm_peak_deg_s", "Fastest lead arm", "deg/s",
               "fastest turn of the lead arm on the way down", between(912, 1048),
               "Cheetham 2008, 19 professionals"},
    MetricText{"stroke_back_cm", "Length of the backswing", "cm",
               "hands at the top, away from the target from address"},
    MetricText{"follow_through_ratio", "Follow-through to backswing", "",
               "way of the hands past impact over their way back", between(1.5, 2.5), "Mann"},
    MetricText{"hip_movement_cm", "Hip movement", "cm",
               "middle of the hips from address to impact, along the target line", between(-1, 1),
               "Manitoba putting analysis"},
    MetricText{"head_movement_cm", "Head movement", "cm",
               "how far the head moves along the target line from address to impact"},
    MetricText{"head_hands_coupling", "Head with the hands", "",
               "whether the head moves with the hands (1) or against them (-1); novices' goes with them",
               between(-1, 0), "Lee 2008"},
    MetricText{"shoulder_rock_deg", "Shoulder turn", "deg",
               "shoulder line on the ground at the top, from address", between(4, 10), "Ariel Dynamics"},
    MetricText{"wrist_break_deg", "Wrist break", "deg",
               "how much further the lower hand is ahead of the lead forearm at the end than at address"},
    MetricText{"head_sway_top_cm", "Head movement at the top", "cm",
               "head at the top, towards the target from address", between(-7, 0), "a coach's rule of thumb"},
    MetricText{"head_lift_impact_cm", "Head lift at impact", "cm", "head at impact, up from address"},
    MetricText{"lead_knee_flex_address_deg", "Lead knee bend at address", "deg",
               "knee of the lead leg at address; 0 is straight", between(15, 29), "a coach's rule of thumb"},
    MetricText{"trail_knee_flex_address_deg", "Trail knee bend at address", "deg",
               "knee of the trail leg at address; 0 is straight", between(15, 29), "a coach's rule of thumb"},
    MetricText{"stance_width_percent", "Stance width", "%",
               "distance of the ankles over that of the shoulders, at address", between(88, 115),
               "a coach's rule of thumb, wedge to driver"},
};

}  // namespace

const MetricText& metric(std::string_view name) {
  const auto* const found =
      std::find_if(kMetrics.begin(), kMetrics.end(), [&](const MetricText& m) { return m.name == name; });
  POSECOACH_ASSERT(found != kMetrics.end());
  return *found;
}

std::string unit(std::string_view unit) {
  return unit == "deg" ? "°" : unit == "deg/s" ? " °/s" : unit.empty() ? "" : " " + std::string(unit);
}

std::string hidden_by_view(Viewpoint view) {
  return view == Viewpoint::FaceOn ? "not visible from face-on: film down the line for it"
                                   : "not visible from down the line: film face-on for it";
}

std::string hidden_by_one_camera() {
  return "one camera only guesses how far a body is turned";
}

std::string not_from_this_side() {
  return "one camera cannot tell it well enough from this side";
}

std::string implausible(double value, std::string_view unit_of_value) {
  return filled("one camera tells turns badly: it made {value} of this, which no golfer does",
                {{"value", number(value, 0) + unit(unit_of_value)}});
}

std::string not_without(std::string_view other) {
  return filled("{other} is not known, which it is made of", {{"other", std::string(other)}});
}

std::string too_few_frames(double frame_rate) {
  return filled("too few frames a second ({rate}) for it", {{"rate", number(frame_rate, 0)}});
}

std::string joint_hidden() {
  return "a joint is hidden from the camera at that moment";
}

std::string sequence_too_close(double frame_rate) {
  return filled("the peaks are less than a frame apart: {rate} frames a second cannot tell",
                {{"rate", number(frame_rate, 0)}});
}

std::string head_is_still(double metres) {
  return filled("the head moves only {size} mm", {{"size", number(1000 * metres, 0)}});
}

std::string sequence(const std::vector<Segment>& order) {
  std::string words;
  for (const Segment segment : order) {
    if (!words.empty()) words += ", ";
    words += segment == Segment::Pelvis ? "pelvis" : segment == Segment::Chest ? "chest" : "lead arm";
  }
  return words;
}

std::string head_goes(bool is_with_the_hands) {
  return is_with_the_hands ? "with the hands" : "against the hands";
}

}  // namespace posecoach::text
