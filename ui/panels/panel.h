// A part of the window: draws itself into its area, changes where the user is, and says what he wants done.
// The same model and state give the same picture: no threads, files or devices here.
#pragma once

#include "ui/screens/window_model.h"
#include "ui/widgets/ui.h"

namespace posecoach {

struct PanelContext {
  Ui& ui;
  const WindowModel& model;
  WindowState& state;
  Intents& intents;

  const Theme& theme() const { return ui.theme(); }
  void want(Intent intent) const { intents.push_back(std::move(intent)); }
};

using PanelFunction = void (*)(const PanelContext& context, const Rect& area);

}  // namespace posecoach
