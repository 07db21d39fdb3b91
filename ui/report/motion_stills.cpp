#include "ui/report/motion_stills.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ui/render/coach_placement.h"
#include "ui/render/overlay_scene.h"
#include "ui/render/words.h"
#include "ui/report/stills.h"

namespace posecoach {
namespace {

constexpr int kWidth_px = 400, kHeight_px = 600;
constexpr double kViewAngle = 0.5;

// Where he looks at a frame, level; +Z for bodies without hips.
Vec3 front_of(const Motion& student, int frame) {
  const int left = student.skeleton().find(HumanoidJoint::LeftHip);
  const int right = student.skeleton().find(HumanoidJoint::RightHip);
  if (left == kNoJoint || right == kNoJoint) return {0, 0, 1};
  const Vec3 front =
      glm::cross(student.position(frame, left) - student.position(frame, right), Vec3(0, 1, 0));
  return glm::length(front) > 1e-6 ? glm::normalize(front) : Vec3(0, 0, 1);
}

struct Bounds {
  Vec3 low{1e9}, high{-1e9};

  void include(std::span<const Vec3> positions) {
    for (const Vec3& p : positions) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
};

PinholeCamera camera_before(const Bounds& bounds, const Vec3& front) {
  const Vec3 size = bounds.high - bounds.low, middle = 0.5 * (bounds.low + bounds.high);
  const double reach = std::max(size.y, std::max(size.x, size.z) * kHeight_px / kWidth_px);
  const double distance = 0.62 * reach / std::tan(0.5 * kViewAngle);
  const Vec3 eye = middle + distance * front + Vec3(0, 0.12 * distance, 0);
  return make_camera_looking_at(eye, middle, kViewAngle, kWidth_px, kHeight_px);
}

}  // namespace

std::vector<ReportPicture> draw_motion_stills(const Comparison& comparison, SceneRenderer& renderer) {
  const Analysis& analysis = comparison.analysis;
  const Motion& student = comparison.student;
  std::vector<ReportPicture> pictures;
  const std::vector<StillMoment> moments = still_moments(analysis);
  if (moments.empty()) return pictures;
  std::vector<std::pair<int, int>> path = analysis.path;
  for (auto& [his, coachs] : path) his -= comparison.first_frame;
  const CoachPlacement placement = stand_on_feet(student, comparison.coach, path);
  const auto clamped = [&](int frame) { return std::clamp(frame, 0, student.frame_count() - 1); };
  // At the first frame of the swing he stands square to the ball.
  const Vec3 front = front_of(student, clamped(path.front().first));
  for (const StillMoment& still : moments) {
    const int frame = clamped(still.student_frame - comparison.first_frame);
    const std::vector<Vec3> coach = placement.positions(comparison.coach, still.coach_frame, frame);
    OverlayMoment moment;
    moment.student.emplace(BodyState{student.skeleton(), student.positions(frame)});
    moment.coach.emplace(BodyState{comparison.coach.skeleton(), coach});
    Bounds bounds;
    bounds.include(moment.student->positions);
    bounds.include(coach);
    const PinholeCamera camera = camera_before(bounds, front);
    const std::optional<JointApart> apart = joint_apart(*moment.student, *moment.coach, still.joint, Vec3(0));
    std::optional<OverlayHighlight> highlight;
    if (apart) highlight = {apart->student, apart->coach};
    Scene scene = make_bodies_scene(moment, comparison.palette, camera, highlight);
    scene.floor = Floor{};
    scene.floor->centre = {0.5 * (bounds.low.x + bounds.high.x), bounds.low.y,
                           0.5 * (bounds.low.z + bounds.high.z)};
    renderer.render(scene, camera);
    pictures.push_back({still.student_frame, still.coach_frame, renderer.read_image(),
                        still_caption(student_phase(analysis, still.student_frame), apart)});
  }
  return pictures;
}

}  // namespace posecoach
