#include "ui/panels/set_up_panels.h"
#include "ui/screens/key_map.h"
#include "ui/screens/screens.h"
#include "ui/widgets/controls.h"

namespace posecoach {

void draw_set_up_screen(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  ui.fill(area, context.theme().background);
  Rect rest = area.inset(18, 14);
  const double width = std::min(rest.width, 1500.0);
  rest = {rest.centre().x - 0.5 * width, rest.y, width, std::min(rest.height, 812.0)};
  ui.text_in(TextStyle::Heading, rest.take_top(38, 14), "Set-up", context.theme().text);
  Rect left = rest.column(0, 2, 14), right = rest.column(1, 2, 14);
  draw_camera_choice(context, left.take_top(0.52 * left.height, 14));
  draw_person(context, left);
  draw_coach_list(context, right.take_top(0.52 * right.height, 14));
  draw_looks(context, right);
  if (context.pressed(Command::Back)) context.state.screen = ScreenName::Live;
}

}  // namespace posecoach
