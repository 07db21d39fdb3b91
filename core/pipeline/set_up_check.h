// "Stand here": whether the camera sees the golfer well, in his words. Levels do not flicker: a check changes
// only after what it sees has lasted for a while.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/body/landmarks.h"
#include "core/coaching/swing_events.h"
#include "core/image/frame.h"
#include "core/pipeline/camera_side.h"
#include "core/pipeline/coach_snapshot.h"

namespace posecoach {

// How bright the person and the rest of the picture are, 0 to 255, and how far dark and bright parts of the
// person are apart (between the 5th and the 95th of a hundred).
struct Brightness {
  double person = 0, around = 0, contrast = 0;
};
// From a grid of pixels in and around the box of the person's landmarks; nothing when that lies outside.
std::optional<Brightness> measure_brightness(const Image& image, const ImageKeypoints& person);

struct SetUpSight {
  const std::optional<SeenPerson>& person;
  std::optional<CameraSide> side;    // where the camera stands
  std::optional<int> people;         // in view, where the pose stage can tell
  std::optional<StrokeKind> stroke;  // of the coach
  const Image& image;
};

class SetUpChecks {
 public:
  // All five topics, in the order of SetUpTopic.
  const std::vector<SetUpCheck>& step(MediaTime time, const SetUpSight& sight);
  // Whether it is told that the camera stands on the line that the putt is played along.
  bool tells_putt_from_behind() const;
  void reset() { *this = SetUpChecks(); }

 private:
  struct Candidate {
    SetUpCheck check;
    MediaTime since;
  };
  std::vector<SetUpCheck> shown_;
  std::array<Candidate, 5> candidates_;
  std::optional<Brightness> brightness_;
  std::optional<MediaTime> brightness_at_;
};

}  // namespace posecoach
