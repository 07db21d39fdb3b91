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
  // Takes the command's key from this frame.
  bool pressed(Command command) const { return was_pressed(ui, model.keys, command); }
  // "Star (B)".
  std::string hint(std::string_view words, Command command) const {
    return with_key(model.keys, words, command);
  }
};

using PanelFunction = void (*)(const PanelContext& context, const Rect& area);

}  // namespace posecoach
