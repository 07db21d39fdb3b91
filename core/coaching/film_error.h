// The error that a faultless stroke has when one camera saw it: the pose stage's own. Measured as the habits
// are (core/coaching/film_habits.h): mean and one standard deviation over the faultless films of the bodies
// that the habits are known from, with a square camera.
#pragma once

#include <string_view>

#include "core/coaching/swing_events.h"

namespace posecoach {

class UsualFilmError {
 public:
  // Motion capture: none.
  UsualFilmError() = default;
  // `line_share`: 0 for a camera in front of the golfer, 1 for one on his target line. In between the errors
  // of both sides count by their shares.
  UsualFilmError(StrokeKind kind, double line_share);

  // Where the coach was filmed, too: from the same side the errors are alike, and a part of them is left;
  // from another side both count.
  UsualFilmError between_films(bool from_one_side) const;

  bool is_none() const { return !is_film_; }
  // Mean joint error in leg lengths of a part of the score (Score::groups, Score::phases).
  double of(std::string_view part) const;

 private:
  bool is_film_ = false;
  StrokeKind kind_ = StrokeKind::FullSwing;
  double line_share_ = 0, share_left_ = 1;
};

// How much of a camera's look along `sight` (level or not) goes along the target line of a golfer who faces
// `front`: the square of the sine of the angle between them, level.
double line_share_of(const Vec3& sight, const Vec3& front);

}  // namespace posecoach
