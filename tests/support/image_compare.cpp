#include "tests/support/image_compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/base/assert.h"
#include "core/image/image_codec.h"

namespace posecoach {
namespace {

const std::filesystem::path kGoldenFolder = POSECOACH_GOLDEN_FOLDER;
const std::filesystem::path kPictureFolder = POSECOACH_TEST_PICTURE_FOLDER;

int pixel_difference(const std::uint8_t* a, const std::uint8_t* b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

// Four times the difference, on black.
Image difference_picture(const Image& a, const Image& b) {
  Image picture = Image::black(a.width, a.height);
  for (std::size_t i = 0; i < a.rgb.size(); ++i)
    picture.rgb[i] = static_cast<std::uint8_t>(std::min(255, 4 * std::abs(a.rgb[i] - b.rgb[i])));
  return picture;
}

}  // namespace

ImageDifference image_difference(const Image& a, const Image& b, int outlier_difference) {
  POSECOACH_ASSERT(a.width == b.width && a.height == b.height && !a.empty());
  ImageDifference difference;
  double sum = 0, outliers = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const int d = pixel_difference(a.pixel(x, y), b.pixel(x, y));
      difference.max = std::max(difference.max, d);
      sum += d;
      if (d > outlier_difference) ++outliers;
    }
  const double pixels = static_cast<double>(a.width) * a.height;
  difference.mean = sum / pixels;
  difference.outlier_fraction = outliers / pixels;
  return difference;
}

testing::AssertionResult matches_golden(const Image& actual, const std::string& name,
                                        const ImageTolerance& tolerance) {
  const std::filesystem::path golden_path = kGoldenFolder / (name + ".png");
  if (const char* update = std::getenv("POSECOACH_UPDATE_GOLDEN"); update != nullptr && *update == '1') {
    std::filesystem::create_directories(kGoldenFolder);
    const Result<void> written = write_png(golden_path, actual);
    if (!written) return testing::AssertionFailure() << written.error().message;
    return testing::AssertionSuccess();
  }
  std::filesystem::create_directories(kPictureFolder);
  const std::filesystem::path actual_path = kPictureFolder / (name + ".actual.png");
  const Result<Image> golden = read_image(golden_path);
  const bool same_size = golden && golden->width == actual.width && golden->height == actual.height;
  if (!same_size) {
    (void)write_png(actual_path, actual);
    return testing::AssertionFailure()
           << (golden ? std::string("another size than the golden picture") : golden.error().message)
           << "; the picture is " << actual_path;
  }
  const ImageDifference d = image_difference(actual, *golden, tolerance.outlier_difference);
  if (d.max <= tolerance.max_difference && d.mean <= tolerance.mean_difference &&
      d.outlier_fraction <= tolerance.outlier_fraction)
    return testing::AssertionSuccess();
  (void)write_png(actual_path, actual);
  (void)write_png(kPictureFolder / (name + ".difference.png"), difference_picture(actual, *golden));
  return testing::AssertionFailure() << name << " differs from its golden picture: at most " << d.max
                                     << " (allowed " << tolerance.max_difference << "), " << d.mean
                                     << " in the mean (" << tolerance.mean_difference << "), "
                                     << 100 * d.outlier_fraction << " % outliers ("
                                     << 100 * tolerance.outlier_fraction << "); see " << actual_path;
}

}  // namespace posecoach
