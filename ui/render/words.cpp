#include "ui/render/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace posecoach {
namespace {

bool is_past(const std::vector<SwingEvent>& events, std::string_view name, double frame) {
  for (const SwingEvent& event : events)
    if (event.name == name) return frame >= event.frame;
  return false;
}

}  // namespace

std::string title_from_name(std::string_view name) {
  std::string title(name);
  for (char& c : title)
    if (c == '_') c = ' ';
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z')
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
  for (const auto& [from, to] :
       {std::pair<std::string_view, std::string_view>{"ollow through", "ollow-through"}, {"oe up", "oe-up"}})
    if (const std::size_t at = title.find(from); at != std::string::npos) title.replace(at, from.size(), to);
  return title;
}

std::string phase_title(const std::vector<SwingEvent>& events, double frame, double near) {
  if (events.empty()) return {};
  const auto distance = [&](const SwingEvent& event) { return std::abs(event.frame - frame); };
  const SwingEvent& nearest = *std::min_element(
      events.begin(), events.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (distance(nearest) <= near) return title_from_name(nearest.name);
  if (frame < events.front().frame) return "Before the swing";
  if (frame > events.back().frame) return "After the swing";
  if (is_past(events, "impact", frame)) return "Follow-through";
  if (is_past(events, "top", frame)) return "Downswing";
  return "Backswing";
}

std::string student_phase(const Analysis& analysis, double frame) {
  constexpr double kNear_s = 0.07;
  const double seconds = analysis.student.seconds;
  const double near = seconds > 0 ? std::max(0.5, kNear_s * analysis.student.frames / seconds) : 2;
  return phase_title(analysis.student_events, frame, near);
}

std::string decimal(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  std::array<char, 64> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
  if (error != std::errc()) return "–";
  std::string result(text.data(), end);
  if (result.find_first_not_of("-0.") == std::string::npos && result[0] == '-') result.erase(0, 1);
  return result;
}

std::string short_source(std::string_view source) {
  constexpr std::string_view kBundled = "bundled:";
  if (source.starts_with(kBundled)) return "the bundled " + std::string(source.substr(kBundled.size()));
  while (source.size() > 1 && source.back() == '/') source.remove_suffix(1);
  const std::size_t slash = source.rfind('/');
  return std::string(
      slash == std::string_view::npos || slash + 1 == source.size() ? source : source.substr(slash + 1));
}

}  // namespace posecoach
