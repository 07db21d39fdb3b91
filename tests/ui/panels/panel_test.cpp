#include <gtest/gtest.h>

#include "tests/support/image_compare.h"
#include "tests/support/sample_window.h"
#include "tests/support/test_window.h"
#include "ui/panels/panel_registry.h"

namespace posecoach {
namespace {

// Text at fractions of a pixel and lit bodies differ a little between processors; a missing word must not
// pass.
constexpr ImageTolerance kPanelTolerance = {130, 0.3, 14, 0.004};

std::string name_of(const testing::TestParamInfo<RegisteredPanel>& info) {
  return std::string(info.param.name);
}

SampleWindow window_in(std::string_view state) {
  return state == "empty" ? empty_window() : state == "normal" ? normal_window() : extreme_window();
}

Image drawn(const RegisteredPanel& panel, SampleWindow window) {
  constexpr double kMargin = 12;
  TestWindow screen(static_cast<int>(panel.width + 2 * kMargin),
                    static_cast<int>(panel.height + 2 * kMargin));
  const Theme plain = make_theme(ThemeKind::Dark, Palette::RedGreen);
  const Theme theme = panel.lies_on_film ? film_theme(plain) : plain;
  Intents intents;
  for (int i = 0; i < 3; ++i)
    screen.frame(theme, [&](Ui& ui) {
      ui.fill(ui.whole(), panel.lies_on_film ? colour_from_hex(0x5C7A68) : theme.background);
      panel.draw({ui, window.model, window.state, intents}, {kMargin, kMargin, panel.width, panel.height});
    });
  EXPECT_TRUE(intents.empty());  // nobody pressed anything
  return screen.picture();
}

class Panel : public testing::TestWithParam<RegisteredPanel> {};

TEST_P(Panel, draws_itself_as_its_golden_pictures) {
  for (const char* state : {"empty", "normal", "extreme"})
    EXPECT_TRUE(matches_golden(drawn(GetParam(), window_in(state)),
                               "panel_" + std::string(GetParam().name) + "_" + state, kPanelTolerance));
}

INSTANTIATE_TEST_SUITE_P(All, Panel,
                         testing::ValuesIn(registered_panels().begin(), registered_panels().end()), name_of);

}  // namespace
}  // namespace posecoach
