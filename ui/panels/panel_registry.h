// Every panel once, by name: tests draw each of them in every state.
#pragma once

#include <span>
#include <string_view>

#include "ui/panels/panel.h"

namespace posecoach {

struct RegisteredPanel {
  std::string_view name;
  double width = 0, height = 0;  // that it is made for, points
  PanelFunction draw = nullptr;
  bool lies_on_film = false;
};
std::span<const RegisteredPanel> registered_panels();

}  // namespace posecoach
