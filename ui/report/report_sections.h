// The parts of the report page, each an HTML fragment that stands on its own; empty where the analysis has
// nothing to say.
#pragma once

#include <span>
#include <string>

#include "core/coaching/analysis.h"
#include "ui/report/replay.h"
#include "ui/report/report_picture.h"

namespace posecoach::report {

std::string summary_section(const Analysis& analysis, const Replay& replay);
std::string pictures_section(const Analysis& analysis, std::span<const ReportPicture> pictures,
                             const Replay& replay, Palette palette);
std::string joints_section(const Analysis& analysis);
std::string timing_section(const Analysis& analysis, const Replay& replay);
std::string spatial_section(const Analysis& analysis, const Replay& replay);
std::string metrics_section(const Analysis& analysis);
std::string method_section(const Analysis& analysis);

}  // namespace posecoach::report
