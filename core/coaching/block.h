// Several swings of one golfer together: one swing lies, a block tells the truth. Good golfers differ from
// others less in their means than in how little they spread (Cheetham 2008).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/coaching/analysis.h"

namespace posecoach {

// What a block needs of each of its swings.
struct BlockSwing {
  std::string stroke;  // "full swing", "putt"
  double percent = 0;  // score
  std::vector<Metric> metrics;
  std::vector<Advice> advice;
};
BlockSwing block_swing_from(const Analysis& analysis);
// From a "posecoach.analysis/1" text as the library keeps it. Errors: Malformed.
Result<BlockSwing> block_swing_from_json(std::string_view text);

struct Spread {
  int count = 0;
  double mean = 0;
  double deviation = 0;  // standard deviation between swings; 0 for a single one
};
Spread spread_of(std::span<const double> values);

struct MetricSpread {
  std::string name, title, unit;
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
Block make_block(std::span<const BlockSwing> swings);
// {"schema": "posecoach.block/1", ...}; docs/FORMATS.md.
std::string to_json(const Block& block);

}  // namespace posecoach
