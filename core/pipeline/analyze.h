// The main job as one function of values: the coach's motion into the student's body, both aligned, and
// everything that is to be said about it. Files, films and pictures are the caller's.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/coaching/analysis.h"
#include "core/coaching/moved_events.h"
#include "core/coaching/sight.h"
#include "core/coaching/strictness.h"
#include "core/coaching/viewpoint.h"
#include "core/motion/motion.h"
#include "core/pipeline/lift.h"
#include "core/retarget/retarget.h"

namespace posecoach {

struct StudentInput {
  std::string source;
  Motion motion;
  Skeleton body;  // that the coach's motion is carried over to
  Viewpoint view = Viewpoint::AllSides;
  Sight sight = {};
  std::optional<CameraSide> camera = {};  // that saw him
  // Of a film, of which `motion` may be a part: what the analysis counts in.
  int first_frame = 0;
  double first_time_s = 0;
  int frames = 0;
  double seconds = 0;
  int joints = 0;  // that its source knows
};

StudentInput student_from_motion(std::string source, const Motion& motion);
StudentInput student_from_film(std::string source, const PoseTrack& track, const LiftedStudent& lifted);

struct CoachInput {
  std::string source;
  Motion motion;
};

struct AnalyzeOptions {
  std::optional<Handedness> hand = {};  // the student's; detected when not given
  Strictness strictness = {};
  RetargetOptions retarget{kDefaultRetargetMethod, Contacts::On, RotationSource::FileFirst};
  std::vector<MovedEvent> moved_events = {};  // by hand; frames of the film, as the analysis counts
};

struct AnalyzedPair {
  Analysis analysis;  // student frames and times are the film's
  // The coach's motion in the student's body, mirrored if the student plays with the other hand, facing as he
  // does, standing on his feet at address, in the student's world. Frames are the coach's own.
  Motion coach;
};

// Which hand the stroke is played with; right where no stroke is found.
Handedness hand_of(const Motion& motion, const Sight& sight = {});

// Errors: those of retarget() and compare(), naming whose motion it is.
Result<AnalyzedPair> analyze(const StudentInput& student, const CoachInput& coach,
                             const AnalyzeOptions& options = {});

}  // namespace posecoach
