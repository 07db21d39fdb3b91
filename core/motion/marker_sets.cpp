#include "core/motion/marker_sets.h"

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "core/motion/rig.h"
#include "core/motion/text_scanner.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// Labels without what stands before a colon, in lower case; '*' stands for the side, l or r. An entry is used
// when all its labels are there; the first that fits wins.
struct SetEntry {
  HumanoidJoint left;
  std::optional<HumanoidJoint> right;  // none: a joint of the middle
  std::initializer_list<std::string_view> labels;
};

const SetEntry kEntries[] = {
    // GEARS
    {Pelvis, {}, {"waistleft", "waistright", "waistlback", "waistrback"}},
    {Neck, {}, {"backtop"}},
    {Head, {}, {"headtop", "headfront", "headside"}},
    {LeftShoulder, RightShoulder, {"*shouldertop", "*shoulderback"}},
    {LeftElbow, RightElbow, {"*elbowout"}},
    {LeftWrist, RightWrist, {"*wristtop"}},
    {LeftKnee, RightKnee, {"*kneeout"}},
    {LeftAnkle, RightAnkle, {"*ankleout"}},
    {LeftToe, RightToe, {"*toein", "*toeout"}},
    // Plug-in Gait and its relatives
    {Pelvis, {}, {"lasi", "rasi", "lpsi", "rpsi"}},
    {Pelvis, {}, {"lasi", "rasi", "sacr"}},
    {Pelvis, {}, {"lasis", "rasis", "lpsis", "rpsis"}},
    {LeftHip, RightHip, {"*hjc"}},
    {Neck, {}, {"c7", "clav"}},
    {Neck, {}, {"c7"}},
    {Chest, {}, {"strn", "t10"}},
    {Head, {}, {"lfhd", "rfhd", "lbhd", "rbhd"}},
    {Head, {}, {"lfhd", "rfhd"}},
    {LeftShoulder, RightShoulder, {"*sho"}},
    {LeftElbow, RightElbow, {"*elb", "*elbm"}},
    {LeftElbow, RightElbow, {"*elb"}},
    {LeftWrist, RightWrist, {"*wra", "*wrb"}},
    {LeftWrist, RightWrist, {"*wri"}},
    {LeftKnee, RightKnee, {"*kne", "*knm"}},
    {LeftKnee, RightKnee, {"*kne", "*knem"}},
    {LeftKnee, RightKnee, {"*kne"}},
    {LeftAnkle, RightAnkle, {"*ank", "*anm"}},
    {LeftAnkle, RightAnkle, {"*ank", "*ankm"}},
    {LeftAnkle, RightAnkle, {"*ank"}},
    {LeftToe, RightToe, {"*toe"}},
    // Landmarks: a joint of the middle between two of the sides
    {LeftToe, RightToe, {"*bigtoe", "*smalltoe"}},
    {LeftToe, RightToe, {"*bigtoe"}},
};

struct HipEntry {
  std::string_view left, right;
  std::initializer_list<std::string_view> back;
  double sideways, down, back_by;
};
// Plug-in Gait: Bell, Pedersen & Brand (1990), "A comparison of the accuracy of several hip center location
// prediction methods": 36 % of the breadth sideways, 30 % down, 19 % back. GEARS wears its markers on the
// belt's sides, a third wider apart; the joints lie under the middle of the belt.
const HipEntry kHipEntries[] = {{"lasi", "rasi", {"lpsi", "rpsi"}, 0.36, 0.30, 0.19},
                                {"lasi", "rasi", {"sacr"}, 0.36, 0.30, 0.19},
                                {"lasis", "rasis", {"lpsis", "rpsis"}, 0.36, 0.30, 0.19},
                                {"waistleft", "waistright", {"waistlback", "waistrback"}, 0.26, 0.25, 0.20}};

std::string plain(std::string_view label) {
  const std::size_t colon = label.find_last_of(':');
  if (colon != std::string_view::npos) label.remove_prefix(colon + 1);
  return to_lower(trimmed(label));
}

class Finder {
 public:
  explicit Finder(std::span<const std::string> labels) {
    for (const std::string& label : labels) plain_.push_back(plain(label));
    for (const std::string& label : labels) names_.push_back(label);
  }

  MarkerBody run() {
    for (const SetEntry& entry : kEntries) {
      add(entry.left, find_all(entry.labels, 'l'));
      if (entry.right) add(*entry.right, find_all(entry.labels, 'r'));
    }
    const auto by_name = map_roles_by_name(names_);
    for (std::size_t marker = 0; marker < by_name.size(); ++marker)
      if (by_name[marker]) add(*by_name[marker], {{marker}});
    for (const HipEntry& entry : kHipEntries) add_hips(entry);
    add_middle(Pelvis, LeftHip, RightHip);
    if (!find(Chest)) add_middle(Neck, LeftShoulder, RightShoulder);
    return std::move(body_);
  }

 private:
  using Markers = std::optional<std::vector<std::size_t>>;

  std::optional<std::size_t> find_label(std::string_view wanted) const {
    const auto found = std::find(plain_.begin(), plain_.end(), wanted);
    if (found == plain_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - plain_.begin());
  }
  Markers find_all(std::initializer_list<std::string_view> labels, char side) const {
    std::vector<std::size_t> markers;
    for (const std::string_view label : labels) {
      std::string wanted(label);
      if (wanted.starts_with('*')) wanted[0] = side;
      const auto marker = find_label(wanted);
      if (!marker) return std::nullopt;
      markers.push_back(*marker);
    }
    return markers;
  }
  const MarkerJoint* find(HumanoidJoint role) const {
    const auto found = std::find_if(body_.joints.begin(), body_.joints.end(),
                                    [&](const MarkerJoint& j) { return j.role == role; });
    return found == body_.joints.end() ? nullptr : &*found;
  }
  void add(HumanoidJoint role, const Markers& markers) {
    if (markers && !find(role)) body_.joints.push_back({role, *markers});
  }
  void add_hips(const HipEntry& entry) {
    const auto left = find_label(entry.left), right = find_label(entry.right);
    const auto back = find_all(entry.back, 'l');
    if (!left || !right || !back || !body_.hips.empty() || find(LeftHip) || find(RightHip)) return;
    body_.hips.push_back({*left, *right, *back, entry.sideways, entry.down, entry.back_by});
  }
  void add_middle(HumanoidJoint role, HumanoidJoint left_role, HumanoidJoint right_role) {
    const MarkerJoint* left = find(left_role);
    const MarkerJoint* right = find(right_role);
    if (find(role) || left == nullptr || right == nullptr) return;
    std::vector<std::size_t> markers = left->markers;
    markers.insert(markers.end(), right->markers.begin(), right->markers.end());
    add(role, markers);
  }

  std::vector<std::string> plain_;
  std::vector<std::string_view> names_;
  MarkerBody body_;
};

}  // namespace

MarkerBody find_marker_joints(std::span<const std::string> labels) {
  return Finder(labels).run();
}

}  // namespace posecoach
