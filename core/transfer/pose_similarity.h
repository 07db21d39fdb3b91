// How alike two poses of different people are, and how well a transfer met the truth: the measures of
// Zheng et al. (2021), section 4.3. All poses must be complete; positions in the paper's units (every pose
// within (-1, 1) by one scale for all).
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/transfer/pose2d.h"

namespace posecoach {

// Pairs of joints that a measure looks at: the bones; bones and all pairs of the five end-effectors; all 105
// pairs.
enum class Links { Bones, BonesAndEnds, All };
using Link = std::pair<Joint2d, Joint2d>;
const std::vector<Link>& links(Links which);
// The ten pairs of nose, wrists and ankles.
const std::vector<Link>& end_effector_links();

// Unit vectors evenly spread over a half turn, beginning at `turned_radians` from the x axis: 2 are x and y,
// 4 add the diagonals, 8 the directions between.
std::vector<Vec2> projection_directions(int count, double turned_radians = 0);

struct LinkCount {
  long long flipped = 0;
  long long total = 0;
  LinkCount& operator+=(const LinkCount& other);
  double percent() const { return total > 0 ? 100.0 * double(flipped) / double(total) : 0; }
};
// How many projections of links onto directions have opposite signs in the two poses.
LinkCount violations(const Pose2d& a, const Pose2d& b, std::span<const Link> links,
                     std::span<const Vec2> directions);

// Mean over the links of the squared angle (radians, in [0, pi]) between the two poses' directions. A link of
// no length in either pose has no direction and is left out.
double mean_squared_angle(const Pose2d& a, const Pose2d& b, std::span<const Link> links);

struct TransferError {
  double mse_lengths = 0;  // mean squared difference of bone lengths
  double mse_angles = 0;   // mean squared angle between corresponding bones
  double mse_joints = 0;   // mean distance of corresponding joints, boxes centred on each other
  double oks_percent = 0;  // object keypoint similarity
};
// `truth` gives the size for the OKS: COCO's formula with k = 2 sigma, the area that of the truth's bounding
// box; COCO has no sigma for neck and mid-hip, they take those of shoulder and hip.
TransferError transfer_error(const Pose2d& result, const Pose2d& truth);

}  // namespace posecoach
