#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/coaching/text/advice_text.h"
#include "core/coaching/text/fill.h"
#include "core/coaching/text/name_text.h"

namespace posecoach::text {
namespace {

struct Sentences {
  std::string_view from, to;
  std::string_view quick, slow, same;
  // Of a slow rehearsal or a film in slow motion: {coach} is the coach's time at the golfer's pace.
  std::string_view quick_at_pace, slow_at_pace, same_at_pace;
};

constexpr std::array kSwing = {
    Sentences{"takeaway", "top", "Your backswing takes {time} s, the coach's {coach} s: {percent} too quick.",
              "Your backswing takes {time} s, the coach's {coach} s: {percent} too slow.",
              "Your backswing takes {time} s, the coach's {coach} s: about the same.",
              "At your pace the backswing should take {coach} s; yours takes {time} s: {percent} too quick.",
              "At your pace the backswing should take {coach} s; yours takes {time} s: {percent} too slow.",
              "At your pace the backswing should take {coach} s; yours takes {time} s: about right."},
    Sentences{"top", "mid_downswing",
              "Your transition takes {time} s, the coach's {coach} s: {percent} too quick.",
              "Your transition takes {time} s, the coach's {coach} s: {percent} too slow.",
              "Your transition takes {time} s, the coach's {coach} s: about the same.",
              "At your pace the transition should take {coach} s; yours takes {time} s: {percent} too quick.",
              "At your pace the transition should take {coach} s; yours takes {time} s: {percent} too slow.",
              "At your pace the transition should take {coach} s; yours takes {time} s: about right."},
    Sentences{"top", "impact", "Your downswing takes {time} s, the coach's {coach} s: {percent} too quick.",
              "Your downswing takes {time} s, the coach's {coach} s: {percent} too slow.",
              "Your downswing takes {time} s, the coach's {coach} s: about the same.",
              "At your pace the downswing should take {coach} s; yours takes {time} s: {percent} too quick.",
              "At your pace the downswing should take {coach} s; yours takes {time} s: {percent} too slow.",
              "At your pace the downswing should take {coach} s; yours takes {time} s: about right."},
    Sentences{
        "impact", "", "Your follow-through takes {time} s, the coach's {coach} s: {percent} too quick.",
        "Your follow-through takes {time} s, the coach's {coach} s: {percent} too slow.",
        "Your follow-through takes {time} s, the coach's {coach} s: about the same.",
        "At your pace the follow-through should take {coach} s; yours takes {time} s: {percent} too "
        "quick.",
        "At your pace the follow-through should take {coach} s; yours takes {time} s: {percent} too slow.",
        "At your pace the follow-through should take {coach} s; yours takes {time} s: about right."},
};
// Over a putt nobody speaks of a downswing.
constexpr Sentences kPuttForward = {
    "top",
    "impact",
    "Your way from the top to the ball takes {time} s, the coach's {coach} s: {percent} too quick.",
    "Your way from the top to the ball takes {time} s, the coach's {coach} s: {percent} too slow.",
    "Your way from the top to the ball takes {time} s, the coach's {coach} s: about the same.",
    "At your pace the way from the top to the ball should take {coach} s; yours takes {time} s: {percent} "
    "too "
    "quick.",
    "At your pace the way from the top to the ball should take {coach} s; yours takes {time} s: {percent} "
    "too "
    "slow.",
    "At your pace the way from the top to the ball should take {coach} s; yours takes {time} s: about "
    "right."};

const Sentences& sentences_of(const TimingAdvice& timing, StrokeKind kind) {
  if (kind == StrokeKind::Putt && timing.from == kPuttForward.from) return kPuttForward;
  for (const Sentences& one : kSwing)
    if (one.from == timing.from && (one.to == timing.to || one.to.empty())) return one;
  POSECOACH_ASSERT(!"a phase without a sentence");
  return kPuttForward;
}

}  // namespace

std::string timing(const TimingAdvice& timing, StrokeKind kind, double pace, bool is_clear) {
  const Sentences& one = sentences_of(timing, kind);
  const double should_s = timing.coach_s * pace, ratio = timing.student_s / should_s;
  const bool at_pace = pace != 1;
  const std::string_view words = !is_clear   ? (at_pace ? one.same_at_pace : one.same)
                                 : ratio < 1 ? (at_pace ? one.quick_at_pace : one.quick)
                                             : (at_pace ? one.slow_at_pace : one.slow);
  return filled(words, {{"time", number(timing.student_s, 2)},
                        {"coach", number(should_s, 2)},
                        {"percent", percent(ratio - 1)}});
}

std::string pose_match(std::string_view event, double late_s, bool is_clear) {
  const std::string_view words = !is_clear    ? "{When}, you are in time."
                                 : late_s > 0 ? "{When}, you are {time} s late."
                                              : "{When}, you are {time} s early.";
  return filled(words, {{"When", std::string(moment(event))}, {"time", number(std::abs(late_s), 2)}});
}

std::string other_pace(double ratio, bool is_film) {
  if (ratio < 1)
    return filled(
        "The whole swing takes only {percent} of the coach's time; its parts are compared at that pace.",
        {{"percent", percent(ratio)}});
  return filled(is_film
                    ? "The whole swing takes {times} times as long as the coach's: a slow swing, or a film "
                      "in slow motion. Its parts are compared at that pace."
                    : "The whole swing takes {times} times as long as the coach's. Its parts are compared "
                      "at that pace.",
                {{"times", number(ratio, 1)}});
}

}  // namespace posecoach::text
