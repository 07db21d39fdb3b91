#include "ui/panels/common_panels.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr double kRow = 62, kGap = 8;
constexpr std::size_t kMostShown = 4;

}  // namespace

void draw_leftovers(const PanelContext& context, const Rect& area) {
  const auto& leftovers = context.model.leftovers;
  if (leftovers.empty()) return;
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  ui.fill(area, theme.scrim);
  const std::size_t shown = std::min(leftovers.size(), kMostShown);
  const double width = std::min(620.0, area.width - 32);
  const std::string words = "The program ended before " +
                            std::string(leftovers.size() == 1 ? "this was" : "these were") +
                            " put away. What was recorded until then is still there.";
  const double height = 48 + 34 + 10 + ui.paragraph_height(TextStyle::Body, width - 48, words, 3) + 14 +
                        static_cast<double>(shown) * (kRow + kGap) + 10 + 38;
  const Rect card{area.centre().x - 0.5 * width, area.centre().y - 0.5 * height, width, height};
  ui.shadow(card, radius::kLarge, 24);
  Rect inner = draw_card(ui, card, 24);
  ui.text_in(TextStyle::Heading, inner.take_top(34, 10), "Something was left over", theme.text);
  inner.take_top(ui.paragraph(TextStyle::Body, inner, words, theme.quiet, 3) + 14);
  const Rect list = inner.take_top(static_cast<double>(shown) * (kRow + kGap), 10);
  const Rect content =
      ui.begin_scroll("leftovers", list, static_cast<double>(leftovers.size()) * (kRow + kGap));
  for (std::size_t i = 0; i < leftovers.size(); ++i) {
    const LeftoverEntry& one = leftovers[i];
    const IdScope scope(ui, one.folder);
    const Rect row{content.x, content.y + static_cast<double>(i) * (kRow + kGap), content.width, kRow};
    ui.fill(row, theme.raised, radius::kMedium);
    Rect line = row.inset(14, 10);
    draw_icon(ui, Icon::Record, line.take_left(24, 10).centre(), 22, theme.warning);
    const Rect trash = line.take_right(86, 8), keep = line.take_right(86, 14);
    ui.text_in(TextStyle::Strong, line.take_top(0.54 * line.height), one.title, theme.text);
    ui.text_in(TextStyle::Caption, line, one.detail, theme.quiet);
    if (draw_button(ui, keep.inset(0, 3), {.id = "keep", .words = "Keep", .look = ButtonLook::Primary}))
      context.want(intent::KeepLeftover{one.folder});
    if (draw_button(ui, trash.inset(0, 3), {.id = "trash", .words = "Trash", .hint = "It can be put back"}))
      context.want(intent::TrashLeftover{one.folder});
  }
  ui.end_scroll();
  const Button later{.id = "later", .words = "Ask me next time", .look = ButtonLook::Quiet};
  if (draw_button(ui, inner.take_bottom(38).take_right(button_width(ui, later)), later) ||
      ui.take_key({Key::Escape}))
    context.state.hides_leftovers = true;
  // Without having to look for it first.
  if (ui.take_key({Key::Enter})) context.want(intent::KeepLeftover{leftovers.front().folder});
}

}  // namespace posecoach
