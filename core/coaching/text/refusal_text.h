// Why a motion cannot be analysed. Errors put the name of the motion and a colon before it, so that these
// begin small and end without a point.
#pragma once

#include <string>
#include <string_view>

#include "core/coaching/swing_events.h"

namespace posecoach::text {

// Missing or too little.
std::string no_such_joints(const std::string& names);
std::string too_few_frames_to_analyse(int frames, int least);
std::string no_stroke_seen();
std::string begins_in_the_backswing();
std::string no_rest_before_the_stroke();
std::string hands_stay_up();
std::string hands_do_not_come_back();
std::string ends_before_impact();
// In place of all of them, where one camera looks along the line that the hands swing on.
std::string putt_too_short_from_here();
std::string out_of_order(std::string_view event, std::string_view other);
// Whole lines, with the names of the motions.
std::string strokes_differ(const std::string& student, StrokeKind students, const std::string& coach);
std::string no_strictness(std::string_view setting);

// Hands that move as in a stroke, but nobody plays golf. `why` is one of those below it.
std::string no_golf_stroke(const std::string& why);
std::string hands_apart(double metres);
std::string feet_walk(double metres);
std::string hands_miss_the_ball(double metres);
std::string no_golf_tempo(double backswing_s, double downswing_s);
std::string chest_does_not_turn(double degrees);

}  // namespace posecoach::text
