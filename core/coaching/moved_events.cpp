#include "core/coaching/moved_events.h"

#include <algorithm>
#include <cmath>

namespace posecoach {
namespace {

// Between these two, both excluded, the events from `first` to `last` lie evenly.
void spread(std::vector<SwingEvent>& events, std::size_t first, std::size_t last, int before, int after) {
  const double step = static_cast<double>(after - before) / static_cast<double>(last - first + 2);
  for (std::size_t k = first; k <= last; ++k)
    events[k].frame = before + static_cast<int>(std::lround(step * static_cast<double>(k - first + 1)));
}

}  // namespace

std::optional<SwingEvents> with_moved(const SwingEvents& found, const std::vector<MovedEvent>& moved,
                                      const JointTrack& track) {
  SwingEvents swing = found;
  std::vector<SwingEvent>& events = swing.events;
  std::vector<std::size_t> put;  // places of the moved ones, rising
  for (std::size_t k = 0; k < events.size(); ++k)
    for (const MovedEvent& one : moved)
      if (one.name == events[k].name) {
        events[k].frame = std::clamp(one.frame, 0, track.frame_count() - 1);
        if (put.empty() || put.back() != k) put.push_back(k);
      }
  if (put.empty()) return swing;
  for (std::size_t i = 0; i <= put.size(); ++i) {
    const std::size_t first = i == 0 ? 0 : put[i - 1] + 1, end = i == put.size() ? events.size() : put[i];
    if (first == end) continue;
    const int before = i == 0 ? -1 : events[put[i - 1]].frame,
              after = i == put.size() ? track.frame_count() : events[put[i]].frame;
    const bool fits = events[first].frame > before && events[end - 1].frame < after;
    if (!fits) spread(events, first, end - 1, before, after);
  }
  for (std::size_t k = 0; k < events.size(); ++k) {
    if (k > 0 && events[k].frame <= events[k - 1].frame) return std::nullopt;
    if (events[k].frame < 0 || events[k].frame >= track.frame_count()) return std::nullopt;
    // What stayed where it was keeps its time between two frames.
    if (events[k].frame != found.events[k].frame) events[k].time_s = track.time(events[k].frame);
  }
  for (const std::size_t k : put) events[k].time_s = track.time(events[k].frame);
  for (std::size_t k = 1; k < events.size(); ++k)
    if (events[k].time_s <= events[k - 1].time_s) return std::nullopt;
  // The backswing begins between the first two positions.
  const double first_s = events.front().time_s,
               second_s = events[std::min<std::size_t>(1, events.size() - 1)].time_s;
  if (swing.takeaway_s < first_s || swing.takeaway_s > second_s)
    swing.takeaway_s = first_s + 0.25 * (second_s - first_s);
  return swing;
}

}  // namespace posecoach
