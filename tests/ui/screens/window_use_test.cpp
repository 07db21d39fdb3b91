// The window as its user drives it, with keys and the mouse in the test's hands.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sample_window.h"
#include "tests/support/test_window.h"
#include "ui/panels/review_panels.h"
#include "ui/screens/screens.h"

namespace posecoach {
namespace {

class WindowUse : public testing::Test {
 protected:
  WindowUse() : screen_(1280, 720), window_(normal_window()) {
    window_.model.toasts.clear();
    window_.model.jobs.clear();
    window_.state.screen = ScreenName::Review;
    window_.model.opened->marks = {};
    // The ring is where no test before has left it.
    for (int i = 0; i < 2; ++i) {
      screen_.press({Key::Tab});
      screen_.frame(make_theme(ThemeKind::Dark, Palette::RedGreen), [](Ui& ui) {
        (void)ui.region("nowhere", {0, 0, 1, 1});
      });
    }
  }

  void frame() {
    screen_.frame(make_theme(ThemeKind::Dark, Palette::RedGreen), [&](Ui& ui) {
      draw_window({ui, window_.model, window_.state, intents_}, ui.whole());
    });
    // What the program would do at once.
    for (const Intent& intent : intents_) {
      if (const auto* const marks = std::get_if<intent::SetMarks>(&intent))
        window_.model.opened->marks = marks->marks;
      if (const auto* const keys = std::get_if<intent::SetKeys>(&intent)) window_.model.keys = keys->keys;
    }
  }
  void press(const char* text) {
    screen_.press(key_press_from_text(text).value());
    frame();
  }
  void press_all(std::initializer_list<const char*> keys) {
    for (const char* const text : keys) press(text);
  }
  void drag(const Vec2& from, const Vec2& to) {
    screen_.move_mouse(from);
    frame();
    screen_.press_mouse();
    frame();
    for (const double share : {0.4, 1.0}) {
      screen_.move_mouse(from + share * (to - from));
      frame();
    }
    screen_.release_mouse();
    frame();
  }
  template <typename Wanted>
  std::optional<Wanted> last() const {
    std::optional<Wanted> found;
    for (const Intent& intent : intents_)
      if (const auto* const one = std::get_if<Wanted>(&intent)) found = *one;
    return found;
  }
  const Marks& marks() const { return window_.model.opened->marks; }
  WindowState& state() { return window_.state; }

  TestWindow screen_;
  SampleWindow window_;
  Intents intents_;
};

TEST_F(WindowUse, a_step_is_one_picture_and_positions_are_reached_by_number) {
  frame();
  const int begin = state().playback.frame;
  press_all({"Right", ".", "Left"});
  EXPECT_EQ(state().playback.frame, begin + 1);
  press("6");
  EXPECT_EQ(state().playback.frame, sample_review()->events[5]);
  press("Ctrl+Left");
  EXPECT_EQ(state().playback.frame, sample_review()->events[4]);
}

TEST_F(WindowUse, a_line_is_drawn_with_the_mouse_taken_back_and_done_again) {
  frame();
  press("N");
  drag({200, 200}, {320, 330});
  ASSERT_EQ(marks().drawings.size(), 1U);
  EXPECT_EQ(marks().drawings[0].kind, DrawingKind::Line);
  EXPECT_EQ(marks().drawings[0].frame, state().playback.frame);
  press("Ctrl+Z");
  EXPECT_TRUE(marks().drawings.empty());
  press("Ctrl+Y");
  EXPECT_EQ(marks().drawings.size(), 1U);
  press("Delete");
  EXPECT_TRUE(marks().drawings.empty());
}

TEST_F(WindowUse, an_angle_is_drawn_by_keys_alone) {
  frame();
  press("V");
  press_all({"Left", "Left", "Enter", "Down", "Down", "Down", "Enter"});
  EXPECT_TRUE(marks().drawings.empty());
  const int picture = state().playback.frame;
  press_all({"Right", "Right", "Right", "Right", "Enter"});
  ASSERT_EQ(marks().drawings.size(), 1U);
  EXPECT_NEAR(angle_deg(marks().drawings[0]), 90, 1e-6);
  EXPECT_EQ(state().playback.frame, picture);  // the arrows moved the crosshair, not the film
  press("Right");
  EXPECT_EQ(state().playback.frame, picture + 1);
}

TEST_F(WindowUse, a_position_is_moved_by_keys_and_by_the_mouse_between_its_neighbours) {
  frame();
  const auto& events = sample_review()->events;
  press("4");
  press("Ctrl+Shift+Right");
  ASSERT_EQ(marks().events.size(), 1U);
  EXPECT_EQ(marks().events[0], (MovedEvent{"top", events[3] + 1}));
  EXPECT_EQ(state().playback.frame, events[3] + 1);
  press("Ctrl+Z");
  EXPECT_TRUE(marks().events.empty());
  // The handle of the top, dragged far beyond the impact: it stops before its neighbour.
  const int at = 634, row = 562;
  drag({at, row}, {at + 400, row});
  ASSERT_EQ(marks().events.size(), 1U);
  EXPECT_EQ(marks().events[0].name, "top");
  EXPECT_EQ(marks().events[0].frame, events[4] - 1);
}

TEST_F(WindowUse, key_pictures_are_where_ctrl_and_arrows_stop) {
  frame();
  press_all({"Home", "Right", "Right", "Insert", "Home", "Ctrl+Right"});
  EXPECT_EQ(marks().key_pictures, (std::vector<int>{2}));
  EXPECT_EQ(state().playback.frame, 2);
}

TEST_F(WindowUse, the_film_comes_nearer_by_keys) {
  frame();
  EXPECT_GT(state().zoom.factor, 1.2);  // the golfer, as large as he fits
  press("Ctrl+0");
  press_all({"Ctrl+Plus", "Ctrl+="});
  EXPECT_NEAR(state().zoom.factor, 1.5625, 1e-9);
  press("Ctrl+Minus");
  EXPECT_NEAR(state().zoom.factor, 1.25, 1e-9);
  press("Z");
  frame();
  EXPECT_GT(state().zoom.factor, 1.2);
  press("Ctrl+0");
  EXPECT_EQ(state().zoom, FilmZoom());
}

TEST_F(WindowUse, skeletons_are_taken_off_the_film_one_after_the_other) {
  frame();
  for (const FigureShow wanted : {FigureShow::Student, FigureShow::None, FigureShow::Both}) {
    press("X");
    EXPECT_EQ(state().figures, wanted);
  }
}

TEST_F(WindowUse, a_key_is_changed_in_the_sheet_by_keys_alone_and_counts_at_once) {
  frame();
  press("F1");
  EXPECT_TRUE(state().shows_keys);
  // The last place of the sheet, then the first box of the list that appears.
  press_all({"Shift+Tab", "Enter"});
  ASSERT_TRUE(state().is_changing_keys);
  state().key_choice = KeyChoice{Command::StepForward, 0, {}};
  press("Space");  // which is Play, pause
  ASSERT_TRUE(state().key_choice && state().key_choice->wanted);
  EXPECT_FALSE(last<intent::SetKeys>());
  frame();
  press("Enter");  // "Use it here" has the ring
  ASSERT_TRUE(last<intent::SetKeys>());
  EXPECT_EQ(window_.model.keys.chords(Command::StepForward)[0], KeyPress{Key::Space});
  press("Esc");
  EXPECT_FALSE(state().shows_keys);
  frame();
  const int picture = state().playback.frame;
  press("Space");
  EXPECT_EQ(state().playback.frame, picture + 1);
  EXPECT_FALSE(state().playback.is_playing);
}

TEST_F(WindowUse, enter_belongs_to_the_ringed_place) {
  state().screen = ScreenName::Live;
  frame();
  press_all({"Tab", "Tab"});  // Review, in the rail
  frame();
  press("Enter");
  EXPECT_EQ(state().screen, ScreenName::Review);
  EXPECT_FALSE(last<intent::OpenLastSwing>());
}

TEST_F(WindowUse, what_was_ringed_on_one_screen_is_not_ringed_on_another) {
  frame();
  press_all({"Tab", "Tab", "Tab", "Tab", "Tab",
             "Tab"});  // the export list, behind the rail; the library has one too
  frame();
  press("F8");
  frame();
  press("Enter");
  EXPECT_EQ(state().screen, ScreenName::Library);
  ASSERT_TRUE(last<intent::CompareWith>());
  EXPECT_EQ(last<intent::CompareWith>()->id, "s14");
}

TEST_F(WindowUse, arrows_walk_where_no_command_wants_them) {
  state().screen = ScreenName::SetUp;
  frame();
  press_all({"Tab", "Down"});
  frame();
  press("Enter");  // below Live is Review
  EXPECT_EQ(state().screen, ScreenName::Review);
}

TEST_F(WindowUse, an_open_list_has_the_keyboard_for_itself) {
  frame();
  // The speed's list.
  screen_.move_mouse({1184, 445});
  frame();
  screen_.press_mouse();
  frame();
  screen_.release_mouse();
  frame();
  frame();
  const Playback before = state().playback;
  press("Right");
  EXPECT_EQ(state().playback, before);
  press("Esc");
  EXPECT_EQ(state().screen, ScreenName::Review);
  frame();
  press("Right");
  EXPECT_EQ(state().playback.frame, before.frame + 1);
}

TEST_F(WindowUse, a_dropped_file_is_imported) {
  frame();
  screen_.drop("/home/anna/swing.mp4");
  frame();
  ASSERT_TRUE(last<intent::ImportFile>());
  EXPECT_EQ(last<intent::ImportFile>()->path, "/home/anna/swing.mp4");
}

TEST_F(WindowUse, what_was_left_over_is_kept_by_enter_or_asked_again_next_time) {
  state().hides_leftovers = false;
  frame();
  frame();
  press("Enter");
  ASSERT_TRUE(last<intent::KeepLeftover>());
  press("Esc");
  EXPECT_TRUE(state().hides_leftovers);
  EXPECT_EQ(state().screen, ScreenName::Review);
}

TEST_F(WindowUse, mirroring_changes_what_is_shown_only) {
  frame();
  press("M");
  EXPECT_TRUE(state().is_mirrored);
  EXPECT_TRUE(intents_.empty());
}

TEST(Mouse, two_quick_clicks_are_one_double_click_however_slowly_pictures_are_drawn) {
  for (const double elapsed_s : {0.016, 0.2, 0.4}) {
    TestWindow screen(200, 100);
    screen.elapsed_s = elapsed_s;
    bool was_double = false;
    const auto frame = [&] {
      screen.frame(make_theme(ThemeKind::Dark, Palette::RedGreen), [&](Ui& ui) {
        was_double = was_double || ui.region("card", {0, 0, 100, 100}).double_clicked;
      });
    };
    screen.move_mouse({50, 50});
    // A click of another test is long over.
    for (int i = 0; i < 200; ++i) frame();
    screen.press_mouse();
    frame();
    screen.release_mouse();
    frame();
    EXPECT_FALSE(was_double) << elapsed_s;
    screen.press_mouse();
    frame();
    EXPECT_TRUE(was_double) << elapsed_s;
    screen.release_mouse();
    frame();
    // What comes a while later is another click.
    was_double = false;
    for (int i = 0; i < 200; ++i) frame();
    screen.press_mouse();
    frame();
    EXPECT_FALSE(was_double) << elapsed_s;
    screen.release_mouse();
    frame();
  }
}

}  // namespace
}  // namespace posecoach
