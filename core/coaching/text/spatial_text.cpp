#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/coaching/text/advice_text.h"
#include "core/coaching/text/fill.h"
#include "core/coaching/text/name_text.h"

namespace posecoach::text {
namespace {

using enum Feature;

// Which way something is off: along the largest part of its offset, or more and less of an angle. A turn
// before the ball and after it is told in different words.
enum class Way {
  Up,
  Down,
  ToTarget,
  FromTarget,
  ToBall,
  FromBall,
  More,
  Less,
  MoreBack,
  LessBack,
  MoreThrough,
  LessThrough,
  Any
};

struct Sentence {
  Feature feature;
  Way way;
  std::string_view fault;  // told by its name; empty: by none, or by any that has no line of its own
  std::string_view words;
};

// The first that fits is said.
constexpr std::array kSentences = {
    Sentence{HipsToTarget, Way::FromTarget, "sway",
             "{When}, your hips are {size} too far from the target: a sway."},
    Sentence{HipsToTarget, Way::FromTarget, "", "{When}, your hips are {size} too far from the target."},
    Sentence{HipsToTarget, Way::ToTarget, "slide",
             "{When}, your hips are {size} too far toward the target: a slide."},
    Sentence{HipsToTarget, Way::ToTarget, "", "{When}, your hips are {size} too far toward the target."},
    Sentence{HipsUp, Way::Up, "", "{When}, your hips are {size} too high."},
    Sentence{HipsUp, Way::Down, "", "{When}, your hips are {size} too low."},
    Sentence{HipsToBall, Way::ToBall, "early_extension",
             "{When}, your hips are {size} too close to the ball: early extension."},
    Sentence{HipsToBall, Way::ToBall, "", "{When}, your hips are {size} too close to the ball."},
    Sentence{HipsToBall, Way::FromBall, "", "{When}, your hips are {size} too far from the ball."},
    Sentence{ChestToTarget, Way::ToTarget, "reverse_spine_angle",
             "{When}, your upper body leans {size} too far toward the target: a reverse spine angle."},
    Sentence{ChestToTarget, Way::ToTarget, "",
             "{When}, your upper body leans {size} too far toward the target."},
    Sentence{ChestToTarget, Way::FromTarget, "",
             "{When}, your upper body leans {size} too far away from the target."},
    Sentence{ChestUp, Way::Up, "loss_of_posture",
             "{When}, your upper body is {size} too high: you are standing up, a loss of posture."},
    Sentence{ChestUp, Way::Up, "", "{When}, your upper body is {size} too high: you stand too upright."},
    Sentence{ChestUp, Way::Down, "", "{When}, your upper body is {size} too low: you bend over too far."},
    Sentence{
        ChestToBall, Way::FromBall, "loss_of_posture",
        "{When}, your upper body is {size} too far from the ball: you are standing up, a loss of posture."},
    Sentence{ChestToBall, Way::FromBall, "flat_shoulder_turn",
             "{When}, your upper body is {size} too far from the ball: you stand up, and your shoulders turn "
             "flat."},
    Sentence{ChestToBall, Way::FromBall, "",
             "{When}, your upper body is {size} too far from the ball: you stand too upright."},
    Sentence{ChestToBall, Way::ToBall, "",
             "{When}, your upper body is {size} too close to the ball: you bend over too far."},
    Sentence{HeadToTarget, Way::ToTarget, "", "{When}, your head is {size} too far toward the target."},
    Sentence{HeadToTarget, Way::FromTarget, "", "{When}, your head is {size} too far from the target."},
    Sentence{HeadUp, Way::Up, "", "{When}, your head is {size} too high."},
    Sentence{HeadUp, Way::Down, "", "{When}, your head is {size} too low."},
    Sentence{HeadToBall, Way::ToBall, "", "{When}, your head is {size} too close to the ball."},
    Sentence{HeadToBall, Way::FromBall, "", "{When}, your head is {size} too far from the ball."},
    Sentence{HipTurn, Way::More, "", "{When}, your hips are {angle} more open than the coach's."},
    Sentence{HipTurn, Way::Less, "", "{When}, your hips are {angle} more closed than the coach's."},
    Sentence{HipTurn, Way::MoreBack, "", "{When}, your hips have turned back {angle} more than the coach's."},
    Sentence{HipTurn, Way::LessBack, "", "{When}, your hips have turned back {angle} less than the coach's."},
    Sentence{HipTurn, Way::MoreThrough, "",
             "{When}, your hips have turned through {angle} more than the coach's."},
    Sentence{HipTurn, Way::LessThrough, "",
             "{When}, your hips have turned through {angle} less than the coach's."},
    Sentence{ShoulderTurn, Way::More, "", "{When}, your shoulders are {angle} more open than the coach's."},
    Sentence{ShoulderTurn, Way::Less, "", "{When}, your shoulders are {angle} more closed than the coach's."},
    Sentence{ShoulderTurn, Way::MoreBack, "",
             "{When}, your shoulders have turned back {angle} more than the coach's."},
    Sentence{ShoulderTurn, Way::LessBack, "",
             "{When}, your shoulders have turned back {angle} less than the coach's."},
    Sentence{ShoulderTurn, Way::MoreThrough, "",
             "{When}, your shoulders have turned through {angle} more than the coach's."},
    Sentence{ShoulderTurn, Way::LessThrough, "",
             "{When}, your shoulders have turned through {angle} less than the coach's."},
    Sentence{ShoulderTilt, Way::More, "flat_shoulder_turn",
             "{When}, your lead shoulder is {angle} too high: your shoulders turn flat."},
    Sentence{ShoulderTilt, Way::More, "", "{When}, your lead shoulder is {angle} too high."},
    Sentence{ShoulderTilt, Way::Less, "", "{When}, your lead shoulder is {angle} too low."},
    Sentence{LeadElbowPlace, Way::Up, "", "{When}, your lead elbow is {size} too high."},
    Sentence{LeadElbowPlace, Way::Down, "", "{When}, your lead elbow is {size} too low."},
    Sentence{LeadElbowPlace, Way::ToTarget, "",
             "{When}, your lead elbow is {size} too far toward the target."},
    Sentence{LeadElbowPlace, Way::FromTarget, "",
             "{When}, your lead elbow is {size} too far from the target."},
    Sentence{LeadElbowPlace, Way::ToBall, "", "{When}, your lead elbow is {size} too close to the ball."},
    Sentence{LeadElbowPlace, Way::FromBall, "", "{When}, your lead elbow is {size} too far from the ball."},
    Sentence{TrailElbowPlace, Way::Up, "", "{When}, your trail elbow is {size} too high."},
    Sentence{TrailElbowPlace, Way::Down, "", "{When}, your trail elbow is {size} too low."},
    Sentence{TrailElbowPlace, Way::ToTarget, "",
             "{When}, your trail elbow is {size} too far toward the target."},
    Sentence{TrailElbowPlace, Way::FromTarget, "",
             "{When}, your trail elbow is {size} too far from the target."},
    Sentence{TrailElbowPlace, Way::ToBall, "", "{When}, your trail elbow is {size} too close to the ball."},
    Sentence{TrailElbowPlace, Way::FromBall, "", "{When}, your trail elbow is {size} too far from the ball."},
    Sentence{LeadArmBend, Way::More, "chicken_wing",
             "{When}, your lead arm is bent {angle} more than the coach's: a chicken wing."},
    Sentence{LeadArmBend, Way::More, "", "{When}, your lead arm is bent {angle} more than the coach's."},
    Sentence{LeadArmBend, Way::Less, "", "{When}, your lead arm is bent {angle} less than the coach's."},
    Sentence{TrailArmBend, Way::More, "", "{When}, your trail arm is bent {angle} more than the coach's."},
    Sentence{TrailArmBend, Way::Less, "", "{When}, your trail arm is bent {angle} less than the coach's."},
    Sentence{HandsPlace, Way::Any, "chicken_wing",
             "{When}, your hands are {size} from where the coach's are: your arms fold, a chicken wing."},
    Sentence{HandsPlace, Way::Up, "", "{When}, your hands are {size} too high."},
    Sentence{HandsPlace, Way::Down, "", "{When}, your hands are {size} too low."},
    Sentence{HandsPlace, Way::ToTarget, "", "{When}, your hands are {size} too far toward the target."},
    Sentence{HandsPlace, Way::FromTarget, "", "{When}, your hands are {size} too far from the target."},
    Sentence{HandsPlace, Way::ToBall, "", "{When}, your hands are {size} too close to the ball."},
    Sentence{HandsPlace, Way::FromBall, "", "{When}, your hands are {size} too far from the ball."},
    Sentence{LeadKneeBend, Way::More, "", "{When}, your lead knee is bent {angle} more than the coach's."},
    Sentence{LeadKneeBend, Way::Less, "", "{When}, your lead knee is bent {angle} less than the coach's."},
    Sentence{TrailKneeBend, Way::More, "", "{When}, your trail knee is bent {angle} more than the coach's."},
    Sentence{TrailKneeBend, Way::Less, "", "{When}, your trail knee is bent {angle} less than the coach's."},
    Sentence{StanceWidth, Way::More, "", "{When}, your feet stand {size} too wide."},
    Sentence{StanceWidth, Way::Less, "", "{When}, your feet stand {size} too narrow."},
    Sentence{HandsToBall, Way::ToBall, "",
             "{When}, your hands are {size} too close to the ball: they come over the top."},
    Sentence{HandsToBall, Way::FromBall, "", "{When}, your hands are {size} too far from the ball."},
    Sentence{LeadWristBreak, Way::More, "",
             "{When}, your lead wrist is broken {angle} more than the coach's: the putter passes the hands."},
    Sentence{LeadWristBreak, Way::Less, "",
             "{When}, your lead wrist is broken {angle} less than the coach's."},
};

// What is seen to be there, but not by how much.
constexpr std::array kWithoutSize = {
    Sentence{HandsPlace, Way::Any, "chicken_wing", "{When}, your arms fold: a chicken wing."},
    Sentence{LeadWristBreak, Way::More, "wrist_break",
             "{When}, your lead wrist is broken: the putter passes the hands."},
    Sentence{HeadUp, Way::Up, "head_lift", "{When}, your head is too high: it has come up."},
};

struct Told {
  Way way = Way::Any;
  double metres = 0;
};

// Along the direction of the largest part of an offset (target, up, ball) that the view can see.
Told place(const Vec3& offset, Viewpoint view) {
  const Vec3 seen(sees_target_direction(view) ? offset.x : 0, offset.y,
                  sees_ball_direction(view) ? offset.z : 0);
  const Vec3 size = glm::abs(seen);
  const double metres = glm::length(seen);
  if (size.y >= size.x && size.y >= size.z) return {seen.y > 0 ? Way::Up : Way::Down, metres};
  if (size.x >= size.z) return {seen.x > 0 ? Way::ToTarget : Way::FromTarget, metres};
  return {seen.z > 0 ? Way::ToBall : Way::FromBall, metres};
}

Way turn(double amount, std::string_view event) {
  if (event == "address") return amount > 0 ? Way::More : Way::Less;
  // Before the ball the turn goes away from the target, after it towards it.
  if (event == "toe_up" || event == "mid_backswing" || event == "top")
    return amount > 0 ? Way::LessBack : Way::MoreBack;
  return amount > 0 ? Way::MoreThrough : Way::LessThrough;
}

Told told(const PartDifference& d, std::string_view event, Viewpoint view) {
  switch (d.feature) {
    case HipsToTarget:
    case ChestToTarget:
    case HeadToTarget:
      return {d.amount > 0 ? Way::ToTarget : Way::FromTarget, d.amount};
    case HipsUp:
    case ChestUp:
    case HeadUp:
      return {d.amount > 0 ? Way::Up : Way::Down, d.amount};
    case HipsToBall:
    case ChestToBall:
    case HeadToBall:
    case HandsToBall:
      return {d.amount > 0 ? Way::ToBall : Way::FromBall, d.amount};
    case LeadElbowPlace:
    case TrailElbowPlace:
    case HandsPlace:
      return place(d.offset, view);
    case HipTurn:
    case ShoulderTurn:
      return {turn(d.amount, event), 0};
    case ShoulderTilt:
    case LeadArmBend:
    case TrailArmBend:
    case LeadKneeBend:
    case TrailKneeBend:
    case StanceWidth:
    case LeadWristBreak:
      break;
  }
  return {d.amount > 0 ? Way::More : Way::Less, d.amount};
}

}  // namespace

std::string spatial(const PartDifference& difference, std::string_view event, std::string_view fault,
                    Viewpoint view) {
  const Told what = told(difference, event, view);
  for (const Sentence& sentence : kWithoutSize)
    if (!difference.is_size_known && sentence.feature == difference.feature && sentence.fault == fault)
      return filled(sentence.words, {{"When", std::string(moment(event))}});
  for (const Sentence& sentence : kSentences) {
    const bool fits = sentence.feature == difference.feature &&
                      (sentence.way == what.way || sentence.way == Way::Any) &&
                      (sentence.fault == fault || sentence.fault.empty());
    if (!fits) continue;
    const double metres = sentence.way == Way::Any ? difference.amount : what.metres;
    return filled(sentence.words, {{"When", std::string(moment(event))},
                                   {"size", centimetres(metres)},
                                   {"angle", degrees(difference.amount)}});
  }
  POSECOACH_ASSERT(!"a difference without a sentence");
  return {};
}

}  // namespace posecoach::text
