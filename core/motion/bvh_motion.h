// What a BVH file means: a body and its motion; and back.
#pragma once

#include <string>
#include <string_view>

#include "core/motion/provenance.h"

namespace posecoach {

// `file_name` is for messages. The file's root joint is the body's root, unless the pelvis hangs below it and
// has position channels of its own (a "reference" above the hips): then the pelvis is. Bones that change
// their length by more than a millimetre make a motion of positions without rotations.
// Errors: as parse_bvh; Incomplete when there are no frames.
Result<MotionFile> read_bvh(std::string_view file_name, std::string_view text);
// Also of a file without frames.
Result<SkeletonFile> read_bvh_skeleton(std::string_view file_name, std::string_view text);

// A BVH of the joints, names, channels, rest pose, axes and units in `provenance`, or, when that has no BVH,
// in centimetres with Z, X, Y rotations. BVH has one frame time: a motion whose frame times are not constant
// is resampled to as many frames at a constant rate. Errors: Unsupported (the motion has no rotations),
// InvalidArgument (its joints are not the provenance's).
Result<std::string> bvh_from_motion(const Motion& motion, const MotionProvenance& provenance);

}  // namespace posecoach
