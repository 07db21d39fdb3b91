// The paper's losses (Eq. 10 to 15, 17, 18). Norms are means over all elements.
#pragma once

#include "core/retarget/network/motion_tensors.h"

namespace posecoach {

struct PaperLossOptions {
  double reconstruction = 1, cycle = 2.5, end_effectors = 50, adversarial = 1;
  bool discriminator = true;
  // The ablations of Table 2: L'_rec drops the parent-relative term, L'_cyc adds the root's path.
  bool reconstruct_rows = true;
  bool cycle_root = false;
};

struct PaperLosses {
  torch::Tensor reconstruction, cycle, end_effectors, adversarial;  // scalars, not weighted
  torch::Tensor total(const PaperLossOptions& options) const;
  torch::Tensor retargeted_rows;  // what the discriminator judges
};

// One source batch, and bodies of any structure to carry it to.
PaperLosses paper_losses(PaperNetworkImpl& network, MotionDiscriminator judge, const BodyBatch& source,
                         const BodyBatch& target, const PaperLossOptions& options);

// Least squares: real motions 1, retargeted ones 0.
torch::Tensor discriminator_loss(MotionDiscriminator judge, const torch::Tensor& real,
                                 const torch::Tensor& retargeted);

// Mean over joints and axes of the squared distance, in chain heights, root at the origin: the code metric.
double local_error(const StructureNetworkImpl& structure, const MotionTensors& one,
                   const MotionTensors& other);

}  // namespace posecoach
