// JPEG pictures in memory, fast enough for every frame of a camera.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/image/frame.h"

namespace posecoach {

using Bytes = std::vector<std::uint8_t>;

// Each keeps its working memory from picture to picture; one thread at a time.
class JpegDecoder {
 public:
  JpegDecoder();
  // Error: Malformed (no JPEG, cut short, damaged, larger than 8192 pixels in a direction). Cameras' harmless
  // oddities pass: missing Huffman tables, stray bytes between segments.
  Result<Image> decode(std::span<const std::uint8_t> jpeg);

 private:
  struct Close {
    void operator()(void* handle) const;
  };
  std::unique_ptr<void, Close> handle_;
};

class JpegEncoder {
 public:
  JpegEncoder();
  // Colour at half resolution (4:2:0); `quality` from 1 to 100.
  Bytes encode(const Image& image, int quality);

 private:
  struct Close {
    void operator()(void* handle) const;
  };
  std::unique_ptr<void, Close> handle_;
  Bytes scratch_;
};

}  // namespace posecoach
