#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/median.h"
#include "core/body/measured_skeleton.h"
#include "core/motion/file_frame.h"
#include "core/motion/marker_sets.h"
#include "core/motion/marker_track.h"
#include "core/motion/rig.h"
#include "core/motion/short_list.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kShortestPerson_m = 0.4;  // leg and trunk
constexpr double kTallestPerson_m = 3.5;
constexpr std::size_t kMostListed = 8;  // labels in a message

// Labels without a single sighting are as good as none.
void drop_unseen(MarkerTrack& track) {
  const std::size_t markers = track.labels.size();
  for (std::size_t m = 0; m < markers; ++m) {
    bool is_seen = false;
    for (std::size_t f = 0; f < track.times.size() && !is_seen; ++f)
      is_seen = track.seen[track.at(f, m)] != 0;
    if (!is_seen) track.labels[m].clear();
  }
}

class MarkerBodyBuilder {
 public:
  MarkerBodyBuilder(std::string_view file_name, MarkerTrack& track) : file_name_(file_name), track_(track) {}

  Result<Motion> run() {
    drop_unseen(track_);
    body_ = find_marker_joints(track_.labels);
    list_joints();
    if (const auto complete = check_joints(); !complete) return tl::unexpected(complete.error());
    fill_gaps(track_, used_markers());
    for (std::size_t f = 0; f < track_.times.size(); ++f) append_frame(f);
    turn_and_scale();
    Result<Skeleton> skeleton = measure_skeleton(joints_, positions_, confidence_);
    if (!skeleton) return failure(skeleton.error());
    auto motion = Motion::from_positions(*std::move(skeleton), track_.times, std::move(positions_),
                                         std::move(confidence_));
    if (!motion) return failure(motion.error());
    return motion;
  }

 private:
  tl::unexpected<Error> failure(const Error& error) const {
    return fail(error.code, std::string(file_name_) + ": " + error.message);
  }

  bool has(HumanoidJoint role) const {
    if (!body_.hips.empty() && (role == LeftHip || role == RightHip)) return true;
    return std::any_of(body_.joints.begin(), body_.joints.end(),
                       [&](const MarkerJoint& j) { return j.role == role; });
  }
  std::size_t joint_with(HumanoidJoint role) const {
    const auto found =
        std::find_if(joints_.begin(), joints_.end(), [&](const MeasuredJoint& j) { return j.role == role; });
    POSECOACH_ASSERT(found != joints_.end());
    return static_cast<std::size_t>(found - joints_.begin());
  }

  // The nearest canonical ancestor that is there; without a chest the arms hang on the neck.
  int parent_of(HumanoidJoint role) const {
    for (auto up = canonical_parent(role); up; up = canonical_parent(*up)) {
      if (*up == Chest && !has(Chest) && has(Neck) && role != Neck) return static_cast<int>(joint_with(Neck));
      if (has(*up)) return static_cast<int>(joint_with(*up));
    }
    return kNoJoint;
  }

  void list_joints() {
    if (!has(Pelvis)) return;
    // In the canonical order parents come first, but for the neck, on which arms may hang.
    std::vector<HumanoidJoint> order = {Pelvis, Spine, SpineMiddle, Chest, Neck};
    for (const HumanoidJoint role : kHumanoidJoints)
      if (std::find(order.begin(), order.end(), role) == order.end()) order.push_back(role);
    for (const HumanoidJoint role : order)
      if (has(role)) joints_.push_back({std::string(to_string(role)), parent_of(role), role});
  }

  Result<void> check_joints() const {
    std::vector<Joint> joints;
    for (const MeasuredJoint& joint : joints_) joints.push_back({joint.name, joint.parent, {}, joint.role});
    std::string missing;
    if (joints.empty()) {
      missing = "no markers of the waist";
    } else {
      const auto checked = check_humanoid(Skeleton::make(joints).value());
      if (checked) return {};
      missing = checked.error().message.substr(0, checked.error().message.find(';'));
    }
    std::vector<std::string> labels;
    for (const std::string& label : track_.labels)
      if (!label.empty()) labels.push_back(label);
    return fail(ErrorCode::Incomplete,
                std::string(file_name_) + ": the markers do not make a body: " + missing +
                    (labels.empty() ? "; no marker is seen in any frame"
                                    : "; there are the labels " + short_list(labels, kMostListed)));
  }

  std::vector<std::size_t> used_markers() const {
    std::vector<std::size_t> used;
    for (const MarkerJoint& joint : body_.joints)
      used.insert(used.end(), joint.markers.begin(), joint.markers.end());
    for (const HipEstimate& hips : body_.hips) {
      used.insert(used.end(), hips.back.begin(), hips.back.end());
      used.insert(used.end(), {hips.left, hips.right});
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    return used;
  }

  struct Place {
    Vec3 position;
    double confidence = 0;
  };
  Place mean_of(std::size_t f, const std::vector<std::size_t>& markers) const {
    Place place;
    for (const std::size_t m : markers) {
      place.position += track_.positions[track_.at(f, m)];
      place.confidence += track_.seen[track_.at(f, m)] != 0 ? 1 : 0;
    }
    const auto count = static_cast<double>(markers.size());
    return {place.position / count, place.confidence / count};
  }

  std::array<Place, 2> hips_of(std::size_t f) const {
    const HipEstimate& hips = body_.hips.front();
    const Place left = mean_of(f, {hips.left}), right = mean_of(f, {hips.right}),
                back = mean_of(f, hips.back);
    const Vec3 across = left.position - right.position;
    const double breadth = glm::length(across);
    const double confidence = (left.confidence + right.confidence + back.confidence) / 3;
    const Vec3 middle = (left.position + right.position) / 2.0;
    const Vec3 backward = back.position - middle;
    const Vec3 upward = glm::cross(across, backward);
    if (breadth <= 0 || glm::length(upward) <= 0) return {left, right};
    const Vec3 down = -glm::normalize(upward);
    const Vec3 level_back = glm::normalize(glm::cross(across, down));
    const Vec3 centre = middle + breadth * (hips.down * down + hips.back_by * level_back);
    return {Place{centre + hips.sideways * across, confidence},
            Place{centre - hips.sideways * across, confidence}};
  }

  void append_frame(std::size_t f) {
    const std::size_t first = positions_.size();
    positions_.resize(first + joints_.size());
    confidence_.resize(first + joints_.size());
    const auto put = [&](HumanoidJoint role, const Place& place) {
      positions_[first + joint_with(role)] = place.position;
      confidence_[first + joint_with(role)] = place.confidence;
    };
    for (const MarkerJoint& joint : body_.joints) put(joint.role, mean_of(f, joint.markers));
    if (body_.hips.empty()) return;
    const auto hips = hips_of(f);
    put(LeftHip, hips[0]);
    put(RightHip, hips[1]);
  }

  // Up is where the upper body is above the feet, mean over the frames.
  void turn_and_scale() {
    const std::size_t top = joint_with(has(Neck) ? Neck : Chest);
    Vec3 up(0);
    std::vector<double> heights;
    const auto at = [&](std::size_t first, HumanoidJoint role) {
      return positions_[first + joint_with(role)];
    };
    for (std::size_t first = 0; first < positions_.size(); first += joints_.size()) {
      up += positions_[first + top] - (at(first, LeftAnkle) + at(first, RightAnkle)) / 2.0;
      heights.push_back(glm::distance(positions_[first + top], at(first, Pelvis)) +
                        glm::distance(at(first, LeftHip), at(first, LeftKnee)) +
                        glm::distance(at(first, LeftKnee), at(first, LeftAnkle)));
    }
    const double height = median(std::move(heights));
    double scale = track_.metres_per_unit;
    if (scale <= 0 || height * scale < kShortestPerson_m || height * scale > kTallestPerson_m)
      scale = height > 0 ? metres_per_unit_of_person(height) : 1;
    const Quat turn = rotation_to_y_up(up);
    for (Vec3& position : positions_) position = turn * position * scale;
  }

  std::string_view file_name_;
  MarkerTrack& track_;
  MarkerBody body_;
  std::vector<MeasuredJoint> joints_;
  std::vector<Vec3> positions_;
  std::vector<double> confidence_;
};

}  // namespace

Result<Motion> motion_from_markers(std::string_view file_name, MarkerTrack track) {
  if (track.times.empty())
    return fail(ErrorCode::Incomplete, std::string(file_name) + ": the file has no frames");
  return MarkerBodyBuilder(file_name, track).run();
}

}  // namespace posecoach
