#include "core/image/sampling.h"

#include <algorithm>
#include <cstring>

#include "core/base/assert.h"

namespace posecoach {
namespace {

// One pixel with a spare channel: GCC and Clang map these to vector registers on every processor.
using Float4 = float __attribute__((vector_size(16)));
using Byte4 = std::uint8_t __attribute__((vector_size(4)));

struct Tap {
  std::size_t byte = 0;  // of the upper left of the four neighbours
  float right = 0;       // weight of the right column
  float below = 0;       // weight of the lower row
  float inside = 1;      // 0 where black lies
};

Float4 load(const std::uint8_t* pixel) {
  Byte4 bytes;
  std::memcpy(&bytes, pixel, 4);
  return __builtin_convertvector(bytes, Float4);
}

// The picture's very last pixel has no byte behind it that could be read along.
Float4 load_last(const std::uint8_t* pixel) {
  return Float4{static_cast<float>(pixel[0]), static_cast<float>(pixel[1]), static_cast<float>(pixel[2]), 0};
}

class Sampler {
 public:
  Sampler(const Image& image, OutsidePicture outside)
      : image_(image),
        outside_(outside),
        row_bytes_(3 * static_cast<std::size_t>(image.width)),
        step_right_(image.width > 1 ? 3 : 0),
        step_below_(image.height > 1 ? row_bytes_ : 0),
        // A pixel whose lower right neighbour ends before this byte can be read four bytes at a time.
        last_wide_(image.rgb.size() - 4) {}

  Tap tap(const Vec2& at_px) const {
    Tap tap;
    // Clamping the coordinate is clamping the neighbours' indices.
    const double x = std::clamp(at_px.x - 0.5, 0.0, static_cast<double>(image_.width - 1));
    const double y = std::clamp(at_px.y - 0.5, 0.0, static_cast<double>(image_.height - 1));
    const int column = std::max(0, std::min(static_cast<int>(x), image_.width - 2));
    const int row = std::max(0, std::min(static_cast<int>(y), image_.height - 2));
    tap.byte = static_cast<std::size_t>(row) * row_bytes_ + 3 * static_cast<std::size_t>(column);
    tap.right = static_cast<float>(x - column);
    tap.below = static_cast<float>(y - row);
    if (outside_ == OutsidePicture::IsBlack)
      tap.inside = at_px.x >= 0 && at_px.x <= image_.width && at_px.y >= 0 && at_px.y <= image_.height;
    return tap;
  }

  Float4 value(const Tap& tap) const {
    const std::uint8_t* upper = image_.rgb.data() + tap.byte;
    const std::uint8_t* lower = upper + step_below_;
    const bool wide = tap.byte + step_below_ + step_right_ <= last_wide_ && image_.rgb.size() >= 4;
    const Float4 corner = wide ? load(lower + step_right_) : load_last(lower + step_right_);
    if (!wide) return mix(load_last(upper), load_last(upper + step_right_), load_last(lower), corner, tap);
    return mix(load(upper), load(upper + step_right_), load(lower), corner, tap);
  }

 private:
  static Float4 mix(Float4 a, Float4 b, Float4 c, Float4 d, const Tap& tap) {
    const Float4 upper = a + (b - a) * tap.right;
    const Float4 lower = c + (d - c) * tap.right;
    return (upper + (lower - upper) * tap.below) * tap.inside;
  }

  const Image& image_;
  OutsidePicture outside_;
  std::size_t row_bytes_;
  std::size_t step_right_;
  std::size_t step_below_;
  std::size_t last_wide_;
};

}  // namespace

void sample_square(const Image& image, const CropSquare& square, int size, OutsidePicture outside,
                   ValueRange range, std::span<float> out) {
  POSECOACH_ASSERT(!image.empty() && size > 0);
  POSECOACH_ASSERT(out.size() == 3 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  const Sampler sampler(image, outside);
  const Vec2 step = square.across_px / static_cast<double>(size);
  float* written = out.data();
  for (int j = 0; j < size; ++j) {
    const Vec2 start = square.at({0.5 / size, (j + 0.5) / size});
    for (int i = 0; i < size; ++i) {
      const Float4 value =
          sampler.value(sampler.tap(start + static_cast<double>(i) * step)) * range.scale + range.offset;
      written[0] = value[0];
      written[1] = value[1];
      written[2] = value[2];
      written += 3;
    }
  }
}

}  // namespace posecoach
