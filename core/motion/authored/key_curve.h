// A smooth curve through key values: position, velocity and acceleration are continuous, it rests (velocity
// and acceleration zero) before the first and after the last key, and it stands still for an instant at every
// key that is higher or lower than both its neighbours. Quintic Hermite pieces; velocities from the clamped
// cubic spline, limited after Fritsch & Carlson (1980) so that it does not swing past its keys.
#pragma once

#include <span>
#include <vector>

namespace posecoach {

struct CurveKey {
  double time_s = 0;
  double value = 0;
};

class KeyCurve {
 public:
  KeyCurve() = default;  // zero everywhere
  // Asserts that times increase strictly.
  explicit KeyCurve(std::span<const CurveKey> keys);

  double value(double time_s) const;

 private:
  struct Knot {
    double time = 0, value = 0, velocity = 0, acceleration = 0;
  };
  std::vector<Knot> knots_;
};

}  // namespace posecoach
