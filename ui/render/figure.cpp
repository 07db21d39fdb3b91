#include "ui/render/figure.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/base/assert.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// Radii in metres of a body with legs of average length (0.86 m), at the parent's and at the child's end.
struct Girth {
  double from = 0.008, to = 0.006;
};

constexpr double kAverageLegs_m = 0.86;

Girth natural_girth(HumanoidJoint child) {
  switch (child) {
    case Spine:
    case SpineMiddle:
    case Chest:
      return {0.029, 0.029};
    case Neck:
      return {0.027, 0.023};
    case Head:
    case HeadTop:
      return {0.022, 0.022};
    case LeftClavicle:
    case RightClavicle:
      return {0.024, 0.025};
    case LeftShoulder:
    case RightShoulder:
      return {0.025, 0.027};
    case LeftElbow:
    case RightElbow:
      return {0.028, 0.023};
    case LeftWrist:
    case RightWrist:
      return {0.024, 0.018};
    case LeftHip:
    case RightHip:
      return {0.029, 0.031};
    case LeftKnee:
    case RightKnee:
      return {0.036, 0.028};
    case LeftAnkle:
    case RightAnkle:
      return {0.029, 0.020};
    case LeftToe:
    case RightToe:
      return {0.022, 0.018};
    case LeftToeTip:
    case RightToeTip:
      return {0.018, 0.014};
    case Pelvis:
      return {0.029, 0.029};
  }
  return {};
}

class Builder {
 public:
  Builder(const BodyState& body, const FigureStyle& style) : body_(body), style_(style) {
    const double legs = body.skeleton.leg_length();
    scale_ = style.thickness * std::clamp(legs > 0 ? legs / kAverageLegs_m : 1.0, 0.3, 3.0);
  }

  Figure make() {
    figure_.surface = style_.surface;
    figure_.opacity = style_.opacity;
    figure_.outline = style_.outline;
    figure_.outline_px = style_.outline_px;
    for (int joint = 0; joint < body_.skeleton.size(); ++joint) add_bone(joint);
    for (int joint = 0; joint < body_.skeleton.size(); ++joint) add_joint(joint);
    for (const auto& [elbow, wrist] : {std::pair(LeftElbow, LeftWrist), std::pair(RightElbow, RightWrist)})
      add_hand(elbow, wrist);
    for (const auto& [knee, ankle, toe] :
         {std::tuple(LeftKnee, LeftAnkle, LeftToe), std::tuple(RightKnee, RightAnkle, RightToe)})
      add_heel(knee, ankle, toe);
    add_head();
    return std::move(figure_);
  }

 private:
  bool is_seen(int joint) const {
    if (joint == kNoJoint) return false;
    const auto i = static_cast<std::size_t>(joint);
    return is_finite(body_.positions[i]) &&
           (body_.confidence.empty() || body_.confidence[i] >= style_.least_confidence);
  }
  const Vec3& at(int joint) const { return body_.positions[static_cast<std::size_t>(joint)]; }
  std::optional<Vec3> seen(HumanoidJoint role) const {
    const int joint = body_.skeleton.find(role);
    return is_seen(joint) ? std::optional(at(joint)) : std::nullopt;
  }
  Girth girth_of(HumanoidJoint child) const {
    const Girth natural = natural_girth(child);
    return {natural.from * scale_, natural.to * scale_};
  }
  // The nearest canonical joint from `joint` up the tree.
  std::optional<HumanoidJoint> nearest_role(int joint) const {
    for (; joint != kNoJoint; joint = body_.skeleton.joint(joint).parent)
      if (body_.skeleton.joint(joint).role) return body_.skeleton.joint(joint).role;
    return std::nullopt;
  }
  // Joints of a rig that are no canonical ones, such as twist bones, take after the nearest that is.
  Girth girth(int joint) const {
    const std::optional<HumanoidJoint> role = nearest_role(joint);
    return role ? girth_of(*role) : Girth{0.011 * scale_, 0.009 * scale_};
  }
  // Eyes, ears and fingers, for which the head and the hands stand.
  bool is_detail(int joint) const {
    const std::optional<HumanoidJoint> role = nearest_role(joint);
    if (role == HeadTop) return true;
    const bool beyond = role == Head || role == LeftWrist || role == RightWrist;
    return beyond && !body_.skeleton.joint(joint).role;
  }
  void add(const Vec3& from, const Vec3& to, double from_radius, double to_radius, Colour colour) {
    figure_.capsules.push_back({from, to, from_radius, to_radius, colour});
  }

  void add_bone(int joint) {
    const int parent = body_.skeleton.joint(joint).parent;
    if (!is_seen(joint) || !is_seen(parent) || is_detail(joint)) return;
    const Girth g = girth(joint);
    add(at(parent), at(joint), g.from, g.to, style_.bone);
  }

  void add_joint(int joint) {
    const auto& role = body_.skeleton.joint(joint).role;
    if (!role || !is_seen(joint)) return;
    switch (*role) {  // where a body bends; a knob at every vertebra would look like a chain
      case LeftShoulder:
      case RightShoulder:
      case LeftElbow:
      case RightElbow:
      case LeftWrist:
      case RightWrist:
      case LeftHip:
      case RightHip:
      case LeftKnee:
      case RightKnee:
      case LeftAnkle:
      case RightAnkle:
        break;
      default:
        return;
    }
    const double radius = 1.34 * girth_of(*role).to;
    add(at(joint), at(joint), radius, radius, style_.joint);
  }

  // To the middle of the knuckles where the rig has them, else straight on from the forearm.
  void add_hand(HumanoidJoint elbow_role, HumanoidJoint wrist_role) {
    const auto elbow = seen(elbow_role), wrist = seen(wrist_role);
    if (!wrist) return;
    Vec3 knuckles(0);
    int count = 0;
    for (const int child : body_.skeleton.children(body_.skeleton.find(wrist_role)))
      if (is_seen(child)) {
        knuckles += at(child);
        ++count;
      }
    Vec3 tip = *wrist;
    if (count > 0)
      tip = knuckles / static_cast<double>(count);
    else if (elbow && glm::length(*wrist - *elbow) > 1e-6)
      tip += 0.08 * scale_ * glm::normalize(*wrist - *elbow);
    const double radius = girth_of(wrist_role).to;
    if (glm::length(tip - *wrist) < radius) return;
    add(mix(*wrist, tip, 0.3), tip, 1.05 * radius, 0.95 * radius, style_.bone);
  }
  static Vec3 mix(const Vec3& a, const Vec3& b, double t) { return a + t * (b - a); }

  void add_heel(HumanoidJoint knee_role, HumanoidJoint ankle_role, HumanoidJoint toe_role) {
    const auto knee = seen(knee_role), ankle = seen(ankle_role), toe = seen(toe_role);
    if (!knee || !ankle || !toe || body_.skeleton.children(body_.skeleton.find(ankle_role)).size() > 1)
      return;
    const Vec3 shin = *ankle - *knee, foot = *toe - *ankle;
    if (glm::length(shin) < 1e-6 || glm::length(foot) < 1e-6) return;
    // The heel lies behind and below the ankle, away from the toes.
    const Vec3 down = glm::normalize(shin);
    const Vec3 back = -(foot - glm::dot(foot, down) * down);
    const double length = glm::length(back);
    if (length < 1e-6) return;
    const Vec3 heel = *ankle + 0.035 * scale_ * down + 0.045 * scale_ * back / length;
    const double radius = girth_of(toe_role).to;
    add(*ankle, heel, radius, radius, style_.bone);
  }

  // An egg, narrow at the chin. The head joint is the base of the skull where the rig has a top of the head,
  // and the middle of the head where not.
  void add_head() {
    const auto head = seen(Head), top = seen(HeadTop);
    const double scale = scale_ / style_.thickness;
    if (!head) return;
    if (top && glm::length(*top - *head) > 0.02 * scale) {
      const Vec3 up = *top - *head;
      const double height = glm::length(up);
      const double crown = std::min(0.080 * scale, 0.45 * height);
      add(*head + up * 0.22, *top - up * (crown / height), 0.80 * crown, crown, style_.bone);
    } else if (const Vec3 up = head_up(*head); glm::length(up) > 1e-6) {
      // The ears, between which this rig's head joint lies, are below the middle of the skull.
      const double crown = 0.082 * scale;
      add(*head - 0.035 * scale * up, *head + 0.05 * scale * up, 0.80 * crown, crown, style_.bone);
    } else {
      add(*head, *head, 0.085 * scale, 0.085 * scale, style_.bone);
    }
  }
  // From the face where the rig has one, else along the neck; zero where there is neither.
  Vec3 head_up(const Vec3& head) const {
    const int nose = body_.skeleton.find("nose"), left = body_.skeleton.find("left_ear"),
              right = body_.skeleton.find("right_ear");
    Vec3 up(0);
    if (is_seen(nose) && is_seen(left) && is_seen(right))
      up = glm::cross(at(nose) - head, at(left) - at(right));
    else if (const auto neck = seen(Neck))
      up = head - *neck;
    return glm::length(up) > 1e-9 ? glm::normalize(up) : Vec3(0);
  }

  const BodyState& body_;
  const FigureStyle& style_;
  double scale_ = 1;
  Figure figure_;
};

}  // namespace

FigureStyle student_style(Palette palette) {
  FigureStyle style;
  if (palette == Palette::ColourBlindSafe) {
    style.bone = colour_from_hex(0x2F8FE0);
    style.joint = colour_from_hex(0xD4EAFF);
  }
  return style;
}

FigureStyle coach_style(Palette palette) {
  FigureStyle style;
  style.bone = colour_from_hex(0xF0443E);
  style.joint = colour_from_hex(0xFFD0CC);
  style.opacity = 0.78;
  if (palette == Palette::ColourBlindSafe) {
    style.bone = colour_from_hex(0xF2A33A);
    style.joint = colour_from_hex(0xFFE7C2);
    style.surface = Surface::Banded;
    style.opacity = 0.85;
  }
  return style;
}

Figure make_figure(const BodyState& body, const FigureStyle& style) {
  POSECOACH_ASSERT(body.positions.size() == static_cast<std::size_t>(body.skeleton.size()));
  POSECOACH_ASSERT(body.confidence.empty() || body.confidence.size() == body.positions.size());
  POSECOACH_ASSERT(style.thickness > 0);
  return Builder(body, style).make();
}

}  // namespace posecoach
