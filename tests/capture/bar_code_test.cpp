#include "capture/bar_code.h"

#include <gtest/gtest.h>

#include <random>

namespace posecoach {
namespace {

Image grey(int width, int height) {
  Image image = Image::black(width, height);
  std::fill(image.rgb.begin(), image.rgb.end(), std::uint8_t{128});
  return image;
}

TEST(BarCode, reads_back_what_was_written_at_any_size) {
  std::mt19937 random(3);
  std::uniform_int_distribution<std::uint32_t> number(0, kLargestBarCode);
  for (const auto& [width, height] :
       {std::pair(1280, 720), std::pair(720, 1280), std::pair(640, 360), std::pair(321, 241)})
    for (int round = 0; round < 50; ++round) {
      Image image = grey(width, height);
      const std::uint32_t written = round == 0 ? 0 : round == 1 ? kLargestBarCode : number(random);
      write_bar_code(image, written);
      ASSERT_EQ(read_bar_code(image), written) << width << "x" << height;
    }
}

TEST(BarCode, survives_noise_and_dull_contrast) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, 25);
  for (std::uint32_t number = 0; number < 20; ++number) {
    Image image = grey(640, 360);
    write_bar_code(image, number * 17231);
    for (std::uint8_t& value : image.rgb)
      value = static_cast<std::uint8_t>(std::clamp(60 + 0.5 * value + noise(random), 0.0, 255.0));
    ASSERT_EQ(read_bar_code(image), number * 17231 % (kLargestBarCode + 1));
  }
}

TEST(BarCode, picture_without_one_has_none) {
  EXPECT_FALSE(read_bar_code(grey(640, 360)));
  EXPECT_FALSE(read_bar_code(Image::black(640, 360)));
  EXPECT_FALSE(read_bar_code(Image{}));
  EXPECT_FALSE(read_bar_code(Image::black(64, 64)));
  std::mt19937 random(5);
  std::uniform_int_distribution<int> byte(0, 255);
  int found = 0;
  for (int round = 0; round < 100; ++round) {
    Image image = Image::black(320, 240);
    for (std::uint8_t& value : image.rgb) value = static_cast<std::uint8_t>(byte(random));
    found += read_bar_code(image) ? 1 : 0;
  }
  EXPECT_EQ(found, 0);
}

TEST(BarCode, damaged_cell_is_noticed) {
  int noticed = 0, cells = 0;
  for (int row = 0; row < 2; ++row)
    for (int column = 2; column < 14; ++column, ++cells) {
      Image image = grey(600, 600);  // cells of ten pixels
      write_bar_code(image, 123456);
      for (int y = 10 * (row + 1); y < 10 * (row + 2); ++y)
        for (int x = 10 * (column + 1); x < 10 * (column + 2); ++x)
          for (int c = 0; c < 3; ++c)
            image.pixel(x, y)[c] = static_cast<std::uint8_t>(255 - image.pixel(x, y)[c]);
      noticed += read_bar_code(image) == 123456U ? 0 : read_bar_code(image) ? 0 : 1;
    }
  EXPECT_EQ(noticed, cells);
}

}  // namespace
}  // namespace posecoach
