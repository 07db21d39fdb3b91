#include "core/coaching/known_fault.h"

#include <algorithm>
#include <array>
#include <vector>

namespace posecoach {
namespace {

enum class Sign { Positive, Negative, Any };

struct Name {
  std::string_view fault;
  StrokeKind kind;
  std::vector<Feature> features;
  Sign sign;
  std::vector<std::string_view> events;
};

const std::vector<Name>& names() {
  using enum Feature;
  static const std::vector<std::string_view> back = {"toe_up", "mid_backswing", "top"};
  static const std::vector<std::string_view> through = {"mid_downswing", "impact", "mid_follow_through"};
  static const std::vector<Name> kNames = {
      {"sway", StrokeKind::FullSwing, {HipsToTarget}, Sign::Negative, back},
      {"slide", StrokeKind::FullSwing, {HipsToTarget}, Sign::Positive, through},
      {"early_extension", StrokeKind::FullSwing, {HipsToBall}, Sign::Positive, through},
      {"loss_of_posture", StrokeKind::FullSwing, {ChestToBall}, Sign::Negative, through},
      {"loss_of_posture", StrokeKind::FullSwing, {ChestUp}, Sign::Positive, through},
      {"reverse_spine_angle", StrokeKind::FullSwing, {ChestToTarget}, Sign::Positive, back},
      {"chicken_wing",
       StrokeKind::FullSwing,
       {LeadArmBend},
       Sign::Positive,
       {"impact", "mid_follow_through"}},
      {"chicken_wing", StrokeKind::FullSwing, {LeadElbowPlace}, Sign::Any, {"impact", "mid_follow_through"}},
      {"chicken_wing", StrokeKind::FullSwing, {HandsPlace}, Sign::Any, {"mid_follow_through"}},
      {"bent_lead_arm",
       StrokeKind::FullSwing,
       {LeadArmBend},
       Sign::Positive,
       {"mid_backswing", "top", "mid_downswing"}},
      {"over_the_top", StrokeKind::FullSwing, {HandsToBall}, Sign::Positive, {"mid_downswing"}},
      {"head_lift", StrokeKind::FullSwing, {HeadUp}, Sign::Positive, through},
      {"flat_shoulder_turn", StrokeKind::FullSwing, {ChestToBall}, Sign::Negative, {"top"}},
      {"flat_shoulder_turn", StrokeKind::FullSwing, {ShoulderTilt}, Sign::Positive, {"mid_backswing", "top"}},
      {"wrist_break", StrokeKind::Putt, {LeadWristBreak}, Sign::Positive, {"impact", "end"}},
      {"head_moves_with_putter", StrokeKind::Putt, {HeadToTarget}, Sign::Negative, {"top"}},
      {"head_moves_with_putter", StrokeKind::Putt, {HeadToTarget}, Sign::Positive, {"impact", "end"}},
  };
  return kNames;
}

bool agrees(Sign sign, double amount) {
  return sign == Sign::Any || (sign == Sign::Positive ? amount > 0 : amount < 0);
}

template <typename Values, typename Value>
bool contains(const Values& values, const Value& value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

}  // namespace

std::string_view known_fault(Feature feature, double amount, std::string_view event, StrokeKind kind) {
  for (const Name& name : names())
    if (name.kind == kind && agrees(name.sign, amount) && contains(name.features, feature) &&
        contains(name.events, event))
      return name.fault;
  return {};
}

std::string_view known_timing_fault(std::string_view from, std::string_view to, double ratio,
                                    StrokeKind kind) {
  if (kind == StrokeKind::Putt) return from == "top" && to == "impact" ? "uneven_tempo" : "";
  if (from == "takeaway" && to == "top" && ratio > 1) return "slow_backswing";
  if (from == "top" && to == "mid_downswing" && ratio < 1) return "quick_transition";
  return {};
}

}  // namespace posecoach
