// Motions and bodies as the networks see them: every frame turned so that the body faces +Z, bones in chain
// heights of the body, its path in leg lengths (so that a path means the same on any body), the slow part of
// the path over the floor taken away.
#pragma once

#include <random>
#include <span>
#include <vector>

#include "core/retarget/network/paper_network.h"
#include "core/retarget/network/turn_clip.h"

namespace posecoach {

struct MotionTensors {
  torch::Tensor bones;      // [batch, time, joints, 3], from the parent; zeros for the root
  torch::Tensor root;       // [batch, time, 3]
  torch::Tensor rotations;  // [batch, time, joints - 1, 4]: how each bone is turned
};

// Some bodies of one structure, each with a motion.
struct BodyBatch {
  BodyLayoutKind kind = BodyLayoutKind::Split28;
  torch::Tensor rest_bones;  // [batch, joints, 3]
  MotionTensors motion;
  torch::Tensor facing;      // [batch, time, 2]: cosine and sine of the heading
  torch::Tensor leg_length;  // [batch, 1, 1], in chain heights
};

// The same motions on another body of the same or another structure.
struct MotionWindow {
  const TurnClip* clip = nullptr;
  int begin = 0;
  bool mirrored = false, reversed = false;
};
std::vector<MotionWindow> random_windows(std::span<const TurnClip> clips, int count, int frames,
                                         std::mt19937_64& random);
TurnClip cut(const MotionWindow& window, int frames);

// One body for each clip; all clips of one length.
BodyBatch make_body_batch(BodyLayoutKind kind, std::span<const TurnClip> clips,
                          std::span<const RoleBody> bodies);

// What an extractor reads, standardised: [batch, time, joints + 1, values].
torch::Tensor input_rows(const StructureNetworkImpl& structure, PaperInput input,
                         const MotionTensors& motion);
// Parent-relative rows and root path, standardised (the paper's X), whatever the input is.
torch::Tensor standard_rows(const StructureNetworkImpl& structure, const MotionTensors& motion);

// Joints relative to the root, [batch, time, joints, 3].
torch::Tensor root_relative(const StructureNetworkImpl& structure, const MotionTensors& motion);

// Decodes features onto bodies.
MotionTensors decode(StructureNetworkImpl& structure, const torch::Tensor& features,
                     const torch::Tensor& rest_bones);
torch::Tensor skeleton_features(StructureNetworkImpl& structure, const torch::Tensor& rest_bones);

// Sets a structure's row statistics from many frames.
void measure_rows(StructureNetworkImpl& structure, PaperInput input, const BodyBatch& batch);

}  // namespace posecoach
