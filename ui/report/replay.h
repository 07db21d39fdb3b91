// The aligned motions boiled down to what a report can carry: some pairs of moments with both bodies' main
// joints, turned so that the student faces +Z at the first of them, feet around the origin.
#pragma once

#include <utility>
#include <vector>

#include "ui/report/comparison.h"

namespace posecoach {

struct ReplayStep {
  int student_frame = 0, coach_frame = 0;
  double student_s = 0, coach_s = 0;  // from each motion's own beginning
  double apart_m = 0;                 // mean joint error
  // How fast the student goes compared with the coach here: 1 alike, 2 twice as fast.
  double speed = 1;
  std::vector<Vec3> student, coach;  // one a joint of the replay, metres
};

struct Replay {
  std::vector<HumanoidJoint> joints;       // those that both bodies have
  std::vector<std::pair<int, int>> bones;  // indices into `joints`
  std::vector<ReplayStep> steps;           // in time
  double overall_speed = 1;                // the coach's time for the whole over the student's

  // The step's speed; in proportion to the whole where that is clearly slower or faster than the coach's, as
  // in a slow rehearsal or a film in slow motion.
  double speed_in_proportion(const ReplayStep& step) const;
  bool is_in_proportion() const;
};

// Takes every pair of the path, or about `most_steps` of them spread evenly, among them those that the
// analysis speaks of: advice, positions, events, stills.
Replay make_replay(const Comparison& comparison, int most_steps);

// Index of the step nearest to a pair of frames, the student's first. Asserts that there are steps.
int step_at(const Replay& replay, int student_frame, int coach_frame);

}  // namespace posecoach
