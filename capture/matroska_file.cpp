#include "capture/matroska_file.h"

extern "C" {
#include <libavformat/avformat.h>
#include <libavutil/mem.h>
}

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <string>

#include "capture/ffmpeg.h"
#include "core/base/atomic_file.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr AVRational kMilliseconds = {1, 1000};
constexpr int kBufferBytes = 1 << 16;

Error write_error(const fs::path& path, int reason) {
  const bool is_full = reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
  const ErrorCode code = reason == ENOENT   ? ErrorCode::NotFound
                         : reason == EEXIST ? ErrorCode::InvalidArgument
                                            : ErrorCode::Unreadable;
  const std::string words = is_full            ? "the disk is full"
                            : reason == EEXIST ? "it is there already; choose another name or folder"
                                               : std::strerror(reason);
  return {code, "cannot write " + path.string() + ": " + words};
}

int errno_of(int ffmpeg_error) {
  return ffmpeg_error < 0 && ffmpeg_error > -4096 ? AVUNERROR(ffmpeg_error) : EIO;
}

int write_bytes(void* opaque, std::uint8_t* bytes, int size) {
  const int descriptor = *static_cast<int*>(opaque);
  for (int done = 0; done < size;) {
    const ssize_t written = ::write(descriptor, bytes + done, static_cast<std::size_t>(size - done));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return AVERROR(errno);
    done += static_cast<int>(written);
  }
  return size;
}

std::int64_t seek_to(void* opaque, std::int64_t offset, int whence) {
  const int descriptor = *static_cast<int*>(opaque);
  if (whence == AVSEEK_SIZE) {
    struct stat facts = {};
    return ::fstat(descriptor, &facts) == 0 ? facts.st_size : AVERROR(errno);
  }
  const off_t at = ::lseek(descriptor, offset, whence & ~AVSEEK_FORCE);
  return at < 0 ? AVERROR(errno) : at;
}

struct FreeMuxer {
  void operator()(AVFormatContext* context) const {
    if (context->pb != nullptr) {
      av_freep(&context->pb->buffer);
      avio_context_free(&context->pb);
    }
    avformat_free_context(context);
  }
};

}  // namespace

class MatroskaFile::Implementation {
 public:
  Implementation(fs::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}
  ~Implementation() { abandon(); }

  Result<void> begin(const FilmStream& stream) {
    AVFormatContext* format = nullptr;
    if (const int made = avformat_alloc_output_context2(&format, nullptr, "matroska", nullptr); made < 0)
      return failed(made);
    format_.reset(format);
    auto* buffer = static_cast<std::uint8_t*>(av_malloc(kBufferBytes));
    format->pb = avio_alloc_context(buffer, kBufferBytes, 1, &descriptor_, nullptr, write_bytes, seek_to);
    if (format->pb == nullptr) return failed(AVERROR(ENOMEM));
    format->flags |= AVFMT_FLAG_CUSTOM_IO;
    AVStream* track = avformat_new_stream(format, nullptr);
    if (track == nullptr) return failed(AVERROR(ENOMEM));
    describe(stream, *track);
    nominal_step_ = std::max<std::int64_t>(1, std::llround(1000 / stream.nominal_fps));
    packet_.reset(av_packet_alloc());
    if (const int begun = avformat_write_header(format, nullptr); begun < 0) return failed(begun);
    return flush(Sync::System);
  }

  Result<void> write(std::span<const std::uint8_t> bytes, bool is_key, Duration time) {
    const auto rounded = std::chrono::round<std::chrono::milliseconds>(time).count();
    last_ticks_ = std::max<std::int64_t>(rounded, last_ticks_ + 1);
    packet_->data = const_cast<std::uint8_t*>(bytes.data());  // the muxer only reads it
    packet_->size = static_cast<int>(bytes.size());
    packet_->pts = packet_->dts = last_ticks_;
    packet_->duration = nominal_step_;
    packet_->flags = is_key ? AV_PKT_FLAG_KEY : 0;
    packet_->stream_index = 0;
    if (const int written = av_write_frame(format_.get(), packet_.get()); written < 0) return failed(written);
    return check();
  }

  Result<void> flush(Sync sync) {
    // Without a packet: the muxer ends its cluster.
    if (last_ticks_ >= 0)
      if (const int ended = av_write_frame(format_.get(), nullptr); ended < 0) return failed(ended);
    avio_flush(format_->pb);
    if (auto checked = check(); !checked) return checked;
    if (sync == Sync::Disk && ::fdatasync(descriptor_) != 0 && errno != EINVAL) return failed(AVERROR(errno));
    whole_bytes_ = avio_tell(format_->pb);
    return {};
  }

  Result<void> finish() {
    if (auto flushed = flush(Sync::System); !flushed) return flushed;
    if (const int ended = av_write_trailer(format_.get()); ended < 0) return failed(ended);
    avio_flush(format_->pb);
    if (auto checked = check(); !checked) return checked;
    if (::fsync(descriptor_) != 0 && errno != EINVAL) return failed(AVERROR(errno));
    ::close(std::exchange(descriptor_, -1));
    return {};
  }

  void abandon() {
    if (descriptor_ < 0) return;
    // What does not fit is left out; the film is whole up to there either way.
    if (::ftruncate(descriptor_, whole_bytes_) != 0) return;
    ::close(std::exchange(descriptor_, -1));
  }

  std::uint64_t bytes() const { return static_cast<std::uint64_t>(whole_bytes_); }

 private:
  tl::unexpected<Error> failed(int reason) const {
    return tl::unexpected(write_error(path_, errno_of(reason)));
  }
  // The muxer hides errors in its buffer.
  Result<void> check() const {
    return format_->pb->error < 0 ? Result<void>(failed(format_->pb->error)) : Result<void>();
  }

  static void describe(const FilmStream& stream, AVStream& track) {
    AVCodecParameters& parameters = *track.codecpar;
    const bool is_jpeg = stream.codec == FilmCodec::Jpeg;
    parameters.codec_type = AVMEDIA_TYPE_VIDEO;
    parameters.codec_id = is_jpeg ? AV_CODEC_ID_MJPEG : AV_CODEC_ID_H264;
    parameters.format = is_jpeg ? AV_PIX_FMT_YUVJ420P : AV_PIX_FMT_YUV420P;
    parameters.width = stream.width;
    parameters.height = stream.height;
    parameters.color_range = is_jpeg ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
    parameters.color_space = is_jpeg ? AVCOL_SPC_BT470BG : AVCOL_SPC_BT709;
    if (!is_jpeg) {
      parameters.color_primaries = AVCOL_PRI_BT709;
      parameters.color_trc = AVCOL_TRC_BT709;
    }
    if (!stream.header.empty()) {
      parameters.extradata =
          static_cast<std::uint8_t*>(av_mallocz(stream.header.size() + AV_INPUT_BUFFER_PADDING_SIZE));
      parameters.extradata_size = static_cast<int>(stream.header.size());
      std::memcpy(parameters.extradata, stream.header.data(), stream.header.size());
    }
    track.time_base = kMilliseconds;
    track.avg_frame_rate = av_d2q(stream.nominal_fps, 100000);
  }

  fs::path path_;
  int descriptor_ = -1;
  std::unique_ptr<AVFormatContext, FreeMuxer> format_;
  FfmpegPointer<AVPacket> packet_;
  std::int64_t nominal_step_ = 33;
  std::int64_t last_ticks_ = -1;
  std::int64_t whole_bytes_ = 0;
};

MatroskaFile::MatroskaFile(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
MatroskaFile::~MatroskaFile() = default;

Result<std::unique_ptr<MatroskaFile>> MatroskaFile::create(const fs::path& path) {
  keep_ffmpeg_quiet();
  if (is_special_file(path))
    return fail(ErrorCode::InvalidArgument,
                "cannot write " + path.string() + ": a film needs a file, not a device or a pipe");
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor < 0) return tl::unexpected(write_error(path, errno));
  return std::unique_ptr<MatroskaFile>(new MatroskaFile(std::make_unique<Implementation>(path, descriptor)));
}

Result<void> MatroskaFile::begin(const FilmStream& stream) {
  return implementation_->begin(stream);
}
Result<void> MatroskaFile::write(std::span<const std::uint8_t> bytes, bool is_key, Duration time) {
  return implementation_->write(bytes, is_key, time);
}
Result<void> MatroskaFile::flush(Sync sync) {
  return implementation_->flush(sync);
}
Result<void> MatroskaFile::finish() {
  return implementation_->finish();
}
void MatroskaFile::abandon() {
  implementation_->abandon();
}
std::uint64_t MatroskaFile::bytes() const {
  return implementation_->bytes();
}

}  // namespace posecoach
