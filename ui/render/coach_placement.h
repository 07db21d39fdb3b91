// Where the personalised coach stands in the student's film: at every frame of the student the coach's pose
// that answers it, on the student's feet,
// without jitter.
#pragma once

#include <utility>
#include <vector>

#include "core/motion/motion.h"

namespace posecoach {

struct CoachPlacement {
  std::vector<double> coach_frame;  // one a student frame; fractional
  std::vector<Vec3> offset;         // one a student frame, metres

  // The coach's joints in the student's world at a frame of the student's motion.
  std::vector<Vec3> positions(const Motion& coach, int student_frame) const;
  // The same place with another pose of the coach, for showing an exact pair of frames.
  std::vector<Vec3> positions(const Motion& coach, double at_coach_frame, int student_frame) const;
};

// The coach's frame for each student frame along the alignment path: even, never backwards, and never further
// than half a frame from a pair of the path. Before the path the coach waits in its first pose, after it in
// its last. `path` has at least one pair and never decreases; its student frames count from 0.
std::vector<double> follow_path(const std::vector<std::pair<int, int>>& path, int student_frames);

// `path` counts the frames of the two motions; pairs beyond the student's motion are left out. `coach` is in
// the student's body and faces as he does. The offset is one for the whole swing, and follows smoothly only
// where the student walks away from it.
CoachPlacement stand_on_feet(const Motion& student, const Motion& coach,
                             const std::vector<std::pair<int, int>>& path);

}  // namespace posecoach
