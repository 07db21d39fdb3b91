#include "core/image/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace posecoach {
namespace {

Image make_noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image image = Image::black(width, height);
  for (auto& value : image.rgb) value = static_cast<std::uint8_t>(random() & 255U);
  return image;
}

std::vector<float> sample(const Image& image, const CropSquare& square, int size,
                          OutsidePicture outside = OutsidePicture::RepeatsTheEdge, ValueRange range = {}) {
  std::vector<float> out(3 * static_cast<std::size_t>(size * size));
  sample_square(image, square, size, outside, range, out);
  return out;
}

// The definition, written down plainly: four neighbours with clamped indices.
double expected_value(const Image& image, const Vec2& at_px, int channel) {
  const double x = at_px.x - 0.5;
  const double y = at_px.y - 0.5;
  const double left = std::floor(x);
  const double top = std::floor(y);
  double sum = 0;
  for (int dy = 0; dy < 2; ++dy)
    for (int dx = 0; dx < 2; ++dx) {
      const double weight = (dx == 1 ? x - left : 1 - (x - left)) * (dy == 1 ? y - top : 1 - (y - top));
      const int column = std::clamp(static_cast<int>(left) + dx, 0, image.width - 1);
      const int row = std::clamp(static_cast<int>(top) + dy, 0, image.height - 1);
      sum += weight * image.pixel(column, row)[channel];
    }
  return sum;
}

TEST(Sampling, a_square_of_the_pictures_own_pixels_gives_them_back) {
  const Image image = make_noise(16, 16, 1);
  const auto out = sample(image, {{0, 0}, {16, 0}, {0, 16}}, 16);
  for (std::size_t i = 0; i < out.size(); ++i) EXPECT_EQ(out[i], static_cast<float>(image.rgb[i]));
}

TEST(Sampling, any_square_equals_the_mean_of_four_clamped_neighbours) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-30, 60);
  std::uniform_real_distribution<double> side(-40, 40);
  for (const auto& [width, height] : {std::pair{31, 17}, {1, 9}, {9, 1}, {1, 1}, {2, 2}}) {
    const Image image = make_noise(width, height, 3);
    for (int round = 0; round < 40; ++round) {
      const CropSquare square{
          {place(random), place(random)}, {side(random), side(random)}, {side(random), side(random)}};
      constexpr int kSize = 7;
      const auto out = sample(image, square, kSize);
      for (int j = 0; j < kSize; ++j)
        for (int i = 0; i < kSize; ++i)
          for (int channel = 0; channel < 3; ++channel)
            ASSERT_NEAR(out[static_cast<std::size_t>(3 * (j * kSize + i) + channel)],
                        expected_value(image, square.at({(i + 0.5) / kSize, (j + 0.5) / kSize}), channel),
                        1e-3);
    }
  }
}

TEST(Sampling, black_begins_exactly_at_the_pictures_border) {
  Image image = make_noise(4, 4, 4);
  std::fill(image.rgb.begin(), image.rgb.end(), std::uint8_t{200});
  // Centres at -1.5, -0.5, 0.5, ...: two columns outside on either side.
  const auto out = sample(image, {{-2, -2}, {8, 0}, {0, 8}}, 8, OutsidePicture::IsBlack);
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) {
      const bool inside = i >= 2 && i < 6 && j >= 2 && j < 6;
      EXPECT_EQ(out[static_cast<std::size_t>(3 * (8 * j + i))], inside ? 200.0F : 0.0F);
    }
}

TEST(Sampling, values_are_scaled_after_black_was_filled_in) {
  Image image = Image::black(2, 2);
  std::fill(image.rgb.begin(), image.rgb.end(), std::uint8_t{255});
  const auto out =
      sample(image, {{-2, 0}, {4, 0}, {0, 4}}, 2, OutsidePicture::IsBlack, {2.0F / 255.0F, -1.0F});
  EXPECT_FLOAT_EQ(out[0], -1);
  EXPECT_FLOAT_EQ(out[3], 1);
}

}  // namespace
}  // namespace posecoach
