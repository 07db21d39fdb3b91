#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "core/base/index.h"
#include "core/motion/bvh_motion.h"
#include "core/motion/rig.h"

namespace posecoach {
namespace {

std::string unique_name(std::string wanted, std::set<std::string>& taken) {
  std::string name = wanted;
  for (int copy = 2; !taken.insert(name).second; ++copy) name = wanted + "_" + std::to_string(copy);
  return name;
}

// Local translations and rotations of one frame, one a BVH joint, in the file's frame.
struct FilePose {
  std::vector<Vec3> translations;
  std::vector<Quat> rotations;
};

// The joints of one frame in the file's world.
struct FileGlobals {
  std::vector<Vec3> positions;
  std::vector<Quat> rotations;
};

class BvhInterpreter {
 public:
  explicit BvhInterpreter(const BvhDocument& document) : document_(document) {}

  Result<SkeletonFile> skeleton() {
    keep_joints();
    const auto roles = map_roles(joints_);
    for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j].role = roles[j];
    start_at_pelvis();
    settle_positions();
    auto frame = file_frame(joints_);
    if (!frame) return tl::unexpected(frame.error());
    Result<Skeleton> skeleton = Skeleton::make(converted(joints_, *frame));
    if (!skeleton) return tl::unexpected(skeleton.error());
    MotionProvenance provenance{MotionFormat::Bvh, *std::move(frame), std::move(origins_)};
    find_world_up(*skeleton, provenance);
    return SkeletonFile{*std::move(skeleton), std::move(provenance)};
  }

  Result<Motion> motion(const SkeletonFile& body) {
    const FileFrame& frame = body.provenance.frame;
    const auto joint_count = index(body.skeleton.size());
    std::vector<MediaTime> times;
    std::vector<Vec3> roots, positions;
    std::vector<Quat> locals;
    FilePose pose = empty_pose();
    FileGlobals globals = empty_globals();
    std::vector<Quat> ours(joint_count);
    for (std::size_t f = 0; f < document_.frame_count; ++f) {
      times.push_back(media_time_from_seconds(static_cast<double>(f) * document_.frame_time_s));
      read_frame(f, pose, globals, body.provenance.bvh);
      for (std::size_t b = 0; b < body.provenance.bvh.size(); ++b) {
        const int j = body.provenance.bvh[b].skeleton_joint;
        if (j == kNoJoint) continue;
        const Vec3 position = frame.world_from_file * globals.positions[b] * frame.metres_per_unit;
        ours[index(j)] =
            frame.world_from_file * globals.rotations[b] * glm::conjugate(frame.rest_from_file[index(j)]);
        const int parent = body.skeleton.joint(j).parent;
        if (parent == kNoJoint) roots.push_back(position);
        if (bones_stretch_)
          positions.push_back(position);
        else
          locals.push_back(glm::normalize(
              parent == kNoJoint ? ours[index(j)] : glm::conjugate(ours[index(parent)]) * ours[index(j)]));
      }
    }
    if (bones_stretch_) return Motion::from_positions(body.skeleton, std::move(times), std::move(positions));
    return Motion::from_rotations(body.skeleton, std::move(times), std::move(roots), std::move(locals));
  }

 private:
  void keep_joints() {
    std::set<std::string> taken;
    std::vector<int> kept;
    for (const BvhJoint& joint : document_.joints) {
      const int parent = joint.parent < 0 ? kNoJoint : kept[index(joint.parent)];
      const bool is_empty_tip = joint.is_end_site && joint.offset == Vec3(0);
      origins_.push_back({joint, is_empty_tip ? kNoJoint : static_cast<int>(joints_.size()), false});
      kept.push_back(origins_.back().skeleton_joint);
      if (is_empty_tip) continue;
      std::string name = joint.is_end_site ? joints_[index(parent)].name + "_end" : joint.name;
      if (name.empty()) name = "joint_" + std::to_string(joints_.size() + 1);
      joints_.push_back({unique_name(std::move(name), taken), parent, joint.offset, {}});
    }
  }

  std::size_t position_channels(std::size_t b) const {
    const auto& channels = document_.joints[b].channels;
    return static_cast<std::size_t>(std::count_if(channels.begin(), channels.end(), [](const BvhChannel& c) {
      return c.kind == BvhChannel::Kind::Position;
    }));
  }

  void start_at_pelvis() {
    const auto pelvis = std::find_if(joints_.begin(), joints_.end(),
                                     [](const Joint& j) { return j.role == HumanoidJoint::Pelvis; });
    if (pelvis == joints_.end() || pelvis == joints_.begin()) return;
    const int root = static_cast<int>(pelvis - joints_.begin());
    const auto origin = std::find_if(origins_.begin(), origins_.end(),
                                     [&](const BvhOrigin& o) { return o.skeleton_joint == root; });
    if (position_channels(static_cast<std::size_t>(origin - origins_.begin())) == 0) return;
    std::vector<int> moved(joints_.size(), kNoJoint);
    std::vector<Joint> below;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const int parent = joints_[j].parent;
      const bool is_root = static_cast<int>(j) == root;
      if (!is_root && (parent == kNoJoint || moved[index(parent)] == kNoJoint)) continue;
      moved[j] = static_cast<int>(below.size());
      below.push_back(joints_[j]);
      below.back().parent = is_root ? kNoJoint : moved[index(parent)];
    }
    for (BvhOrigin& o : origins_)
      if (o.skeleton_joint != kNoJoint) o.skeleton_joint = moved[index(o.skeleton_joint)];
    joints_ = std::move(below);
  }

  // Position channels below the root: usually they repeat the offset (or are all 0), sometimes they are the
  // bone's true offset, rarely bones stretch.
  void settle_positions() {
    double extent = 0;
    for (const Joint& joint : joints_) extent += glm::length(joint.offset);
    const double tolerance = 1e-4 * extent;  // about a millimetre of a whole body's bones
    FilePose pose = empty_pose();
    for (std::size_t b = 0; b < origins_.size(); ++b) {
      const int j = origins_[b].skeleton_joint;
      if (j == kNoJoint || joints_[index(j)].parent == kNoJoint || position_channels(b) == 0 ||
          document_.frame_count == 0)
        continue;
      std::vector<Vec3> seen;
      for (std::size_t f = 0; f < document_.frame_count; ++f) seen.push_back(translation(f, b));
      const bool all_zero = std::all_of(seen.begin(), seen.end(),
                                        [&](const Vec3& v) { return glm::length(v) <= 1e-9 * extent; });
      const bool constant = std::all_of(seen.begin(), seen.end(), [&](const Vec3& v) {
        return glm::distance(v, seen.front()) <= tolerance;
      });
      if (all_zero && position_channels(b) == 3)
        origins_[b].position_adds = true;
      else if (constant)
        joints_[index(j)].offset = seen.front();
      else
        bones_stretch_ = true;
    }
  }

  std::size_t first_channel(std::size_t b) {
    if (first_channels_.empty()) {
      std::size_t next = 0;
      for (const BvhJoint& joint : document_.joints) {
        first_channels_.push_back(next);
        next += joint.channels.size();
      }
    }
    return first_channels_[b];
  }

  Vec3 translation(std::size_t f, std::size_t b) {
    const BvhJoint& joint = document_.joints[b];
    Vec3 place = joint.offset;
    std::size_t at = f * document_channel_count_ + first_channel(b);
    for (const BvhChannel& channel : joint.channels) {
      if (channel.kind == BvhChannel::Kind::Position)
        place[static_cast<int>(channel.axis)] = document_.values[at];
      ++at;
    }
    return place;
  }

  void read_frame(std::size_t f, FilePose& pose, FileGlobals& globals,
                  const std::vector<BvhOrigin>& origins) {
    for (std::size_t b = 0; b < document_.joints.size(); ++b) {
      const BvhJoint& joint = document_.joints[b];
      pose.translations[b] = origins[b].position_adds ? joint.offset : translation(f, b);
      pose.rotations[b] = Quat(1, 0, 0, 0);
      std::size_t at = f * document_channel_count_ + first_channel(b);
      for (const BvhChannel& channel : joint.channels) {
        if (channel.kind == BvhChannel::Kind::Rotation)
          pose.rotations[b] =
              pose.rotations[b] * rotation_about(channel.axis, radians_from_degrees(document_.values[at]));
        ++at;
      }
      if (joint.parent < 0) {
        globals.positions[b] = pose.translations[b];
        globals.rotations[b] = pose.rotations[b];
      } else {
        const auto parent = index(joint.parent);
        globals.positions[b] = globals.positions[parent] + globals.rotations[parent] * pose.translations[b];
        globals.rotations[b] = globals.rotations[parent] * pose.rotations[b];
      }
    }
  }

  FilePose empty_pose() const {
    return {std::vector<Vec3>(document_.joints.size()), std::vector<Quat>(document_.joints.size())};
  }
  FileGlobals empty_globals() const {
    return {std::vector<Vec3>(document_.joints.size()), std::vector<Quat>(document_.joints.size())};
  }

  // Which way is up in the file's world is said by how the body stands in its frames; the rest pose may stand
  // along another axis.
  void find_world_up(const Skeleton& skeleton, MotionProvenance& provenance) {
    using enum HumanoidJoint;
    constexpr std::size_t kSamples = 50;
    const HumanoidJoint top = skeleton.has(Neck) ? Neck : Chest;
    if (!skeleton.has(top) || !skeleton.has(LeftAnkle) || !skeleton.has(RightAnkle)) return;
    const auto origin_of = [&](HumanoidJoint role) {
      const auto found = std::find_if(provenance.bvh.begin(), provenance.bvh.end(), [&](const BvhOrigin& o) {
        return o.skeleton_joint == skeleton.find(role);
      });
      return static_cast<std::size_t>(found - provenance.bvh.begin());
    };
    FilePose pose = empty_pose();
    FileGlobals globals = empty_globals();
    Vec3 up(0);
    std::size_t count = 0;
    const std::size_t step = std::max<std::size_t>(1, document_.frame_count / kSamples);
    for (std::size_t f = 0; f < document_.frame_count; f += step) {
      read_frame(f, pose, globals, provenance.bvh);
      const Vec3 feet =
          (globals.positions[origin_of(LeftAnkle)] + globals.positions[origin_of(RightAnkle)]) / 2.0;
      const Vec3 way = globals.positions[origin_of(top)] - feet;
      if (glm::length(way) <= 0) continue;
      up += glm::normalize(way);
      ++count;
    }
    if (count == 0 || glm::length(up) < 0.5 * static_cast<double>(count)) return;  // lying or tumbling
    const Vec3 mean = glm::normalize(up);
    const double largest = std::max({std::abs(mean.x), std::abs(mean.y), std::abs(mean.z)});
    if ((provenance.frame.world_from_file * mean).y < 0.5 && largest > 0.8)
      provenance.frame.world_from_file = rotation_to_y_up(mean);
  }

  const BvhDocument& document_;
  const std::size_t document_channel_count_ = document_.channel_count();
  std::vector<std::size_t> first_channels_;
  std::vector<Joint> joints_;  // in the file's frame until converted
  std::vector<BvhOrigin> origins_;
  bool bones_stretch_ = false;
};

tl::unexpected<Error> in_file(std::string_view file_name, const Error& error) {
  return fail(error.code, std::string(file_name) + ": " + error.message);
}

}  // namespace

Result<SkeletonFile> read_bvh_skeleton(std::string_view file_name, std::string_view text) {
  const auto document = parse_bvh(file_name, text);
  if (!document) return tl::unexpected(document.error());
  auto body = BvhInterpreter(*document).skeleton();
  if (!body) return in_file(file_name, body.error());
  return body;
}

Result<MotionFile> read_bvh(std::string_view file_name, std::string_view text) {
  const auto document = parse_bvh(file_name, text);
  if (!document) return tl::unexpected(document.error());
  if (document->frame_count == 0)
    return fail(ErrorCode::Incomplete, std::string(file_name) + ": the file has a skeleton, but no frames");
  BvhInterpreter interpreter(*document);
  auto body = interpreter.skeleton();
  if (!body) return in_file(file_name, body.error());
  auto motion = interpreter.motion(*body);
  if (!motion) return in_file(file_name, motion.error());
  return MotionFile{*std::move(motion), std::move(body->provenance)};
}

}  // namespace posecoach
