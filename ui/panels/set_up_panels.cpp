#include "ui/panels/set_up_panels.h"

#include <array>
#include <charconv>
#include <cmath>

#include "ui/panels/common_panels.h"
#include "ui/render/words.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr double kRow = 50, kGap = 6;

// One line of a list of which one is chosen: a disc in a ring, told apart without colour.
bool draw_option(Ui& ui, std::string_view id, const Rect& row, std::string_view title,
                 std::string_view detail, bool is_chosen, Icon icon) {
  const Theme& theme = ui.theme();
  const Interaction on = ui.region(id, row);
  ui.fill(row,
          is_chosen    ? mix(theme.raised, theme.accent, 0.16F)
          : on.hovered ? theme.raised
                       : theme.surface,
          radius::kMedium);
  ui.outline(row, is_chosen ? theme.accent : theme.line, radius::kMedium, is_chosen ? 1.5 : 1);
  ui.focus_ring(row, radius::kMedium, on);
  Rect inner = row.inset(12, 7);
  const Vec2 dot = inner.take_left(18, 10).centre();
  ui.ring(dot, 8, is_chosen ? theme.accent : theme.faint, 1.8);
  if (is_chosen) ui.disc(dot, 4.2, theme.accent);
  if (icon != Icon::None) draw_icon(ui, icon, inner.take_right(20).centre(), 18, theme.faint);
  if (detail.empty()) {
    ui.text_in(TextStyle::Strong, inner, title, theme.text);
  } else {
    ui.text_in(TextStyle::Strong, inner.take_top(0.54 * inner.height), title, theme.text);
    ui.text_in(TextStyle::Caption, inner, detail, theme.quiet);
  }
  if (on.hovered) ui.use_hand_pointer();
  return on.clicked;
}

std::string mode_words(const PictureMode& mode) {
  return std::to_string(mode.width) + " × " + std::to_string(mode.height) + ", " + decimal(mode.fps, 0) +
         " pictures/s" + (mode.format.empty() ? "" : ", " + mode.format);
}

void draw_modes(const PanelContext& context, const CameraEntry& camera, const Rect& area) {
  if (camera.modes.empty()) return;
  std::vector<Choice> choices = {{"The best for swings", "chosen by the program"}};
  int chosen = 0;
  for (std::size_t i = 0; i < camera.modes.size(); ++i) {
    choices.push_back({mode_words(camera.modes[i]), ""});
    if (context.model.mode == camera.modes[i]) chosen = static_cast<int>(i) + 1;
  }
  const std::string shown =
      chosen == 0 ? "Pictures: the best for swings" : choices[static_cast<std::size_t>(chosen)].title;
  const int picked = draw_dropdown(context.ui, "mode", area, shown, choices, chosen, Icon::SetUp);
  if (picked < 0) return;
  std::optional<PictureMode> mode;
  if (picked > 0) mode = camera.modes[static_cast<std::size_t>(picked - 1)];
  context.want(intent::ChooseSource{camera.source, mode});
}

std::optional<double> height_from(std::string_view words) {
  double value = 0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), value);
  if (error != std::errc() || end == words.data()) return std::nullopt;
  if (value > 3) value /= 100;  // centimetres
  return value >= 0.5 && value <= 2.6 ? std::optional(value) : std::nullopt;
}

const PersonChoice* current_person(const WindowModel& model) {
  for (const PersonChoice& person : model.people)
    if (person.id == model.person) return &person;
  return nullptr;
}

}  // namespace

void draw_camera_choice(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const WindowModel& model = context.model;
  Rect inner = draw_titled_card(ui, area, "Camera", Icon::Camera);
  if (draw_button(ui, {inner.right() - 34, area.y + 10, 34, 34},
                  {.id = "refresh",
                   .icon = Icon::Retry,
                   .look = ButtonLook::Quiet,
                   .hint = "Look for cameras again"}))
    context.want(intent::RefreshCameras{});
  Rect typed = inner.take_bottom(36, 10);
  const Button film{.id = "choose film",
                    .words = "A film",
                    .icon = Icon::Folder,
                    .hint = "Practise with a recorded film instead of a camera"};
  if (draw_button(ui, typed.take_left(button_width(ui, film), 8), film))
    open_import_dialog(context, BrowseFor::Source);
  const Rect use = typed.take_right(64, 8);
  ui.text_field("typed source", typed, context.state.typed_source, "Or write: /dev/video0, simulated:putt");
  const bool is_entered = ui.was_entered("typed source") && !context.state.typed_source.empty();
  if (draw_button(ui, use,
                  {.id = "use source", .words = "Use", .is_enabled = !context.state.typed_source.empty()}) ||
      is_entered)
    context.want(intent::ChooseSource{context.state.typed_source, {}});
  const CameraEntry* chosen = nullptr;
  for (const CameraEntry& camera : model.cameras)
    if (camera.source == model.source) chosen = &camera;
  if (chosen != nullptr && !chosen->modes.empty()) draw_modes(context, *chosen, inner.take_bottom(36, 10));
  const bool has_camera =
      std::any_of(model.cameras.begin(), model.cameras.end(),
                  [](const CameraEntry& camera) { return camera.source.starts_with("camera:"); });
  if (!has_camera && !model.cameras.empty()) {
    constexpr std::string_view kNone = "No camera was found. Plug one in: it appears here.";
    Rect note = inner.take_top(34, 10);
    ui.fill(note, theme.raised, radius::kMedium);
    draw_icon(ui, Icon::Information, note.take_left(38).centre(), 17, theme.accent);
    ui.text_in(TextStyle::Body, note, kNone, theme.text);
  }
  const double wanted = static_cast<double>(model.cameras.size()) * (kRow + kGap);
  const Rect content = ui.begin_scroll("cameras", inner, wanted);
  for (std::size_t i = 0; i < model.cameras.size(); ++i) {
    const CameraEntry& camera = model.cameras[i];
    const Rect row{content.x, content.y + static_cast<double>(i) * (kRow + kGap), content.width, kRow};
    const bool is_simulated = camera.source.starts_with("simulated");
    if (draw_option(ui, "camera " + std::to_string(i), row, camera.name, camera.detail,
                    camera.source == model.source, is_simulated ? Icon::Body : Icon::Camera) &&
        camera.source != model.source)
      context.want(intent::ChooseSource{camera.source, {}});
  }
  ui.end_scroll();
}

void draw_person(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const WindowModel& model = context.model;
  WindowState& state = context.state;
  Rect inner = draw_titled_card(ui, area, "You", Icon::Person);
  std::vector<Choice> choices;
  int chosen = -1;
  std::string shown = "Who is practising?";
  for (std::size_t i = 0; i < model.people.size(); ++i) {
    const PersonChoice& person = model.people[i];
    choices.push_back(
        {person.name, std::string(person.hand == Handedness::Left ? "Left-handed" : "Right-handed") +
                          (person.is_measured ? ", measured" : ", not measured")});
    if (person.id == model.person) {
      chosen = static_cast<int>(i);
      shown = person.name;
    }
  }
  const int picked = draw_dropdown(ui, "person", inner.take_top(36, 8), shown, choices, chosen, Icon::Person);
  if (picked >= 0) context.want(intent::ChoosePerson{model.people[static_cast<std::size_t>(picked)].id});
  Rect add = inner.take_top(36, 14);
  const Rect button = add.take_right(64, 8);
  ui.text_field("new person", add, state.typed_name, "Somebody new");
  const bool is_entered = ui.was_entered("new person") && !state.typed_name.empty();
  if (draw_button(ui, button,
                  {.id = "add person", .words = "Add", .is_enabled = !state.typed_name.empty()}) ||
      is_entered) {
    context.want(intent::AddPerson{state.typed_name});
    state.typed_name.clear();
  }
  const PersonChoice* const person = current_person(model);
  if (person == nullptr) return;
  Rect hand = inner.take_top(36, 10);
  ui.text_in(TextStyle::Body, hand.take_left(76), "Plays", theme.quiet);
  constexpr std::array<std::string_view, 2> kHands = {"Right-handed", "Left-handed"};
  const int is_left = person->hand == Handedness::Left ? 1 : 0;
  if (const int now = draw_segments(ui, "hand", hand, kHands, is_left); now != is_left)
    context.want(intent::SetHand{now == 1 ? Handedness::Left : Handedness::Right});
  Rect height = inner.take_top(36, 10);
  ui.text_in(TextStyle::Body, height.take_left(76), "Height", theme.quiet);
  const std::string known = person->height_m ? decimal(*person->height_m, 2) + " m" : "metres, as 1.78";
  if (ui.text_field("height", height, state.typed_height, known) && height_from(state.typed_height))
    context.want(intent::SetHeight{height_from(state.typed_height)});
  Rect body = inner.take_top(36);
  ui.text_in(TextStyle::Body, body.take_left(76), "Body", theme.quiet);
  const Button measure{.id = "measure",
                       .words = person->is_measured ? "Measure again" : "Measure me",
                       .icon = Icon::Measure,
                       .look = person->is_measured ? ButtonLook::Plain : ButtonLook::Primary};
  if (draw_button(ui, body.take_left(button_width(ui, measure), 12), measure)) {
    context.want(intent::MeasureBody{});
    state.screen = ScreenName::Live;
  }
  if (body.width < 90) return;
  const Pill pill{person->is_measured ? "measured" : "not yet",
                  person->is_measured ? theme.good : theme.warning, theme.raised,
                  person->is_measured ? Icon::Check : Icon::Warning};
  draw_pill(ui, {body.x, body.centre().y - 12, std::min(pill_width(ui, pill), body.width), 24}, pill);
}

void draw_coach_list(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const WindowModel& model = context.model;
  Rect inner = draw_titled_card(ui, area, "Coach", Icon::Coach);
  const Button add{.id = "add coach", .words = "Add a coach from a file", .icon = Icon::Plus};
  if (draw_button(ui, inner.take_bottom(36, 10), add)) open_import_dialog(context, BrowseFor::Coach);
  if (model.coaches.empty())
    return draw_empty(ui, inner, Icon::Coach, "No coach",
                      "Add a motion file, or make a swing of the library the coach.");
  const double wanted = static_cast<double>(model.coaches.size()) * (kRow + kGap);
  const Rect content = ui.begin_scroll("coaches", inner, wanted);
  for (std::size_t i = 0; i < model.coaches.size(); ++i) {
    const CoachChoice& coach = model.coaches[i];
    const Rect row{content.x, content.y + static_cast<double>(i) * (kRow + kGap), content.width, kRow};
    if (draw_option(ui, "coach " + std::to_string(i), row, coach.title, coach.detail, coach.id == model.coach,
                    Icon::None) &&
        coach.id != model.coach)
      context.want(intent::ChooseCoach{coach.id});
  }
  ui.end_scroll();
}

void draw_looks(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const WindowModel& model = context.model;
  Rect inner = draw_titled_card(ui, area, "Looks and sound", Icon::SetUp);
  const auto row = [&](std::string_view words) {
    Rect line = inner.take_top(36, 10);
    ui.text_in(TextStyle::Body, line.take_left(86), words, theme.quiet);
    return line;
  };
  constexpr std::array<std::string_view, 2> kThemes = {"Dark", "Light"};
  const int kind = draw_segments(ui, "theme", row("Theme"), kThemes, static_cast<int>(model.theme));
  if (kind != static_cast<int>(model.theme))
    context.want(intent::SetLook{static_cast<ThemeKind>(kind), model.palette});
  constexpr std::array<std::string_view, 2> kPalettes = {"Red and green", "Colour-blind safe"};
  const int palette =
      draw_segments(ui, "palette", row("Colours"), kPalettes, static_cast<int>(model.palette));
  if (palette != static_cast<int>(model.palette))
    context.want(intent::SetLook{model.theme, static_cast<Palette>(palette)});
  constexpr std::array<std::string_view, 3> kSizes = {"Normal", "Larger", "Largest"};
  constexpr std::array<double, 3> kFactors = {1.0, 1.25, 1.5};
  int size = 0;
  for (std::size_t i = 0; i < kFactors.size(); ++i)
    if (std::abs(kFactors[i] - model.text_size) < 0.1) size = static_cast<int>(i);
  const int now = draw_segments(ui, "text size", row("Size"), kSizes, size);
  if (now != size) context.want(intent::SetTextSize{kFactors[static_cast<std::size_t>(now)]});
  const Rect sound = inner.take_top(36, 8);
  const bool is_on = draw_switch(
      ui, "sound", sound, model.has_sound ? "Sounds for the hands-free loop" : "No sound device: silent",
      model.is_sound_on && model.has_sound);
  if (model.has_sound && is_on != model.is_sound_on) context.want(intent::SetSound{is_on});
  if (inner.height >= 40 && !model.folder.empty()) {
    ui.text_in(TextStyle::Caption, inner.take_top(18), "Swings are kept in", theme.faint);
    ui.text_in(TextStyle::Caption, inner.take_top(18), model.folder, theme.quiet);
  }
}

}  // namespace posecoach
