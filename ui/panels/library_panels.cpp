#include "ui/panels/library_panels.h"

#include <array>
#include <cmath>

#include "ui/panels/common_panels.h"
#include "ui/render/words.h"
#include "ui/screens/key_map.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

enum Filter { All, Starred, Trash };

std::string lower(std::string_view words) {
  std::string result(words);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

bool has_all_words(const SwingCard& card, std::string_view search) {
  const std::string text = lower(card.title + " " + card.when + " " + card.date + " " + card.person + " " +
                                 card.coach + " " + card.stroke + " " + card.notes);
  std::string word;
  for (const char c : lower(search) + " ") {
    if (c != ' ') {
      word += c;
      continue;
    }
    if (!word.empty() && text.find(word) == std::string::npos) return false;
    word.clear();
  }
  return true;
}

void choose(const PanelContext& context, const SwingCard& card) {
  context.state.selected = card.id;
}

void open(const PanelContext& context, const SwingCard& card) {
  if (!card.unreadable.empty()) return;
  if (context.state.is_picking_second)
    context.want(intent::CompareWith{card.id});
  else
    context.want(intent::OpenSwing{card.id});
}

void draw_thumbnail(Ui& ui, const SwingCard& card, const Rect& area) {
  const Theme& theme = ui.theme();
  ui.fill(area, theme.background, radius::kMedium);
  if (card.thumbnail && !card.thumbnail->empty()) {
    const Rect place = fitted(card.thumbnail->width, card.thumbnail->height, area);
    const bool is_whole = place.width > area.width - 1 && place.height > area.height - 1;
    ui.texture(ui.views().picture(card.thumbnail), place, is_whole ? radius::kMedium : 0);
  } else {
    draw_icon(ui, card.unreadable.empty() ? Icon::Review : Icon::Warning, area.centre(), 34, theme.faint);
  }
}

std::string card_line(const SwingCard& card) {
  std::string line = card.when;
  if (!card.person.empty()) line += " · " + card.person;
  return line;
}

void draw_swing_card(const PanelContext& context, const Rect& area, const SwingCard& card) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const IdScope scope(ui, card.id);
  const bool is_chosen = context.state.selected == card.id;
  const Interaction on = ui.region("card", area);
  ui.fill(area, on.hovered ? theme.raised : theme.surface, radius::kLarge);
  ui.outline(area, is_chosen ? theme.accent : theme.line, radius::kLarge, is_chosen ? 2.5 : 1);
  ui.focus_ring(area, radius::kLarge, on);
  Rect inner = area.inset(8);
  const Rect picture = inner.take_top(inner.width * 9 / 16, 8);
  draw_thumbnail(ui, card, picture);
  if (card.score_percent) {
    const Vec2 at(picture.right() - 24, picture.y + 24);
    ui.disc(at, 21, colour_from_hex(0x0C1016).with_alpha(0.82F));
    const ThemeScope film(ui, film_theme(theme));
    draw_score_ring(ui, at, 18, *card.score_percent, TextStyle::Strong);
  }
  if (card.is_starred) {
    ui.disc({picture.x + 18, picture.y + 18}, 14, colour_from_hex(0x0C1016).with_alpha(0.82F));
    draw_icon(ui, Icon::StarFilled, {picture.x + 18, picture.y + 18}, 18, colour_from_hex(0xFFC247));
  }
  Rect words = inner.inset(4, 0);
  ui.text_in(TextStyle::Strong, words.take_top(20), card.title, theme.text);
  ui.text_in(TextStyle::Caption, words.take_top(18), card_line(card), theme.quiet);
  if (on.hovered) ui.use_hand_pointer();
  if (on.clicked) choose(context, card);
  if (on.double_clicked || (on.clicked && on.focused) || (on.clicked && context.state.is_picking_second))
    open(context, card);
}

void draw_no_swings(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  draw_empty(ui, area, Icon::Library, "No swings yet",
             "Start hands-free on the Live screen and swing, or drop a film of a swing here.");
  constexpr double kHigh = 38, kGap = 10;
  const Button live{
      .id = "to live", .words = "Practise live", .icon = Icon::Live, .look = ButtonLook::Primary},
      film{.id = "import first", .words = "Import a film", .icon = Icon::Import};
  const double first = button_width(ui, live), second = button_width(ui, film);
  const double x = area.centre().x - 0.5 * (first + kGap + second), y = area.centre().y + 100;
  if (draw_button(ui, {x, y, first, kHigh}, live)) context.state.screen = ScreenName::Live;
  if (draw_button(ui, {x + first + kGap, y, second, kHigh}, film))
    open_import_dialog(context, BrowseFor::Swing);
}

}  // namespace

std::vector<const SwingCard*> shown_swings(const WindowModel& model, const WindowState& state) {
  std::vector<const SwingCard*> shown;
  for (const SwingCard& card : model.swings) {
    const bool passes = state.filter == Trash
                            ? card.is_trashed
                            : !card.is_trashed && (state.filter != Starred || card.is_starred);
    if (passes && has_all_words(card, state.search)) shown.push_back(&card);
  }
  return shown;
}

const SwingCard* chosen_swing(const WindowModel& model, const WindowState& state) {
  for (const SwingCard& card : model.swings)
    if (card.id == state.selected) return &card;
  return nullptr;
}

void draw_library_bar(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  WindowState& state = context.state;
  Rect row = area;
  const double title = ui.text_width(TextStyle::Heading, "Library") + 24;
  ui.text_in(TextStyle::Heading, row.take_left(title), "Library", context.theme().text);
  constexpr std::array<std::string_view, 3> kFilters = {"All", "Starred", "Trash"};
  state.filter = draw_segments(ui, "filter", row.take_left(250, 16).inset(0, 1), kFilters, state.filter);
  const Button import{.id = "import",
                      .words = "Import",
                      .icon = Icon::Import,
                      .hint = "A film of a swing; or drop it on the window"};
  if (draw_button(ui, row.take_right(button_width(ui, import), 10), import))
    open_import_dialog(context, BrowseFor::Swing);
  Rect search = row.take_right(std::min(300.0, row.width));
  ui.text_field("search", search, state.search, "Search: name, date, note");
}

void draw_swing_cards(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const auto shown = shown_swings(context.model, context.state);
  if (!context.model.library_message.empty())
    return draw_empty(ui, area, Icon::Warning, "The library cannot be opened", context.model.library_message);
  if (shown.empty()) {
    if (!context.state.search.empty())
      return draw_empty(ui, area, Icon::Search, "Nothing found", "No swing has all of these words.");
    if (context.state.filter == Trash)
      return draw_empty(ui, area, Icon::Trash, "The trash is empty",
                        "Swings that you delete wait here and can be put back.");
    if (context.state.filter == Starred)
      return draw_empty(ui, area, Icon::Star, "No starred swings",
                        "Star the swings that you want to find again.");
    return draw_no_swings(context, area);
  }
  const int columns = std::max(1, static_cast<int>(area.width / 224));
  constexpr double kGap = 14;
  const double width = (area.width - 14 - kGap * (columns - 1)) / columns,
               height = (width - 16) * 9 / 16 + 64;
  const int rows = (static_cast<int>(shown.size()) + columns - 1) / columns;
  const Rect content = ui.begin_scroll("cards", area, rows * (height + kGap));
  for (int i = 0; i < static_cast<int>(shown.size()); ++i) {
    const Rect card{content.x + (width + kGap) * (i % columns),
                    content.y + (height + kGap) * (i / columns) + 3, width, height};
    // Far off cards cost nothing; those next to the edge stay reachable by the keyboard.
    if (card.bottom() < area.y - height || card.y > area.bottom() + height) continue;
    draw_swing_card(context, card, *shown[static_cast<std::size_t>(i)]);
  }
  ui.end_scroll();
}

void draw_swing_details(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  WindowState& state = context.state;
  Rect inner = draw_card(ui, area);
  const SwingCard* const card = chosen_swing(context.model, state);
  if (card == nullptr)
    return draw_empty(ui, inner, Icon::Review, "Choose a swing",
                      "Its notes and what can be done with it appear here.");
  ui.paragraph(TextStyle::Title, inner.take_top(24), card->title, theme.text, 1);
  ui.text_in(TextStyle::Caption, inner.take_top(18, 8), card_line(*card), theme.quiet);
  if (!card->unreadable.empty()) {
    const double height = ui.paragraph_height(TextStyle::Body, inner.width, card->unreadable, 6);
    draw_icon(ui, Icon::Warning, inner.take_top(30, 4).centre(), 26, theme.warning);
    ui.paragraph(TextStyle::Body, inner.take_top(height, 12), card->unreadable, theme.text, 6);
  } else {
    const auto fact = [&](std::string_view name, const std::string& value) {
      if (value.empty()) return;
      Rect line = inner.take_top(22);
      ui.text_in(TextStyle::Body, line.take_left(70), name, theme.quiet);
      ui.text_in(TextStyle::Body, line, value, theme.text);
    };
    fact("Stroke", card->stroke);
    fact("Coach", card->coach);
    if (card->score_percent) fact("Match", decimal(std::round(*card->score_percent), 0) + " of 100");
    if (card->seconds > 0) fact("Film", decimal(card->seconds, 1) + " s");
    inner.take_top(8);
  }
  if (card->is_trashed) {
    if (draw_button(
            ui, inner.take_top(38, 8),
            {.id = "restore", .words = "Put back", .icon = Icon::Restore, .look = ButtonLook::Primary}))
      context.want(intent::RestoreSwing{card->id});
    return;
  }
  if (card->unreadable.empty()) {
    const bool is_picking = state.is_picking_second;
    const bool is_itself = context.model.opened && context.model.opened->id == card->id;
    if (draw_button(ui, inner.take_top(38, 8),
                    {.id = "open",
                     .words = is_picking ? "Compare with this one" : "Review",
                     .icon = is_picking ? Icon::SideBySide : Icon::Review,
                     .look = ButtonLook::Primary,
                     .hint = is_picking ? "Both are played together (Enter)" : "Look at it closely (Enter)",
                     .is_enabled = !is_picking || !is_itself}))
      open(context, *card);
    Rect pair = inner.take_top(36, 8);
    if (draw_button(ui, pair.column(0, 2, 8),
                    {.id = "compare",
                     .words = "Compare",
                     .icon = Icon::SideBySide,
                     .hint = is_itself              ? "This one is open in Review: choose another to compare"
                             : context.model.opened ? "Beside the one that is open in Review"
                                                    : "Open another swing first; then this one beside it",
                     .is_enabled = context.model.opened.has_value() && !is_itself && !is_picking}))
      context.want(intent::CompareWith{card->id});
    const std::string star_hint = context.hint("Found again under Starred", Command::ToggleStar);
    if (draw_button(ui, pair.column(1, 2, 8),
                    {.id = "star",
                     .words = card->is_starred ? "Starred" : "Star",
                     .icon = card->is_starred ? Icon::StarFilled : Icon::Star,
                     .hint = star_hint,
                     .is_on = card->is_starred}))
      context.want(intent::SetStar{card->id, !card->is_starred});
    pair = inner.take_top(36, 8);
    if (draw_button(ui, pair.column(0, 2, 8),
                    {.id = "coach",
                     .words = "Make coach",
                     .icon = Icon::Coach,
                     .hint = "Compare later swings with this one"}))
      context.want(intent::MakeReference{card->id});
    draw_export_menu(context, pair.column(1, 2, 8), card->id);
  }
  if (state.notes_of != card->id) {
    state.notes_of = card->id;
    state.notes = card->notes;
  }
  constexpr double kTrash = 36, kNotes = 200;
  if (inner.height >= 60 + kTrash + 12) {
    ui.text_in(TextStyle::Strong, inner.take_top(22, 4), "Notes", theme.text);
    const IdScope scope(ui, card->id);
    const Rect field = inner.take_top(std::min(kNotes, inner.height - kTrash - 10), 10);
    if (ui.text_field("notes", field, state.notes, "What you felt, what you tried", 8))
      context.want(intent::SetNotes{card->id, state.notes});
  }
  const std::string hint = context.hint("It can be put back", Command::MoveToTrash);
  if (draw_button(ui, inner.take_top(kTrash),
                  {.id = "trash",
                   .words = "Move to trash",
                   .icon = Icon::Trash,
                   .look = ButtonLook::Quiet,
                   .hint = hint}))
    context.want(intent::TrashSwing{card->id});
}

}  // namespace posecoach
