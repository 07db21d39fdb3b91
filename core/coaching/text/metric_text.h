// What is said about a metric: its name, its definition in one line, the range that good golfers are in, with
// its source, and why it cannot be given. All in one place, to be read and translated together.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/coaching/kinematic_sequence.h"
#include "core/coaching/viewpoint.h"

namespace posecoach::text {

struct UsualRange {
  double low = 0, high = 0;
};

struct MetricText {
  std::string_view name, title, unit, definition;
  std::optional<UsualRange> usual = {};
  std::string_view source = {};  // of the range
};

// Asserts that there is one of this name.
const MetricText& metric(std::string_view name);
// As it stands behind a number: "°", " cm", "".
std::string unit(std::string_view unit);

// Why a metric cannot be given.
std::string hidden_by_view(Viewpoint view);
std::string hidden_by_one_camera();
std::string not_from_this_side();
std::string implausible(double value, std::string_view unit);
std::string not_without(std::string_view other);
std::string too_few_frames(double frame_rate);
std::string joint_hidden();
std::string sequence_too_close(double frame_rate);
std::string head_is_still(double metres);

// What a metric says in words.
std::string sequence(const std::vector<Segment>& order);
std::string head_goes(bool is_with_the_hands);

}  // namespace posecoach::text
