#include "core/motion/authored/golf_script.h"

#include <gtest/gtest.h>

#include "core/motion/bundled_motion.h"

namespace posecoach {
namespace {

constexpr std::string_view kScript = R"({
  "schema": "posecoach.golf_motion/1", "name": "swing",
  "club": {"head": "iron", "grip_to_head_m": 0.8, "grip_to_butt_m": 0.1},
  "stance": {"width_of_shoulders": 1, "lead_flare_deg": 1, "trail_flare_deg": 2, "knee_flex_deg": 3, "hips_back_cm": 4},
  "instants": [{"name": "address", "time_s": 0.5}, {"name": "top", "time_s": 1.5}, {"name": "impact", "time_s": 2}],
  "channels": {"pelvis_turn_deg": {"address": 0, "top": -40, "impact": 30}}})";

std::string with(std::string_view from, std::string_view to) {
  std::string text(kScript);
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(GolfScript, reads_values_at_instants) {
  const GolfScript script = GolfScript::parse(kScript, "a").value();
  EXPECT_NEAR(script.pose(1.5)[GolfChannel::PelvisTurn], -40, 1e-12);
  EXPECT_EQ(script.pose(1.5)[GolfChannel::ChestTurn], 0);
  EXPECT_EQ(script.duration_s(), 2);
}

TEST(GolfScript, stretching_a_part_moves_what_follows) {
  GolfScript script = GolfScript::parse(kScript, "a").value();
  script.stretch("address", "top", 1.5);
  EXPECT_NEAR(script.time_of("top"), 2.0, 1e-12);
  EXPECT_NEAR(script.time_of("impact"), 2.5, 1e-12);
  EXPECT_NEAR(script.pose(2.0)[GolfChannel::PelvisTurn], -40, 1e-12);
}

TEST(GolfScript, standing_first_puts_everything_off_and_changes_nothing) {
  for (const char* name : {"swing", "putt"}) {
    const GolfScript at_once = bundled_script(name).value();
    GolfScript later = at_once;
    later.stand_first(1.5);
    for (const GolfInstant& instant : at_once.instants())
      EXPECT_NEAR(later.time_of(instant.name), instant.time_s + 1.5, 1e-12) << instant.name;
    for (double time_s = 0; time_s < at_once.duration_s(); time_s += 0.05) {
      const GolfPose one = at_once.pose(time_s), other = later.pose(time_s + 1.5);
      for (std::size_t k = 0; k < kGolfChannelCount; ++k) EXPECT_NEAR(one.at(k), other.at(k), 1e-9) << time_s;
      EXPECT_EQ(later.pose(std::min(time_s, 1.5)), at_once.pose(0)) << time_s;
    }
  }
}

TEST(GolfScript, a_shorter_stroke_goes_a_part_of_its_way_in_the_same_time) {
  const GolfScript whole = bundled_script("putt").value();
  GolfScript half = whole;
  half.lengthen(0.5);
  const GolfPose address = whole.pose(whole.time_of("address"));
  for (const char* instant : {"address", "mid_backswing", "top", "impact", "end"}) {
    EXPECT_EQ(half.time_of(instant), whole.time_of(instant));
    const GolfPose one = whole.pose(whole.time_of(instant)), other = half.pose(half.time_of(instant));
    for (const GolfChannel channel :
         {GolfChannel::HandsAngle, GolfChannel::ChestTurn, GolfChannel::ClubAngle})
      EXPECT_NEAR(other[channel] - address[channel], 0.5 * (one[channel] - address[channel]), 1e-9)
          << instant;
    EXPECT_NEAR(other[GolfChannel::BallAim], one[GolfChannel::BallAim], 1e-12);
  }
}

TEST(GolfScript, added_curves_add_up) {
  GolfScript script = GolfScript::parse(kScript, "a").value();
  const std::vector<GolfScript::Offset> offsets = {{"address", 0}, {"top", -5}, {"impact", 0}};
  script.add(GolfChannel::PelvisTurn, offsets);
  EXPECT_NEAR(script.pose(1.5)[GolfChannel::PelvisTurn], -45, 1e-12);
  EXPECT_NEAR(script.pose(2)[GolfChannel::PelvisTurn], 30, 1e-12);
}

TEST(GolfScript, says_what_is_wrong) {
  const auto message = [](const std::string& text) {
    const auto script = GolfScript::parse(text, "my.json");
    EXPECT_FALSE(script);
    if (script) return std::string();
    EXPECT_EQ(script.error().code, ErrorCode::Malformed);
    EXPECT_EQ(script.error().message.find("my.json"), 0U);
    return script.error().message;
  };
  EXPECT_NE(message(with("pelvis_turn_deg", "pelvis_twist")).find("pelvis_twist"), std::string::npos);
  EXPECT_NE(message(with("\"top\": -40", "\"peak\": -40")).find("peak"), std::string::npos);
  EXPECT_NE(message(with("\"time_s\": 1.5", "\"time_s\": 0.1")).find("time does not increase"),
            std::string::npos);
  EXPECT_NE(message(with("golf_motion/1", "golf_motion/9")).find("schema"), std::string::npos);
  message("");
  message("{");
  message("[]");
}

}  // namespace
}  // namespace posecoach
