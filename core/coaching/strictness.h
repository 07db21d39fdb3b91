// How hard a coach wants a golfer to be judged, part by part: 2 tells half the difference already, 0.5 only
// twice of it, 0 never. It decides what is told, never the score: that stays comparable.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace posecoach {

enum class JudgedPart { Hips, Trunk, Head, Arms, Legs, Timing };
inline constexpr std::array kJudgedParts = {JudgedPart::Hips, JudgedPart::Trunk, JudgedPart::Head,
                                            JudgedPart::Arms, JudgedPart::Legs,  JudgedPart::Timing};
std::string_view to_string(JudgedPart part);  // "hips", "trunk", "head", "arms", "legs", "timing"

class Strictness {
 public:
  static constexpr double kLargest = 10;

  Strictness() { factor_.fill(1); }
  // "arms=2,legs=0"; "all=1.5" sets every part. Errors: InvalidArgument, with what it may be.
  static Result<Strictness> parse(std::string_view text);

  double of(JudgedPart part) const { return factor_[static_cast<std::size_t>(part)]; }
  void set(JudgedPart part, double factor) { factor_[static_cast<std::size_t>(part)] = factor; }
  // One line for the golfer; empty where every part is judged as usual.
  std::string words() const;

 private:
  std::array<double, kJudgedParts.size()> factor_{};
};

}  // namespace posecoach
