// What every user of FFmpeg's libraries needs.
#pragma once

#include <memory>
#include <string>

struct AVCodecContext;
struct AVFormatContext;
struct AVFrame;
struct AVPacket;
struct SwsContext;

namespace posecoach {

// FFmpeg writes to standard error on its own; after this it does not.
void keep_ffmpeg_quiet();

// What one of its negative results means, in words.
std::string ffmpeg_reason(int error);

// Its objects, freed as it wants them freed.
struct FfmpegFree {
  void operator()(AVCodecContext* context) const;
  void operator()(AVFrame* frame) const;
  void operator()(AVPacket* packet) const;
  void operator()(SwsContext* context) const;
};
template <typename Object>
using FfmpegPointer = std::unique_ptr<Object, FfmpegFree>;

struct FfmpegCloseInput {
  void operator()(AVFormatContext* input) const;
};
using FfmpegInput = std::unique_ptr<AVFormatContext, FfmpegCloseInput>;

// Encoders that halve the colours' resolution want even sizes.
constexpr int even(int size) {
  return size + size % 2;
}

}  // namespace posecoach
