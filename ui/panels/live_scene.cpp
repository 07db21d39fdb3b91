#include "ui/panels/live_scene.h"

#include <algorithm>
#include <array>

namespace posecoach {
namespace {

using enum Landmark;

constexpr std::array kLandmarkBones = {
    std::pair(LeftShoulder, RightShoulder), std::pair(LeftShoulder, LeftElbow),
    std::pair(LeftElbow, LeftWrist),        std::pair(RightShoulder, RightElbow),
    std::pair(RightElbow, RightWrist),      std::pair(LeftShoulder, LeftHip),
    std::pair(RightShoulder, RightHip),     std::pair(LeftHip, RightHip),
    std::pair(LeftHip, LeftKnee),           std::pair(LeftKnee, LeftAnkle),
    std::pair(RightHip, RightKnee),         std::pair(RightKnee, RightAnkle),
    std::pair(LeftAnkle, LeftFootIndex),    std::pair(RightAnkle, RightFootIndex)};

constexpr std::array kMarkedJoints = {
    HumanoidJoint::LeftShoulder, HumanoidJoint::RightShoulder, HumanoidJoint::LeftElbow,
    HumanoidJoint::RightElbow,   HumanoidJoint::LeftWrist,     HumanoidJoint::RightWrist,
    HumanoidJoint::LeftHip,      HumanoidJoint::RightHip,      HumanoidJoint::LeftKnee,
    HumanoidJoint::RightKnee,    HumanoidJoint::LeftAnkle,     HumanoidJoint::RightAnkle};

constexpr double kSeen = 0.3;

BodyState state_of(const BodyPose& body) {
  return {*body.skeleton, body.positions, body.confidence};
}

void add_body(Scene& scene, const BodyPose& body, FigureStyle style, double outline_px) {
  if (!body.skeleton || body.positions.size() != static_cast<std::size_t>(body.skeleton->size())) return;
  style.outline_px = outline_px;
  style.thickness = 0.86;
  scene.figures.push_back(make_figure(state_of(body), style));
}

// Not yet placed in the world: a flat figure of lines.
void add_flat_person(Scene& scene, const SeenPerson& person, const Colour& colour, const Vec2& factor,
                     const Vec2& origin) {
  const double width = std::max(3.0, 5 * factor.y);
  for (const auto& [from, to] : kLandmarkBones) {
    const ImageKeypoint &a = person.image[from], &b = person.image[to];
    if (a.visibility < kSeen || b.visibility < kSeen) continue;
    scene.add(make_line(a.position_px * factor - origin, b.position_px * factor - origin, width, colour));
  }
}

Colour closeness_colour(const LiveSceneStyle& style, float far) {
  return far < 0.5F ? mix(style.close, style.near, 2 * far) : mix(style.near, style.far, 2 * far - 1);
}

// A disc on each of the student's joints: small and quiet where he is with the coach, large where he is not,
// so that it does not need colour to be told.
void add_closeness(Scene& scene, const BodyPose& student, const Ghost& ghost, const LiveSceneStyle& style,
                   const PinholeCamera& camera) {
  const double unit = std::min(camera.width_px, camera.height_px) / 720.0;
  for (const HumanoidJoint role : kMarkedJoints) {
    const double closeness = ghost.closeness[static_cast<std::size_t>(role)];
    const int joint = student.skeleton->find(role);
    if (closeness < 0 || joint == kNoJoint) continue;
    const auto i = static_cast<std::size_t>(joint);
    if (i < student.confidence.size() && student.confidence[i] < kSeen) continue;
    const std::optional<Vec2> at = camera.project(student.positions[i]);
    if (!at) continue;
    const double far = 1 - std::clamp(closeness, 0.0, 1.0);
    Box mark = make_disc(*at, (6 + 7 * far) * unit, closeness_colour(style, static_cast<float>(far)));
    mark.border = 2 * unit;
    mark.border_colour = colour_from_hex(0xFFFFFF);
    scene.add(mark);
  }
}

}  // namespace

SceneView make_live_scene(const CoachSnapshot& snapshot, const LiveSceneStyle& style, int width_px,
                          int height_px, const PicturePart& part) {
  SceneView view;
  view.camera.width_px = width_px;
  view.camera.height_px = height_px;
  view.camera.focal_px = height_px;
  view.camera.centre_px = 0.5 * Vec2(width_px, height_px);
  if (snapshot.camera && snapshot.camera->width_px > 0 && snapshot.camera->height_px > 0)
    view.camera = cropped_to(*snapshot.camera, part, width_px, height_px);
  if (snapshot.frame) view.scene.picture = snapshot.frame->image;
  view.scene.part = part;
  const double outline_px = std::max(1.0, 1.6 * std::min(width_px, height_px) / 720.0);
  const bool shows_coach = style.figures == FigureShow::Both && snapshot.ghost;
  if (snapshot.camera && shows_coach)
    add_body(view.scene, snapshot.ghost->body, coach_style(style.palette), outline_px);
  if (style.figures == FigureShow::None) return view;
  const bool is_placed = snapshot.camera && snapshot.student && snapshot.student->skeleton;
  const Vec2 whole = Vec2(width_px, height_px) / part.size();
  if (is_placed)
    add_body(view.scene, *snapshot.student, student_style(style.palette), outline_px);
  else if (snapshot.person && snapshot.frame && snapshot.frame->image)
    add_flat_person(view.scene, *snapshot.person, student_style(style.palette).bone,
                    whole / Vec2(snapshot.frame->image->width, snapshot.frame->image->height),
                    part.begin * whole);
  if (is_placed && shows_coach)
    add_closeness(view.scene, *snapshot.student, *snapshot.ghost, style, view.camera);
  return view;
}

}  // namespace posecoach
