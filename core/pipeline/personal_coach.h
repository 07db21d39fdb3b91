// The coach in one student's body, with what the ghost needs to know of his stroke.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/body/mirror.h"
#include "core/coaching/alignment.h"
#include "core/coaching/body_axes.h"
#include "core/coaching/joint_track.h"
#include "core/coaching/swing_events.h"
#include "core/motion/motion.h"
#include "core/retarget/retarget.h"

namespace posecoach {

struct PersonalCoach {
  Motion motion;  // in the student's body and of his hand, in the coach's world
  std::shared_ptr<const Skeleton> body;
  JointTrack track;   // of that motion
  TimeWindow stroke;  // from address to the end; the whole motion where no stroke is seen in it
  Vec3 feet;          // middle of the ankles at address
  BodyAxes axes;      // at address
  std::optional<StrokeKind> kind;
  // Known across the coach's view alone, +Z of his world towards the camera: never turned about.
  bool is_flat = false;
  std::string message = {};  // what of him is not shown, for people; usually empty

  // The joints at a time of the track, straight between the two nearest frames.
  std::vector<Vec3> positions(double time_s) const;
  // Of each joint then: below 1 only where the coach is flat.
  std::vector<double> confidence(double time_s) const;
  // One frame: the mean over the moments before the stroke.
  JointTrack address() const;
};

// Of a motion that is in the student's body already, of his hand. Errors: a motion that coaching cannot use.
Result<PersonalCoach> personal_coach_from(Motion motion);

// Errors: those of retarget(), and a motion that coaching cannot use.
Result<PersonalCoach> make_personal_coach(const Motion& coach, const Skeleton& body, Handedness hand,
                                          const RetargetOptions& options);

}  // namespace posecoach
