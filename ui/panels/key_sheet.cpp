// All keys on one sheet, and the same sheet to change them.
#include <array>

#include "ui/panels/common_panels.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr double kLine = 22, kRow = 34;
constexpr Command kFirstPosition = Command::Position1, kLastPosition = Command::Position8;

bool is_position(Command command) {
  return command >= kFirstPosition && command <= kLastPosition;
}

bool are_positions_usual(const KeyMap& keys) {
  for (const KeyBinding& binding : key_bindings())
    if (is_position(binding.command) && keys.is_changed(binding.command)) return false;
  return true;
}

void draw_line(const PanelContext& context, Rect& column, std::string_view words, const std::string& keys,
               bool is_changed) {
  if (column.height < kLine) return;
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  Rect row = column.take_top(kLine);
  ui.text_in(TextStyle::Body, row.take_left(0.46 * row.width, 8), words, theme.text);
  ui.text_in(TextStyle::Body, row, keys, is_changed ? theme.accent : theme.quiet);
}

void draw_group(const PanelContext& context, Rect& column, KeyGroup group) {
  const KeyMap& keys = context.model.keys;
  const bool folds_positions = are_positions_usual(keys);
  context.ui.text_in(TextStyle::Strong, column.take_top(25), title_of(group), context.theme().accent);
  for (const KeyBinding& binding : key_bindings()) {
    if (binding.group != group) continue;
    if (folds_positions && is_position(binding.command)) {
      if (binding.command == kFirstPosition) draw_line(context, column, "To a position", "1 to 8", false);
      continue;
    }
    draw_line(context, column, binding.words, key_words(keys, binding.command),
              keys.is_changed(binding.command));
  }
  column.take_top(12);
}

void draw_reading(const PanelContext& context, const Rect& area) {
  constexpr std::array<std::array<std::optional<KeyGroup>, 3>, 3> kColumns = {
      {{KeyGroup::Everywhere, KeyGroup::Live, KeyGroup::Library}, {KeyGroup::Player}, {KeyGroup::Review}}};
  for (int c = 0; c < 3; ++c) {
    Rect column = area.column(c, 3, 30);
    for (const std::optional<KeyGroup>& group : kColumns[static_cast<std::size_t>(c)])
      if (group) draw_group(context, column, *group);
  }
}

void want_keys(const PanelContext& context, KeyMap keys) {
  context.state.key_choice.reset();
  context.want(intent::SetKeys{std::move(keys)});
}

// The next key is the chosen one, unless somebody has it already.
void take_chosen_key(const PanelContext& context) {
  std::optional<KeyChoice>& choice = context.state.key_choice;
  if (!choice || choice->wanted) return;
  const std::optional<KeyPress> press = context.ui.take_any_key();
  if (!press) return;
  if (press->key == Key::Escape) {
    choice.reset();
    return;
  }
  if (!KeyMap::is_free(*press)) return;
  if (context.model.keys.owner(*press, choice->command)) {
    choice->wanted = press;
    context.ui.focus_on("use it here");
    return;
  }
  KeyMap keys = context.model.keys;
  keys.set(choice->command, choice->place, *press);
  want_keys(context, std::move(keys));
}

void draw_key_box(const PanelContext& context, const Rect& box, const KeyBinding& binding,
                  std::size_t place) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  std::optional<KeyChoice>& choice = context.state.key_choice;
  const KeyPress& press = context.model.keys.chords(binding.command)[place];
  const bool is_waiting = choice && choice->command == binding.command && choice->place == place;
  const Interaction on =
      ui.region("key " + std::to_string(place), box, binding.is_fixed ? Focus::Never : Focus::ByKeyboard);
  const Colour paper = is_waiting ? chosen_paper(theme) : on.hovered ? theme.hovered : theme.raised;
  if (!binding.is_fixed) ui.fill(box, paper, radius::kSmall);
  if (is_waiting) ui.outline(box, theme.accent, radius::kSmall, 1.5);
  ui.focus_ring(box, radius::kSmall, on);
  const std::string words = is_waiting               ? "Press a key"
                            : press.key == Key::None ? (place == 0 ? "none" : "+")
                                                     : to_words(press);
  ui.text_in(TextStyle::Body, box.inset(6, 0), words, press.key == Key::None ? theme.faint : theme.text,
             Align::Centre);
  if (binding.is_fixed) return;
  if (on.hovered) ui.use_hand_pointer();
  if (on.clicked) choice = KeyChoice{binding.command, place, {}};
}

void draw_change_row(const PanelContext& context, const Rect& area, const KeyBinding& binding) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const IdScope scope(ui, binding.name);
  Rect row = area.inset(0, 3);
  const Rect back = row.take_right(30, 6);
  if (context.model.keys.is_changed(binding.command) &&
      draw_button(ui, back,
                  {.id = "back", .icon = Icon::Undo, .look = ButtonLook::Quiet, .hint = "As it was"})) {
    KeyMap keys = context.model.keys;
    keys.reset(binding.command);
    want_keys(context, std::move(keys));
  }
  const double wide = std::min(104.0, 0.27 * row.width);
  const Rect second = row.take_right(wide, 6), first = row.take_right(wide, 10);
  ui.text_in(TextStyle::Body, row, binding.words, theme.text);
  draw_key_box(context, first, binding, 0);
  if (!binding.is_fixed) draw_key_box(context, second, binding, 1);
}

void draw_changing(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  // Both columns as long as each other.
  const auto bindings = key_bindings();
  constexpr std::array kGroups = {KeyGroup::Everywhere, KeyGroup::Live, KeyGroup::Library, KeyGroup::Player,
                                  KeyGroup::Review};
  constexpr double kTitle = 30;
  double total = 0;
  for (const KeyGroup group : kGroups) {
    total += kTitle;
    for (const KeyBinding& binding : bindings) total += binding.group == group ? kRow : 0;
  }
  const double tall = 0.5 * total + 4 * kRow;
  const Rect content = ui.begin_scroll("keys", area, tall);
  int column = 0;
  double y = content.y;
  for (const KeyGroup group : kGroups) {
    const auto next = [&](double height) {
      if (column == 0 && y + height > content.y + 0.5 * total + kRow) {
        column = 1;
        y = content.y;
      }
      const Rect whole = content.inset(4, 0).column(column, 2, 36);
      const Rect row{whole.x, y, whole.width, height};
      y += height;
      return row;
    };
    ui.text_in(TextStyle::Strong, next(kTitle), title_of(group), context.theme().accent);
    for (const KeyBinding& binding : bindings)
      if (binding.group == group) draw_change_row(context, next(kRow), binding);
  }
  ui.end_scroll();
}

// What is going on, and the buttons that fit it.
void draw_foot(const PanelContext& context, Rect row) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  WindowState& state = context.state;
  if (!state.is_changing_keys) {
    const Button change{.id = "change keys", .words = "Change keys", .icon = Icon::Keyboard};
    if (draw_button(ui, row.take_right(button_width(ui, change), 16), change)) state.is_changing_keys = true;
    return ui.text_in(
        TextStyle::Caption, row,
        "Tab and arrows walk from place to place, Enter presses. While you write, keys go into the "
        "text; Esc ends that.",
        theme.quiet);
  }
  const Button done{.id = "done", .words = "Done", .look = ButtonLook::Primary};
  if (draw_button(ui, row.take_right(90, 8), done)) {
    state.is_changing_keys = false;
    state.key_choice.reset();
  }
  if (!state.key_choice) {
    const Button reset{.id = "reset keys",
                       .words = "Reset to defaults",
                       .icon = Icon::Undo,
                       .is_enabled = context.model.keys.is_changed()};
    if (draw_button(ui, row.take_right(button_width(ui, reset), 16), reset)) want_keys(context, KeyMap());
    return ui.text_in(TextStyle::Body, row, "Choose the key that you want to change.", theme.quiet);
  }
  const KeyChoice choice = *state.key_choice;
  const std::string what(binding_of(choice.command).words);
  if (!choice.wanted) {
    const Button none{.id = "no key", .words = "No key"};
    if (draw_button(ui, row.take_right(button_width(ui, none), 16), none)) {
      KeyMap keys = context.model.keys;
      keys.set(choice.command, choice.place, KeyPress());
      return want_keys(context, std::move(keys));
    }
    return ui.text_in(TextStyle::Strong, row, "Press the key for \"" + what + "\". Esc leaves it as it is.",
                      theme.text);
  }
  const Button keep{.id = "leave it", .words = "Leave it"};
  if (draw_button(ui, row.take_right(button_width(ui, keep), 8), keep)) state.key_choice.reset();
  const Button use{.id = "use it here", .words = "Use it here", .look = ButtonLook::Primary};
  if (draw_button(ui, row.take_right(button_width(ui, use), 16), use)) {
    KeyMap keys = context.model.keys;
    keys.set(choice.command, choice.place, *choice.wanted);
    return want_keys(context, std::move(keys));
  }
  const std::optional<Command> owner = context.model.keys.owner(*choice.wanted, choice.command);
  draw_icon(ui, Icon::Warning, row.take_left(22, 8).centre(), 20, theme.warning);
  ui.text_in(TextStyle::Strong, row,
             to_words(*choice.wanted) + " is \"" + std::string(owner ? binding_of(*owner).words : "") +
                 "\" already.",
             theme.text);
}

void close(WindowState& state) {
  state.shows_keys = state.is_changing_keys = false;
  state.key_choice.reset();
}

}  // namespace

void draw_key_sheet(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  WindowState& state = context.state;
  take_chosen_key(context);
  if (context.pressed(Command::Back) || context.pressed(Command::ShowKeys)) {
    if (state.key_choice)
      state.key_choice.reset();
    else
      close(state);
  }
  ui.fill(area, theme.scrim);
  const double width = std::min(1120.0, area.width - 24), height = std::min(692.0, area.height - 20);
  const Rect card{area.centre().x - 0.5 * width, area.centre().y - 0.5 * height, width, height};
  ui.shadow(card, radius::kLarge, 24);
  Rect inner = draw_card(ui, card, 22);
  Rect heading = inner.take_top(34, 8);
  if (draw_button(
          ui, heading.take_right(36),
          {.id = "close keys", .icon = Icon::Cross, .look = ButtonLook::Quiet, .hint = "Close (Esc)"}))
    close(state);
  ui.text_in(TextStyle::Heading, heading, state.is_changing_keys ? "Change keys" : "Keys", theme.text);
  const Rect foot = inner.take_bottom(38, 10);
  if (state.is_changing_keys)
    draw_changing(context, inner);
  else
    draw_reading(context, inner);
  draw_foot(context, foot);
}

}  // namespace posecoach
