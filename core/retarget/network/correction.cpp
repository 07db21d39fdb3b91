#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <memory>

#include "core/base/index.h"
#include "core/body/forward_kinematics.h"
#include "core/retarget/doubt.h"
#include "core/retarget/learned.h"
#include "core/retarget/network/correction_network.h"
#include "core/retarget/network/one_thread.h"
#include "core/retarget/network/shipped_weights.h"
#include "core/retarget/network/turn_clip.h"
#include "core/retarget/network/weights_file.h"
#include "core/retarget/rotation_recovery.h"

namespace posecoach {
namespace {

Result<CorrectionNetwork> load_network() {
  const Result<WeightsFile> file = read_weights(shipped_network_weights(), "retarget-network.pt");
  if (!file) return tl::unexpected(file.error());
  if (file->kind != kCorrectionWeightsKind)
    return fail(ErrorCode::Malformed, "retarget-network.pt: not weights of the correction network");
  CorrectionNetwork network{CorrectionNetworkOptions()};
  if (const Result<void> loaded = load_tensors(*network, file->tensors, "retarget-network.pt"); !loaded)
    return tl::unexpected(loaded.error());
  return network;
}

// Rotation vectors [frames * canonical joints], in world axes.
std::vector<Vec3> corrections(CorrectionNetwork network, const CorrectionFrames& frames) {
  torch::InferenceMode inference;
  const auto count = static_cast<int64_t>(frames.headings.size());
  const torch::Tensor values =
      torch::from_blob(const_cast<float*>(frames.values.data()), {1, count, kCorrectionValues}, torch::kFloat)
          .transpose(1, 2)
          .contiguous();
  const torch::Tensor steadier =
      torch::from_blob(const_cast<float*>(frames.steadier.data()),
                       {1, count, static_cast<int64_t>(kHumanoidJointCount), kSteadyTurns, 3}, torch::kFloat);
  const torch::Tensor said = network(values, steadier).contiguous();
  const float* at = said.data_ptr<float>();
  std::vector<Vec3> vectors;
  for (const double heading : frames.headings)
    for (std::size_t role = 0; role < kHumanoidJointCount; ++role, at += 3)
      vectors.push_back(glm::angleAxis(heading, Vec3(0, 1, 0)) * Vec3(static_cast<double>(at[0]),
                                                                      static_cast<double>(at[1]),
                                                                      static_cast<double>(at[2])));
  return vectors;
}

// Linear in time between frames at the network's rate, which begin with the motion.
Vec3 correction_at(const std::vector<Vec3>& vectors, double seconds, HumanoidJoint role) {
  const std::size_t frames = vectors.size() / kHumanoidJointCount;
  const double place = std::clamp(seconds * kNetworkFramesPerSecond, 0.0, static_cast<double>(frames - 1));
  const auto before = static_cast<std::size_t>(place);
  const std::size_t after = std::min(before + 1, frames - 1);
  const auto of = [&](std::size_t frame) {
    return vectors[frame * kHumanoidJointCount + static_cast<std::size_t>(role)];
  };
  return glm::mix(of(before), of(after), place - static_cast<double>(before));
}

}  // namespace

Result<Motion> corrected_motion(const Motion& motion) {
  const std::vector<double> doubt = doubts(motion);
  if (std::all_of(doubt.begin(), doubt.end(), [](double d) { return d == 0; })) return motion;
  try {
    use_one_thread();
    static const Result<CorrectionNetwork> network = load_network();
    if (!network) return tl::unexpected(network.error());
    const Motion smooth = smoothed_where_doubtful(motion);
    const CorrectionFrames frames = correction_frames(resample(motion, kNetworkFramesPerSecond));
    const std::vector<Vec3> vectors = corrections(*network, frames);

    const Skeleton& skeleton = motion.skeleton();
    const TPose t_pose = make_t_pose(skeleton);
    const std::size_t joints = index(skeleton.size());
    std::vector<Quat> turns = recovered_turns(smooth), local(turns.size());
    std::vector<Vec3> roots;
    for (int frame = 0; frame < motion.frame_count(); ++frame) {
      const double seconds = to_seconds(motion.time(frame) - motion.time(0));
      const std::size_t first = index(frame) * joints;
      for (std::size_t j = 0; j < joints; ++j) {
        const Vec3 vector = doubt[index(frame)] * correction_at(vectors, seconds, frames.driver[j]);
        turns[first + j] = rotation_from_vector(vector) * turns[first + j] * t_pose.rotations[j];
      }
      local_rotations(skeleton, std::span<const Quat>(turns).subspan(first, joints),
                      std::span(local).subspan(first, joints));
      roots.push_back(smooth.position(frame, 0));
    }
    return Motion::from_rotations(skeleton, {motion.times().begin(), motion.times().end()}, std::move(roots),
                                  std::move(local));
  } catch (const std::exception& error) {
    return fail(ErrorCode::Internal, std::string("the correction network failed: ") + error.what());
  }
}

}  // namespace posecoach
