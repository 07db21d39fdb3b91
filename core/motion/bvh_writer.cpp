#include <algorithm>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/body/forward_kinematics.h"
#include "core/motion/bvh_motion.h"

namespace posecoach {
namespace {

using Kind = BvhChannel::Kind;

constexpr double kCentimetre = 0.01;
constexpr EulerOrder kUsualOrder = {Axis::Z, Axis::X, Axis::Y};

std::string file_safe(std::string_view name) {
  std::string safe(name);
  for (char& c : safe)
    if (c == '{' || c == '}' || static_cast<unsigned char>(c) < ' ') c = '_';
  return safe;
}

std::vector<BvhChannel> position_channels() {
  return {{Kind::Position, Axis::X}, {Kind::Position, Axis::Y}, {Kind::Position, Axis::Z}};
}
void append_rotation_channels(std::vector<BvhChannel>& channels) {
  for (const Axis axis : kUsualOrder) channels.push_back({Kind::Rotation, axis});
}

// Depth first, as BVH needs it; a leaf called "<parent>_end" is an End Site, every other leaf gets an empty
// one.
void append_usual(const Skeleton& skeleton, int joint, int parent, std::vector<BvhOrigin>& bvh) {
  const Joint& ours = skeleton.joint(joint);
  const bool is_leaf = skeleton.children(joint).empty();
  BvhJoint theirs{file_safe(ours.name), parent, ours.offset / kCentimetre, {}, false};
  theirs.is_end_site = is_leaf && parent >= 0 && ours.name == skeleton.joint(ours.parent).name + "_end";
  if (parent < 0) theirs.channels = position_channels();
  if (theirs.is_end_site)
    theirs.name.clear();
  else
    append_rotation_channels(theirs.channels);
  const int here = static_cast<int>(bvh.size());
  const bool needs_end = is_leaf && !theirs.is_end_site;
  bvh.push_back({std::move(theirs), joint, false});
  if (needs_end) bvh.push_back({{"", here, {}, {}, true}, kNoJoint, false});
  for (const int child : skeleton.children(joint)) append_usual(skeleton, child, here, bvh);
}

MotionProvenance usual_provenance(const Skeleton& skeleton) {
  MotionProvenance provenance;
  provenance.frame = {kCentimetre, Quat(1, 0, 0, 0),
                      std::vector<Quat>(index(skeleton.size()), Quat(1, 0, 0, 0))};
  append_usual(skeleton, 0, -1, provenance.bvh);
  return provenance;
}

bool fits(const Skeleton& skeleton, const MotionProvenance& provenance) {
  if (provenance.frame.rest_from_file.size() != index(skeleton.size())) return false;
  std::vector<bool> seen(index(skeleton.size()), false);
  for (const BvhOrigin& origin : provenance.bvh) {
    if (origin.skeleton_joint == kNoJoint) continue;
    if (origin.skeleton_joint < 0 || origin.skeleton_joint >= skeleton.size()) return false;
    seen[index(origin.skeleton_joint)] = true;
  }
  return std::find(seen.begin(), seen.end(), false) == seen.end();
}

Motion at_constant_rate(const Motion& motion) {
  const int frames = motion.frame_count();
  if (frames < 3) return motion;
  const double step = to_seconds(motion.duration()) / (frames - 1);
  std::vector<MediaTime> times;
  bool is_constant = true;
  for (int f = 0; f < frames; ++f) {
    times.push_back(motion.time(0) + duration_from_seconds(step * f));
    is_constant &= std::abs(to_seconds(motion.time(f) - times.back())) < 0.01 * step;
  }
  times.back() = motion.time(frames - 1);
  return is_constant ? motion : resample(motion, times);
}

class BvhComposer {
 public:
  BvhComposer(const Motion& motion, const MotionProvenance& provenance)
      : motion_(motion), frame_(provenance.frame), bvh_(provenance.bvh) {}

  BvhDocument run() {
    complete_channels();
    for (const BvhOrigin& origin : bvh_) document_.joints.push_back(with_offset(origin));
    document_.frame_count = index(motion_.frame_count());
    constexpr double kUsualFrame_s = 1.0 / 30;
    document_.frame_time_s = motion_.frame_count() > 1
                                 ? to_seconds(motion_.duration()) / (motion_.frame_count() - 1)
                                 : kUsualFrame_s;
    document_.values.reserve(document_.frame_count * document_.channel_count());
    previous_.assign(bvh_.size(), Vec3(0));
    for (int f = 0; f < motion_.frame_count(); ++f) append_frame(f);
    return std::move(document_);
  }

 private:
  static std::vector<Axis> rotation_axes(const BvhJoint& joint) {
    std::vector<Axis> axes;
    for (const BvhChannel& channel : joint.channels)
      if (channel.kind == Kind::Rotation) axes.push_back(channel.axis);
    return axes;
  }

  bool is_root(const BvhOrigin& origin) const {
    return origin.skeleton_joint != kNoJoint &&
           motion_.skeleton().joint(origin.skeleton_joint).parent == kNoJoint;
  }

  // The root needs all positions; a joint that turns needs three angles, whatever the file had.
  void complete_channels() {
    for (BvhOrigin& origin : bvh_) {
      auto& channels = origin.joint.channels;
      const auto positions = std::count_if(channels.begin(), channels.end(),
                                           [](const BvhChannel& c) { return c.kind == Kind::Position; });
      if (is_root(origin) && positions != 3) {
        std::erase_if(channels, [](const BvhChannel& c) { return c.kind == Kind::Position; });
        const auto all = position_channels();
        channels.insert(channels.begin(), all.begin(), all.end());
      }
      if (origin.joint.is_end_site || is_euler_order(rotation_axes(origin.joint))) continue;
      if (origin.skeleton_joint == kNoJoint || !turns(origin.skeleton_joint)) {
        if (rotation_axes(origin.joint).size() <= 3) continue;
      }
      std::erase_if(channels, [](const BvhChannel& c) { return c.kind == Kind::Rotation; });
      append_rotation_channels(channels);
    }
  }
  bool turns(int joint) const {
    for (int f = 0; f < motion_.frame_count(); ++f) {
      const Quat& q = motion_.rotations(f)[index(joint)];
      if (glm::length(Vec3(q.x, q.y, q.z)) > 1e-9) return true;
    }
    return false;
  }

  // Where a file's position channels overrule its offsets, the offsets stay as they are.
  BvhJoint with_offset(const BvhOrigin& origin) const {
    BvhJoint joint = origin.joint;
    const bool has_positions = std::any_of(joint.channels.begin(), joint.channels.end(),
                                           [](const BvhChannel& c) { return c.kind == Kind::Position; });
    if (origin.skeleton_joint != kNoJoint && !has_positions)
      joint.offset = file_offset(origin.skeleton_joint);
    return joint;
  }
  Vec3 file_offset(int joint) const {
    const Joint& ours = motion_.skeleton().joint(joint);
    const auto turned_by = index(ours.parent == kNoJoint ? 0 : ours.parent);
    return glm::conjugate(frame_.rest_from_file[turned_by]) * ours.offset / frame_.metres_per_unit;
  }

  void append_frame(int f) {
    const auto joints = index(motion_.joint_count());
    std::vector<Quat> ours(joints);
    global_rotations(motion_.skeleton(), motion_.rotations(f), ours);
    std::vector<Quat> theirs(bvh_.size(), Quat(1, 0, 0, 0));
    std::vector<Vec3> places(bvh_.size());
    const Quat file_from_world = glm::conjugate(frame_.world_from_file);
    for (std::size_t b = 0; b < bvh_.size(); ++b) {
      const BvhOrigin& origin = bvh_[b];
      const int parent = origin.joint.parent;
      const Quat from_parent = parent < 0 ? Quat(1, 0, 0, 0) : theirs[index(parent)];
      const Vec3 parent_place = parent < 0 ? Vec3(0) : places[index(parent)];
      Vec3 translation = document_.joints[b].offset;
      theirs[b] = from_parent;
      if (origin.skeleton_joint != kNoJoint) {
        const auto j = index(origin.skeleton_joint);
        theirs[b] = file_from_world * ours[j] * frame_.rest_from_file[j];
        const Vec3 place =
            file_from_world * motion_.position(f, origin.skeleton_joint) / frame_.metres_per_unit;
        translation = is_root(origin) ? glm::conjugate(from_parent) * (place - parent_place)
                                      : file_offset(origin.skeleton_joint);
      }
      places[b] = parent_place + from_parent * translation;
      append_values(b, origin.position_adds ? Vec3(0) : translation, glm::conjugate(from_parent) * theirs[b]);
    }
  }

  void append_values(std::size_t b, const Vec3& translation, const Quat& rotation) {
    const BvhJoint& joint = document_.joints[b];
    const std::vector<Axis> axes = rotation_axes(joint);
    Vec3 angles(0);
    if (is_euler_order(axes)) {
      angles = euler_angles(rotation, {axes[0], axes[1], axes[2]}, previous_[b]);
      previous_[b] = angles;
    }
    int next_angle = 0;
    for (const BvhChannel& channel : joint.channels)
      document_.values.push_back(channel.kind == Kind::Position ? translation[static_cast<int>(channel.axis)]
                                                                : degrees_from_radians(angles[next_angle++]));
  }

  const Motion& motion_;
  const FileFrame& frame_;
  std::vector<BvhOrigin> bvh_;
  BvhDocument document_;
  std::vector<Vec3> previous_;
};

}  // namespace

Result<std::string> bvh_from_motion(const Motion& motion, const MotionProvenance& provenance) {
  if (!motion.has_rotations())
    return fail(ErrorCode::Unsupported,
                "a BVH file needs joint rotations, and this motion has positions only: write .trc or "
                ".pose.json, or retarget it to a body first");
  const MotionProvenance usual =
      provenance.bvh.empty() ? usual_provenance(motion.skeleton()) : MotionProvenance{};
  const MotionProvenance& used = provenance.bvh.empty() ? usual : provenance;
  if (!fits(motion.skeleton(), used))
    return fail(ErrorCode::InvalidArgument,
                "the motion's joints are not those of the BVH file that it is written like");
  const Motion even = at_constant_rate(motion);
  return format_bvh(BvhComposer(even, used).run());
}

}  // namespace posecoach
