// From a motion file's own units, axes and rest pose to the program's: metres, +Y up, a T-pose that faces +Z.
// Such files say none of it, so it is told from the body itself.
#pragma once

#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/body/skeleton.h"

namespace posecoach {

// Our offset of joint j = rest_from_file[parent of j] * offset * metres_per_unit; our world position =
// world_from_file * position * metres_per_unit; our global rotation of j =
// world_from_file * rotation * conjugate(rest_from_file[j]).
struct FileFrame {
  double metres_per_unit = 1;
  Quat world_from_file = Quat(1, 0, 0, 0);
  std::vector<Quat> rest_from_file;  // one a joint
};

// `joints` carry roles and the file's offsets. The unit is the one that makes a body of people's height:
// metre, foot, decimetre, CMU's 5.6444 cm, inch, centimetre, millimetre. Limbs that stand far from a T-pose
// (arms more than 25 degrees, legs more than 18 degrees) are turned into it. `world_from_file` is that of the
// rest pose. Errors: Malformed when the body has no extent.
Result<FileFrame> file_frame(std::span<const Joint> joints);

// The unit in which a person's leg (hip to ankle) and trunk (pelvis to neck) together are `length` long.
double metres_per_unit_of_person(double length);

// The offsets in our frame.
std::vector<Joint> converted(std::vector<Joint> joints, const FileFrame& frame);

// The rotation by quarter turns that takes the axis nearest to `up` to +Y; `up` need not be of unit length.
Quat rotation_to_y_up(const Vec3& up);

}  // namespace posecoach
