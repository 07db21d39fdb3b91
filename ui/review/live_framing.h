// Which part of the live picture is looked at: the golfer as large as fits, with room for the club, so that
// he sees himself from where he stands. It moves seldom and gently, never while he swings, and shows the
// whole picture as long as the camera does not see all of him. Plain arithmetic.
#pragma once

#include "core/pipeline/coach_snapshot.h"
#include "ui/render/scene.h"

namespace posecoach {

struct LiveFraming {
  PicturePart part, aim;  // now, and where it is going
  double shape = 0;       // of the place that they were made for
  bool has_begun = false;
  double unseen_s = 0;  // since the golfer was seen last
  bool operator==(const LiveFraming&) const = default;
};

// `shape` is the width of the place on the screen over its height.
LiveFraming framed(LiveFraming framing, const CoachSnapshot& snapshot, double shape, double elapsed_s);

// The whole picture; what would only make thin bars of the background is cut off.
PicturePart whole_part(double width_px, double height_px, double shape);

}  // namespace posecoach
