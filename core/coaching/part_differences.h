// How the student's body differs from the coach's at one moment, part by part in the order in which the parts
// carry each other (feet, pelvis, chest, head and arms), so that hips that have slid are not told again as a
// chest, a head and two arms in the wrong place. For right-handed swings; lead = left.
//
// Directions are the golfer's: target (the lead side), up, ball (in front of him), from the coach's stance at
// address. Student minus coach throughout.
#pragma once

#include <string_view>
#include <vector>

#include "core/coaching/body_axes.h"
#include "core/coaching/joint_track.h"

namespace posecoach {

enum class Feature : unsigned char {
  HipsToTarget,  // middle of the hips over the ankles, metres
  HipsUp,
  HipsToBall,
  ChestToTarget,  // middle of the shoulders over the hips, metres: side bend and forward bend
  ChestUp,
  ChestToBall,
  HeadToTarget,  // over the middle of the shoulders, metres; for a putt over the ankles
  HeadUp,        // over the ankles, metres
  HeadToBall,
  HipTurn,         // degrees, positive towards the target
  ShoulderTurn,    // relative to the hips' turn difference
  ShoulderTilt,    // lead shoulder higher, degrees
  LeadElbowPlace,  // in the chest's own axes, metres
  TrailElbowPlace,
  LeadArmBend,  // degrees
  TrailArmBend,
  HandsPlace,    // in the chest's own axes, metres
  LeadKneeBend,  // degrees
  TrailKneeBend,
  StanceWidth,     // metres
  HandsToBall,     // over the ankles, metres: thrown out, over the top
  LeadWristBreak,  // degrees by which the lower hand is ahead of the lead forearm, towards the target
};
inline constexpr std::size_t kFeatureCount = 22;

// "hips_to_target", "lead_arm_bend", ... as written in files.
std::string_view to_string(Feature feature);

struct PartDifference {
  Feature feature = Feature::HipsToTarget;
  double amount = 0;      // metres or degrees, signed
  Vec3 offset;            // left, up, front components of the displacement that it stands for, metres
  double share = 0;       // of the summed joint error of the moment
  double confidence = 1;  // of the joints that it was read from
  bool is_size_known = true;
};

// What one moment of a track looks like, averaged over a short time around it.
JointTrack moment_of(const JointTrack& track, double time_s);

// `student` and `coach` are single moments that face the same way; the feet of both are put together at the
// anchor's ankles.
enum class Anchor { BothFeet, LeadFoot };
// A full swing's head is carried by the shoulders; over a putt it should not move at all.
enum class HeadOver { Shoulders, Feet };
// Arms are placed in axes that turn with the chest, or, where one camera guesses how far the chest is turned,
// in the world's.
enum class ArmAxes { Chest, World };
struct DifferenceOptions {
  Anchor anchor = Anchor::BothFeet;
  HeadOver head_over = HeadOver::Shoulders;
  ArmAxes arm_axes = ArmAxes::Chest;
};
std::vector<PartDifference> part_differences(const JointTrack& student, const JointTrack& coach,
                                             const BodyAxes& axes, const DifferenceOptions& options);

}  // namespace posecoach
