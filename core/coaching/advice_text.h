// Every sentence that coaching says, in one place: plain and short, lead and trail instead of left and right,
// so that a mirrored swing reads the same.
#pragma once

#include <string>
#include <string_view>

#include "core/coaching/analysis.h"
#include "core/coaching/kinematic_sequence.h"
#include "core/coaching/part_differences.h"
#include "core/coaching/viewpoint.h"

namespace posecoach::text {

// "At the top, your lead arm is bent 24° more than the coach's." `offset` as in PartDifference; directions
// that `view` cannot see are not named.
std::string spatial(const PartDifference& difference, std::string_view event, Viewpoint view);

// "Your downswing takes 0.20 s, the coach's 0.30 s: 33 % too quick."
std::string timing(const TimingAdvice& timing, double relative_ratio, bool is_clear, bool in_proportion);

// "Your top comes 0.12 s late."
std::string pose_match(std::string_view event, double late_s, bool is_clear);
// "Your hips are 10 cm ...: a sway."
std::string with_fault_name(std::string sentence, std::string_view fault);
// Lists of parts, each may be empty.
std::string strictness(const std::string& harder, const std::string& softer, const std::string& never);
// `advice`, where one was given in most of the swings.
std::string block(int swings, double mean, double deviation, const std::string& advice, int times);
// At a low percent: nothing that one could point at.
std::string no_clear_difference(double percent);
// The swing as a whole takes `ratio` times as long as the coach's.
std::string other_pace(double ratio, bool is_film);
// The coach's hands are out of reach of the student's arms by as much.
std::string out_of_reach(double metres);

// "backswing", "downswing", "follow-through", "stroke", from the events that bound it.
std::string_view phase(std::string_view from, std::string_view to);
// "at the top"
std::string_view moment(std::string_view event);
// What one camera cannot tell; empty where every direction is known.
std::string seen_from(Viewpoint view);
// Why a motion is refused. `why` is one of those below it.
std::string no_golf_stroke(const std::string& why);
std::string hands_apart(double metres);
std::string feet_walk(double metres);
std::string hands_miss_the_ball(double metres);
std::string no_golf_tempo(double backswing_s, double downswing_s);
std::string chest_does_not_turn(double degrees);
// Why a metric cannot be given.
std::string hidden_by_view(Viewpoint view);
std::string hidden_by_one_camera();
std::string sequence_too_close(double frame_rate);
std::string head_is_still(double metres);
// What a metric says in words.
std::string sequence(const std::vector<Segment>& order);
std::string head_goes(bool is_with_the_hands);
std::string implausible(double value, std::string_view unit);
std::string too_few_frames(double frame_rate);
std::string hidden_joints(std::string_view what);

}  // namespace posecoach::text
