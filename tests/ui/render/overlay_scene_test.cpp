#include "ui/render/overlay_scene.h"

#include <gtest/gtest.h>

#include "core/body/standard_body.h"
#include "tests/support/compared_motions.h"
#include "tests/support/image_compare.h"
#include "tests/support/offscreen.h"
#include "ui/render/words.h"

namespace posecoach {
namespace {

std::string all_text(const Scene& scene) {
  std::string text;
  for (const Flat& flat : scene.flats)
    if (flat.text) text += flat.text->utf8 + "\n";
  return text;
}

PinholeCamera camera_of(int width, int height) {
  return make_camera_looking_at({0.4, 1.2, 3.6}, {0, 0.85, 0}, 0.62, width, height);
}

TEST(OverlayScene, says_score_phase_distance_and_who_is_who) {
  const ComparedMotions motions = make_compared_motions();
  OverlayMoment moment;
  moment.phase = "Backswing";
  moment.time_s = 1.234;
  moment.apart_m = 0.063;
  const Scene scene = make_overlay_scene(make_overlay_story(motions.analysis, Palette::RedGreen), moment,
                                         camera_of(1280, 720));
  const std::string text = all_text(scene);
  for (const char* words :
       {"81", "Overall match", "6.3 cm apart now", "Backswing", "1.23 s", "You", "Coach in your body"})
    EXPECT_NE(text.find(words), std::string::npos) << words;
  EXPECT_TRUE(scene.figures.empty());
}

TEST(OverlayScene, text_stays_inside_pictures_of_any_size) {
  const ComparedMotions motions = make_compared_motions();
  OverlayMoment moment;
  moment.phase = "Mid follow-through";
  moment.apart_m = 0.5;
  for (const auto& [width, height] : {std::pair(354, 492), std::pair(640, 360), std::pair(1280, 720),
                                      std::pair(1080, 1920), std::pair(3840, 2160)}) {
    const Scene scene = make_overlay_scene(make_overlay_story(motions.analysis, Palette::RedGreen), moment,
                                           camera_of(width, height));
    for (const Flat& flat : scene.flats) {
      if (!flat.text) continue;
      const Text& text = *flat.text;
      const double text_width = text_width_px(text.utf8, text.weight, text.size_px);
      const double left = text.baseline.x - (text.align == Align::Left     ? 0
                                             : text.align == Align::Centre ? 0.5
                                                                           : 1) *
                                                text_width;
      EXPECT_GE(left, 0) << width << ' ' << text.utf8;
      EXPECT_LE(left + text_width, width) << width << ' ' << text.utf8;
      EXPECT_GE(text.baseline.y - text.size_px, 0) << width << ' ' << text.utf8;
      EXPECT_LE(text.baseline.y, height) << width << ' ' << text.utf8;
      EXPECT_GE(text.size_px, 8) << width << ' ' << text.utf8;
    }
  }
}

TEST(OverlayScene, long_paths_are_thinned_and_keep_their_ends) {
  ComparedMotions motions = make_compared_motions();
  motions.analysis.path.clear();
  for (int i = 0; i < 5000; ++i) motions.analysis.path.emplace_back(i, i / 2);
  motions.analysis.student.frames = 5000;
  motions.analysis.coach.frames = 2500;
  const OverlayStory story = make_overlay_story(motions.analysis, Palette::RedGreen);
  EXPECT_LE(story.links.size(), 60U);
  EXPECT_EQ(story.links.front().first, 0);
  EXPECT_EQ(story.links.back().first, 1);
}

TEST(OverlayScene, empty_analysis_and_empty_moment_still_make_a_picture) {
  const Scene scene =
      make_overlay_scene(make_overlay_story(Analysis{}, Palette::ColourBlindSafe), {}, camera_of(320, 240));
  EXPECT_EQ(render_image(scene, camera_of(320, 240)).width, 320);
}

TEST(OverlayScene, scaled_camera_projects_to_scaled_pixels) {
  const PinholeCamera camera = camera_of(640, 360);
  const PinholeCamera larger = scaled_to(camera, 1920, 1080);
  const Vec2 small = camera.project({0.3, 1.1, 0.2}).value(), large = larger.project({0.3, 1.1, 0.2}).value();
  EXPECT_NEAR(large.x, 3 * small.x, 1e-9);
  EXPECT_NEAR(large.y, 3 * small.y, 1e-9);
}

// Over a bright and a dark plain film.
TEST(OverlayScene, golden_overlay) {
  const ComparedMotions motions = make_compared_motions();
  for (const auto& [name, shade] : {std::pair("overlay_bright", 225), std::pair("overlay_dark", 28)}) {
    auto film = std::make_shared<Image>(Image::black(256, 256));
    std::fill(film->rgb.begin(), film->rgb.end(), static_cast<std::uint8_t>(shade));
    OverlayMoment moment;
    moment.film = film;
    moment.student.emplace(BodyState{motions.student.skeleton(), motions.student.positions(12)});
    moment.coach.emplace(BodyState{motions.coach.skeleton(), motions.coach.positions(22)});
    moment.student_fraction = 0.2;
    moment.coach_fraction = 0.35;
    moment.phase = "Backswing";
    moment.time_s = 0.4;
    moment.apart_m = 0.083;
    const PinholeCamera camera = camera_of(256, 256);
    const Scene scene =
        make_overlay_scene(make_overlay_story(motions.analysis, Palette::RedGreen), moment, camera);
    EXPECT_TRUE(matches_golden(render_image(scene, camera), name));
  }
}

TEST(Words, names_become_titles) {
  EXPECT_EQ(title_from_name("left_elbow"), "Left elbow");
  EXPECT_EQ(title_from_name("mid_follow_through"), "Mid follow-through");
  EXPECT_EQ(title_from_name("toe_up"), "Toe-up");
  EXPECT_EQ(title_from_name(""), "");
}

TEST(Words, phases_lie_between_events) {
  const std::vector<SwingEvent> events = {
      {"address", 10, 0}, {"top", 40, 0}, {"impact", 50, 0}, {"finish", 80, 0}};
  EXPECT_EQ(phase_title(events, 2, 1), "Before the swing");
  EXPECT_EQ(phase_title(events, 25, 1), "Backswing");
  EXPECT_EQ(phase_title(events, 41, 1), "Top");
  EXPECT_EQ(phase_title(events, 45, 1), "Downswing");
  EXPECT_EQ(phase_title(events, 60, 1), "Follow-through");
  EXPECT_EQ(phase_title(events, 99, 1), "After the swing");
  EXPECT_EQ(phase_title({}, 5, 1), "");
}

TEST(Words, numbers_have_a_point_and_no_minus_before_zero) {
  EXPECT_EQ(decimal(-0.04, 1), "0.0");
  EXPECT_EQ(decimal(1234.56, 1), "1234.6");
  EXPECT_EQ(decimal(std::nan(""), 1), "–");
}

TEST(Words, sources_are_short) {
  EXPECT_EQ(short_source("/home/anna/Videos/swing.mp4"), "swing.mp4");
  EXPECT_EQ(short_source("pictures/"), "pictures");
  EXPECT_EQ(short_source("bundled:swing"), "the bundled swing");
}

}  // namespace
}  // namespace posecoach
