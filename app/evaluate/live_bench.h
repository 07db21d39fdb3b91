// A simulated stroke as the live loop sees it: filmed, looked at by the pose networks, and played through the
// hands-free loop with standing before and after it. Of posecoach evaluate live.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/evaluate/filmed_students.h"
#include "core/motion/authored/authored_motion.h"

namespace posecoach {

struct LiveCase {
  std::string motion, body, view, hand;
  double fps = 30, length = 1;
  double slower = 1;  // played so many times as slowly
  std::string name() const;
};

// What the loop made of one stroke. Times in seconds.
struct LiveOutcome {
  LiveCase asked;
  int found = 0;
  int false_starts = 0;  // strokes found while he stood, waggled, or stepped up to the ball and away
  bool is_kind_right = false, is_hand_right = false;
  double begin_late = 0;                     // the takeaway that was found, after the true one
  double told_late = 0;                      // when the stroke was known to be over, after its true finish
  double score = 0;                          // of the answer
  std::string message;                       // why there is none
  double ghost_median = 0, ghost_worst = 0;  // how far off the ghost is in time; worst: of nine in ten
  double ghost_takeaway = 0;                 // the same, in the first half of the backswing
  // How late each event of the same film is, when it is analysed as a film; empty with the reason in
  // `film_message`.
  std::map<std::string, double> events_late;
  std::string film_message;
};

class LiveBench {
 public:
  explicit LiveBench(FilmedStudents& films) : films_(films) {}
  // Errors: a wrong case, and those of the pose stage and its files.
  Result<LiveOutcome> run(const LiveCase& one);

 private:
  FilmedStudents& films_;
};

}  // namespace posecoach
