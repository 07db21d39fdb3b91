// What a golfer is told: advice, and the remarks beside it. Plain and short, lead and trail instead of left
// and right, so that a mirrored swing reads the same. Every sentence is a whole one with blanks for numbers.
#pragma once

#include <string>
#include <string_view>

#include "core/coaching/analysis.h"
#include "core/coaching/part_differences.h"
#include "core/coaching/swing_events.h"
#include "core/coaching/viewpoint.h"

namespace posecoach::text {

// "At the top, your lead arm is bent 24° more than the coach's." `offset` as in PartDifference; directions
// that `view` cannot see are not named. Where golfers have a name for it ("sway"), it is said.
std::string spatial(const PartDifference& difference, std::string_view event, std::string_view fault,
                    Viewpoint view);

// "Your downswing takes 0.20 s, the coach's 0.30 s: 33 % too quick." `pace`, where the swing as a whole is
// another's: how many times as long it takes as the coach's; else 1.
std::string timing(const TimingAdvice& timing, StrokeKind kind, double pace, bool is_clear);

// "At the top, you are 0.12 s late."
std::string pose_match(std::string_view event, double late_s, bool is_clear);

// At a low percent: nothing that one could point at.
std::string no_clear_difference(double percent);

// Remarks.
// What one camera cannot tell; empty where every direction is known.
std::string seen_from(Viewpoint view, StrokeKind kind);
std::string coach_seen_elsewhere();
// The swing as a whole takes `ratio` times as long as the coach's.
std::string other_pace(double ratio, bool is_film);
// The coach's hands are out of reach of the student's arms by as much.
std::string out_of_reach(double metres);
// Parts of the body, in words with commas between; each list may be empty.
std::string strictness(const std::string& harder, const std::string& milder, const std::string& never);
// Events were moved by hand, and are in order or not.
std::string moved_by_hand(bool count);
std::string only_the_score(const std::string& reason);

// Several swings: mean, spread, and what was told in most of them.
std::string block(int swings, double mean, double deviation, const std::string& advice, int times);

// At address, before the swing. `amount` student less coach.
enum class Posture { Stance, Spine, Side, Knees, Hands };
std::string address(Posture what, double amount);

// One command's answer in a few lines.
std::string summary_title(const Analysis& analysis);
std::string summary_score(const Score& score);
std::string summary_tempo(const Metric& tempo);
std::string summary_advice(int number, const Advice& advice);
std::string summary_note(const std::string& note);

}  // namespace posecoach::text
