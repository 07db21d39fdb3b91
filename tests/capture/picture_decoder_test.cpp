#include "capture/v4l2/picture_decoder.h"

#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "tests/capture/numbered_film.h"

namespace posecoach {
namespace {

using Colour = std::array<double, 3>;

AgreedFormat format_of(std::uint32_t pixel_format, int width, int height, std::size_t bytes_a_row) {
  AgreedFormat format;
  format.pixel_format = pixel_format;
  format.width = width;
  format.height = height;
  format.bytes_a_row = bytes_a_row;
  return format;
}

// ITU-R BT.601, 8 bits, 16 to 235: the textbook's direction, from RGB.
Colour yuv_of(const Colour& rgb) {
  const double y = 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
  return {16 + 219 * y / 255, 128 + 224 * (rgb[2] - y) / 1.772 / 255, 128 + 224 * (rgb[0] - y) / 1.402 / 255};
}

std::uint8_t byte(double value) {
  return static_cast<std::uint8_t>(std::lround(value));
}

// Columns of two pixels, each pair of one colour, so that halved colour loses nothing.
class DecoderTest : public testing::Test {
 protected:
  static constexpr int kWidth = 12, kHeight = 6;
  static constexpr std::size_t kStride = 64;

  Colour colour(int x, int y) const {
    const int pair = x / 2, row = y / 2;
    return {static_cast<double>((pair * 37 + row * 80) % 256), static_cast<double>((pair * 91 + 20) % 256),
            static_cast<double>((255 - pair * 40 + row * 11) % 256)};
  }
  void expect_picture(const Result<Image>& image, double tolerance) const {
    ASSERT_TRUE(image) << image.error().message;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_NEAR(image->pixel(x, y)[c], colour(x, y)[c], tolerance) << x << " " << y << " " << c;
  }
  Bytes filled(const std::function<void(int x, int y, std::uint8_t* row)>& put, int rows = kHeight) const {
    Bytes bytes(kStride * static_cast<std::size_t>(rows), 0xEE);  // the padding is no picture
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) put(x, y, &bytes[kStride * static_cast<std::size_t>(y)]);
    return bytes;
  }
};

TEST_F(DecoderTest, reads_every_raw_format_with_padded_rows) {
  const Bytes yuyv = filled([&](int x, int y, std::uint8_t* row) {
    const Colour yuv = yuv_of(colour(x, y));
    row[2 * x] = byte(yuv[0]);
    row[2 * x + 1] = byte(yuv[x % 2 == 0 ? 1 : 2]);
  });
  expect_picture(PictureDecoder(format_of(V4L2_PIX_FMT_YUYV, kWidth, kHeight, kStride)).decode(yuyv), 3);

  const Bytes uyvy = filled([&](int x, int y, std::uint8_t* row) {
    const Colour yuv = yuv_of(colour(x, y));
    row[2 * x + 1] = byte(yuv[0]);
    row[2 * x] = byte(yuv[x % 2 == 0 ? 1 : 2]);
  });
  expect_picture(PictureDecoder(format_of(V4L2_PIX_FMT_UYVY, kWidth, kHeight, kStride)).decode(uyvy), 3);

  Bytes nv12 = filled([&](int x, int y, std::uint8_t* row) { row[x] = byte(yuv_of(colour(x, y))[0]); },
                      kHeight * 3 / 2);
  for (int y = 0; y < kHeight; y += 2)
    for (int x = 0; x < kWidth; ++x)
      nv12[kStride * static_cast<std::size_t>(kHeight + y / 2) + static_cast<std::size_t>(x)] =
          byte(yuv_of(colour(x, y))[x % 2 == 0 ? 1 : 2]);
  expect_picture(PictureDecoder(format_of(V4L2_PIX_FMT_NV12, kWidth, kHeight, kStride)).decode(nv12), 3);

  const Bytes rgb = filled([&](int x, int y, std::uint8_t* row) {
    for (std::size_t c = 0; c < 3; ++c) row[3 * x + static_cast<int>(c)] = byte(colour(x, y)[c]);
  });
  expect_picture(PictureDecoder(format_of(V4L2_PIX_FMT_RGB24, kWidth, kHeight, kStride)).decode(rgb), 0);

  const Bytes bgr = filled([&](int x, int y, std::uint8_t* row) {
    for (std::size_t c = 0; c < 3; ++c) row[3 * x + 2 - static_cast<int>(c)] = byte(colour(x, y)[c]);
  });
  expect_picture(PictureDecoder(format_of(V4L2_PIX_FMT_BGR24, kWidth, kHeight, kStride)).decode(bgr), 0);
}

TEST_F(DecoderTest, black_and_white_are_so_in_both_ranges) {
  for (const bool is_full : {false, true}) {
    AgreedFormat format = format_of(V4L2_PIX_FMT_YUYV, 2, 1, 4);
    format.has_full_range = is_full;
    const Bytes bytes = {static_cast<std::uint8_t>(is_full ? 0 : 16), 128,
                         static_cast<std::uint8_t>(is_full ? 255 : 235), 128};
    const Image image = PictureDecoder(format).decode(bytes).value();
    EXPECT_EQ(image.rgb, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255})) << is_full;
  }
}

TEST_F(DecoderTest, a_picture_cut_short_is_refused_but_not_for_the_last_rows_padding) {
  PictureDecoder decoder(format_of(V4L2_PIX_FMT_RGB24, kWidth, kHeight, kStride));
  const std::size_t least = kStride * (kHeight - 1) + 3 * kWidth;
  EXPECT_TRUE(decoder.decode(Bytes(least, 1)));
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, least / 2, least - 1}) {
    const auto image = decoder.decode(Bytes(size, 1));
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().code, ErrorCode::Malformed);
  }
}

TEST(Jpeg, every_way_to_cut_one_short_is_refused_or_harmless) {
  JpegEncoder encoder;
  JpegDecoder decoder;
  const Image image = numbered_picture(320, 240, 7);
  const Bytes whole = encoder.encode(image, 80);
  ASSERT_TRUE(decoder.decode(whole));
  for (std::size_t size = 0; size + 2 < whole.size(); size += 1 + size / 40) {
    const auto cut = decoder.decode(std::span(whole).first(size));
    ASSERT_FALSE(cut) << size << " of " << whole.size();
    EXPECT_EQ(cut.error().code, ErrorCode::Malformed);
  }
  EXPECT_TRUE(decoder.decode(whole)) << "a damaged picture must not spoil the next";
}

TEST(Jpeg, damaged_bytes_never_do_harm) {
  JpegEncoder encoder;
  JpegDecoder decoder;
  const Bytes whole = encoder.encode(numbered_picture(320, 240, 7), 80);
  std::mt19937 random(11);
  for (int round = 0; round < 400; ++round) {
    Bytes damaged = whole;
    for (int i = 0; i < 8; ++i) damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
    const auto image = decoder.decode(damaged);
    EXPECT_TRUE(image || image.error().code == ErrorCode::Malformed);
  }
}

TEST(Jpeg, stray_bytes_and_padding_of_real_cameras_pass) {
  JpegEncoder encoder;
  JpegDecoder decoder;
  const Image image = numbered_picture(320, 240, 7);
  Bytes padded = encoder.encode(image, 80);
  padded.insert(padded.end(), 4096, 0);
  EXPECT_TRUE(decoder.decode(padded));
}

}  // namespace
}  // namespace posecoach
