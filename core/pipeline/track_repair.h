// What a pose stage gets wrong now and then, mended with the frames before and after: left and right
// exchanged, and single frames in which a joint jumps away and back.
#pragma once

#include <span>

#include "core/body/landmarks.h"

namespace posecoach {

// One time for each person, increasing; frames far apart (over 0.3 s) do not vouch for each other. Exchanged
// sides go back to the side that they have most of the time; arms with shoulders and face, and legs with
// hips, each for itself. A joint that stands over a hand's breadth away from where the two frames before and
// the two after have it is put there, and counts half as visible.
void repair_people(std::span<const double> times_s, std::span<SeenPerson> people);

}  // namespace posecoach
