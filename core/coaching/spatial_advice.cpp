#include "core/coaching/spatial_advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>

#include "core/coaching/film_habits.h"
#include "core/coaching/known_fault.h"
#include "core/coaching/part_differences.h"
#include "core/coaching/posture.h"
#include "core/coaching/score.h"
#include "core/coaching/text/advice_text.h"

namespace posecoach {
namespace {

enum class Group {
  Hips,
  Chest,
  Head,
  HipTurn,
  Shoulders,
  LeadArm,
  TrailArm,
  Hands,
  Wrists,
  LeadLeg,
  TrailLeg,
  Stance
};
JudgedPart judged_part(Group group) {
  switch (group) {
    case Group::Hips:
    case Group::HipTurn:
      return JudgedPart::Hips;
    case Group::Chest:
    case Group::Shoulders:
      return JudgedPart::Trunk;
    case Group::Head:
      return JudgedPart::Head;
    case Group::LeadArm:
    case Group::TrailArm:
    case Group::Hands:
    case Group::Wrists:
      return JudgedPart::Arms;
    case Group::LeadLeg:
    case Group::TrailLeg:
    case Group::Stance:
      break;
  }
  return JudgedPart::Legs;
}

enum class Direction { Target, Up, Ball, Any };

struct FeatureRule {
  Feature feature;
  Group group;
  const char* joint;  // of a right-hander
  Direction direction;
  // Metres or degrees from which on a difference is clear to motion capture: two good swings of one golfer
  // stay below it. For films see core/coaching/film_habits.h.
  double clear;
};

constexpr std::array<FeatureRule, kFeatureCount> kRules = {{
    {Feature::HipsToTarget, Group::Hips, "pelvis", Direction::Target, 0.04},
    {Feature::HipsUp, Group::Hips, "pelvis", Direction::Up, 0.035},
    {Feature::HipsToBall, Group::Hips, "pelvis", Direction::Ball, 0.04},
    {Feature::ChestToTarget, Group::Chest, "chest", Direction::Target, 0.045},
    {Feature::ChestUp, Group::Chest, "chest", Direction::Up, 0.05},
    {Feature::ChestToBall, Group::Chest, "chest", Direction::Ball, 0.045},
    {Feature::HeadToTarget, Group::Head, "head", Direction::Target, 0.035},
    {Feature::HeadUp, Group::Head, "head", Direction::Up, 0.045},
    {Feature::HeadToBall, Group::Head, "head", Direction::Ball, 0.055},
    {Feature::HipTurn, Group::HipTurn, "left_hip", Direction::Any, 12},
    {Feature::ShoulderTurn, Group::Shoulders, "left_shoulder", Direction::Any, 12},
    {Feature::ShoulderTilt, Group::Shoulders, "left_shoulder", Direction::Any, 7.5},
    {Feature::LeadElbowPlace, Group::LeadArm, "left_elbow", Direction::Any, 0.06},
    {Feature::TrailElbowPlace, Group::TrailArm, "right_elbow", Direction::Any, 0.06},
    {Feature::LeadArmBend, Group::LeadArm, "left_elbow", Direction::Any, 14},
    {Feature::TrailArmBend, Group::TrailArm, "right_elbow", Direction::Any, 24},
    {Feature::HandsPlace, Group::Hands, "left_wrist", Direction::Any, 0.07},
    {Feature::LeadKneeBend, Group::LeadLeg, "left_knee", Direction::Any, 14},
    {Feature::TrailKneeBend, Group::TrailLeg, "right_knee", Direction::Any, 14},
    {Feature::StanceWidth, Group::Stance, "left_ankle", Direction::Target, 0.05},
    {Feature::HandsToBall, Group::Hands, "left_wrist", Direction::Ball, 0.05},
    {Feature::LeadWristBreak, Group::Wrists, "left_wrist", Direction::Any, 14},
}};

// Half hidden joints of films are in the habits that were measured (film_habits.h): a far hip and ankle down
// the line are never seen well.
constexpr double kLeastConfidence = 0.5, kLeastConfidenceOneCamera = 0.25;
// What was off at address already and stays so is told at address.
constexpr double kAlreadyAtAddress = 0.75;
// A putt is a small movement: half of it is clear already.
constexpr double kPuttFactor = 0.5;
constexpr double kExplains = 0.8;
constexpr double kPushes = 0.6;
// Next to something this much worse a difference is told only when it is this clear by itself.
constexpr double kByProduct = 0.7, kClearByItself = 2;
// The finish is a result, not a cause.
constexpr double kFinishWeight = 0.6;

// Close to straight, an elbow's angle says little about where the hand is; and nobody is told to bend the
// lead arm.
constexpr double kStraighterArmFactor = 2.2;
// What golfers have a name for is told by it, where something without a name says as much.
constexpr double kKnownFaultFactor = 1.15;
// Metres that are clear are those of a golfer of 1.80 m; shorter and taller ones move less and more.
constexpr double kUsualLeg_m = 0.884;

struct Candidate {
  const FeatureRule* rule = nullptr;
  PartDifference difference;
  std::string event;
  double severity = 0, rank = 0;
};

bool is_length(const FeatureRule& rule) {
  return rule.clear < 1;
}

double size_of(const PartDifference& difference, const FeatureRule& rule, const ComparedSwings& swings,
               const BodyAxes& axes) {
  // Of a film, the amount was put right and the offset was not.
  const bool is_place = rule.direction == Direction::Any && is_length(rule) && !is_one_camera(swings.views);
  if (!is_place) return std::abs(difference.amount);
  const Vec3& o = difference.offset;
  return glm::length(swings.sight.seen(o.x * axes.left + o.y * axes.up + o.z * axes.front));
}

std::vector<PartDifference> differences_at(const ComparedSwings& swings, std::string_view event,
                                           const BodyAxes& axes, Anchor anchor) {
  const bool is_putt = swings.student_events.kind == StrokeKind::Putt;
  std::vector<PartDifference> differences =
      part_differences(moment_of(swings.student, swings.student_events.time_of(event)),
                       moment_of(swings.coach, swings.coach_events.time_of(event)), axes,
                       {anchor, is_putt ? HeadOver::Feet : HeadOver::Shoulders,
                        is_one_camera(swings.views) ? ArmAxes::World : ArmAxes::Chest});
  // With the club at the ball, as all through a putt, a body's own reach bends his arms, and the coach's in
  // that body likewise.
  if (swings.coach_himself == nullptr || is_putt || event == "address" || event == "impact")
    return differences;
  const JointTrack student = moment_of(swings.student, swings.student_events.time_of(event)),
                   coach = moment_of(*swings.coach_himself, swings.coach_events.time_of(event));
  const auto arm_bend = [](const JointTrack& body, bool is_lead) {
    return is_lead ? bend_deg(body, 0, HumanoidJoint::LeftShoulder, HumanoidJoint::LeftElbow,
                              HumanoidJoint::LeftWrist)
                   : bend_deg(body, 0, HumanoidJoint::RightShoulder, HumanoidJoint::RightElbow,
                              HumanoidJoint::RightWrist);
  };
  for (PartDifference& difference : differences) {
    const bool is_lead = difference.feature == Feature::LeadArmBend;
    if (is_lead || difference.feature == Feature::TrailArmBend)
      difference.amount = arm_bend(student, is_lead) - arm_bend(coach, is_lead);
  }
  return differences;
}

// A webcam's body is not quite the golfer's, and its pose model has habits: what is off from address on may
// be theirs, only what changes from there is the swing's, less what is usual.
void put_right(std::vector<PartDifference>& differences, const ComparedSwings& swings, std::string_view event,
               const BodyAxes& axes, Anchor anchor, double size) {
  const std::vector<PartDifference> before = differences_at(swings, "address", axes, anchor);
  for (std::size_t k = 0; k < differences.size(); ++k) {
    PartDifference& difference = differences[k];
    const FeatureRule& rule = kRules[static_cast<std::size_t>(difference.feature)];
    const auto habit = feature_habit(swings.views, swings.student_events.kind, event, difference.feature);
    const double seen = difference.amount - before[k].amount, unit = is_length(rule) ? size : 1;
    const double right = habit ? unit * habit->truth_from(seen / unit) : seen;
    difference.offset -= before[k].offset;
    // A displacement along one direction is as long as its amount.
    if (rule.direction != Direction::Any && std::abs(seen) > 1e-9) difference.offset *= right / seen;
    // A distance is none below what is usual.
    difference.amount = difference.feature == Feature::HandsPlace ? std::max(0.0, right) : right;
    difference.is_size_known = !habit || habit->is_size_known;
  }
}

// 0 where the view cannot tell.
double clear_amount(const FeatureRule& rule, const ComparedSwings& swings, std::string_view event,
                    double size) {
  const double unit = is_length(rule) ? size : 1;
  if (!is_one_camera(swings.views)) return unit * rule.clear;
  const auto habit = feature_habit(swings.views, swings.student_events.kind, event, rule.feature);
  return habit ? unit * habit->clear : 0;
}

std::vector<Candidate> candidates_at(const ComparedSwings& swings, std::string_view event,
                                     const BodyAxes& axes, Anchor anchor, double size) {
  const bool is_putt = swings.student_events.kind == StrokeKind::Putt;
  std::vector<PartDifference> differences = differences_at(swings, event, axes, anchor);
  if (is_one_camera(swings.views)) put_right(differences, swings, event, axes, anchor, size);
  std::vector<Candidate> found;
  for (const PartDifference& difference : differences) {
    const FeatureRule& rule = kRules[static_cast<std::size_t>(difference.feature)];
    const double clear = clear_amount(rule, swings, event, size);
    const double least_confidence =
        is_one_camera(swings.views) ? kLeastConfidenceOneCamera : kLeastConfidence;
    if (clear <= 0 || difference.confidence < least_confidence) continue;
    // In a full swing the wrists hinge and release; over a putt they are quiet.
    if (rule.feature == Feature::LeadWristBreak && !is_putt) continue;
    if (rule.feature == Feature::HandsToBall && event != "mid_downswing") continue;
    Candidate candidate{&rule, difference, std::string(event), 0, 0};
    candidate.severity = size_of(difference, rule, swings, axes) / clear;
    const bool is_arm_bend = rule.feature == Feature::LeadArmBend || rule.feature == Feature::TrailArmBend;
    if (is_arm_bend && difference.amount < 0) candidate.severity /= kStraighterArmFactor;
    if (is_putt && !is_one_camera(swings.views)) candidate.severity /= kPuttFactor;
    candidate.severity *= swings.strictness.of(judged_part(rule.group));
    if (!is_one_camera(swings.views) && (event == "finish" || event == "end"))
      candidate.severity *= kFinishWeight;
    candidate.rank = candidate.severity * std::sqrt(difference.share + 0.02);
    if (!known_fault(rule.feature, difference.amount, event, swings.student_events.kind).empty())
      candidate.rank *= kKnownFaultFactor;
    found.push_back(std::move(candidate));
  }
  return found;
}

// The moment at which one feature is told: where it is worst, or address when it was there from the start.
Candidate worst_moment(const std::vector<Candidate>& moments) {
  const auto worst = std::max_element(moments.begin(), moments.end(),
                                      [](const auto& a, const auto& b) { return a.severity < b.severity; });
  const Candidate& first = moments.front();
  const bool same_way = glm::dot(first.difference.offset, worst->difference.offset) > 0 ||
                        first.difference.amount * worst->difference.amount > 0;
  if (first.event == "address" && same_way && first.severity > kAlreadyAtAddress * worst->severity)
    return first;
  return *worst;
}

using Moments = std::map<Feature, std::vector<Candidate>>;

// Whether what carries this part is off at the same moment and nearly as badly: hands by an arm, a head by
// the trunk.
bool is_explained(const Candidate& candidate, const std::map<Group, Candidate>& by_group,
                  const Moments& moments) {
  if (candidate.rule->feature == Feature::HandsPlace) {
    for (const Group arm : {Group::LeadArm, Group::TrailArm})
      if (const auto found = by_group.find(arm);
          found != by_group.end() && found->second.severity > kExplains * candidate.severity)
        return true;
  }
  // Both hands are on the club: when the lead arm folds the trail arm has to.
  if (candidate.rule->group == Group::TrailArm) {
    const auto lead = by_group.find(Group::LeadArm);
    if (lead != by_group.end() && lead->second.event == candidate.event &&
        lead->second.severity > kExplains * candidate.severity)
      return true;
  }
  const auto is_nearly_as_bad = [&](Group group, double part) {
    const auto found = by_group.find(group);
    return found != by_group.end() && found->second.event == candidate.event &&
           found->second.severity > part * candidate.severity;
  };
  // The hands stay at the ball when the chest leaves it; in the chest's axes they are then off.
  if (candidate.rule->feature == Feature::HandsPlace && is_nearly_as_bad(Group::Chest, kExplains))
    return true;
  // Shoulders that turn flat lift the chest.
  if (candidate.difference.feature == Feature::ChestToBall && candidate.event == "top" &&
      is_nearly_as_bad(Group::Shoulders, kPushes))
    return true;
  // Hips that come forward push the chest up: that is one fault, early extension.
  if (candidate.difference.feature == Feature::ChestToBall ||
      candidate.difference.feature == Feature::ChestUp) {
    const auto hips = by_group.find(Group::Hips);
    if (hips != by_group.end() && hips->second.difference.feature == Feature::HipsToBall &&
        hips->second.difference.amount > 0 && hips->second.event == candidate.event &&
        hips->second.severity > kPushes * candidate.severity)
      return true;
  }
  if (candidate.rule->group == Group::Head) {
    for (const auto& [feature, all] : moments)
      for (const Candidate& other : all)
        if ((other.rule->group == Group::Hips || other.rule->group == Group::Chest) &&
            other.event == candidate.event && other.severity > kExplains * candidate.severity)
          return true;
  }
  return false;
}

SpatialAdvice to_advice(const Candidate& candidate, const ComparedSwings& swings) {
  SpatialAdvice advice;
  advice.joint = candidate.rule->joint;
  advice.event = candidate.event;
  advice.student_frame = swings.student.nearest_frame(swings.student_events.time_of(candidate.event));
  advice.coach_frame = swings.coach.nearest_frame(swings.coach_events.time_of(candidate.event));
  advice.offset_m = candidate.difference.offset;
  advice.distance_m = glm::length(advice.offset_m);
  advice.turn_deg = candidate.rule->clear >= 1 ? candidate.difference.amount : 0;
  advice.share = candidate.difference.share;
  advice.severity = candidate.severity;
  advice.measure = to_string(candidate.difference.feature);
  advice.amount = candidate.difference.amount;
  advice.fault =
      known_fault(candidate.difference.feature, advice.amount, candidate.event, swings.student_events.kind);
  advice.advice = text::spatial(candidate.difference, candidate.event, advice.fault, swings.views.student);
  return advice;
}

}  // namespace

std::vector<SpatialAdvice> find_spatial_advice(const ComparedSwings& swings, std::size_t most) {
  const double takeaway = swings.coach_events.takeaway_s;
  const BodyAxes axes = body_axes(swings.coach, std::max(0.0, takeaway - 0.2), takeaway);
  Moments by_feature;
  Anchor anchor = Anchor::BothFeet;
  const double size = std::clamp(leg_length(swings.coach) / kUsualLeg_m, 0.7, 1.2);
  for (const SwingEvent& event : swings.student_events.events) {
    for (Candidate& candidate : candidates_at(swings, event.name, axes, anchor, size))
      by_feature[candidate.difference.feature].push_back(std::move(candidate));
    if (event.name != "impact") continue;
    anchor = Anchor::LeadFoot;
  }
  std::map<Group, Candidate> by_group;
  for (const auto& [feature, moments] : by_feature) {
    const Candidate candidate = worst_moment(moments);
    if (candidate.severity < 1) continue;
    const auto [place, is_new] = by_group.try_emplace(candidate.rule->group, candidate);
    if (!is_new && candidate.rank > place->second.rank) place->second = candidate;
  }
  std::vector<Candidate> ranked;
  for (const auto& [group, candidate] : by_group)
    if (!is_explained(candidate, by_group, by_feature)) ranked.push_back(candidate);
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.rank > b.rank; });
  // Next to the main thing, what is slight is its by-product.
  if (!ranked.empty()) {
    const double least = std::min(kClearByItself, kByProduct * ranked.front().severity);
    std::erase_if(ranked, [least](const Candidate& candidate) { return candidate.severity < least; });
  }
  if (ranked.size() > most) ranked.resize(most);
  std::vector<SpatialAdvice> advice;
  for (const Candidate& candidate : ranked) advice.push_back(to_advice(candidate, swings));
  return advice;
}

}  // namespace posecoach
