// What a golfer is told about a coach who is known from pictures only.
#pragma once

#include <string>
#include <string_view>

#include "core/body/humanoid.h"

namespace posecoach::text {

// "In the pose of the coach's picture, your left elbow is 8 cm too high." Metres in the picture, right and up
// positive; the smaller of both is told where it is no afterthought.
std::string picture_offset(HumanoidJoint joint, double right_m, double up_m);
std::string no_picture_difference();
std::string picture_and_frame(int frame);
std::string no_frame_like_the_picture();
std::string never_seen_together(const std::string& student, const std::string& picture);

std::string picture_is_mirrored();
std::string picture_is_mirrored_for_left_handed();
// Parts in words with commas between.
std::string left_out_where_hidden(const std::string& parts);
std::string drawn_without(const std::string& parts);
// `side` as in "face-on".
std::string coach_is_seen_from(std::string_view side);

}  // namespace posecoach::text
