#include "ui/panels/live_panels.h"
#include "ui/render/words.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr double kPad = 14, kSign = 26, kHeading = 30;

std::string_view topic_title(SetUpTopic topic) {
  switch (topic) {
    case SetUpTopic::WholeBody:
      return "Whole body";
    case SetUpTopic::Light:
      return "Light";
    case SetUpTopic::OnePerson:
      return "One person";
    case SetUpTopic::View:
      return "View";
    case SetUpTopic::Distance:
      return "Distance";
  }
  return {};
}

// A disc with a tick, a triangle, a square with a cross: told apart without colour.
void draw_level(Ui& ui, SetUpLevel level, const Vec2& at) {
  const Theme& theme = ui.theme();
  const Colour ink = colour_from_hex(0x0B0F14);
  switch (level) {
    case SetUpLevel::Good:
      ui.disc(at, 10, theme.good);
      return draw_icon(ui, Icon::Check, at, 13, ink);
    case SetUpLevel::Poor: {
      const std::array<Vec2, 3> triangle = {at + Vec2(0, -11), at + Vec2(11.5, 9), at + Vec2(-11.5, 9)};
      ui.polygon(triangle, theme.warning);
      ui.line(at + Vec2(0, -4), at + Vec2(0, 2.5), ink, 2.2);
      return ui.disc(at + Vec2(0, 5.6), 1.4, ink);
    }
    case SetUpLevel::Bad:
      ui.fill({at.x - 10, at.y - 10, 20, 20}, theme.bad, 4);
      return draw_icon(ui, Icon::Cross, at, 14, ink);
  }
}

double row_height(const Ui& ui, const SetUpCheck& check, double width) {
  if (check.level == SetUpLevel::Good) return 28;
  return 22 + ui.paragraph_height(TextStyle::Body, width - kSign - 8, check.words, 3) + 6;
}

// As its list names it, with the size of its pictures.
std::string source_words(const WindowModel& model) {
  const CoachSnapshot& snapshot = *model.snapshot;
  std::string words = snapshot.source.empty() ? "No camera" : snapshot.source;
  for (const CameraEntry& camera : model.cameras)
    if (!camera.source.empty() && snapshot.source.starts_with(camera.source)) words = camera.name;
  if (snapshot.frame && snapshot.frame->image)
    words += ", " + std::to_string(snapshot.frame->image->width) + " × " +
             std::to_string(snapshot.frame->image->height);
  return words;
}

}  // namespace

double set_up_checks_height(const PanelContext& context, double width) {
  if (!context.model.snapshot || context.model.snapshot->checks.empty()) return 0;
  double height = 2 * kPad + kHeading;
  for (const SetUpCheck& check : context.model.snapshot->checks)
    height += row_height(context.ui, check, width - 2 * kPad);
  return height;
}

void draw_set_up_checks(const PanelContext& context, const Rect& area) {
  if (!context.model.snapshot || context.model.snapshot->checks.empty()) return;
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const auto& checks = context.model.snapshot->checks;
  Rect inner = draw_card(ui, area, kPad);
  const bool is_ready = std::all_of(checks.begin(), checks.end(),
                                    [](const SetUpCheck& check) { return check.level == SetUpLevel::Good; });
  Rect heading = inner.take_top(kHeading - 8, 8);
  ui.text_in(TextStyle::Title, heading, is_ready ? "You stand well" : "Stand here", theme.text);
  const ClipScope clip(ui, area);
  for (const SetUpCheck& check : checks) {
    const double height = row_height(ui, check, inner.width);
    if (inner.height < height) break;
    Rect row = inner.take_top(height);
    const Rect sign = row.take_left(kSign, 8);
    draw_level(ui, check.level, {sign.centre().x - 2, sign.y + 11});
    if (check.level == SetUpLevel::Good) {
      ui.text_in(TextStyle::Body, row.take_top(22), topic_title(check.topic), theme.quiet);
      continue;
    }
    ui.text_in(TextStyle::Strong, row.take_top(22), topic_title(check.topic), theme.text);
    ui.paragraph(TextStyle::Body, row, check.words, theme.quiet, 3);
  }
}

double address_advice_height(const PanelContext& context, double width) {
  if (!context.model.snapshot || context.model.snapshot->address_advice.empty()) return 0;
  double height = 2 * kPad + kHeading;
  for (const std::string& words : context.model.snapshot->address_advice)
    height += context.ui.paragraph_height(TextStyle::Body, width - 2 * kPad - 18, words, 3) + 6;
  return height;
}

void draw_address_advice(const PanelContext& context, const Rect& area) {
  if (!context.model.snapshot || context.model.snapshot->address_advice.empty()) return;
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  Rect inner = draw_card(ui, area, kPad);
  ui.text_in(TextStyle::Title, inner.take_top(kHeading - 8, 8), "Your address", theme.text);
  const ClipScope clip(ui, area);
  for (const std::string& words : context.model.snapshot->address_advice) {
    const double height = ui.paragraph_height(TextStyle::Body, inner.width - 18, words, 3);
    if (inner.height < height) break;
    Rect row = inner.take_top(height, 6);
    const Rect sign = row.take_left(12, 6);
    ui.disc({sign.x + 4, sign.y + 10}, 3.5, theme.coach);
    ui.paragraph(TextStyle::Body, row, words, theme.text, 3);
  }
}

void draw_status_line(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  ui.fill(area, theme.background);
  ui.fill({area.x, area.y, area.width, 1}, theme.line);
  Rect row = area.inset(space::kMedium, 0);
  if (!context.model.snapshot) {
    ui.text_in(TextStyle::Caption, row, "Starting…", theme.quiet);
    return;
  }
  const CoachSnapshot& snapshot = *context.model.snapshot;
  const LiveCounters& counters = snapshot.counters;
  const bool is_live = snapshot.source_state == SourceState::Live;
  const std::string name = source_words(context.model);
  const double name_width = std::min(ui.text_width(TextStyle::Caption, name) + 22, 0.32 * row.width);
  Rect left = row.take_left(name_width, 18);
  ui.disc({left.x + 5, left.centre().y}, 4, is_live ? theme.good : theme.warning);
  left.take_left(16);
  ui.text_in(TextStyle::Caption, left, name, theme.text);
  struct Item {
    std::string words;
    bool is_bad;
  };
  std::vector<Item> items = {
      {decimal(counters.captured_fps, 1) + " pictures/s", false},
      {"pose " + decimal(counters.pose_fps, 1) + "/s", false},
      {"latency " + decimal(counters.latency_median_ms, 0) + " ms, 95 % below " +
           decimal(counters.latency_p95_ms, 0) + " ms",
       false},
      {std::to_string(counters.captured) + " captured", false},
      {std::to_string(counters.skipped_by_pose) + " skipped", false},
      {std::to_string(counters.lost_by_camera) + " lost", counters.lost_by_camera > 0}};
  if (context.model.is_recording)
    items.push_back({"recording " + decimal(context.model.recorded_s, 0) + " s, " +
                         std::to_string(context.model.recorded_frames) + " pictures, " +
                         std::to_string(context.model.recording_lost) + " lost",
                     context.model.recording_lost > 0});
  for (const Item& item : items) {
    const double width = ui.text_width(TextStyle::Caption, item.words);
    if (width > row.width) break;
    ui.text_in(TextStyle::Caption, row.take_left(width + 1, 20), item.words,
               item.is_bad ? theme.bad : theme.quiet);
  }
}

}  // namespace posecoach
