// Which moment of the student answers which moment of the coach, and how far apart the two bodies are then.
#pragma once

#include <utility>
#include <vector>

#include "core/coaching/joint_track.h"
#include "core/coaching/sight.h"

namespace posecoach {

// A part of a motion, in seconds from its first frame.
struct TimeWindow {
  double begin_s = 0, end_s = 0;
};

// Both motions run at this rate inside the warp, whatever their own: a coach at 120 fps and a student at 30
// are then compared at the same instants instead of at the nearest frames.
inline constexpr double kAlignmentRate = 120;

struct Alignment {
  Sight sight;           // what the distances below were seen by
  double coach_yaw = 0;  // the one turn about +Y, radians, that makes the coach face as the student does
  // Both windows at kAlignmentRate; the coach already turned (about the world's origin).
  JointTrack student, coach;
  std::vector<HumanoidJoint> joints;       // compared: those that both have, without the root
  std::vector<std::pair<int, int>> steps;  // the warp's path through those two tracks
  std::vector<double> step_error_m;        // mean joint error of each step
  std::vector<std::pair<int, int>> path;   // the same path in the motions' own frames, without gaps
  std::vector<double> path_error_m;        // mean joint error of each of its pairs
  // The student's time that answers a coach's time (and the other way round), along the path.
  double student_time(double coach_time_s) const;
  double coach_time(double student_time_s) const;
};

// Windows without a value: the whole coach is searched for anywhere inside the student. Poses are compared
// with the pelvis at the origin; turn and warp are improved in turns until both stand still.
Alignment align(const JointTrack& student, const JointTrack& coach, const TimeWindow& student_window,
                const TimeWindow& coach_window, const Sight& sight = {});
Alignment align_anywhere(const JointTrack& student, const JointTrack& coach, const TimeWindow& coach_window,
                         const Sight& sight = {});

}  // namespace posecoach
