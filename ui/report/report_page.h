// The analysis as one HTML page that needs nothing else: no network, no other file. Readable on a phone, on
// paper and in the dark.
#pragma once

#include <span>
#include <string>

#include "core/coaching/block.h"
#include "ui/report/comparison.h"
#include "ui/report/report_picture.h"

namespace posecoach {

// `pictures` stand for the analysis' worst frames, in its order; there may be none. `block`: the golfer's
// last swings, this one among them.
std::string make_report_page(const Comparison& comparison, std::span<const ReportPicture> pictures,
                             const Block& block = {});

}  // namespace posecoach
