#include "core/motion/authored/golf_fault.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <vector>

#include "core/base/assert.h"

namespace posecoach {
namespace {

using enum GolfChannel;

constexpr std::array<GolfFault, 15> kFaults = {{
    {"sway", "swing", "cm", 10, 25, "hips move away from the target in the backswing"},
    {"slide", "swing", "cm", 10, 25, "hips move too far towards the target in the downswing"},
    {"early_extension", "swing", "cm", 8, 20,
     "hips move towards the ball in the downswing, the trunk straightens"},
    {"loss_of_posture", "swing", "deg", 15, 35, "the trunk's forward bend is lost by impact"},
    {"reverse_spine_angle", "swing", "deg", 15, 30, "the trunk leans towards the target at the top"},
    {"chicken_wing", "swing", "deg", 45, 90, "the lead elbow bends and sticks out after impact"},
    {"bent_lead_arm", "swing", "deg", 35, 80, "the lead elbow bends at the top"},
    {"over_the_top", "swing", "deg", 12, 25,
     "hands and club are thrown out towards the ball early in the downswing"},
    {"quick_transition", "swing", "%", 35, 70,
     "the time from the top to the lead arm level is shorter by this"},
    {"slow_backswing", "swing", "%", 40, 150, "the backswing takes longer by this"},
    {"head_lift", "swing", "cm", 7, 15, "the head comes up at impact"},
    {"flat_shoulder_turn", "swing", "deg", 15, 30, "the shoulders turn flatter at the top"},
    {"wrist_break", "putt", "deg", 20, 45,
     "the lead wrist breaks down through impact: the putter passes the hands"},
    {"head_moves_with_putter", "putt", "cm", 4, 12, "the head goes back and through with the putter"},
    {"uneven_tempo", "putt", "%", 50, 150, "the time from the top to impact is longer by this"},
}};

using Offsets = std::vector<GolfScript::Offset>;

// A channel's part in a fault: what one unit of the amount adds at the named instants.
struct Change {
  GolfChannel channel;
  Offsets for_one;
};

std::vector<Change> changes_of(std::string_view fault) {
  if (fault == "sway")
    return {{PelvisSway,
             {{"address", 0}, {"mid_backswing", -0.8}, {"top", -1}, {"mid_downswing", -0.4}, {"impact", 0}}}};
  if (fault == "slide")
    return {{PelvisSway,
             {{"top", 0}, {"mid_downswing", 0.5}, {"impact", 1}, {"mid_follow_through", 0.8}, {"finish", 0}}},
            {ChestSide, {{"top", 0}, {"impact", 0.5}, {"mid_follow_through", 0.4}, {"finish", 0}}}};
  if (fault == "early_extension")
    return {
        {PelvisThrust,
         {{"top", 0}, {"mid_downswing", 0.5}, {"impact", 1}, {"mid_follow_through", 0.9}, {"finish", 0}}},
        {ChestBend,
         {{"top", 0}, {"mid_downswing", -0.5}, {"impact", -1.4}, {"mid_follow_through", -1}, {"finish", 0}}},
        {PelvisBend,
         {{"top", 0},
          {"mid_downswing", -0.5},
          {"impact", -1.2},
          {"mid_follow_through", -0.6},
          {"finish", 0}}}};
  if (fault == "loss_of_posture")
    return {
        {ChestBend,
         {{"top", 0}, {"mid_downswing", -0.5}, {"impact", -1}, {"mid_follow_through", -0.6}, {"finish", 0}}},
        {PelvisBend,
         {{"top", 0},
          {"mid_downswing", -0.3},
          {"impact", -0.6},
          {"mid_follow_through", -0.3},
          {"finish", 0}}}};
  if (fault == "reverse_spine_angle")
    return {
        {ChestSide,
         {{"address", 0}, {"mid_backswing", -0.7}, {"top", -1.1}, {"mid_downswing", -0.5}, {"impact", 0}}},
        {PelvisSide, {{"address", 0}, {"top", -0.5}, {"impact", 0}}}};
  if (fault == "chicken_wing")
    return {
        {LeadElbow,
         {{"delivery", 0},
          {"impact", 0.25},
          {"release", 0.8},
          {"mid_follow_through", 1.2},
          {"wrap", 0.3},
          {"finish", 0}}},
        {LeadElbowOut, {{"delivery", 0}, {"release", 0.03}, {"mid_follow_through", 0.035}, {"finish", 0}}}};
  if (fault == "bent_lead_arm")
    return {{LeadElbow,
             {{"address", 0},
              {"toe_up", 0.15},
              {"mid_backswing", 0.5},
              {"top", 1},
              {"mid_downswing", 0.8},
              {"impact", 0}}}};
  if (fault == "over_the_top")
    return {{HandsOut, {{"top", 0}, {"mid_downswing", 1}, {"delivery", 0.7}, {"impact", 0}}},
            {ClubPlane, {{"top", 0}, {"mid_downswing", 1}, {"delivery", 0.5}, {"impact", 0}}},
            {ChestTurn, {{"top", 0}, {"mid_downswing", 1}, {"impact", 0.4}, {"mid_follow_through", 0}}}};
  if (fault == "head_lift")
    return {{ChestBend,
             {{"mid_downswing", 0},
              {"impact", -1.3},
              {"release", -1.5},
              {"mid_follow_through", -1},
              {"finish", 0}}},
            {HeadBend, {{"mid_downswing", 0}, {"impact", -2.5}, {"mid_follow_through", -1.5}, {"finish", 0}}},
            {HeadTurn, {{"mid_downswing", 0}, {"impact", 2.5}, {"mid_follow_through", 2}, {"finish", 0}}},
            {PelvisLift, {{"mid_downswing", 0}, {"impact", 0.25}, {"mid_follow_through", 0}}}};
  if (fault == "flat_shoulder_turn")
    return {
        {ChestBend,
         {{"address", 0}, {"mid_backswing", -0.8}, {"top", -1.1}, {"mid_downswing", -0.5}, {"impact", 0}}},
        {PelvisBend, {{"address", 0}, {"top", -0.3}, {"impact", 0}}}};
  if (fault == "wrist_break")
    return {{ClubAngle, {{"top", 0}, {"impact", 0.3}, {"mid_follow_through", 0.8}, {"end", 1}}}};
  if (fault == "head_moves_with_putter")
    return {{PelvisSway, {{"address", 0}, {"top", -0.4}, {"impact", 0}, {"end", 0.4}}},
            {ChestSide, {{"address", 0}, {"top", 1.1}, {"impact", 0}, {"end", -1.1}}}};
  return {};
}

bool change_timing(GolfScript& script, const FaultChoice& choice) {
  const double part = choice.amount / 100;
  if (choice.fault->name == "quick_transition")
    script.stretch("top", "mid_downswing", 1 - part);
  else if (choice.fault->name == "slow_backswing")
    script.stretch("takeaway", "top", 1 + part);
  else if (choice.fault->name == "uneven_tempo")
    script.stretch("top", "impact", 1 + part);
  else
    return false;
  return true;
}

std::string in_words(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

}  // namespace

std::span<const GolfFault> golf_faults() {
  return kFaults;
}

std::string golf_fault_table() {
  std::string table;
  for (const GolfFault& fault : kFaults)
    table += std::string(fault.name) + " (" + std::string(fault.motion) + ", " + std::string(fault.unit) +
             ", default " + in_words(fault.default_amount) + "): " + std::string(fault.meaning) + "\n";
  return table;
}

Result<FaultChoice> choose_fault(std::string_view name, std::optional<double> amount) {
  const auto* const found = std::find_if(kFaults.begin(), kFaults.end(),
                                         [&](const GolfFault& fault) { return fault.name == name; });
  if (found == kFaults.end()) {
    std::string known;
    for (const GolfFault& fault : kFaults) known += (known.empty() ? "" : ", ") + std::string(fault.name);
    return fail(ErrorCode::InvalidArgument,
                "there is no fault \"" + std::string(name) + "\"; there are: " + known);
  }
  const FaultChoice choice{found, amount.value_or(found->default_amount)};
  if (!(choice.amount >= 0 && choice.amount <= found->largest_amount))
    return fail(ErrorCode::InvalidArgument, "the amount of " + std::string(name) + " is from 0 to " +
                                                in_words(found->largest_amount) + " " +
                                                std::string(found->unit));
  return choice;
}

Result<FaultChoice> fault_from_string(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return choose_fault(text);
  const std::string_view number = text.substr(equals + 1);
  double amount = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), amount);
  if (error != std::errc{} || end != number.data() + number.size())
    return fail(ErrorCode::InvalidArgument,
                "the amount of a fault is a number, as in sway=8; \"" + std::string(number) + "\" is none");
  return choose_fault(text.substr(0, equals), amount);
}

Result<void> apply_fault(GolfScript& script, const FaultChoice& choice) {
  POSECOACH_ASSERT(choice.fault != nullptr);
  if (choice.fault->motion != script.name())
    return fail(ErrorCode::InvalidArgument, std::string(choice.fault->name) + " is a fault of the " +
                                                std::string(choice.fault->motion) + ", not of the " +
                                                script.name());
  if (change_timing(script, choice)) return {};
  for (Change& change : changes_of(choice.fault->name)) {
    for (GolfScript::Offset& offset : change.for_one) offset.value *= choice.amount;
    script.add(change.channel, change.for_one);
  }
  return {};
}

}  // namespace posecoach
