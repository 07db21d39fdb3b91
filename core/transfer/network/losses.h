// The pose losses of Zheng et al. (2021), equations 4 to 6, over batches [poses, 15, 2]. Differentiable in
// `result`.
#pragma once

#include <vector>

#include "core/transfer/network/torch.h"
#include "core/transfer/pose_similarity.h"

namespace posecoach {

// Which pairs along which directions, as tensors.
struct LinkProjection {
  torch::Tensor first, second;  // [pairs], indices of joints
  torch::Tensor directions;     // [2, directions]

  LinkProjection(const std::vector<Link>& links, const std::vector<Vec2>& directions);
  // p_i - p_j along every direction: [poses, pairs, directions].
  torch::Tensor differences(const torch::Tensor& poses) const;
};

// Equations 4 and 5: the order of two joints along a direction must stay as it was, at least `sigma` apart;
// joints closer than that stay close. Summed over directions, averaged over pairs and poses.
torch::Tensor virtual_link_loss(const torch::Tensor& source, const torch::Tensor& result,
                                const LinkProjection& links, double sigma);
// The ranking loss that the paper compares with (Pavlakos et al., 2018): log(1 + exp(-+ difference)).
torch::Tensor ranking_loss(const torch::Tensor& source, const torch::Tensor& result,
                           const LinkProjection& links, double sigma);
// Equation 6 over the bones: the mean of |cos(turn) - 1|. A bone of no length has no direction and counts
// nothing.
torch::Tensor angle_loss(const torch::Tensor& source, const torch::Tensor& result);

}  // namespace posecoach
