// The whole of coaching: two motions in, everything that is to be said about them out.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/coaching/analysis.h"
#include "core/coaching/moved_events.h"
#include "core/coaching/sight.h"
#include "core/coaching/strictness.h"
#include "core/coaching/swing_events.h"
#include "core/coaching/viewpoint.h"
#include "core/motion/motion.h"

namespace posecoach {

struct CompareOptions {
  std::optional<Handedness> hand = {};  // the student's; detected when not given
  Viewpoints views = {};
  Sight sight = {};        // of the camera, in the world of the student's motion
  Sight coach_sight = {};  // likewise of the coach, if a camera saw him
  Strictness strictness = {};
  // The coach's motion before it was carried over, frame by frame the same: the bend of his arms, which
  // closing the grip of longer arms would change, is told from it. Right-handed where `coach` is.
  const Motion* coach_himself = nullptr;
  // The student's events that somebody put in their place by hand; frames of his motion. Everything that is
  // told from events is told from these; a note says so, also where they cannot be and the found ones count.
  std::vector<MovedEvent> moved_events = {};
  // How error messages call the two.
  std::string student_name = "the student's motion", coach_name = "the coach's motion";
};

// `coach` is already in the student's body. Coach and student may be of different hands: each is compared as
// a right-hander, and everything that is reported about the student is mirrored back. A student whose swing
// cannot be divided into its events is searched for the coach's motion instead; the analysis says so and
// keeps to the score. Sources and retargeting fields are the caller's to fill in. The same input gives the
// same bits. Errors: Incomplete (missing joints, too few frames, a coach's motion that is no stroke, strokes
// of different kinds, a student who does nothing like it), Unsupported (a student who
// does not play golf).
Result<Analysis> compare(const Motion& student, const Motion& coach, const CompareOptions& options = {});

}  // namespace posecoach
