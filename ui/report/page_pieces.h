// Pieces that several sections of the report page are made of.
#pragma once

#include <string>
#include <string_view>

#include "ui/report/replay.h"

namespace posecoach::report {

// Empty where the body is.
std::string section(std::string_view id, std::string_view title, const std::string& body,
                    std::string_view lead = {});
// Shows the moment in the replay where the page can; nothing on paper.
std::string moment_button(const Replay& replay, int student_frame, int coach_frame);
std::string centimetres(double metres, int digits = 1);
std::string in_unit(double value, int digits, std::string_view unit);
// A table's cell that carries its column's name, for screens too narrow for columns.
std::string cell(std::string_view label, const std::string& content);
// "good", "fair" or "poor": the colour of a score.
std::string_view grade(double percent);

}  // namespace posecoach::report
