#include "core/retarget/network/paper_losses.h"

namespace posecoach {
namespace {

torch::Tensor squared(const torch::Tensor& a, const torch::Tensor& b) {
  return (a - b).square().mean();
}

// Movement a frame of toes, head and hands in the world, ten times, as the public code has it.
torch::Tensor end_effector_velocities(const StructureNetworkImpl& structure, const MotionTensors& motion,
                                      const BodyBatch& body, const torch::Tensor& facing) {
  const auto ends = BodyLayout::of(structure.kind).end_effectors();
  const torch::Tensor rows =
      torch::tensor(std::vector<int64_t>(ends.begin(), ends.end()), torch::TensorOptions(torch::kLong));
  const torch::Tensor at = torch::matmul(structure.root_from_parent.index_select(0, rows), motion.bones) +
                           (body.leg_length * motion.root).unsqueeze(2);
  const torch::Tensor cosine = facing.select(2, 0).unsqueeze(2), sine = facing.select(2, 1).unsqueeze(2);
  const torch::Tensor x = at.select(3, 0), y = at.select(3, 1), z = at.select(3, 2);
  const torch::Tensor world = torch::stack({cosine * x + sine * z, y, cosine * z - sine * x}, 3);
  const int64_t steps = world.size(1) - 1;
  return 10 * (world.narrow(1, 1, steps) - world.narrow(1, 0, steps));
}

}  // namespace

torch::Tensor PaperLosses::total(const PaperLossOptions& options) const {
  torch::Tensor sum =
      options.reconstruction * reconstruction + options.cycle * cycle + options.end_effectors * end_effectors;
  if (options.discriminator) sum = sum + options.adversarial * adversarial;
  return sum;
}

PaperLosses paper_losses(PaperNetworkImpl& network, MotionDiscriminator judge, const BodyBatch& source,
                         const BodyBatch& target, const PaperLossOptions& options) {
  StructureNetworkImpl& from = *network.of(source.kind);
  StructureNetworkImpl& to = *network.of(target.kind);
  const PaperInput input = network.options().input;
  const torch::Tensor motion_features = from.motion(input_rows(from, input, source.motion));
  const torch::Tensor source_body = skeleton_features(from, source.rest_bones);
  const torch::Tensor target_body = skeleton_features(to, target.rest_bones);
  const torch::Tensor source_relative = root_relative(from, source.motion);
  PaperLosses losses;

  const MotionTensors again = decode(from, motion_features + source_body, source.rest_bones);
  losses.reconstruction =
      100 * squared(root_relative(from, again), source_relative) +
      200 * squared(source.leg_length * again.root, source.leg_length * source.motion.root);
  if (options.reconstruct_rows)
    losses.reconstruction =
        losses.reconstruction + squared(standard_rows(from, again), standard_rows(from, source.motion));

  const MotionTensors carried = decode(to, motion_features + target_body, target.rest_bones);
  losses.end_effectors = squared(end_effector_velocities(from, source.motion, source, source.facing),
                                 end_effector_velocities(to, carried, target, source.facing));

  const torch::Tensor carried_features = to.motion(input_rows(to, input, carried));
  const MotionTensors back = decode(from, carried_features + source_body, source.rest_bones);
  losses.cycle =
      squared(root_relative(from, back), source_relative) + (motion_features - carried_features).abs().mean();
  if (options.cycle_root)
    losses.cycle =
        losses.cycle + squared(source.leg_length * back.root, source.leg_length * source.motion.root);

  losses.retargeted_rows = standard_rows(to, carried);
  losses.adversarial =
      options.discriminator ? (judge(losses.retargeted_rows) - 1).square().mean() : torch::zeros({});
  return losses;
}

torch::Tensor discriminator_loss(MotionDiscriminator judge, const torch::Tensor& real,
                                 const torch::Tensor& retargeted) {
  return 0.5 * ((judge(real) - 1).square().mean() + judge(retargeted.detach()).square().mean());
}

double local_error(const StructureNetworkImpl& structure, const MotionTensors& one,
                   const MotionTensors& other) {
  return squared(root_relative(structure, one), root_relative(structure, other)).item<double>();
}

}  // namespace posecoach
