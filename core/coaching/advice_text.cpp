#include "core/coaching/advice_text.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace posecoach::text {
namespace {

std::string centimetres(double metres) {
  return fmt::format("{:.0f} cm", std::abs(metres) * 100);
}

std::string degrees(double value) {
  return fmt::format("{:.0f}°", std::abs(value));
}

// The direction of the largest part of an offset (target, up, ball) that the view can see.
std::string way(const Vec3& offset, Viewpoint view) {
  const double target = sees_target_direction(view) ? offset.x : 0;
  const double ball = sees_ball_direction(view) ? offset.z : 0;
  const double up = offset.y;
  if (std::abs(up) >= std::abs(target) && std::abs(up) >= std::abs(ball))
    return up > 0 ? "too high" : "too low";
  if (std::abs(target) >= std::abs(ball))
    return target > 0 ? "too far toward the target" : "too far from the target";
  return ball > 0 ? "too close to the ball" : "too far from the ball";
}

std::string place(const char* what, const char* is, const Vec3& offset, Viewpoint view) {
  const Vec3 seen(sees_target_direction(view) ? offset.x : 0, offset.y,
                  sees_ball_direction(view) ? offset.z : 0);
  return fmt::format("{} {} {} {}", what, is,
                     centimetres(std::sqrt(seen.x * seen.x + seen.y * seen.y + seen.z * seen.z)),
                     way(offset, view));
}

std::string bend(const char* what, double amount) {
  return fmt::format("{} is bent {} {} than the coach's", what, degrees(amount),
                     amount > 0 ? "more" : "less");
}

std::string turn(const char* what, double amount, std::string_view event) {
  // Before the ball the turn goes away from the target, after it towards it.
  const bool back = event == "address" || event == "toe_up" || event == "mid_backswing" || event == "top";
  const bool less = back ? amount > 0 : amount < 0;
  return fmt::format(
      "{} are turned {} {} than the coach's", what, degrees(amount),
      event == "address" ? (amount > 0 ? "more open" : "more closed") : (less ? "less" : "more"));
}

std::string body_part(const PartDifference& d, std::string_view event, Viewpoint view) {
  switch (d.feature) {
    case Feature::HipsToTarget:
    case Feature::HipsUp:
    case Feature::HipsToBall:
      return place("your hips", "are", d.offset, view);
    case Feature::ChestToTarget:
      return fmt::format("your upper body leans {} too far {}", centimetres(d.amount),
                         d.amount > 0 ? "toward the target" : "away from the target");
    case Feature::ChestUp:
      return d.amount > 0 ? fmt::format("your back is {} too upright", centimetres(d.amount))
                          : fmt::format("you are bent over {} too low", centimetres(d.amount));
    case Feature::ChestToBall:
      return fmt::format("your upper body is bent {} too {}", centimetres(d.amount),
                         d.amount > 0 ? "far forward" : "little forward: you are standing up");
    case Feature::HeadToTarget:
    case Feature::HeadUp:
    case Feature::HeadToBall:
      return place("your head", "is", d.offset, view);
    case Feature::HipTurn:
      return turn("your hips", d.amount, event);
    case Feature::ShoulderTurn:
      return turn("your shoulders", d.amount, event);
    case Feature::ShoulderTilt:
      if (event == "top")
        return fmt::format("your shoulders are tilted {} too {}", degrees(d.amount),
                           d.amount > 0 ? "little: they turn flat" : "much: they turn steep");
      return fmt::format("your lead shoulder is {} too {}", degrees(d.amount), d.amount > 0 ? "high" : "low");
    case Feature::LeadElbowPlace:
      return place("your lead elbow", "is", d.offset, view);
    case Feature::TrailElbowPlace:
      return place("your trail elbow", "is", d.offset, view);
    case Feature::LeadArmBend:
      return bend("your lead arm", d.amount);
    case Feature::TrailArmBend:
      return bend("your trail arm", d.amount);
    case Feature::HandsPlace:
      if (event == "mid_follow_through")
        return fmt::format("your hands are {} away from where the coach's are, your arms fold",
                           centimetres(d.amount));
      return place("your hands", "are", d.offset, view);
    case Feature::HandsToBall:
      return fmt::format("your hands are {} too {} the ball{}", centimetres(d.amount),
                         d.amount > 0 ? "close to" : "far from",
                         d.amount > 0 ? ": they come over the top" : "");
    case Feature::LeadKneeBend:
      return bend("your lead knee", d.amount);
    case Feature::TrailKneeBend:
      return bend("your trail knee", d.amount);
    case Feature::LeadWristBreak:
      return fmt::format(
          "your lead wrist is broken {} {}", degrees(d.amount),
          d.amount > 0 ? "more than the coach's: the putter passes the hands" : "less than the coach's");
    case Feature::StanceWidth:
      return fmt::format("your feet stand {} too {}", centimetres(d.amount),
                         d.amount > 0 ? "wide" : "narrow");
  }
  return {};
}

struct Names {
  std::string_view key, words;
};

constexpr std::array kMoments = {Names{"address", "at address"},
                                 Names{"toe_up", "early in the backswing"},
                                 Names{"mid_backswing", "halfway back"},
                                 Names{"top", "at the top"},
                                 Names{"mid_downswing", "halfway down"},
                                 Names{"impact", "at impact"},
                                 Names{"mid_follow_through", "after impact"},
                                 Names{"finish", "at the finish"},
                                 Names{"end", "at the end of the stroke"}};

}  // namespace

std::string_view moment(std::string_view event) {
  for (const Names& names : kMoments)
    if (names.key == event) return names.words;
  return event;
}

std::string_view phase(std::string_view from, std::string_view to) {
  if (to == "top") return "backswing";
  if (from == "top" && to == "mid_downswing") return "transition";
  if (to == "impact") return "downswing";
  if (from == "impact") return "follow-through";
  return "swing";
}

std::string spatial(const PartDifference& difference, std::string_view event, Viewpoint view) {
  std::string sentence(moment(event));
  sentence.front() = static_cast<char>(sentence.front() - 'a' + 'A');
  return sentence + ", " + body_part(difference, event, view) + ".";
}

std::string timing(const TimingAdvice& t, double relative_ratio, bool is_clear, bool in_proportion) {
  const std::string name(phase(t.from, t.to));
  const std::string times =
      fmt::format("Your {} takes {:.2f} s, the coach's {:.2f} s", name, t.student_s, t.coach_s);
  if (!is_clear) return times + (in_proportion ? ": in proportion about the same." : ": about the same.");
  const double percent = 100 * std::abs(relative_ratio - 1);
  return times + fmt::format(": {}{:.0f} % too {}.", in_proportion ? "in proportion to your swing " : "",
                             percent, relative_ratio < 1 ? "quick" : "slow");
}

std::string pose_match(std::string_view event, double late_s, bool is_clear) {
  std::string name(event);
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!is_clear) return "Your " + name + " comes in time.";
  return fmt::format("Your {} comes {:.2f} s too {}.", name, std::abs(late_s), late_s > 0 ? "late" : "early");
}

std::string with_fault_name(std::string sentence, std::string_view fault) {
  // What the sentence does not say already.
  constexpr std::array kNames = {
      Names{"sway", "a sway"}, Names{"slide", "a slide"}, Names{"early_extension", "early extension"},
      Names{"reverse_spine_angle", "a reverse spine angle"}, Names{"chicken_wing", "a chicken wing"}};
  for (const Names& name : kNames)
    if (name.key == fault && !sentence.empty() && sentence.back() == '.') {
      sentence.pop_back();
      return sentence + ": " + std::string(name.words) + ".";
    }
  return sentence;
}

std::string strictness(const std::string& harder, const std::string& softer, const std::string& never) {
  std::string words;
  const auto add = [&](const char* how, const std::string& parts) {
    if (!parts.empty()) words += (words.empty() ? "" : "; ") + std::string(how) + ": " + parts;
  };
  add("Judged harder than usual", harder);
  add(words.empty() ? "Judged more mildly than usual" : "more mildly", softer);
  add(words.empty() ? "Not judged" : "not at all", never);
  return words.empty() ? words : words + ".";
}

std::string block(int swings, double mean, double deviation, const std::string& advice, int times) {
  std::string words = swings == 1
                          ? fmt::format("One swing: {:.0f} of 100.", mean)
                          : fmt::format("{} swings: {:.0f} ± {:.0f} of 100.", swings, mean, deviation);
  if (!advice.empty() && swings > 1) words += fmt::format(" In {} of them: {}", times, advice);
  return words;
}

std::string no_clear_difference(double percent) {
  if (percent < 80)
    return "No clear difference from the coach was found: many small ones, none that stands out.";
  return "No clear difference from the coach was found.";
}

std::string other_pace(double ratio, bool is_film) {
  if (ratio < 1)
    return fmt::format(
        "The whole swing takes only {:.0f} % of the coach's time; its parts are compared in proportion.",
        100 * ratio);
  return fmt::format(
      "The whole swing takes {:.1f} times as long as the coach's: {}; its parts are compared in proportion.",
      ratio, is_film ? "a slow swing or a film in slow motion" : "a slow swing");
}

std::string out_of_reach(double metres) {
  return fmt::format(
      "The coach's grip is up to {:.0f} cm out of reach of your arms; there the drawn hands are open.",
      100 * metres);
}

std::string no_golf_stroke(const std::string& why) {
  return "this is no golf stroke: " + why;
}

std::string hands_apart(double metres) {
  return "the hands are " + centimetres(metres) + " apart, and no two hands on one club are";
}

std::string feet_walk(double metres) {
  return "the feet move " + centimetres(metres) + " before the ball would be hit";
}

std::string hands_miss_the_ball(double metres) {
  return "the hands pass " + centimetres(metres) + " away from where they started, so the ball is missed";
}

std::string no_golf_tempo(double backswing_s, double downswing_s) {
  return fmt::format("the hands go back for {:.1f} s and forward for {:.1f} s", backswing_s, downswing_s);
}

std::string chest_does_not_turn(double angle) {
  return "the chest turns only " + degrees(angle);
}

std::string hidden_by_view(Viewpoint view) {
  return view == Viewpoint::FaceOn ? "not visible from face-on: film down the line for it"
                                   : "not visible from down the line: film face-on for it";
}

std::string hidden_by_one_camera() {
  return "one camera only guesses how far a body is turned";
}

std::string sequence_too_close(double frame_rate) {
  return fmt::format("the peaks are less than a frame apart: {:.0f} frames a second cannot tell", frame_rate);
}

std::string head_is_still(double metres) {
  return fmt::format("the head moves only {:.0f} mm", 1000 * metres);
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

std::string implausible(double value, std::string_view unit) {
  return fmt::format("the pose model's {:.0f} {} is not plausible: one camera tells turns badly", value,
                     unit);
}

std::string seen_from(Viewpoint view) {
  switch (view) {
    case Viewpoint::AllSides:
      return {};
    case Viewpoint::FaceOn:
      return "Filmed face-on: turns, and what happens towards the ball, are not judged.";
    case Viewpoint::DownTheLine:
      return "Filmed down the line: turns, the lead arm, and what happens along the target line are not "
             "judged.";
    case Viewpoint::Between:
      break;
  }
  return "Filmed from an angle: only the timing and the height of the head are judged; stand square to the "
         "camera for more.";
}

std::string too_few_frames(double frame_rate) {
  return fmt::format("too few frames a second ({:.0f}) for it", frame_rate);
}

std::string hidden_joints(std::string_view what) {
  return std::string(what) + " hidden from the camera at that moment";
}

}  // namespace posecoach::text
