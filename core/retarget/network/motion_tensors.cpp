#include "core/retarget/network/motion_tensors.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/index.h"

namespace posecoach {
namespace {

class Filler {
 public:
  explicit Filler(std::vector<int64_t> shape)
      : tensor_(torch::zeros(shape)), at_(tensor_.data_ptr<float>()) {}
  void add(const Vec3& v) {
    for (int i = 0; i < 3; ++i) *at_++ = static_cast<float>(v[i]);
  }
  void add(const Quat& q) {
    for (const double value : {q.w, q.x, q.y, q.z}) *at_++ = static_cast<float>(value);
  }
  void add(double value) { *at_++ = static_cast<float>(value); }
  torch::Tensor done() const { return tensor_; }

 private:
  torch::Tensor tensor_;
  float* at_;
};

torch::Tensor joint_rows(const StructureNetworkImpl& structure, PaperInput input,
                         const MotionTensors& motion) {
  switch (input) {
    case PaperInput::ParentBased:
      return motion.bones;
    case PaperInput::RootBased:
      return root_relative(structure, motion);
    case PaperInput::Rotations:
      break;
  }
  const torch::Tensor rotations = motion.rotations;
  return torch::cat({torch::zeros_like(rotations.narrow(2, 0, 1)), rotations}, 2);
}

torch::Tensor raw_rows(const torch::Tensor& joints, const torch::Tensor& root) {
  torch::Tensor row = root.unsqueeze(2);
  if (joints.size(3) == 4) row = torch::cat({row, torch::zeros_like(row.narrow(3, 0, 1))}, 3);
  return torch::cat({joints, row}, 2);
}

}  // namespace

std::vector<MotionWindow> random_windows(std::span<const TurnClip> clips, int count, int frames,
                                         std::mt19937_64& random) {
  std::vector<double> starts;  // in how many places a window fits
  for (const TurnClip& clip : clips)
    starts.push_back(std::max(0.0, static_cast<double>(clip.frames.size()) - frames + 1));
  std::discrete_distribution<std::size_t> pick(starts.begin(), starts.end());
  std::vector<MotionWindow> windows;
  for (int i = 0; i < count; ++i) {
    const std::size_t clip = pick(random);
    const int last = static_cast<int>(starts[clip]) - 1;
    windows.push_back({&clips[clip], std::uniform_int_distribution<int>(0, last)(random),
                       std::bernoulli_distribution(0.5)(random), std::bernoulli_distribution(0.5)(random)});
  }
  return windows;
}

TurnClip cut(const MotionWindow& window, int frames) {
  const auto begin = window.clip->frames.begin() + window.begin;
  TurnClip made{window.clip->name, {begin, begin + frames}};
  if (window.mirrored) made = mirrored(made);
  if (window.reversed) made = reversed(std::move(made));
  return made;
}

BodyBatch make_body_batch(BodyLayoutKind kind, std::span<const TurnClip> clips,
                          std::span<const RoleBody> bodies) {
  POSECOACH_ASSERT(clips.size() == bodies.size() && !clips.empty());
  const BodyLayout& layout = BodyLayout::of(kind);
  const int joints = layout.size();
  const auto batch = static_cast<int64_t>(clips.size());
  const auto time = static_cast<int64_t>(clips[0].frames.size());
  Filler rest_bones({batch, joints, 3}), bones({batch, time, joints, 3}), root({batch, time, 3}),
      rotations({batch, time, joints - 1, 4}), facing({batch, time, 2}), leg_length({batch, 1, 1});
  std::vector<Vec3> at(index(joints));
  const auto add_bones = [&](Filler& to, const Quat& turn, double height) {
    for (int j = 0; j < joints; ++j) {
      const int parent = layout.joints()[index(j)].parent;
      to.add(parent == kNoJoint ? Vec3(0) : turn * (at[index(j)] - at[index(parent)]) / height);
    }
  };
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const RoleBody& body = bodies[i];
    layout.place(body.rest, RoleArray<Quat>{}, body.rest_height, at);
    const double height = layout.chain_height(at);
    add_bones(rest_bones, Quat(1, 0, 0, 0), height);
    leg_length.add(body.leg_length / height);
    for (const TurnFrame& frame : clips[i].frames) {
      layout.place(posed(body, frame), frame.turns, body.rest_height, at);
      const Quat turn = glm::angleAxis(-frame.heading, Vec3(0, 1, 0));
      add_bones(bones, turn, height);
      root.add(turn * (at[0] / body.leg_length - frame.slow_path));
      for (int j = 1; j < joints; ++j) {
        const LayoutJoint& parent = layout.joints()[index(layout.joints()[index(j)].parent)];
        const Quat bone_turn = turn * frame.turns[parent.first];
        rotations.add(bone_turn.w < 0 ? -bone_turn : bone_turn);
      }
      facing.add(std::cos(frame.heading));
      facing.add(std::sin(frame.heading));
    }
  }
  return {kind,
          rest_bones.done(),
          {bones.done(), root.done(), rotations.done()},
          facing.done(),
          leg_length.done()};
}

torch::Tensor input_rows(const StructureNetworkImpl& structure, PaperInput input,
                         const MotionTensors& motion) {
  return (raw_rows(joint_rows(structure, input, motion), motion.root) - structure.input_mean) /
         structure.input_deviation;
}

torch::Tensor standard_rows(const StructureNetworkImpl& structure, const MotionTensors& motion) {
  return (raw_rows(motion.bones, motion.root) - structure.mean) / structure.deviation;
}

torch::Tensor root_relative(const StructureNetworkImpl& structure, const MotionTensors& motion) {
  return torch::matmul(structure.root_from_parent, motion.bones);
}

MotionTensors decode(StructureNetworkImpl& structure, const torch::Tensor& features,
                     const torch::Tensor& rest_bones) {
  const DecodedMotion decoded = structure.decoder(features);
  const torch::Tensor last = structure.mean.select(0, -1), spread = structure.deviation.select(0, -1);
  return {turned_bones(rest_bones, decoded.rotations), decoded.root * spread + last, decoded.rotations};
}

torch::Tensor skeleton_features(StructureNetworkImpl& structure, const torch::Tensor& rest_bones) {
  return structure.skeleton((rest_bones - structure.rest_mean) / structure.rest_deviation);
}

void measure_rows(StructureNetworkImpl& structure, PaperInput input, const BodyBatch& batch) {
  torch::NoGradGuard no_gradient;
  // Rows that hardly vary (the root's zeros, rigid faces) are not blown up.
  const auto spread = [](const torch::Tensor& values) {
    const torch::Tensor deviation = values.std(0, false);
    return torch::where(deviation < 1e-3, torch::ones_like(deviation), deviation);
  };
  const torch::Tensor rows = raw_rows(batch.motion.bones, batch.motion.root).flatten(0, 1);
  structure.mean.copy_(rows.mean(0));
  structure.deviation.copy_(spread(rows));
  const torch::Tensor inputs =
      raw_rows(joint_rows(structure, input, batch.motion), batch.motion.root).flatten(0, 1);
  structure.input_mean.copy_(inputs.mean(0));
  structure.input_deviation.copy_(spread(inputs));
  structure.rest_mean.copy_(batch.rest_bones.mean(0));
  structure.rest_deviation.copy_(spread(batch.rest_bones));
}

}  // namespace posecoach
