#include <gtest/gtest.h>

#include <numeric>

#include "core/image/image_codec.h"
#include "tests/support/image_compare.h"
#include "tests/support/sample_window.h"
#include "tests/support/test_window.h"
#include "ui/panels/live_panels.h"
#include "ui/screens/screens.h"

namespace posecoach {
namespace {

constexpr ImageTolerance kScreenTolerance = {150, 0.3, 14, 0.004};

Image drawn(SampleWindow window, const Theme& theme, int width = 1280, int height = 720, double scale = 1) {
  TestWindow screen(width, height, scale);
  Intents intents;
  for (int i = 0; i < 3; ++i)
    screen.frame(theme, [&](Ui& ui) { draw_window({ui, window.model, window.state, intents}, ui.whole()); });
  return screen.picture();
}

const Theme kDark = make_theme(ThemeKind::Dark, Palette::RedGreen);
const Theme kLight = make_theme(ThemeKind::Light, Palette::RedGreen);
const Theme kSafe = make_theme(ThemeKind::Dark, Palette::ColourBlindSafe);

SampleWindow on_screen(SampleWindow window, ScreenName screen) {
  window.state.screen = screen;
  return window;
}

SampleWindow quiet(SampleWindow window) {
  window.model.toasts.clear();
  window.model.jobs.clear();
  return window;
}

SampleWindow live(LoopState loop) {
  SampleWindow window = quiet(normal_window());
  CoachSnapshot snapshot = sample_snapshot(loop);
  if (loop != LoopState::Off) snapshot.checks[3] = {SetUpTopic::View, SetUpLevel::Good, ""};
  if (loop != LoopState::Off) snapshot.checks[4] = {SetUpTopic::Distance, SetUpLevel::Good, ""};
  window.model.snapshot = std::make_shared<const CoachSnapshot>(snapshot);
  window.state.replay.frame = 40;
  return window;
}

TEST(Screens, live_states) {
  EXPECT_TRUE(matches_golden(drawn(live(LoopState::Off), kDark), "screen_live_off", kScreenTolerance));
  EXPECT_TRUE(matches_golden(drawn(live(LoopState::Armed), kDark), "screen_live_armed", kScreenTolerance));
  EXPECT_TRUE(
      matches_golden(drawn(live(LoopState::Ready), kSafe), "screen_live_ready_safe", kScreenTolerance));
  EXPECT_TRUE(matches_golden(drawn(live(LoopState::Replay), kDark), "screen_live_replay", kScreenTolerance));
}

TEST(Screens, who_has_no_swing_yet_is_told_how_to_begin) {
  SampleWindow window = live(LoopState::Off);
  window.model.swings.clear();
  window.model.is_simulated = true;
  window.model.cameras.erase(window.model.cameras.begin());
  CoachSnapshot snapshot = *window.model.snapshot;
  snapshot.checks.resize(3);
  snapshot.address_advice.clear();
  window.model.snapshot = std::make_shared<const CoachSnapshot>(snapshot);
  EXPECT_TRUE(matches_golden(drawn(window, kDark), "screen_live_first", kScreenTolerance));
  EXPECT_TRUE(shows_first_steps(window.model, window.state));
  snapshot.loop = LoopState::Armed;
  window.model.snapshot = std::make_shared<const CoachSnapshot>(snapshot);
  EXPECT_FALSE(shows_first_steps(window.model, window.state));
}

TEST(Screens, live_while_measuring_and_when_the_camera_is_lost) {
  SampleWindow window = live(LoopState::Off);
  CoachSnapshot snapshot = *window.model.snapshot;
  snapshot.measuring =
      Measuring{Measuring::Stage::CountDown, 2.3, "Stand upright, arms a little away from your body."};
  window.model.snapshot = std::make_shared<const CoachSnapshot>(snapshot);
  window.model.is_simulated = true;
  EXPECT_TRUE(matches_golden(drawn(window, kDark), "screen_live_measuring", kScreenTolerance));
  snapshot.measuring.reset();
  snapshot.source_state = SourceState::Lost;
  snapshot.source_message = "HD Pro Webcam C920 was unplugged. Plug it in again: it will be used by itself.";
  window.model.snapshot = std::make_shared<const CoachSnapshot>(snapshot);
  window.model.is_simulated = false;
  EXPECT_TRUE(matches_golden(drawn(window, kDark), "screen_live_lost", kScreenTolerance));
}

TEST(Screens, a_film_that_was_damaged_says_so_when_it_is_over) {
  SampleWindow window = live(LoopState::Off);
  window.model.source = "/home/anna/Videos/driver 12 May.mp4";
  CoachSnapshot snapshot = *window.model.snapshot;
  snapshot.source_state = SourceState::Ended;
  window.model.snapshot = std::make_shared<const CoachSnapshot>(snapshot);
  const Image whole = drawn(window, kDark);
  snapshot.source_message =
      "driver 12 May.mp4 is cut off: 57 of 120 pictures could be read. Copy it from where it was recorded "
      "once "
      "more, or choose another film.";
  window.model.snapshot = std::make_shared<const CoachSnapshot>(snapshot);
  const Image damaged = drawn(window, kDark);
  EXPECT_GT(image_difference(whole, damaged, 40).outlier_fraction, 0.001);
  EXPECT_TRUE(matches_golden(damaged, "screen_live_damaged_film", kScreenTolerance));
}

TEST(Screens, review_in_every_look) {
  const SampleWindow window = quiet(on_screen(normal_window(), ScreenName::Review));
  EXPECT_TRUE(matches_golden(drawn(window, kDark), "screen_review_dark", kScreenTolerance));
  EXPECT_TRUE(matches_golden(drawn(window, kLight), "screen_review_light", kScreenTolerance));
  EXPECT_TRUE(matches_golden(drawn(window, kSafe), "screen_review_safe", kScreenTolerance));
}

TEST(Screens, review_of_two_swings) {
  SampleWindow window = quiet(on_screen(normal_window(), ScreenName::Review));
  window.model.compared = window.model.opened;
  window.model.compared->title = "Swing 12";
  window.model.compared->review = second_review();
  window.model.compared->picture = [](int wanted) -> std::optional<ShownPicture> {
    return ShownPicture{wanted, *second_review()->swing->pictures->picture(static_cast<std::size_t>(wanted))};
  };
  EXPECT_TRUE(matches_golden(drawn(window, kDark), "screen_review_side_by_side", kScreenTolerance));
  window.state.compare = CompareLook::Superposed;
  EXPECT_TRUE(matches_golden(drawn(window, kDark), "screen_review_superposed", kScreenTolerance));
}

// Bodies and picture are those of the moment that is seen; the sign names the one that is wanted.
TEST(Screens, review_says_when_the_wanted_picture_is_still_being_fetched) {
  SampleWindow window = quiet(on_screen(normal_window(), ScreenName::Review));
  window.model.opened->marks = {};
  const PictureLookup all = window.model.opened->picture;
  double waited_s = 0.1;
  window.model.opened->picture = [&](int wanted) {
    std::optional<ShownPicture> shown = all(wanted - 9);
    shown->waited_s = waited_s;
    return shown;
  };
  const Image patient = drawn(window, kDark);
  waited_s = 0.4;
  const Image waiting = drawn(window, kDark);
  EXPECT_GT(image_difference(patient, waiting, 40).outlier_fraction, 0.001);
  EXPECT_TRUE(matches_golden(waiting, "screen_review_waiting", kScreenTolerance));
}

TEST(Screens, review_says_which_picture_of_a_damaged_film_cannot_be_read) {
  SampleWindow window = quiet(on_screen(normal_window(), ScreenName::Review));
  window.model.opened->marks = {};
  const PictureLookup all = window.model.opened->picture;
  window.model.opened->picture = [&](int wanted) {
    std::optional<ShownPicture> shown = all(wanted - 9);
    shown->is_wanted_unreadable = true;
    return shown;
  };
  EXPECT_TRUE(matches_golden(drawn(window, kDark), "screen_review_unreadable", kScreenTolerance));
}

// A left-hander beside a right-hander is seen in a mirror, so that both swing the same way.
TEST(Screens, swings_of_both_hands_are_compared_in_a_mirror) {
  SampleWindow window = quiet(on_screen(normal_window(), ScreenName::Review));
  auto left_handed = std::make_shared<AnalyzedSwing>(*sample_review()->swing);
  left_handed->pair.analysis.student.hand = Handedness::Left;
  window.model.compared = window.model.opened;
  window.model.compared->review = make_review_swing(left_handed);
  window.model.opened->marks = {};
  window.state.figures = FigureShow::None;
  const Image both = drawn(window, kDark);
  // The golfer's blue shirt, left and right of the middle between the films.
  const auto columns_of_shirt = [&](int begin, int end) {
    std::vector<int> columns;
    for (int x = begin; x < end; ++x)
      for (int y = 110; y < 330; ++y) {
        const std::uint8_t* const pixel = both.pixel(x, y);
        if (pixel[2] > 90 && pixel[2] > 2 * pixel[0] && pixel[2] > pixel[1] + 40)
          columns.push_back(x - begin);
      }
    return columns;
  };
  const auto mean = [](const std::vector<int>& columns) {
    return std::accumulate(columns.begin(), columns.end(), 0.0) / static_cast<double>(columns.size());
  };
  const std::vector<int> first = columns_of_shirt(98, 526), second = columns_of_shirt(534, 962);
  ASSERT_GT(first.size(), 300U);
  ASSERT_NEAR(static_cast<double>(first.size()), static_cast<double>(second.size()),
              0.1 * static_cast<double>(first.size()));
  EXPECT_NEAR(mean(first) + mean(second), 427, 6);
}

TEST(Screens, library_and_set_up) {
  EXPECT_TRUE(matches_golden(drawn(on_screen(normal_window(), ScreenName::Library), kDark),
                             "screen_library_dark", kScreenTolerance));
  EXPECT_TRUE(matches_golden(drawn(quiet(on_screen(normal_window(), ScreenName::Library)), kLight),
                             "screen_library_light", kScreenTolerance));
  EXPECT_TRUE(matches_golden(drawn(quiet(on_screen(normal_window(), ScreenName::SetUp)), kDark),
                             "screen_set_up_dark", kScreenTolerance));
  EXPECT_TRUE(matches_golden(drawn(quiet(on_screen(normal_window(), ScreenName::SetUp)), kLight),
                             "screen_set_up_light", kScreenTolerance));
}

TEST(Screens, empty_screens_say_what_to_do) {
  for (const auto& [name, screen] :
       {std::pair("live", ScreenName::Live), std::pair("review", ScreenName::Review),
        std::pair("library", ScreenName::Library), std::pair("set_up", ScreenName::SetUp)})
    EXPECT_TRUE(matches_golden(drawn(on_screen(empty_window(), screen), kDark),
                               std::string("screen_empty_") + name, kScreenTolerance));
}

// On a 4K screen everything is three times as fine, and in the same place.
TEST(Screens, four_k_looks_as_at_its_normal_size) {
  for (const ScreenName screen :
       {ScreenName::Live, ScreenName::Review, ScreenName::Library, ScreenName::SetUp}) {
    const SampleWindow window = quiet(on_screen(normal_window(), screen));
    const Image small = drawn(window, kDark), large = drawn(window, kDark, 1280, 720, 3);
    ASSERT_EQ(large.width, 3840);
    EXPECT_LT(image_difference(resized(large, 1280, 720), small, 40).outlier_fraction, 0.05);
  }
}

TEST(Screens, any_window_size_draws) {
  for (const auto& [width, height] :
       {std::pair(640, 360), std::pair(200, 900), std::pair(3840, 2160), std::pair(1, 1)})
    for (const ScreenName screen :
         {ScreenName::Live, ScreenName::Review, ScreenName::Library, ScreenName::SetUp})
      EXPECT_EQ(drawn(on_screen(extreme_window(), screen), kLight, width, height).width, width);
}

}  // namespace
}  // namespace posecoach
