// Recorded motion without a body: how each canonical joint is turned, and the path of the hips in leg
// lengths. Put on any body, two bodies give a pair of which the truth is known.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/motion/motion.h"
#include "core/retarget/network/body_layout.h"

namespace posecoach {

inline constexpr double kNetworkFramesPerSecond = 30;

struct TurnFrame {
  RoleArray<Quat> turns;  // global, away from the T-pose
  Vec3 hips;              // mid-hips, leg lengths, world axes
  // What the network does not see: the direction that the body faces (radians about +Y from +Z), and the slow
  // part of the path over the floor (leg lengths, y = 0).
  double heading = 0;
  Vec3 slow_path;
};

struct TurnClip {
  std::string name;
  std::vector<TurnFrame> frames;  // at kNetworkFramesPerSecond
};

// Errors: Incomplete naming the joints that the rig lacks.
Result<TurnClip> make_turn_clip(std::string name, const Motion& motion);

// The mirror image; the same frames backwards.
TurnClip mirrored(const TurnClip& clip);
TurnClip reversed(TurnClip clip);

// Where a body faces: across hips and shoulders, smoothed over time, so that neither a shrug nor a lost frame
// turns it. One angle a frame, continuous.
std::vector<double> smooth_headings(std::span<const Vec3> across);
// The path over the floor, smoothed over a second and a half; y = 0.
std::vector<Vec3> slow_path(std::span<const Vec3> path);

// A Gaussian over frames; the ends count as often as they stick out. Sigma in frames.
std::vector<Vec3> smoothed(std::span<const Vec3> values, double sigma_frames);

// A body to put clips on: T-pose positions of the canonical joints, the hips' height from the floor in its y.
struct RoleBody {
  RoleArray<Vec3> rest;
  double leg_length = 0;  // hip to ankle
  double rest_height = 0;
};
RoleBody make_role_body(const RoleArray<Vec3>& rest);

// Canonical joint positions in a frame; metres.
RoleArray<Vec3> posed(const RoleBody& body, const TurnFrame& frame);

struct BodyVariety {
  double proportions = 0.25;     // each limb's length within 1 +- this
  double cartoon_share = 0.25;   // bodies with proportions that no human has
  double rest_tilt_share = 0.5;  // bodies whose T-pose points elsewhere than the average one's
};
RoleBody random_role_body(std::mt19937_64& random, const BodyVariety& variety = {});

}  // namespace posecoach
