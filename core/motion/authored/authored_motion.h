// A golf motion that we wrote ourselves, in any body: with the club, the ball and the true time of every
// event.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/body/mirror.h"
#include "core/motion/authored/golfer_poser.h"
#include "core/motion/motion.h"

namespace posecoach {

struct AuthoredEvent {
  std::string
      name;  // "address", "takeaway", "top", "impact", "finish" (a putt: "end"), and what lies between
  double time_s = 0;
};

struct AuthoredMotion {
  Motion motion;                      // with rotations
  std::vector<ClubPose> club;         // one a frame
  std::vector<AuthoredEvent> events;  // in the order of time
  Vec3 ball;                          // where it lies until impact
  double deficit_m = 0;  // the most that a hand or foot misses its place by; 0 for bodies that can play

  // Asserts that there is one of this name.
  double time_of(std::string_view event) const;
};

// Errors: Incomplete (the body lacks joints), InvalidArgument (frame rate not in (0, 1000]).
Result<AuthoredMotion> make_authored_motion(const GolfScript& script, const Skeleton& body,
                                            double frames_per_second, Handedness hand = Handedness::Right);

}  // namespace posecoach
