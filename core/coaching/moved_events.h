// Events that somebody put in their place by hand: what was found gives way to them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/coaching/joint_track.h"
#include "core/coaching/swing_events.h"

namespace posecoach {

struct MovedEvent {
  std::string name;
  int frame = 0;  // of the motion, or of the film where a film is spoken of
  bool operator==(const MovedEvent&) const = default;
};

// Every moved event where it was put; those that were found and are no longer between their neighbours move
// evenly in between. Names that the stroke does not have are passed over. Nothing where the moved ones do not
// follow each other, or leave no frame for those between them.
std::optional<SwingEvents> with_moved(const SwingEvents& found, const std::vector<MovedEvent>& moved,
                                      const JointTrack& track);

}  // namespace posecoach
