#include "capture/v4l2/jpeg.h"

#include <turbojpeg.h>

#include <cstring>
#include <string>
#include <utility>

#include "core/base/assert.h"

namespace posecoach {
namespace {

constexpr int kLargestSide = 8192;

bool is_harmless(const char* warning) {
  return std::strstr(warning, "extraneous bytes before marker") != nullptr;
}

}  // namespace

void JpegDecoder::Close::operator()(void* handle) const {
  tjDestroy(handle);
}
void JpegEncoder::Close::operator()(void* handle) const {
  tjDestroy(handle);
}

JpegDecoder::JpegDecoder() : handle_(tjInitDecompress()) {
  POSECOACH_ASSERT(handle_ != nullptr);
}

Result<Image> JpegDecoder::decode(std::span<const std::uint8_t> jpeg) {
  const auto damaged = [&] {
    // What is left of a damaged picture inside the library would spoil the next.
    const std::unique_ptr<void, Close> spoilt =
        std::exchange(handle_, std::unique_ptr<void, Close>(tjInitDecompress()));
    POSECOACH_ASSERT(handle_ != nullptr);
    return fail(ErrorCode::Malformed, std::string("a damaged JPEG picture: ") + tjGetErrorStr2(spoilt.get()));
  };
  int width = 0, height = 0, subsampling = 0, colours = 0;
  if (tjDecompressHeader3(handle_.get(), jpeg.data(), static_cast<unsigned long>(jpeg.size()), &width,
                          &height, &subsampling, &colours) != 0 &&
      tjGetErrorCode(handle_.get()) != TJERR_WARNING)
    return damaged();
  if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide)
    return fail(ErrorCode::Malformed,
                "a JPEG picture of " + std::to_string(width) + "x" + std::to_string(height) + " pixels");
  Image image = Image::black(width, height);
  if (tjDecompress2(handle_.get(), jpeg.data(), static_cast<unsigned long>(jpeg.size()), image.rgb.data(),
                    width, 0, height, TJPF_RGB, TJFLAG_FASTUPSAMPLE | TJFLAG_FASTDCT) != 0 &&
      !(tjGetErrorCode(handle_.get()) == TJERR_WARNING && is_harmless(tjGetErrorStr2(handle_.get()))))
    return damaged();
  return image;
}

JpegEncoder::JpegEncoder() : handle_(tjInitCompress()) {
  POSECOACH_ASSERT(handle_ != nullptr);
}

Bytes JpegEncoder::encode(const Image& image, int quality) {
  POSECOACH_ASSERT(!image.empty() && quality >= 1 && quality <= 100);
  scratch_.resize(tjBufSize(image.width, image.height, TJSAMP_420));
  std::uint8_t* out = scratch_.data();
  unsigned long size = static_cast<unsigned long>(scratch_.size());
  const int failed = tjCompress2(handle_.get(), image.rgb.data(), image.width, 0, image.height, TJPF_RGB,
                                 &out, &size, TJSAMP_420, quality, TJFLAG_NOREALLOC | TJFLAG_FASTDCT);
  POSECOACH_ASSERT(failed == 0);
  return {scratch_.begin(), scratch_.begin() + static_cast<std::ptrdiff_t>(size)};
}

}  // namespace posecoach
