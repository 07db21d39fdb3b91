// 2D poses from whatever the user names: a film, a folder of pictures, a file of poses, a motion.
#pragma once

#include <string>
#include <vector>

#include "app/commands.h"
#include "core/base/progress.h"
#include "core/transfer/pose2d.h"
#include "core/vision/pose_tracker.h"

namespace posecoach {

struct TimedPose2d {
  std::size_t frame = 0;
  double time_s = 0;
  Pose2d pose;
};

// Frames in which somebody is seen. A motion is looked at from `turn_degrees` about the vertical. "FILE#3" is
// the fourth clip of a file of annotated clips. Errors: those of the readers; NoPerson when there is nobody
// in it.
Result<std::vector<TimedPose2d>> read_poses2d(const std::string& input, double turn_degrees,
                                              const PoseTrackerOptions& options, const Progress& progress);

}  // namespace posecoach
