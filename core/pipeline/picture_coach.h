// A coach of whom there is only a film or a picture, in the student's proportions straight on the student's
// picture: what moves across the view comes from the 2D pose transfer (core/transfer); depth, of which a
// picture says little, is the pose model's, in the student's size.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/pipeline/lift.h"
#include "core/transfer/transferer.h"

namespace posecoach {

struct PictureCoach {
  // On the student's webcam body, in the student's world, standing on the student's feet; a frame for each
  // frame of the coach. Projected by the student's camera it is the transferred pose. What was not seen of
  // the coach, or cannot be told from his pictures, has confidence 0.
  Motion motion;
  std::vector<Joint2d> hidden;      // joints that he does not show in a good part of his frames
  std::vector<std::string> doubts;  // for people; the first is about those, where there are any
};

// Both seen by a camera that stands still, from about the same side. Errors: Incomplete (the two are filmed
// from different sides; nobody to measure).
Result<PictureCoach> coach_in_picture(const LiftedStudent& coach, const LiftedStudent& student,
                                      Transferer& transferer);

// The same for a student whose body was measured, whatever picture he will be drawn on: for the live picture.
// In a world whose +Z is towards the coach's camera, the feet on the floor at the origin. Errors:
// InvalidArgument (a body that is no webcam body), and those above.
Result<PictureCoach> coach_on_body(const LiftedStudent& coach, const Skeleton& body, Transferer& transferer);

// The person in a mirror: what a right-handed coach's film shows a left-handed student.
LiftedStudent mirrored(const LiftedStudent& filmed);

// A picture as a film in which nobody moves, so that it can be lifted. Errors: NoPerson.
Result<PoseTrack> still_film(const PoseTrack& pictures);

}  // namespace posecoach
