// Everything that a user may name as a motion or a body, in one place:
//   bundled:NAME, reference:NAME (a coach of the user's own), a motion file, a pose file, a film, a folder of
//   pictures, simulated:...
#pragma once

#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/motion/provenance.h"
#include "core/pipeline/lift.h"
#include "core/vision/pose_tracker.h"

namespace posecoach {

struct LoadOptions {
  PoseTrackerOptions pose;  // for films
  LiftOptions lift;         // for films and pose files
  Progress progress;
};

// A person seen by a camera: what the pose stage saw, and where that is in the world.
struct SeenStudent {
  PoseTrack track;
  LiftedStudent lifted;
};

struct LoadedMotion {
  std::string source;  // as the user wrote it
  Motion motion;
  MotionProvenance provenance;         // of motion files
  std::optional<SeenStudent> student;  // of films and pose files; `motion` is student->lifted.motion then
  // Frame of the source that is frame 0 of `motion`: not 0 where nobody was seen at the start of a film.
  int first_frame = 0;
};

// Errors: those of the readers, the pose stage and lift, each with the source's name.
Result<LoadedMotion> load_motion(const std::string& source, const LoadOptions& options = {});

// Only what the pose stage sees; for films, pictures, simulated students and pose files.
Result<PoseTrack> load_pose_track(const std::string& source, const LoadOptions& options = {});

// A .body.json, or the body of anything that load_motion reads; a motion file without frames will do.
// `options.lift` says how a film's person is measured.
Result<SkeletonFile> load_body(const std::string& source, const LoadOptions& options = {});

}  // namespace posecoach
