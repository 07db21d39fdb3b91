// Names out of files and analyses as people say them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/coaching/analysis.h"

namespace posecoach {

// "left_elbow" -> "Left elbow", "mid_follow_through" -> "Mid follow-through", "tempo_ratio" -> "Tempo ratio".
std::string title_from_name(std::string_view name);

// What goes on at a frame: the title of an event at most `near` frames away, else the part of the stroke
// between two events ("Backswing"); empty when there are no events.
std::string phase_title(const std::vector<SwingEvent>& events, double frame, double near);

// The same for a frame of the student of an analysis, an event counting for 0.07 s on either side.
std::string student_phase(const Analysis& analysis, double frame);

// With `digits` after the point, whatever the locale.
std::string decimal(double value, int digits);

// The last part of a path; "bundled:swing" -> "the bundled swing".
std::string short_source(std::string_view source);

}  // namespace posecoach
