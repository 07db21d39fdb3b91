// What the interface remembers from frame to frame. Included by the .cpp files of ui/widgets only.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ui/theme/theme.h"

struct ImFont;

namespace posecoach {

struct InterfaceState {
  std::array<ImFont*, kTextStyleCount> fonts{};
  double scale = 0;  // that the fonts were made for

  // Keyboard focus: the places of the frame in the order of drawing; Tab walks along them.
  std::uint32_t focused = 0;
  bool is_focus_shown = false;
  bool was_focus_moved = false;  // by the keyboard, in this frame: scroll there
  std::vector<std::uint32_t> places, places_before;
  int layer = 0, top_layer = 0, top_layer_before = 0;

  std::string open_popup;
  std::string wanted_field;   // to be written in from now on
  std::string hovered_words;  // tooltip of the place under the pointer
  double hovered_since_s = 0;
};

}  // namespace posecoach
