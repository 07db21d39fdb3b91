// Choosing a file: places at the left, the folder's films in the middle, a line for those who know the path.
#include <array>

#include "ui/panels/common_panels.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr double kRow = 38;

void choose(const PanelContext& context, const FolderEntry& entry) {
  if (entry.is_folder) {
    context.want(intent::ListFolder{entry.path});
    context.ui.focus_on("entry 0");
  } else {
    context.state.typed_import = entry.path;
  }
}

bool draw_entry(Ui& ui, std::string_view id, const Rect& row, const FolderEntry& entry, bool is_chosen,
                Interaction& on) {
  const Theme& theme = ui.theme();
  on = ui.region(id, row);
  if (is_chosen)
    ui.fill(row, chosen_paper(theme), radius::kSmall);
  else if (on.hovered)
    ui.fill(row, theme.raised, radius::kSmall);
  ui.focus_ring(row.inset(3), radius::kSmall, on);
  Rect line = row.inset(10, 0);
  draw_icon(ui, entry.is_folder ? Icon::Folder : Icon::Review, line.take_left(20, 10).centre(), 18,
            entry.is_folder ? theme.accent : theme.quiet);
  const double detail = entry.detail.empty() ? 0 : ui.text_width(TextStyle::Caption, entry.detail) + 2;
  if (detail > 0 && detail < 0.5 * line.width)
    ui.text_in(TextStyle::Caption, line.take_right(detail, 12), entry.detail, theme.quiet);
  ui.text_in(TextStyle::Body, line, entry.name, theme.text);
  if (on.hovered) ui.use_hand_pointer();
  return on.clicked;
}

void draw_places(const PanelContext& context, const Rect& area) {
  Rect rest = area;
  for (std::size_t i = 0; i < context.model.listing.places.size() && rest.height >= kRow; ++i) {
    const FolderEntry& place = context.model.listing.places[i];
    Interaction on;
    if (draw_entry(context.ui, "place " + std::to_string(i), rest.take_top(kRow, 2), place,
                   place.path == context.model.listing.path, on))
      choose(context, place);
  }
}

bool draw_entries(const PanelContext& context, Rect area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const FolderListing& listing = context.model.listing;
  Rect heading = area.take_top(36, 6);
  const Button up{.id = "up", .words = "Up", .icon = Icon::Restore, .is_enabled = !listing.parent.empty()};
  if (draw_button(ui, heading.take_left(button_width(ui, up), 12).inset(0, 1), up))
    context.want(intent::ListFolder{listing.parent});
  ui.text_in(TextStyle::Strong, heading, listing.path, theme.quiet);
  if (!listing.message.empty()) {
    draw_empty(ui, area, Icon::Warning, "This folder cannot be opened", listing.message);
    return false;
  }
  if (listing.path.empty()) return false;  // not listed yet
  if (listing.entries.empty()) {
    draw_empty(ui, area, Icon::Folder, "Nothing to import here",
               "There is no film or motion file in this folder.");
    return false;
  }
  const IdScope scope(ui, listing.path);  // each folder is scrolled by itself
  bool is_taken = false;
  const Rect content = ui.begin_scroll("files", area, static_cast<double>(listing.entries.size()) * kRow);
  for (std::size_t i = 0; i < listing.entries.size(); ++i) {
    const Rect row{content.x, content.y + static_cast<double>(i) * kRow, content.width, kRow};
    if (row.bottom() < area.y - kRow || row.y > area.bottom() + kRow) continue;
    const FolderEntry& entry = listing.entries[i];
    Interaction on;
    const bool is_chosen = context.state.typed_import == entry.path;
    if (!draw_entry(ui, "entry " + std::to_string(i), row, entry, is_chosen, on)) continue;
    choose(context, entry);
    // A second press, or a second Enter, takes it.
    is_taken = is_taken || (!entry.is_folder && (on.double_clicked || (on.focused && is_chosen)));
  }
  ui.end_scroll();
  return is_taken;
}

}  // namespace

void draw_import_dialog(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  WindowState& state = context.state;
  struct Words {
    std::string_view title, hint, verb;
  };
  static constexpr std::array<Words, 3> kWords = {
      {{"Import a swing", "A film or a motion file. You can also drop it on the window.", "Import"},
       {"Add a coach", "A motion file, a film or a picture.", "Add"},
       {"Practise with a film", "It plays in the camera's place.", "Use"}}};
  const Words& said = kWords[static_cast<std::size_t>(state.browse_for)];
  ui.fill(area, theme.scrim);
  const double width = std::min(860.0, area.width - 32), height = std::min(560.0, area.height - 32);
  const Rect card{area.centre().x - 0.5 * width, area.centre().y - 0.5 * height, width, height};
  ui.shadow(card, radius::kLarge, 24);
  Rect inner = draw_card(ui, card, 24);
  ui.text_in(TextStyle::Heading, inner.take_top(32, 4), said.title, theme.text);
  ui.text_in(TextStyle::Body, inner.take_top(22, 12), said.hint, theme.quiet);
  Rect row = inner.take_bottom(38, 14);
  const bool is_ready = !state.typed_import.empty();
  bool is_taken = draw_button(
      ui, row.take_right(110, 10),
      {.id = "import now", .words = said.verb, .look = ButtonLook::Primary, .is_enabled = is_ready});
  const bool is_left = draw_button(ui, row.take_right(100, 14), {.id = "import not", .words = "Cancel"}) ||
                       ui.take_key({Key::Escape});
  ui.text_field("import path", row, state.typed_import, "Or write where it is: /home/you/Videos/swing.mp4");
  is_taken = is_taken || ui.was_entered("import path");
  draw_places(context, inner.take_left(std::min(180.0, 0.28 * inner.width), 16));
  is_taken = draw_entries(context, inner) || is_taken;
  if (is_taken && !state.typed_import.empty()) {
    switch (state.browse_for) {
      case BrowseFor::Swing:
        context.want(intent::ImportFile{state.typed_import});
        break;
      case BrowseFor::Coach:
        context.want(intent::ChooseCoach{state.typed_import});
        break;
      case BrowseFor::Source:
        context.want(intent::ChooseSource{state.typed_import, {}});
    }
    state.typed_import.clear();
    ui.close_popup();
  }
  if (is_left) ui.close_popup();
}

void open_import_dialog(const PanelContext& context, BrowseFor what) {
  context.state.browse_for = what;
  context.state.typed_import.clear();
  context.want(intent::ListFolder{context.model.listing.path});
  context.ui.open("import");
  context.ui.focus_on("entry 0");
}

}  // namespace posecoach
