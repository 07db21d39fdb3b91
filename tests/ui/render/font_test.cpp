#include "ui/render/font.h"

#include <gtest/gtest.h>

namespace posecoach {
namespace {

TEST(Font, width_is_proportional_to_size) {
  const double width = text_width_px("Top of the backswing", FontWeight::Medium, 20);
  EXPECT_GT(width, 150);
  EXPECT_NEAR(text_width_px("Top of the backswing", FontWeight::Medium, 60), 3 * width, 1e-3);
  EXPECT_GT(text_width_px("Top of the backswing", FontWeight::Bold, 20), width);
}

TEST(Font, pairs_are_kerned) {
  EXPECT_LT(text_width_px("AV", FontWeight::Medium, 100),
            text_width_px("A", FontWeight::Medium, 100) + text_width_px("V", FontWeight::Medium, 100) - 1);
}

TEST(Font, broken_utf8_is_laid_out_as_replacement_signs) {
  for (const std::string& text :
       {std::string("\xff\xfe"), std::string("a\xc3"), std::string("\xe2\x82"), std::string()})
    EXPECT_LE(lay_out(text, FontWeight::Medium, 20).size(), text.size());
  EXPECT_EQ(lay_out("\xff", FontWeight::Medium, 20).size(), 1U);
}

TEST(Font, shortened_text_fits_and_ends_with_an_ellipsis) {
  const std::string text = "/home/anna/Vidéos/träning/swing number twenty-one.mp4";
  for (double width = 10; width < 500; width += 7) {
    const std::string cut = shortened(text, FontWeight::Medium, 15, width);
    EXPECT_LE(text_width_px(cut, FontWeight::Medium, 15), width);
    if (!cut.empty() && cut != text) {
      EXPECT_EQ(cut.substr(cut.size() - 3), "…");
    }
  }
  EXPECT_EQ(shortened(text, FontWeight::Medium, 15, 2000), text);
}

}  // namespace
}  // namespace posecoach
