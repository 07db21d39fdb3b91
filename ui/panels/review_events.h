// The named positions on the student's row of the timeline, which can be put in their place by hand.
#pragma once

#include <functional>

#include "ui/panels/panel.h"

namespace posecoach {

// Of the timeline: from a picture to its place on the row and back.
struct EventRow {
  double y = 0;
  std::function<double(int picture)> x_of;
  std::function<int(double x)> picture_at;
};
void draw_event_handles(const PanelContext& context, const EventRow& row);

bool is_moved_by_hand(const OpenedSwing& swing, std::size_t event);
// The keys that move the position which is shown, a picture at a time.
void use_event_keys(const PanelContext& context);
// All of them back to where they were found.
void put_events_back(const PanelContext& context);

}  // namespace posecoach
