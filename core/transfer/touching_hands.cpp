#include "core/transfer/touching_hands.h"

namespace posecoach {

void keep_hands_together(Pose2d& result, const Pose2d& source, double scale, double weight) {
  using enum Joint2d;
  if (weight <= 0 || !source.is_seen(LeftWrist) || !source.is_seen(RightWrist)) return;
  const Vec2 wanted = (source[LeftWrist] - source[RightWrist]) * scale;
  const Vec2 missing = wanted - (result[LeftWrist] - result[RightWrist]);
  const Vec2 each = 0.5 * weight * missing;
  result[LeftWrist] += each;
  result[LeftElbow] += 0.5 * each;
  result[RightWrist] -= each;
  result[RightElbow] -= 0.5 * each;
}

}  // namespace posecoach
