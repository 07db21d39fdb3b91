#include <imgui_internal.h>
#include <imgui_stdlib.h>

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
  const auto found = std::find(places.begin(), places.end(), state.focused);
  if (found == places.end())
    state.focused = backwards ? places.back() : places.front();
  else if (backwards)
    state.focused = found == places.begin() ? places.back() : *(found - 1);
  else
    state.focused = found + 1 == places.end() ? places.front() : *(found + 1);
}

}  // namespace

Ui::Ui(InterfaceState& state, const Theme& theme, SceneViews& views, FrameInput input)
    : state_(state), theme_(&theme), views_(views), input_(std::move(input)) {
  state_.layer = 0;
  state_.top_layer = 0;
  state_.was_focus_moved = false;
  for (const KeyPress& press : std::vector(input_.keys))
    if (press.key == Key::Tab && !press.control) {
      if (is_writing()) ImGui::ClearActiveID();
      move_focus(state_, press.shift);
      std::erase(input_.keys, press);
    }
  if (ImGui::IsMouseClicked(0)) state_.is_focus_shown = false;
  begin_window("window", whole(), ImGuiWindowFlags_NoBringToFrontOnFocus);
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
  result.double_clicked = result.hovered && ImGui::IsMouseDoubleClicked(0);
  if (result.held) result.drag = {static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y)};
  if (result.hovered) result.wheel = static_cast<double>(io.MouseWheel);
  if (focus == Focus::Never || state_.layer < state_.top_layer_before) return result;
  state_.places.push_back(item);
  if (result.held) state_.focused = item;
  result.focused = state_.is_focus_shown && state_.focused == item;
  if (result.focused && state_.was_focus_moved) ImGui::SetScrollHereY(0.5F);
  if (result.focused && take_key({Key::Enter})) result.clicked = true;
  return result;
}

bool Ui::text_field(std::string_view id, const Rect& rect, std::string& words, std::string_view hint,
                    int lines) {
  const Theme& look = theme();
  const std::string name = "##" + std::string(id);  // no label
  const ImGuiID item = ImGui::GetID(name.c_str());
  const bool is_reachable = state_.layer >= state_.top_layer_before;
  if (is_reachable) state_.places.push_back(item);
  const bool is_focused = state_.is_focus_shown && state_.focused == item;
  fill(rect, look.raised, radius::kSmall);
  const bool is_asked_for = is_reachable && state_.wanted_field == id;
  if (is_asked_for) state_.wanted_field.clear();
  if ((is_reachable && is_focused && state_.was_focus_moved) || is_asked_for) ImGui::SetKeyboardFocusHere();
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
  ImGui::PopStyleColor(4);
  ImGui::PopStyleVar();
  outline(rect, is_active ? look.accent : look.line, radius::kSmall, is_active ? 1.5 : 1);
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

bool Ui::take_key(const KeyPress& press) {
  if (is_writing() && press.key != Key::Escape) return false;
  const auto found = std::find(input_.keys.begin(), input_.keys.end(), press);
  if (found == input_.keys.end()) return false;
  input_.keys.erase(found);
  return true;
}

std::vector<KeyPress> Ui::keys() const {
  return is_writing() ? std::vector<KeyPress>() : input_.keys;
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
  state_.open_popup = popup;
}

void Ui::close_popup() {
  state_.open_popup.clear();
}

const Theme* Ui::exchange_theme(const Theme* theme) {
  return std::exchange(theme_, theme);
}

}  // namespace posecoach
