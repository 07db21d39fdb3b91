#include "core/coaching/text/picture_text.h"

#include <algorithm>
#include <cmath>

#include "core/coaching/text/fill.h"
#include "core/coaching/text/name_text.h"

namespace posecoach::text {

std::string picture_offset(HumanoidJoint which, double right_m, double up_m) {
  const double right = std::abs(right_m), up = std::abs(up_m);
  const bool is_high = up_m > 0, is_right = right_m > 0;
  std::string_view words;
  if (std::min(right, up) > 0.5 * std::max(right, up))
    words =
        is_high
            ? (is_right
                   ? "In the pose of the coach's picture, your {joint} is {up} too high and {side} too far "
                     "to the right in the picture."
                   : "In the pose of the coach's picture, your {joint} is {up} too high and {side} too far "
                     "to the left in the picture.")
            : (is_right
                   ? "In the pose of the coach's picture, your {joint} is {up} too low and {side} too far "
                     "to the right in the picture."
                   : "In the pose of the coach's picture, your {joint} is {up} too low and {side} too far "
                     "to the left in the picture.");
  else if (up > right)
    words = is_high ? "In the pose of the coach's picture, your {joint} is {up} too high."
                    : "In the pose of the coach's picture, your {joint} is {up} too low.";
  else
    words = is_right ? "In the pose of the coach's picture, your {joint} is {side} too far to the right in "
                       "the picture."
                     : "In the pose of the coach's picture, your {joint} is {side} too far to the left in "
                       "the picture.";
  return filled(words, {{"joint", joint(which)}, {"up", centimetres(up_m)}, {"side", centimetres(right_m)}});
}

std::string no_picture_difference() {
  return "No clear difference from the coach's picture was found.";
}

std::string picture_and_frame(int frame) {
  return filled(
      "One picture of the coach, compared with the moment of the film that is most like it (frame {frame}).",
      {{"frame", std::to_string(frame)}});
}

std::string no_frame_like_the_picture() {
  return "No moment of the film is much like the picture.";
}

std::string never_seen_together(const std::string& student, const std::string& picture) {
  return filled("the joints of {student} and of the picture {picture} are never seen together",
                {{"student", student}, {"picture", picture}});
}

std::string picture_is_mirrored() {
  return "The coach's picture is mirrored: so it is more like the student.";
}

std::string picture_is_mirrored_for_left_handed() {
  return "The picture is mirrored, for a left-handed golfer.";
}

std::string left_out_where_hidden(const std::string& parts) {
  return filled("Left out where the coach hides them: {parts}.", {{"parts", parts}});
}

std::string drawn_without(const std::string& parts) {
  return filled("The coach's pictures do not always show, and he is drawn there without: {parts}.",
                {{"parts", parts}});
}

std::string coach_is_seen_from(std::string_view side) {
  return filled("The coach is seen {side}: stand so that the camera sees you {side} too.",
                {{"side", std::string(side)}});
}

}  // namespace posecoach::text
