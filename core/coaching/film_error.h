// The error that a faultless stroke has when one camera saw it: the pose stage's own. Most of it is habit: at
// the same stage of a stroke, from the same side, the model puts a joint as far beside its place in one
// golfer as in the next. What is left wavers from film to film. Both are means over the faultless films of
// the bodies that the habits of events and measures (core/coaching/film_habits.h) are known from;
// docs/SCORE.md.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/base/math.h"
#include "core/body/humanoid.h"
#include "core/coaching/swing_events.h"

namespace posecoach {

// The stages at which a film is compared: the events of a stroke and half-way between them, up to the middle
// of the follow-through, or half-way to a putt's end. When hands have come to rest is not seen in a film.
class FilmStages {
 public:
  explicit FilmStages(const SwingEvents& stroke);

  int count() const;
  // How much a moment counts for a stage: 1 at the stage, nothing at its neighbours.
  double weight(int stage, double time_s) const;
  // The first stages of backswing, downswing and follow-through, and the count.
  using Phases = std::array<int, 4>;
  Phases phases() const;

 private:
  StrokeKind kind_;
  std::vector<double> events_s_;
};

class UsualFilmError {
 public:
  // Motion capture: none.
  UsualFilmError() = default;
  // `camera_deg`: where the camera stands around a right-hander at address, from his front (0) towards his
  // left; -90 is down the line. Offsets are known near the places that were measured; elsewhere their size is
  // forgiven instead.
  UsualFilmError(StrokeKind kind, double camera_deg);

  // Where the coach was filmed, too: from the same side the habits are alike and cancel; from another side
  // the coach's are forgiven by their size.
  UsualFilmError between_films(bool from_one_side) const;
  // Of a film that shows this part of the habits: by a pose model that has them not, 0.
  UsualFilmError shown(double part) const;

  bool is_none() const { return !is_film_; }
  // Where a joint is seen from its place in the coach's body, leg lengths along a right-hander's left, up and
  // front. It is taken off by `share()`.
  Vec3 offset(HumanoidJoint joint, int stage) const;
  double share() const { return share_; }
  // The error, in leg lengths, that a part of the body (Score::groups) may have about a stage when the
  // offsets are taken off: mean and two standard deviations.
  double of(std::string_view part, int stage) const;

 private:
  template <typename Rows>
  double of(const Rows& rows, std::string_view part, int stage) const;

  bool is_film_ = false;
  StrokeKind kind_ = StrokeKind::FullSwing;
  double camera_deg_ = 0;
  double share_ = 0;                // of the offsets that is taken off
  double left_times_ = 1;           // of what is left
  double size_forgiven_ = 0;        // of the offsets' size, beside what is not taken off
  bool are_offsets_alike_ = false;  // in both of two films: nothing to take off or to forgive
};

// Where a camera that looks along `sight` stands around somebody with these axes, degrees as above.
double camera_deg_of(const Vec3& sight, const Vec3& left, const Vec3& front);

}  // namespace posecoach
