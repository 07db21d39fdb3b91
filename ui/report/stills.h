// Which moments of an analysis deserve a still picture, and what each of them shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/coaching/analysis.h"
#include "core/image/camera.h"
#include "ui/render/figure.h"
#include "ui/render/overlay_scene.h"

namespace posecoach {

struct StillMoment {
  int student_frame = 0, coach_frame = 0;
  std::optional<HumanoidJoint> joint;  // what the advice for this moment is about
};

// The moments of the advice, the worst frames, and where there is room the stroke's events: at most five,
// apart from each other in time, in the order of time.
std::vector<StillMoment> still_moments(const Analysis& analysis);

// A joint of both bodies and how far apart they are with both pelvises in one place, or, for the pelvis
// itself, with the feet in one place.
struct JointApart {
  HumanoidJoint joint = HumanoidJoint::Pelvis;
  Vec3 student, coach;  // where they are drawn
  double distance_m = 0;
};

// The wanted joint, or else the one farthest apart among those that a golfer can be told about; nothing where
// none is seen in both. Distances along `unseen`, a unit vector or zero, do not count: one camera only
// guesses them.
std::optional<JointApart> joint_apart(const BodyState& student, const BodyState& coach,
                                      std::optional<HumanoidJoint> wanted, const Vec3& unseen);

// "Top: left elbow 14 cm away".
std::string still_caption(const std::string& phase, const std::optional<JointApart>& apart);

struct PixelCrop {
  int left = 0, top = 0, width = 0, height = 0;
};

// Around the points with some air, two parts wide and three high as far as the picture reaches.
PixelCrop crop_around(const std::vector<Vec2>& points, int width, int height);
// The crop lies within the picture.
Image cut_out(const Image& image, const PixelCrop& crop);

}  // namespace posecoach
