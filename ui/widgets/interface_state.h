// What the interface remembers from frame to frame. Included by the .cpp files of ui/widgets only.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ui/theme/theme.h"
#include "ui/widgets/rect.h"

struct ImFont;

namespace posecoach {

struct InterfaceState {
  std::array<ImFont*, kTextStyleCount> fonts{};
  double scale = 0;  // that the fonts were made for

  // Keyboard focus: the places of the frame in the order of drawing; Tab walks along them, arrows across
  // them.
  struct Place {
    std::uint32_t id = 0;
    Rect rect;
  };
  std::uint32_t focused = 0;
  bool is_focus_shown = false;
  bool was_focus_moved = false;    // by the keyboard, in this frame: scroll there
  std::uint32_t next_focused = 0;  // by arrows, from the next frame on
  std::vector<Place> places, places_before;
  std::string wanted_place;         // to be ringed as soon as it is drawn
  std::uint32_t focused_below = 0;  // while a popup is open

  bool has_focused_place() const {
    if (!is_focus_shown) return false;
    for (const Place& place : places_before)
      if (place.id == focused) return true;
    return false;
  }
  int layer = 0, top_layer = 0, top_layer_before = 0;

  std::string open_popup;
  std::string wanted_field;   // to be written in from now on
  std::string entered_field;  // in which Enter was pressed in this frame
  std::string hovered_words;  // tooltip of the place under the pointer
  double hovered_since_s = 0;
};

}  // namespace posecoach
