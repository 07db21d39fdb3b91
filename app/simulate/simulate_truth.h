// What is true of a simulated film, as JSON ("posecoach.truth/1").
#pragma once

#include <string>

#include "capture/simulated_student.h"

namespace posecoach {

// {"schema", "source", "motion", "view", "hand", "fps", "width", "height",
//  "camera": {"focal_px", "centre_px", "rotation_camera_from_world": rows,
//  "translation_camera_from_world_m"}, "body": as a .body.json, "faults": [{"name", "amount", "unit"}],
//  "events": [{"name", "time_s"}], "joints": [names], "roles": [canonical names or null], "landmarks": [33
//  names], "frames": [{"index", "time_s", "joints_m": [[x, y, z]], "joints_px": [[x, y]],
//              "landmarks_m": [[x, y, z]], "landmarks_px": [[x, y]],
//              "club_m": {"butt", "grip", "head"}}]}
std::string truth_as_json(const SimulatedStudent& student, const SimulatedStudentOptions& options);

}  // namespace posecoach
