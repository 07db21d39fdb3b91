#include "capture/frame_ring.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "capture/matroska_file.h"
#include "capture/picture_encoder.h"
#include "core/base/assert.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

double mean_rate(std::span<const CompressedFrame> frames) {
  if (frames.size() < 2) return 30;
  return static_cast<double>(frames.size() - 1) / to_seconds(frames.back().time - frames.front().time);
}

Result<void> write_pictures(std::span<const CompressedFrame> frames, ClipCodec codec, MatroskaFile& file) {
  const CompressedFrame& first = frames.front();
  const FilmCodec film_codec = codec == ClipCodec::Jpeg ? FilmCodec::Jpeg : FilmCodec::H264;
  auto encoder = make_picture_encoder(film_codec, first.width, first.height, mean_rate(frames));
  if (!encoder) return tl::unexpected(encoder.error());
  FilmStream stream = (*encoder)->stream();
  if (codec == ClipCodec::Jpeg) {
    stream.width = first.width;
    stream.height = first.height;
  }
  if (auto begun = file.begin(stream); !begun) return begun;
  for (const CompressedFrame& frame : frames) {
    const Duration time = frame.time - first.time;
    if (codec == ClipCodec::Jpeg && frame.width == first.width && frame.height == first.height) {
      if (auto written = file.write(*frame.jpeg, true, time); !written) return written;
      continue;
    }
    const Result<Image> image = decompressed(frame);
    if (!image) return tl::unexpected(image.error());
    const Result<EncodedPicture> picture = (*encoder)->encode(*image);
    if (!picture) return tl::unexpected(picture.error());
    if (auto written = file.write(picture->bytes, picture->is_key, time); !written) return written;
  }
  return file.finish();
}

}  // namespace

Result<Image> decompressed(const CompressedFrame& frame) {
  thread_local JpegDecoder decoder;
  return decoder.decode(*frame.jpeg);
}

FrameRing::FrameRing(const FrameRingOptions& options) : options_(options) {}

void FrameRing::push(const Frame& frame) {
  POSECOACH_ASSERT(frame.image != nullptr);
  CompressedFrame compressed{frame.index,        frame.time,          frame.captured_at,
                             frame.image->width, frame.image->height, nullptr};
  {
    const std::scoped_lock lock(encoding_);
    compressed.jpeg = std::make_shared<const Bytes>(encoder_.encode(*frame.image, options_.quality));
  }
  const std::scoped_lock lock(mutex_);
  if (!frames_.empty() && frame.time <= frames_.back().time) {
    frames_.clear();
    bytes_ = 0;
  }
  bytes_ += compressed.jpeg->size();
  frames_.push_back(std::move(compressed));
  while (frames_.size() > 1 &&
         (bytes_ > options_.most_bytes || frames_.back().time - frames_.front().time > options_.longest)) {
    bytes_ -= frames_.front().jpeg->size();
    frames_.pop_front();
  }
}

std::vector<CompressedFrame> FrameRing::frames_between(MediaTime first, MediaTime last) const {
  const std::scoped_lock lock(mutex_);
  std::vector<CompressedFrame> chosen;
  for (const CompressedFrame& frame : frames_)
    if (frame.time >= first && frame.time <= last) chosen.push_back(frame);
  return chosen;
}

void FrameRing::clear() {
  const std::scoped_lock lock(mutex_);
  frames_.clear();
  bytes_ = 0;
}

FrameRing::Held FrameRing::held() const {
  const std::scoped_lock lock(mutex_);
  if (frames_.empty()) return {};
  return {frames_.size(), bytes_, frames_.back().time - frames_.front().time};
}

Result<void> write_clip(std::span<const CompressedFrame> frames, const fs::path& path, ClipCodec codec) {
  if (frames.empty()) return fail(ErrorCode::Incomplete, "cannot write " + path.string() + ": no pictures");
  if (path.extension() != ".mkv")
    return fail(ErrorCode::InvalidArgument, "cannot write " + path.string() + ": a clip's name ends in .mkv");
  const auto goes_back = [](const CompressedFrame& a, const CompressedFrame& b) { return b.time <= a.time; };
  if (std::adjacent_find(frames.begin(), frames.end(), goes_back) != frames.end())
    return fail(ErrorCode::InvalidArgument, "cannot write " + path.string() + ": time does not increase");
  const fs::path temporary = path.string() + ".tmp" + std::to_string(::getpid()) + ".mkv";
  ::unlink(temporary.c_str());
  auto file = MatroskaFile::create(temporary);
  if (!file) return tl::unexpected(file.error());
  Result<void> done = write_pictures(frames, codec, **file);
  if (done && std::rename(temporary.c_str(), path.c_str()) != 0)
    done = fail(ErrorCode::Unreadable, "cannot write " + path.string() + ": " + std::strerror(errno));
  if (!done) ::unlink(temporary.c_str());
  return done;
}

}  // namespace posecoach
