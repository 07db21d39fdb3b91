#include "ui/review/film_zoom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

namespace posecoach {
namespace {

constexpr Rect kArea{100, 50, 600, 400};
constexpr double kWidth = 1920, kHeight = 1080;

TEST(FilmZoom, the_whole_film_lies_in_the_middle_of_its_area) {
  const FilmPlace place = place_film(kArea, kWidth, kHeight, {});
  EXPECT_NEAR(place.whole.width, 600, 1e-9);
  EXPECT_NEAR(place.whole.height, 337.5, 1e-9);
  EXPECT_NEAR(place.whole.centre().y, kArea.centre().y, 1e-9);
}

TEST(FilmZoom, screen_and_film_are_each_others_inverse) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 200; ++round) {
    const FilmZoom zoom{1 + 7 * unit(random), {unit(random), unit(random)}};
    const FilmPlace place = place_film(kArea, kWidth, kHeight, zoom, round % 2 == 0);
    const Vec2 px(kWidth * unit(random), kHeight * unit(random));
    EXPECT_LT(glm::distance(place.film_from_screen(place.screen_from_film(px)), px), 1e-6);
  }
}

TEST(FilmZoom, a_mirrored_film_shows_its_right_at_the_left) {
  const FilmPlace place = place_film(kArea, kWidth, kHeight, {}, true);
  EXPECT_NEAR(place.screen_from_film({kWidth, 0}).x, kArea.x, 1e-9);
}

TEST(FilmZoom, the_point_under_the_pointer_stays_while_there_is_film_around_it) {
  const FilmZoom from{3, {0.5, 0.5}};
  const FilmPlace place = place_film(kArea, kWidth, kHeight, from);
  const Vec2 about(320, 260), px = place.film_from_screen(about);
  const FilmPlace larger = place_film(kArea, kWidth, kHeight, zoomed(from, 1.4, about, place));
  EXPECT_LT(glm::distance(larger.screen_from_film(px), about), 1e-6);
  EXPECT_NEAR(larger.whole.width / place.whole.width, 1.4, 1e-9);
}

TEST(FilmZoom, no_gap_ever_opens_beside_a_film_that_is_larger_than_its_area) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> by(-300, 300), factor(0.6, 1.7);
  FilmZoom zoom;
  for (int round = 0; round < 500; ++round) {
    const FilmPlace place = place_film(kArea, kWidth, kHeight, zoom);
    zoom = round % 2 == 0 ? panned(zoom, {by(random), by(random)}, place)
                          : zoomed(zoom, factor(random), {400 + by(random), 250}, place);
    const FilmPlace now = place_film(kArea, kWidth, kHeight, zoom);
    EXPECT_GE(zoom.factor, 1);
    EXPECT_LE(zoom.factor, kLargestZoom);
    if (now.whole.width >= kArea.width) {
      EXPECT_LE(now.whole.x, kArea.x + 1e-6);
      EXPECT_GE(now.whole.right(), kArea.right() - 1e-6);
    }
    if (now.whole.height >= kArea.height) {
      EXPECT_LE(now.whole.y, kArea.y + 1e-6);
      EXPECT_GE(now.whole.bottom(), kArea.bottom() - 1e-6);
    }
  }
}

TEST(FilmZoom, a_part_of_the_film_is_as_large_as_it_fits) {
  const Vec2 from(800, 300), to(1100, 900);
  const FilmZoom zoom = zoom_on(from, to, kArea, kWidth, kHeight);
  const FilmPlace place = place_film(kArea, kWidth, kHeight, zoom);
  EXPECT_NEAR(place.screen_from_film(from).y, kArea.y, 1e-6);
  EXPECT_NEAR(place.screen_from_film(to).y, kArea.bottom(), 1e-6);
  EXPECT_GT(place.screen_from_film(from).x, kArea.x);
  EXPECT_LT(place.screen_from_film(to).x, kArea.right());
  // Who fills the film, and nothing at all, leave it whole.
  EXPECT_EQ(zoom_on({-50, -50}, {kWidth + 50, kHeight + 50}, kArea, kWidth, kHeight).factor, 1);
  EXPECT_EQ(zoom_on(from, from, kArea, kWidth, kHeight), FilmZoom());
}

TEST(FilmZoom, what_is_seen_of_the_film_is_what_lies_on_the_area) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 100; ++round) {
    const FilmZoom zoom{1 + 7 * unit(random), {unit(random), unit(random)}};
    const FilmPlace place = place_film(kArea, kWidth, kHeight, zoom, round % 2 == 0);
    const SeenFilm seen = seen_film(place);
    const Vec2 begin = seen.part.begin * Vec2(kWidth, kHeight), end = seen.part.end * Vec2(kWidth, kHeight);
    const Vec2 a = place.screen_from_film(begin), b = place.screen_from_film(end);
    EXPECT_NEAR(std::min(a.x, b.x), seen.on_screen.x, 1e-6);
    EXPECT_NEAR(std::max(a.x, b.x), seen.on_screen.right(), 1e-6);
    EXPECT_NEAR(a.y, seen.on_screen.y, 1e-6);
    EXPECT_NEAR(b.y, seen.on_screen.bottom(), 1e-6);
  }
}

}  // namespace
}  // namespace posecoach
