// The student's posture at address against the coach's, steadied: over half a second of standing still, told
// anew a few times a second at most.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/live_lift.h"
#include "core/pipeline/personal_coach.h"

namespace posecoach {

class AddressWatch {
 public:
  // Empty while he is not at address.
  const std::vector<std::string>& step(MediaTime time, const LiveStudent& student, bool is_at_address,
                                       const PersonalCoach& coach, Handedness hand);
  void reset() { *this = AddressWatch(); }

 private:
  struct Look {
    MediaTime time;
    LiveStudent student;
  };
  std::vector<std::string> look(const PersonalCoach& coach, Handedness hand) const;

  std::deque<Look> looks_;
  std::optional<MediaTime> told_at_;
  std::vector<std::string> advice_;
};

}  // namespace posecoach
