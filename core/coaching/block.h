// Several swings of one golfer together: one swing lies, a block tells the truth. Good golfers differ from
// others less in their means than in how little they spread (Cheetham 2008).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/coaching/analysis.h"

namespace posecoach {

struct Spread {
  int count = 0;
  double mean = 0;
  double deviation = 0;  // standard deviation between swings; 0 for a single one
};
Spread spread_of(std::span<const double> values);

struct MetricSpread {
  std::string name, unit;
  Spread spread;  // of the swings in which the metric was available
  std::optional<double> coach = {};
};

// One piece of advice and in how many of the swings it was given.
struct RepeatedAdvice {
  std::string fault, measure, event;  // as in Advice
  int swings = 0;
  std::string text;        // of the swing where it was clearest
  int clearest_swing = 0;  // index into the block
};

struct Block {
  int swings = 0;
  Spread percent;                      // score
  std::vector<MetricSpread> metrics;   // in the order of the sheet
  std::vector<RepeatedAdvice> advice;  // most often first, then clearest
  std::string words;                   // one line
};

// An empty block for no swings. Swings of different kinds (full swings and putts) share what both have.
Block make_block(std::span<const Analysis* const> swings);

}  // namespace posecoach
