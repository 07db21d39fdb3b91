#include "ui/panels/common_panels.h"
#include "ui/screens/key_map.h"
#include "ui/screens/screens.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/sign.h"

namespace posecoach {
namespace {

constexpr double kRail = 84;

void use_common_keys(const PanelContext& context) {
  Ui& ui = context.ui;
  WindowState& state = context.state;
  if (context.pressed(Command::ShowKeys)) state.shows_keys = true;
  for (const auto& [command, screen] :
       {std::pair(Command::ShowLive, ScreenName::Live), std::pair(Command::ShowReview, ScreenName::Review),
        std::pair(Command::ShowLibrary, ScreenName::Library),
        std::pair(Command::ShowSetUp, ScreenName::SetUp)})
    if (context.pressed(command)) state.screen = screen;
  if (context.pressed(Command::FullScreen)) context.want(intent::ToggleFullScreen{});
  if (context.pressed(Command::Quit)) context.want(intent::Quit{});
  for (const std::string& path : ui.dropped_files()) context.want(intent::ImportFile{path});
}

void draw_screen(const PanelContext& context, const Rect& area) {
  // Each has its own: what Tab ringed on one is not ringed on another.
  const IdScope scope(context.ui, "screen " + std::to_string(static_cast<int>(context.state.screen)));
  switch (context.state.screen) {
    case ScreenName::Live:
      return draw_live_screen(context, area);
    case ScreenName::Review:
      return draw_review_screen(context, area);
    case ScreenName::Library:
      return draw_library_screen(context, area);
    case ScreenName::SetUp:
      return draw_set_up_screen(context, area);
  }
}

}  // namespace

void draw_starting(Ui& ui, const Rect& area) {
  const Theme& theme = ui.theme();
  ui.fill(area, theme.background);
  draw_sign(ui, area.centre() + Vec2(0, -44), 112);
  ui.text(TextStyle::Heading, area.centre() + Vec2(0, 48), "Virtual Pose Coach", theme.text, Align::Centre);
  ui.text(TextStyle::Body, area.centre() + Vec2(0, 76), "Starting", theme.quiet, Align::Centre);
}

void draw_window(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  WindowState& state = context.state;
  ui.fill(area, context.theme().background);
  use_common_keys(context);
  Rect rest = area;
  draw_rail(context, rest.take_left(kRail));
  draw_screen(context, rest);
  // Over the screen, below the dialogs.
  const Rect messages = state.screen == ScreenName::Live ? live_messages_area(context.model, rest) : rest;
  if (!context.model.toasts.empty() || !context.model.jobs.empty()) {
    ui.begin_overlay("messages", messages_area(context.model, messages));
    draw_messages(context, messages);
    ui.end_overlay();
  }
  const auto in_layer = [&](const char* name, PanelFunction draw) {
    ui.begin_layer(name, area);
    draw(context, area);
    ui.end_layer();
  };
  if (!context.model.leftovers.empty() && !state.hides_leftovers) in_layer("leftovers", draw_leftovers);
  if (ui.is_open("import")) in_layer("import dialog", draw_import_dialog);
  if (state.shows_keys) in_layer("key sheet", draw_key_sheet);
}

}  // namespace posecoach
