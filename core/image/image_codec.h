// Pictures as files: PNG and JPEG, in and out of memory.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/image/frame.h"

namespace posecoach {

// Asserts a picture that is not empty.
std::string encode_png(const Image& image);
// `quality` in [1, 100].
std::string encode_jpeg(const Image& image, int quality = 88);

// Any format that OpenCV reads, turned upright as the file says. `name` is for the message. Errors:
// Malformed.
Result<Image> decode_image(std::string_view bytes, std::string_view name);

Result<Image> read_image(const std::filesystem::path& path);
Result<void> write_png(const std::filesystem::path& path, const Image& image);

// The picture in another size: averaged when it shrinks, interpolated when it grows.
Image resized(const Image& image, int width, int height);

}  // namespace posecoach
