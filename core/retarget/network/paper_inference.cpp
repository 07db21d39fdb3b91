#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/file.h"
#include "core/base/index.h"
#include "core/retarget/carry.h"
#include "core/retarget/joint_mapping.h"
#include "core/retarget/learned.h"
#include "core/retarget/network/motion_tensors.h"
#include "core/retarget/network/one_thread.h"
#include "core/retarget/network/paper_inference.h"
#include "core/retarget/network/shipped_weights.h"
#include "core/retarget/root_path.h"
#include "core/retarget/t_pose.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr int kShortest = 16;

// A skeleton's joints as those of its layout.
class LayoutBody {
 public:
  explicit LayoutBody(const Skeleton& skeleton)
      : skeleton_(skeleton), layout_(BodyLayout::of(layout_kind_of(skeleton))) {
    rest_ = placed(make_t_pose(skeleton).positions);
    height_ = layout_.chain_height(rest_);
  }

  std::vector<Vec3> placed(std::span<const Vec3> joints) const {
    if (layout_.kind() == BodyLayoutKind::Webcam38) return {joints.begin(), joints.end()};
    std::vector<Vec3> at(index(layout_.size()));
    layout_.place(role_positions(skeleton_, joints), RoleArray<Quat>{}, 1, at);
    return at;
  }
  // Bones of one frame, from the parent, turned and in chain heights.
  void add_bones(std::span<const Vec3> at, const Quat& turn, std::vector<float>& to) const {
    for (int j = 0; j < layout_.size(); ++j) {
      const int parent = layout_.joints()[index(j)].parent;
      const Vec3 bone = parent == kNoJoint ? Vec3(0) : turn * (at[index(j)] - at[index(parent)]) / height_;
      for (int i = 0; i < 3; ++i) to.push_back(static_cast<float>(bone[i]));
    }
  }
  torch::Tensor rest_bones() const {
    std::vector<float> values;
    add_bones(rest_, Quat(1, 0, 0, 0), values);
    return torch::tensor(values).view({1, layout_.size(), 3});
  }

  const BodyLayout& layout() const { return layout_; }
  std::span<const Vec3> rest() const { return rest_; }
  double height() const { return height_; }

 private:
  const Skeleton& skeleton_;
  const BodyLayout& layout_;
  std::vector<Vec3> rest_;
  double height_ = 0;
};

// The layout's joints that are canonical ones, as a skeleton of the body's proportions.
Skeleton canonical_skeleton(const LayoutBody& body, std::vector<int>& joints_of_layout) {
  std::array<int, kHumanoidJointCount> made;
  made.fill(kNoJoint);
  std::vector<Joint> joints;
  for (int j = 0; j < body.layout().size(); ++j) {
    const LayoutJoint& from = body.layout().joints()[index(j)];
    const auto role = static_cast<std::size_t>(from.first);
    if (from.first != from.second || made[role] != kNoJoint) continue;
    int parent = kNoJoint;
    for (auto up = canonical_parent(from.first); up && parent == kNoJoint; up = canonical_parent(*up))
      parent = made[static_cast<std::size_t>(*up)];
    made[role] = static_cast<int>(joints.size());
    const Vec3 parent_at = parent == kNoJoint ? Vec3(0) : body.rest()[index(joints_of_layout[index(parent)])];
    joints.push_back({from.name, parent, body.rest()[index(j)] - parent_at, from.first});
    joints_of_layout.push_back(j);
  }
  Result<Skeleton> skeleton = Skeleton::make(std::move(joints));
  POSECOACH_ASSERT(skeleton.has_value());
  return *std::move(skeleton);
}

}  // namespace

Result<PaperNetwork> load_paper_network(std::string_view bytes, const std::string& name) {
  const Result<WeightsFile> file = read_weights(bytes, name);
  if (!file) return tl::unexpected(file.error());
  const auto variant = file->numbers.find("variant");
  if (file->kind != kPaperWeightsKind || variant == file->numbers.end() || variant->second < 0 ||
      variant->second > static_cast<int64_t>(PaperVariant::RotationInput))
    return fail(ErrorCode::Malformed, name + ": not weights of the paper's network");
  PaperNetwork network(network_options_of(static_cast<PaperVariant>(variant->second)));
  if (const Result<void> loaded = load_tensors(*network, file->tensors, name); !loaded)
    return tl::unexpected(loaded.error());
  return network;
}

Result<Motion> carried_by(PaperNetwork network, const Motion& coach, const Skeleton& body) {
  if (const auto mapping = map_joints(coach.skeleton(), body); !mapping)
    return tl::unexpected(mapping.error());
  const Motion sampled = resample(coach, kNetworkFramesPerSecond);
  const LayoutBody from(coach.skeleton()), to(body);
  const int frames = sampled.frame_count();
  const double from_leg = coach.skeleton().leg_length(), to_leg = body.leg_length();
  std::vector<Vec3> across, hips;
  for (int frame = 0; frame < frames; ++frame) {
    const auto at = sampled.positions(frame);
    const auto line = [&](HumanoidJoint left, HumanoidJoint right) {
      const Vec3 v = at[index(coach.skeleton().find(left))] - at[index(coach.skeleton().find(right))];
      return glm::length(v) > 1e-9 ? glm::normalize(v) : v;
    };
    across.push_back(line(LeftHip, RightHip) + line(LeftShoulder, RightShoulder));
    hips.push_back(hip_centre(coach.skeleton(), at) / from_leg);
  }
  const std::vector<double> headings = smooth_headings(across);
  const std::vector<Vec3> slow = slow_path(hips);

  // Of the ablation that reads rotations; the file's own, or recovered ones where it has none.
  std::vector<TurnFrame> turns;
  if (network->options().input == PaperInput::Rotations) {
    const Result<TurnClip> clip = make_turn_clip("coach", sampled);
    if (!clip) return tl::unexpected(clip.error());
    turns = clip->frames;
    turns.resize(index(frames), turns.back());
  }

  // Whole motions go through at once; the end is held until the network's stride is full.
  const int padded = std::max(kShortest, (frames + 3) / 4 * 4);
  std::vector<float> bones, roots, rotations;
  for (int i = 0; i < padded; ++i) {
    const int frame = std::min(i, frames - 1);
    const Quat turn = glm::angleAxis(-headings[index(frame)], Vec3(0, 1, 0));
    const std::vector<Vec3> at = from.placed(sampled.positions(frame));
    from.add_bones(at, turn, bones);
    for (int j = 1; j < from.layout().size() && !turns.empty(); ++j) {
      const LayoutJoint& joint = from.layout().joints()[index(j)];
      const HumanoidJoint carrier = from.layout().joints()[index(joint.parent)].first;
      const Quat q = turn * turns[index(frame)].turns[carrier];
      for (const double value : {q.w, q.x, q.y, q.z})
        rotations.push_back(static_cast<float>(q.w < 0 ? -value : value));
    }
    const Vec3 root = turn * (at[0] / from_leg - slow[index(frame)]);
    for (int k = 0; k < 3; ++k) roots.push_back(static_cast<float>(root[k]));
  }
  const MotionTensors motion{torch::tensor(bones).view({1, padded, from.layout().size(), 3}),
                             torch::tensor(roots).view({1, padded, 3}),
                             turns.empty()
                                 ? torch::Tensor()
                                 : torch::tensor(rotations).view({1, padded, from.layout().size() - 1, 4})};
  torch::NoGradGuard no_gradient;
  StructureNetworkImpl& in = *network->of(from.layout().kind());
  StructureNetworkImpl& out = *network->of(to.layout().kind());
  const torch::Tensor features = in.motion(input_rows(in, network->options().input, motion));
  const MotionTensors carried =
      decode(out, features + skeleton_features(out, to.rest_bones()), to.rest_bones());
  const torch::Tensor relative = root_relative(out, carried).contiguous(), root = carried.root.contiguous();

  std::vector<int> joints_of_layout;
  const bool webcam = to.layout().kind() == BodyLayoutKind::Webcam38;
  const Skeleton skeleton = webcam ? body : canonical_skeleton(to, joints_of_layout);
  if (webcam)
    for (int j = 0; j < body.size(); ++j) joints_of_layout.push_back(j);
  std::vector<Vec3> positions;
  const auto vector_at = [](const float* v) {
    return Vec3(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
  };
  for (int frame = 0; frame < frames; ++frame) {
    const Quat turn = glm::angleAxis(headings[index(frame)], Vec3(0, 1, 0));
    const Vec3 at_root = to_leg * (turn * vector_at(root.data_ptr<float>() + 3 * frame) + slow[index(frame)]);
    for (const int j : joints_of_layout)
      positions.push_back(at_root + to.height() * (turn * vector_at(relative.data_ptr<float>() +
                                                                    3 * (frame * to.layout().size() + j))));
  }
  const Result<Motion> on_layout = Motion::from_positions(
      skeleton, {sampled.times().begin(), sampled.times().end()}, std::move(positions));
  if (!on_layout) return tl::unexpected(on_layout.error());
  return carried_by_turns(resample(*on_layout, coach.times()), body, RetargetMethod::Rotation,
                          RotationSource::Positions);
}

Result<Motion> carried_by_paper_network(const Motion& coach, const Skeleton& body,
                                        const std::filesystem::path& weights) {
  try {
    use_one_thread();
    if (!weights.empty()) {
      const Result<std::string> bytes = read_file(weights);
      if (!bytes) return tl::unexpected(bytes.error());
      const Result<PaperNetwork> network = load_paper_network(*bytes, weights.string());
      if (!network) return tl::unexpected(network.error());
      return carried_by(*network, coach, body);
    }
    static const Result<PaperNetwork> shipped =
        load_paper_network(shipped_paper_weights(), "retarget-paper.pt");
    if (!shipped) return tl::unexpected(shipped.error());
    return carried_by(*shipped, coach, body);
  } catch (const std::exception& error) {
    return fail(ErrorCode::Internal, std::string("the paper's network failed: ") + error.what());
  }
}

}  // namespace posecoach
