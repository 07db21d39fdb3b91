#include "core/image/image_codec.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace posecoach {
namespace {

Image smooth_picture(int width, int height) {
  Image image = Image::black(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.pixel(x, y)[0] = static_cast<std::uint8_t>(255 * x / width);
      image.pixel(x, y)[1] = static_cast<std::uint8_t>(255 * y / height);
      image.pixel(x, y)[2] = 40;
    }
  return image;
}

TEST(ImageCodec, png_gives_back_every_byte) {
  std::mt19937 random(7);
  Image noise = Image::black(37, 21);
  for (std::uint8_t& byte : noise.rgb) byte = static_cast<std::uint8_t>(random());
  const Result<Image> again = decode_image(encode_png(noise), "noise");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->width, 37);
  EXPECT_EQ(again->height, 21);
  EXPECT_EQ(again->rgb, noise.rgb);
}

TEST(ImageCodec, jpeg_keeps_colours_in_their_channels) {
  const Image picture = smooth_picture(64, 48);
  const Result<Image> again = decode_image(encode_jpeg(picture, 95), "picture");
  ASSERT_TRUE(again) << again.error().message;
  for (int y = 4; y < 44; y += 5)
    for (int x = 4; x < 60; x += 7)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(again->pixel(x, y)[c], picture.pixel(x, y)[c], 12) << x << ',' << y << ',' << c;
}

TEST(ImageCodec, damaged_bytes_are_an_error_with_the_name) {
  for (const std::string& bytes : {std::string(), std::string("not a picture"), std::string(5000, '\xff')}) {
    const Result<Image> image = decode_image(bytes, "holiday.png");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().code, ErrorCode::Malformed);
    EXPECT_NE(image.error().message.find("holiday.png"), std::string::npos);
  }
}

TEST(ImageCodec, shrinking_averages) {
  Image stripes = Image::black(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; x += 2)
      for (int c = 0; c < 3; ++c) stripes.pixel(x, y)[c] = 200;
  const Image small = resized(stripes, 16, 16);
  for (const std::uint8_t value : small.rgb) EXPECT_NEAR(value, 100, 1);
}

}  // namespace
}  // namespace posecoach
