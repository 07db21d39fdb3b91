// What a transfer cannot know from the pictures that it was given, said in words instead of drawn as if
// known.
#pragma once

#include <string>
#include <vector>

#include "core/transfer/bone_lengths.h"
#include "core/transfer/transferer.h"

namespace posecoach {

// Where a bone that was not seen is drawn: hanging, in fractions of stature, the person facing the camera.
Vec2 guessed_bone(std::size_t bone);

// Joints not seen in the pose, those expected to be far off although they were seen, and
// doubts_about_lengths.
std::vector<std::string> doubts_about(const Pose2d& pose, const TransferredPose& result,
                                      const BoneLengths2d& source, const BoneLengths2d& identity);

// Bones that no picture of a person shows at a believable length: strongly foreshortened in all of them, or
// never seen.
std::vector<std::string> doubts_about_lengths(const BoneLengths2d& source, const BoneLengths2d& identity);

}  // namespace posecoach
