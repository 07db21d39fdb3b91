#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/widgets/imgui_values.h"
#include "ui/widgets/interface_state.h"
#include "ui/widgets/ui.h"

namespace posecoach {
namespace {

constexpr ImGuiWindowFlags kPlainWindow = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse;
constexpr double kTooltipAfter_s = 0.5;

void begin_window(const char* name, const Rect& area, ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos(top_left(area));
  ImGui::SetNextWindowSize(im(area.size()));
  ImGui::Begin(name, nullptr, kPlainWindow | flags);
}

// Tab walks through the places of the last frame.
void move_focus(InterfaceState& state, bool backwards) {
  const auto& places = state.places_before;
  state.is_focus_shown = true;
  state.was_focus_moved = true;
  if (places.empty()) return;
  const auto found = std::find_if(places.begin(), places.end(),
                                  [&](const auto& place) { return place.id == state.focused; });
  if (found == places.end())
    state.focused = backwards ? places.back().id : places.front().id;
  else if (backwards)
    state.focused = found == places.begin() ? places.back().id : (found - 1)->id;
  else
    state.focused = found + 1 == places.end() ? places.front().id : (found + 1)->id;
}

// The nearest place in this direction; what lies aside counts as further away.
std::uint32_t place_towards(const std::vector<InterfaceState::Place>& places, const Rect& from,
                            const Vec2& direction) {
  constexpr double kAside = 2.5;
  std::uint32_t best = 0;
  double nearest = 1e18;
  for (const InterfaceState::Place& place : places) {
    const bool is_across = direction.x != 0;
    const double gap = is_across
                           ? (direction.x > 0 ? place.rect.x - from.right() : from.x - place.rect.right())
                           : (direction.y > 0 ? place.rect.y - from.bottom() : from.y - place.rect.bottom());
    if (gap < -2) continue;
    const double aside = is_across
                             ? std::max({0.0, place.rect.y - from.bottom(), from.y - place.rect.bottom()})
                             : std::max({0.0, place.rect.x - from.right(), from.x - place.rect.right()});
    const Vec2 apart = place.rect.centre() - from.centre();
    const double middles = std::abs(is_across ? apart.y : apart.x);
    const double distance = gap + kAside * aside + 0.1 * middles;
    if (distance >= nearest) continue;
    nearest = distance;
    best = place.id;
  }
  return best;
}

}  // namespace

Ui::Ui(InterfaceState& state, const Theme& theme, SceneViews& views, FrameInput input)
    : state_(state), theme_(&theme), views_(views), input_(std::move(input)) {
  state_.layer = 0;
  state_.top_layer = 0;
  state_.was_focus_moved = false;
  state_.entered_field.clear();
  if (state_.next_focused != 0) {
    state_.focused = std::exchange(state_.next_focused, 0);
    state_.is_focus_shown = state_.was_focus_moved = true;
  }
  // A text field is left by Esc and Tab.
  if (is_writing() && take({Key::Escape}, Repeats::Ignored)) ImGui::ClearActiveID();
  for (const bool backwards : {false, true})
    while (take({Key::Tab, backwards}, Repeats::Count)) {
      if (is_writing()) ImGui::ClearActiveID();
      move_focus(state_, backwards);
    }
  if (ImGui::IsMouseClicked(0)) state_.is_focus_shown = false;
  begin_window("window", whole(), ImGuiWindowFlags_NoBringToFrontOnFocus);
}

Vec2 Ui::mouse() const {
  const ImVec2& at = ImGui::GetIO().MousePos;
  return {static_cast<double>(at.x), static_cast<double>(at.y)};
}

Vec2 Ui::mouse_moved() const {
  const ImVec2& by = ImGui::GetIO().MouseDelta;
  return {static_cast<double>(by.x), static_cast<double>(by.y)};
}

bool Ui::is_writing() const {
  return ImGui::GetIO().WantTextInput;
}

Interaction Ui::region(std::string_view id, const Rect& rect, Focus focus) {
  Interaction result;
  const ImGuiIO& io = ImGui::GetIO();
  result.mouse = {static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y)};
  if (rect.is_empty()) return result;
  ImGui::SetCursorScreenPos(top_left(rect));
  result.clicked = ImGui::InvisibleButton(std::string(id).c_str(), im(rect.size()));
  const ImGuiID item = ImGui::GetItemID();
  ImGui::SetItemAllowOverlap();
  result.hovered = ImGui::IsItemHovered();
  result.held = ImGui::IsItemActive();
  result.pressed = ImGui::IsItemActivated();
  result.released = ImGui::IsItemDeactivated();
  result.double_clicked = result.hovered && ImGui::IsMouseDoubleClicked(0);
  if (result.held) result.drag = {static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y)};
  if (result.hovered) result.wheel = static_cast<double>(io.MouseWheel);
  if (focus == Focus::Never || state_.layer < state_.top_layer_before) return result;
  state_.places.push_back({item, rect});
  if (result.held) state_.focused = item;
  if (!state_.wanted_place.empty() && state_.wanted_place == id) {
    state_.wanted_place.clear();
    state_.focused = item;
    state_.is_focus_shown = state_.was_focus_moved = true;
  }
  result.focused = state_.is_focus_shown && state_.focused == item;
  if (result.focused && state_.was_focus_moved) ImGui::SetScrollHereY(0.5F);
  if (result.focused && !is_writing() && take({Key::Enter}, Repeats::Ignored)) result.clicked = true;
  return result;
}

bool Ui::text_field(std::string_view id, const Rect& rect, std::string& words, std::string_view hint,
                    int lines) {
  const Theme& look = theme();
  const std::string name = "##" + std::string(id);  // no label
  const ImGuiID item = ImGui::GetID(name.c_str());
  const bool is_reachable = state_.layer >= state_.top_layer_before;
  if (is_reachable) state_.places.push_back({item, rect});
  const bool is_focused = is_reachable && state_.is_focus_shown && state_.focused == item;
  fill(rect, look.raised, radius::kSmall);
  const bool is_asked_for = is_reachable && state_.wanted_field == id;
  if (is_asked_for) state_.wanted_field.clear();
  const bool is_entered = is_focused && !is_writing() && take({Key::Enter}, Repeats::Ignored);
  if ((is_focused && state_.was_focus_moved) || is_entered || is_asked_for) ImGui::SetKeyboardFocusHere();
  const double pad_y =
      lines > 1 ? space::kSmall : 0.5 * (rect.height - static_cast<double>(ImGui::GetFontSize()));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, im(Vec2(space::kMedium, pad_y)));
  ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
  ImGui::PushStyleColor(ImGuiCol_Text, im(look.text));
  ImGui::PushStyleColor(ImGuiCol_TextDisabled, im(look.faint));
  ImGui::PushStyleColor(ImGuiCol_TextSelectedBg, im(look.accent.with_alpha(0.4F)));
  ImGui::SetCursorScreenPos(top_left(rect));
  bool is_changed = false;
  if (lines > 1) {
    is_changed = ImGui::InputTextMultiline(name.c_str(), &words, im(rect.size()));
    if (words.empty() && !ImGui::IsItemActive())
      paragraph(TextStyle::Body, rect.inset(space::kMedium, space::kSmall), hint, look.faint, lines);
  } else {
    ImGui::SetNextItemWidth(static_cast<float>(rect.width));
    is_changed = ImGui::InputTextWithHint(name.c_str(), std::string(hint).c_str(), &words);
  }
  const bool is_active = ImGui::IsItemActive();
  if (lines == 1 && (is_active || ImGui::IsItemDeactivated()) && take({Key::Enter}, Repeats::Ignored)) {
    state_.entered_field = id;
    if (is_active) ImGui::ClearActiveID();
    take_all_keys();  // its letters are no commands
  }
  ImGui::PopStyleColor(4);
  ImGui::PopStyleVar();
  const bool is_ringed = is_active || is_focused;
  outline(rect, is_ringed ? look.accent : look.line, radius::kSmall, is_ringed ? 1.5 : 1);
  return is_changed;
}

void Ui::tooltip(const Rect& of, const Interaction& on, std::string_view words) {
  if (!on.hovered || words.empty()) return;
  if (state_.hovered_words != words) {
    state_.hovered_words = words;
    state_.hovered_since_s = time_s();
  }
  if (time_s() - state_.hovered_since_s < kTooltipAfter_s) return;
  const double width = text_width(TextStyle::Caption, words) + 2 * space::kSmall, height = 26;
  Rect box{of.centre().x - 0.5 * width, of.bottom() + 6, width, height};
  if (box.bottom() > whole().height - 4) box.y = of.y - height - 6;
  box.x = std::clamp(box.x, 4.0, std::max(4.0, whole().width - width - 4));
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const Theme& look = theme();
  const bool is_dark = look.kind == ThemeKind::Dark;
  const Colour paper = colour_from_hex(is_dark ? 0xF3F6FA : 0x151B23);
  const Colour ink = colour_from_hex(is_dark ? 0x151B23 : 0xFFFFFF);
  list.AddRectFilled(top_left(box), bottom_right(box), im(paper), static_cast<float>(radius::kSmall));
  ImFont* const font = state_.fonts[static_cast<std::size_t>(TextStyle::Caption)];
  const double size = static_cast<double>(font->FontSize) / state_.scale;
  const Vec2 at(box.x + space::kSmall, std::round(box.centre().y + 0.5 * cap_height(TextStyle::Caption) -
                                                  static_cast<double>(font->Ascent) / state_.scale));
  list.AddText(font, static_cast<float>(size), im(at), im(ink), words.data(), words.data() + words.size());
}

void Ui::focus_ring(const Rect& rect, double corner_radius, const Interaction& on) {
  if (on.focused) outline(rect.inset(-3), theme().accent, corner_radius + 3, 2);
}

void Ui::use_hand_pointer() {
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

bool Ui::take(const KeyPress& press, Repeats repeats) {
  const auto take_from = [&](std::vector<KeyPress>& keys) {
    const auto found = std::find(keys.begin(), keys.end(), press);
    if (found == keys.end()) return false;
    keys.erase(found);
    return true;
  };
  return take_from(input_.keys) || (repeats == Repeats::Count && take_from(input_.repeated_keys));
}

bool Ui::take_key(const KeyPress& press, Repeats repeats) {
  // What lies below an open list or dialog hears nothing.
  if (is_writing() || state_.layer < state_.top_layer_before) return false;
  if (press == KeyPress{Key::Enter} && state_.has_focused_place()) return false;
  return take(press, repeats);
}

std::optional<KeyPress> Ui::take_any_key() {
  if (is_writing() || input_.keys.empty()) return std::nullopt;
  const KeyPress press = input_.keys.front();
  input_.keys.erase(input_.keys.begin());
  return press;
}

void Ui::take_all_keys() {
  input_.keys.clear();
  input_.repeated_keys.clear();
}

bool Ui::has_ring() const {
  return state_.has_focused_place();
}

void Ui::focus_on(std::string_view id) {
  state_.wanted_place = id;
}

void Ui::walk_by_arrows() {
  if (is_writing()) return;
  const auto& places = state_.places;
  for (const auto& [key, direction] : {std::pair(Key::Left, Vec2(-1, 0)), std::pair(Key::Right, Vec2(1, 0)),
                                       std::pair(Key::Up, Vec2(0, -1)), std::pair(Key::Down, Vec2(0, 1))}) {
    if (!take({key}, Repeats::Count) || places.empty()) continue;
    const auto here = std::find_if(places.begin(), places.end(),
                                   [&](const auto& place) { return place.id == state_.focused; });
    if (here == places.end() || !state_.is_focus_shown)
      state_.next_focused = here == places.end() ? places.front().id : here->id;
    else
      state_.next_focused = place_towards(places, here->rect, direction);
  }
}

void Ui::push_id(std::string_view id) {
  ImGui::PushID(id.data(), id.data() + id.size());
}

void Ui::pop_id() {
  ImGui::PopID();
}

void Ui::push_clip(const Rect& rect) {
  ImGui::PushClipRect(top_left(rect), bottom_right(rect), true);
}

void Ui::pop_clip() {
  ImGui::PopClipRect();
}

Rect Ui::begin_scroll(std::string_view id, const Rect& area, double content_height) {
  const Theme& look = theme();
  ImGui::PushStyleColor(ImGuiCol_ScrollbarBg, 0);
  ImGui::PushStyleColor(ImGuiCol_ScrollbarGrab, im(look.line));
  ImGui::PushStyleColor(ImGuiCol_ScrollbarGrabHovered, im(look.faint));
  ImGui::PushStyleColor(ImGuiCol_ScrollbarGrabActive, im(look.quiet));
  ImGui::SetCursorScreenPos(top_left(area));
  ImGui::BeginChild(std::string(id).c_str(), im(area.size()), false,
                    ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const bool has_bar = content_height > area.height;
  ImGui::Dummy(ImVec2(1, static_cast<float>(content_height)));
  return {static_cast<double>(start.x), static_cast<double>(start.y), area.width - (has_bar ? 14 : 0),
          content_height};
}

void Ui::end_scroll() {
  ImGui::EndChild();
  ImGui::PopStyleColor(4);
}

bool Ui::was_entered(std::string_view field) {
  if (state_.entered_field != field) return false;
  state_.entered_field.clear();
  return true;
}

void Ui::write_in(std::string_view field) {
  state_.wanted_field = field;
}

void Ui::begin_overlay(std::string_view id, const Rect& area) {
  begin_window(std::string(id).c_str(), area, ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
}

void Ui::end_overlay() {
  ImGui::End();
}

void Ui::begin_layer(std::string_view id, const Rect& area) {
  ++state_.layer;
  state_.top_layer = std::max(state_.top_layer, state_.layer);
  ImGui::SetNextWindowFocus();
  begin_window(std::string(id).c_str(), area, 0);
}

void Ui::end_layer() {
  ImGui::End();
  --state_.layer;
}

bool Ui::is_open(std::string_view popup) const {
  return state_.open_popup == popup;
}

void Ui::open(std::string_view popup) {
  if (state_.open_popup.empty()) state_.focused_below = state_.focused;
  state_.open_popup = popup;
}

void Ui::close_popup() {
  state_.open_popup.clear();
  state_.focused = state_.focused_below;
}

const Theme* Ui::exchange_theme(const Theme* theme) {
  return std::exchange(theme_, theme);
}

}  // namespace posecoach
