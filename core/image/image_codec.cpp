#include "core/image/image_codec.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/assert.h"
#include "core/base/file.h"

namespace posecoach {
namespace {

cv::Mat bgr_from(const Image& image) {
  POSECOACH_ASSERT(!image.empty());
  // OpenCV has no view of constant memory; the conversion only reads it.
  const cv::Mat rgb(image.height, image.width, CV_8UC3, const_cast<std::uint8_t*>(image.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  return bgr;
}

std::string encode(const Image& image, const char* extension, const std::vector<int>& parameters) {
  std::vector<unsigned char> bytes;
  const bool encoded = cv::imencode(extension, bgr_from(image), bytes, parameters);
  POSECOACH_ASSERT(encoded);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string encode_png(const Image& image) {
  return encode(image, ".png", {cv::IMWRITE_PNG_COMPRESSION, 6});
}

std::string encode_jpeg(const Image& image, int quality) {
  POSECOACH_ASSERT(quality >= 1 && quality <= 100);
  return encode(image, ".jpg", {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_OPTIMIZE, 1});
}

Result<Image> decode_image(std::string_view bytes, std::string_view name) {
  cv::Mat bgr;
  try {
    if (!bytes.empty())
      bgr = cv::imdecode(cv::Mat(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data())),
                         cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {  // sizes beyond OpenCV's limits; same answer as any other damage
  }
  if (bgr.empty())
    return fail(ErrorCode::Malformed,
                std::string(name) + ": not a picture that can be read (PNG, JPEG, BMP, ...)");
  Image image = Image::black(bgr.cols, bgr.rows);
  cv::Mat rgb(image.height, image.width, CV_8UC3, image.rgb.data());
  cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  return image;
}

Result<Image> read_image(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_file(path);
  if (!bytes) return tl::unexpected(bytes.error());
  return decode_image(*bytes, path.string());
}

Result<void> write_png(const std::filesystem::path& path, const Image& image) {
  return write_file_atomically(path, encode_png(image));
}

Image resized(const Image& image, int width, int height) {
  POSECOACH_ASSERT(!image.empty() && width > 0 && height > 0);
  const cv::Mat from(image.height, image.width, CV_8UC3, const_cast<std::uint8_t*>(image.rgb.data()));
  Image result = Image::black(width, height);
  cv::Mat to(height, width, CV_8UC3, result.rgb.data());
  const bool shrinks = width < image.width && height < image.height;
  cv::resize(from, to, to.size(), 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  return result;
}

}  // namespace posecoach
