// Faults that golfers know by name, each with an amount in a natural unit. A fault changes a script smoothly,
// over the part of the swing where it happens; with amount 0 it changes nothing.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/motion/authored/golf_script.h"

namespace posecoach {

struct GolfFault {
  std::string_view name;
  std::string_view motion;  // "swing" or "putt"
  std::string_view unit;    // "cm" (for a stature of 1.80 m), "deg" or "%"
  double default_amount;
  double largest_amount;
  std::string_view meaning;  // what the amount measures
};

std::span<const GolfFault> golf_faults();
// One line a fault: name, motion, unit, default, meaning.
std::string golf_fault_table();

struct FaultChoice {
  const GolfFault* fault = nullptr;  // never null
  double amount = 0;
};

// Errors: InvalidArgument, listing the known names, or telling the range of the amount.
Result<FaultChoice> choose_fault(std::string_view name, std::optional<double> amount = {});
// "sway" or "sway=8".
Result<FaultChoice> fault_from_string(std::string_view text);

// Errors: InvalidArgument for a fault of the other motion.
Result<void> apply_fault(GolfScript& script, const FaultChoice& choice);

}  // namespace posecoach
