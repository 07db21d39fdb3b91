// The alignment as a picture: a row of the student, a row of the coach, and lines between the moments that
// answer each other; below, how far apart they are and who is faster. SVG for the report page.
#pragma once

#include <string>

#include "core/coaching/analysis.h"
#include "ui/report/replay.h"

namespace posecoach::report {

// Where the two time lines lie in the drawing, which is 1000 wide; the page's script moves its marks along
// them.
struct TimelineAxis {
  double left = 64, right = 984;
  double student_y = 0, coach_y = 0;
  double student_begin_s = 0, student_end_s = 1, coach_begin_s = 0, coach_end_s = 1;

  double student_x(double seconds) const;
  double coach_x(double seconds) const;
};

TimelineAxis timeline_axis(const Replay& replay);

// Empty for a replay without steps.
std::string timeline_figure(const Analysis& analysis, const Replay& replay);

}  // namespace posecoach::report
