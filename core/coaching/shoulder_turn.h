// How a putter's shoulder line turns, as it happens, seen by a camera on his target line: his hands move
// along the line of sight there (pendulum.h), but the line turns across the picture. Of that a pose model
// shows from a third to all, golfer by golfer. So its size does not count, only how place and speed go
// together: from rest, going back, at the top, going forward, and through.
#pragma once

#include <deque>

#include "core/base/math.h"
#include "core/base/time.h"

namespace posecoach {

class ShoulderTurn {
 public:
  // `across_m`: the shoulder line's length across the picture, metres. A gap of over half a second begins
  // anew.
  void step(MediaTime time, double across_m);
  void reset() { *this = ShoulderTurn(); }

  // Both are means over the last quarter of a second: of now they are half of that late, in every stroke
  // alike.
  double away_m() const { return place_ - rest_; }
  double speed() const { return speed_; }  // metres a second
  // How long it has been slow, seconds.
  double still_s() const { return still_s_; }

  // He rests here; `part` of what lies between this and where he rested before is believed.
  void rest_here(double part) { rest_ += part * (place_ - rest_); }

  // Shorter than 1: (0, 0) at rest, (0, 1) going back, (1, 0) at the top, (0, -1) at the ball, (-1, 0) at the
  // end; or all of it mirrored. What trembles by `tremble_m` is half way to rest.
  Vec3 phase(double tremble_m) const;

 private:
  struct Sample {
    MediaTime time;
    double across_m = 0;
  };
  std::deque<Sample> samples_;
  double place_ = 0, speed_ = 0, rest_ = 0, still_s_ = 0;
};

}  // namespace posecoach
