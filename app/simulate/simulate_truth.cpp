#include "app/simulate/simulate_truth.h"

#include <nlohmann/json.hpp>

#include "core/body/body_file.h"

namespace posecoach {
namespace {

using Json = nlohmann::ordered_json;

// Tenths of a millimetre and hundredths of a pixel are plenty, and keep the file readable.
double rounded(double value, double step) {
  return std::round(value / step) * step;
}

Json as_json(const Vec3& v) {
  return Json::array({rounded(v.x, 1e-5), rounded(v.y, 1e-5), rounded(v.z, 1e-5)});
}

Json projected(const PinholeCamera& camera, const Vec3& point) {
  const auto px = camera.project(point);
  if (!px) return nullptr;
  return Json::array({rounded(px->x, 1e-3), rounded(px->y, 1e-3)});
}

Json camera_json(const PinholeCamera& camera) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    Json line = Json::array();
    for (int column = 0; column < 3; ++column) line.push_back(camera.rotation_camera_from_world[column][row]);
    rows.push_back(line);
  }
  const Vec3& t = camera.translation_camera_from_world;
  return {{"focal_px", camera.focal_px},
          {"centre_px", {camera.centre_px.x, camera.centre_px.y}},
          {"rotation_camera_from_world", rows},
          {"translation_camera_from_world_m", {t.x, t.y, t.z}}};
}

Json frame_json(const SimulatedStudent& student, int frame) {
  const Motion& motion = student.authored().motion;
  Json joints = Json::array(), joints_px = Json::array(), landmarks = Json::array(),
       landmarks_px = Json::array();
  for (const Vec3& position : motion.positions(frame)) {
    joints.push_back(as_json(position));
    joints_px.push_back(projected(student.camera(), position));
  }
  for (const Vec3& position : student.landmarks(frame)) {
    landmarks.push_back(as_json(position));
    landmarks_px.push_back(projected(student.camera(), position));
  }
  const ClubPose& club = student.authored().club[static_cast<std::size_t>(frame)];
  return {
      {"index", frame},
      {"time_s", to_seconds(motion.time(frame))},
      {"joints_m", joints},
      {"joints_px", joints_px},
      {"landmarks_m", landmarks},
      {"landmarks_px", landmarks_px},
      {"club_m", {{"butt", as_json(club.butt)}, {"grip", as_json(club.grip)}, {"head", as_json(club.head)}}}};
}

}  // namespace

std::string truth_as_json(const SimulatedStudent& student, const SimulatedStudentOptions& options) {
  const Motion& motion = student.authored().motion;
  Json faults = Json::array(), events = Json::array(), names = Json::array(), roles = Json::array(),
       landmarks = Json::array(), frames = Json::array();
  for (const FaultChoice& choice : options.faults)
    faults.push_back({{"name", choice.fault->name}, {"amount", choice.amount}, {"unit", choice.fault->unit}});
  for (const AuthoredEvent& event : student.authored().events)
    events.push_back({{"name", event.name}, {"time_s", event.time_s}});
  for (const Joint& joint : motion.skeleton().joints()) {
    names.push_back(joint.name);
    roles.push_back(joint.role ? Json(to_string(*joint.role)) : Json(nullptr));
  }
  for (std::size_t i = 0; i < kLandmarkCount; ++i) landmarks.push_back(to_string(static_cast<Landmark>(i)));
  for (int frame = 0; frame < motion.frame_count(); ++frame) frames.push_back(frame_json(student, frame));
  const Json truth = {{"schema", "posecoach.truth/1"},
                      {"source", options.name},
                      {"motion", options.motion},
                      {"view", to_string(options.view)},
                      {"hand", options.hand == Handedness::Left ? "left" : "right"},
                      {"fps", options.frames_per_second},
                      {"width", options.width},
                      {"height", options.height},
                      {"camera", camera_json(student.camera())},
                      {"body_name", options.body_name},
                      {"body", Json::parse(body_to_json(motion.skeleton()))},
                      {"faults", faults},
                      {"events", events},
                      {"joints", names},
                      {"roles", roles},
                      {"landmarks", landmarks},
                      {"frames", frames}};
  return truth.dump() + "\n";
}

}  // namespace posecoach
