// The parts of the report page, each an HTML fragment that stands on its own; empty where the analysis has
// nothing to say.
#pragma once

#include <span>
#include <string>

#include "core/coaching/analysis.h"
#include "core/coaching/block.h"
#include "ui/report/replay.h"
#include "ui/report/report_picture.h"

namespace posecoach::report {

std::string summary_section(const Analysis& analysis, const Replay& replay);
std::string pictures_section(const Analysis& analysis, std::span<const ReportPicture> pictures,
                             const Replay& replay, Palette palette);
// The score of each part of the body and of the stroke.
std::string parts_section(const Analysis& analysis);
// Pair by pair, both bodies drawn over each other with the joints marked that differ most.
std::string poses_section(const Analysis& analysis, const Replay& replay);
// Several swings of one golfer; empty for fewer than two.
std::string block_section(const Block& block);
std::string joints_section(const Analysis& analysis);
std::string timing_section(const Analysis& analysis, const Replay& replay);
std::string spatial_section(const Analysis& analysis, const Replay& replay);
std::string metrics_section(const Analysis& analysis);
std::string method_section(const Analysis& analysis);

}  // namespace posecoach::report
