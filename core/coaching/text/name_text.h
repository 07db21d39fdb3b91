// Names of moments, parts of the body and strokes, as golfers say them.
#pragma once

#include <string>
#include <string_view>

#include "core/body/humanoid.h"
#include "core/coaching/strictness.h"
#include "core/coaching/swing_events.h"

namespace posecoach::text {

// "At the top", at the beginning of a sentence.
std::string_view moment(std::string_view event);
// As a word within a list: "hips".
std::string_view judged_part(JudgedPart part);
// "left elbow".
std::string joint(HumanoidJoint joint);
// "right-handed full swing".
std::string_view stroke(std::string_view stroke, bool is_left_handed);

}  // namespace posecoach::text
