#include "capture/film_decoder.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/dict.h>
#include <libavutil/parseutils.h>
}

#include <cstring>
#include <fstream>

#include "capture/ffmpeg.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

using Codec = FfmpegPointer<AVCodecContext>;

constexpr AVRational kNanoseconds = {1, 1'000'000'000};
// Pictures above 8K would not fit the memory that we promise to keep to.
constexpr std::int64_t kMostPixels = std::int64_t{7680} * 4320;

Result<void> check_file(const fs::path& path) {
  std::error_code reason;
  const fs::file_status status = fs::status(path, reason);
  if (status.type() == fs::file_type::not_found)
    return fail(ErrorCode::NotFound, "cannot open " + path.string() + ": no such file");
  if (reason) return fail(ErrorCode::Unreadable, "cannot open " + path.string() + ": " + reason.message());
  if (!fs::is_regular_file(status))
    return fail(ErrorCode::Unreadable, path.string() + " is not a film but a folder or a device");
  if (fs::file_size(path, reason) == 0) return fail(ErrorCode::Malformed, path.string() + " is empty");
  return {};
}

// FFmpeg "plays" plain text as a film of characters.
bool is_text(AVCodecID codec) {
  return codec == AV_CODEC_ID_ANSI || codec == AV_CODEC_ID_BINTEXT || codec == AV_CODEC_ID_XBIN ||
         codec == AV_CODEC_ID_IDF;
}

bool begins_like_mp4(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  char head[8] = {};
  file.read(head, sizeof head);
  return file && std::string_view(head + 4, 4) == "ftyp";
}

Result<FfmpegInput> open_format(const fs::path& path) {
  const auto no_film = [&](int error) {
    if (error == AVERROR(EACCES))
      return fail(ErrorCode::Unreadable, path.string() + " cannot be opened: " + ffmpeg_reason(error));
    if (error == AVERROR_INVALIDDATA && begins_like_mp4(path))
      return fail(ErrorCode::Malformed, path.string() +
                                            " is a film without its index: it was cut off while it was "
                                            "recorded or copied, and cannot be played");
    return fail(ErrorCode::Malformed,
                path.string() + " is not a film that can be read (" + ffmpeg_reason(error) + ")");
  };
  AVDictionary* options = nullptr;
  // A file that names other places must not make us go there.
  av_dict_set(&options, "protocol_whitelist", "file", 0);
  AVFormatContext* opened = nullptr;
  const int result = avformat_open_input(&opened, ("file:" + path.string()).c_str(), nullptr, &options);
  av_dict_free(&options);
  if (result < 0) return no_film(result);
  FfmpegInput format(opened);
  if (const int found = avformat_find_stream_info(format.get(), nullptr); found < 0) return no_film(found);
  return format;
}

Result<AVStream*> find_pictures(const fs::path& path, AVFormatContext& format) {
  bool has_sound = false;
  AVStream* best = nullptr;
  const int preferred = av_find_best_stream(&format, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
  for (unsigned i = 0; i < format.nb_streams; ++i) {
    AVStream* stream = format.streams[i];
    stream->discard = AVDISCARD_ALL;
    has_sound |= stream->codecpar->codec_type == AVMEDIA_TYPE_AUDIO;
    const bool is_film = stream->codecpar->codec_type == AVMEDIA_TYPE_VIDEO &&
                         (stream->disposition & AV_DISPOSITION_ATTACHED_PIC) == 0 &&
                         !is_text(stream->codecpar->codec_id);
    if (is_film && (best == nullptr || static_cast<int>(i) == preferred)) best = stream;
  }
  if (best == nullptr && has_sound)
    return fail(ErrorCode::Unsupported, path.string() + " holds sound but no pictures");
  if (best == nullptr)
    return fail(ErrorCode::Malformed, path.string() + " is not a film: it holds no pictures");
  best->discard = AVDISCARD_DEFAULT;
  return best;
}

Result<Codec> open_codec(const fs::path& path, const AVStream& stream) {
  const AVCodecParameters& parameters = *stream.codecpar;
  if (std::int64_t{parameters.width} * parameters.height > kMostPixels)
    return fail(ErrorCode::Unsupported,
                path.string() + " has pictures of " + std::to_string(parameters.width) + "x" +
                    std::to_string(parameters.height) + " pixels; at most 7680x4320 are supported");
  const AVCodec* decoder = avcodec_find_decoder(parameters.codec_id);
  if (decoder == nullptr)
    return fail(ErrorCode::Unsupported, path.string() + " is compressed as " +
                                            avcodec_get_name(parameters.codec_id) +
                                            ", which cannot be decoded here");
  Codec codec(avcodec_alloc_context3(decoder));
  avcodec_parameters_to_context(codec.get(), &parameters);
  codec->pkt_timebase = stream.time_base;
  codec->max_pixels = kMostPixels;
  codec->thread_count = 2;
  // Frames decoded side by side need memory for each, too much for very large ones.
  const bool is_large = std::int64_t{parameters.width} * parameters.height > std::int64_t{2560} * 1440;
  codec->thread_type = is_large ? FF_THREAD_SLICE : FF_THREAD_SLICE | FF_THREAD_FRAME;
  if (const int opened = avcodec_open2(codec.get(), decoder, nullptr); opened < 0)
    return fail(ErrorCode::Unsupported, path.string() + " cannot be decoded: " + ffmpeg_reason(opened));
  return codec;
}

Orientation orientation_of(const AVStream& stream) {
  std::size_t size = 0;
  const std::uint8_t* data = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, &size);
  if (data == nullptr || size < 9 * sizeof(std::int32_t)) return {};
  std::int32_t matrix[9] = {};
  std::memcpy(matrix, data, sizeof matrix);
  return orientation_from_matrix(matrix[0], matrix[1], matrix[3], matrix[4]);
}

// The first moment of pictures or sound.
std::optional<Duration> start_of(const AVFormatContext& format) {
  std::optional<Duration> start;
  for (unsigned i = 0; i < format.nb_streams; ++i) {
    const AVStream& stream = *format.streams[i];
    const bool counts = stream.codecpar->codec_type == AVMEDIA_TYPE_VIDEO ||
                        stream.codecpar->codec_type == AVMEDIA_TYPE_AUDIO;
    if (!counts || stream.start_time == AV_NOPTS_VALUE ||
        (stream.disposition & AV_DISPOSITION_ATTACHED_PIC) != 0)
      continue;
    const Duration begins(av_rescale_q(stream.start_time, stream.time_base, kNanoseconds));
    if (!start || begins < *start) start = begins;
  }
  return start;
}

// How long the pictures go on, as the container claims. A sound track may be longer than they are, so the
// whole file's length only counts where there is none.
std::optional<Duration> claimed_length(const AVFormatContext& format, const AVStream& pictures) {
  if (pictures.duration > 0)
    return Duration(av_rescale_q(pictures.duration, pictures.time_base, kNanoseconds));
  // Matroska notes it in words: "00:00:08.808808000".
  const AVDictionaryEntry* words = av_dict_get(pictures.metadata, "DURATION", nullptr, 0);
  std::int64_t microseconds = 0;
  if (words != nullptr && av_parse_time(&microseconds, words->value, 1) >= 0 && microseconds > 0)
    return std::chrono::microseconds(microseconds);
  if (format.nb_streams > 1 || format.duration <= 0) return std::nullopt;
  return std::chrono::microseconds(format.duration);
}

}  // namespace

class FilmDecoder::Implementation {
 public:
  Implementation(FfmpegInput format, Codec codec, const AVStream& stream)
      : format_(std::move(format)),
        codec_(std::move(codec)),
        stream_(stream),
        frame_(av_frame_alloc()),
        packet_(av_packet_alloc()),
        start_(start_of(*format_)),
        claimed_length_(claimed_length(*format_, stream)) {
    facts_.orientation = orientation_of(stream);
    const AVRational rate = av_guess_frame_rate(format_.get(), format_->streams[stream.index], nullptr);
    facts_.nominal_fps = rate.num > 0 && rate.den > 0 ? av_q2d(rate) : 0;
    if (stream.nb_frames > 0) facts_.frame_count = static_cast<std::size_t>(stream.nb_frames);
  }

  std::optional<DecodedPicture> next() {
    while (true) {
      const int received = avcodec_receive_frame(codec_.get(), frame_.get());
      if (received == 0) {
        ++decoded_;
        damaged_ |= frame_->decode_error_flags != 0 || (frame_->flags & AV_FRAME_FLAG_CORRUPT) != 0;
        return DecodedPicture{frame_.get(), next_time()};
      }
      if (received == AVERROR_EOF) {
        cut_off_ |= ends_early();
        return std::nullopt;
      }
      if (received != AVERROR(EAGAIN)) damaged_ = true;
      feed();
    }
  }

  const FilmFacts& facts() const { return facts_; }
  bool is_damaged() const { return damaged_ || cut_off_; }
  bool is_cut_off() const { return cut_off_; }

 private:
  // Of a trimmed film the edit list hides pictures, often half of them; and claimed lengths are rounded.
  bool ends_early() const {
    if (facts_.frame_count) return decoded_ + hidden_ + decoded_ / 10 + 2 < *facts_.frame_count;
    if (!claimed_length_ || !last_) return false;
    // Some containers count the length from zero, not from a later start.
    const double end_s = to_seconds(*last_) + std::max(0.0, start_ ? to_seconds(*start_) : 0.0);
    return 0.9 * to_seconds(*claimed_length_) - 0.25 > end_s;
  }

  void feed() {
    while (!at_end_) {
      const int read = av_read_frame(format_.get(), packet_.get());
      if (read < 0) {
        at_end_ = true;
        damaged_ |= read != AVERROR_EOF;
        break;
      }
      const bool ours = packet_->stream_index == stream_.index;
      hidden_ += ours && (packet_->flags & AV_PKT_FLAG_DISCARD) != 0 ? 1U : 0U;
      const int sent = ours ? avcodec_send_packet(codec_.get(), packet_.get()) : 0;
      damaged_ |= ours && (sent < 0 || (packet_->flags & AV_PKT_FLAG_CORRUPT) != 0);
      av_packet_unref(packet_.get());
      if (ours && sent == 0) return;
    }
    avcodec_send_packet(codec_.get(), nullptr);
  }

  MediaTime next_time() {
    const Duration step = facts_.nominal_fps > 0 ? duration_from_seconds(1 / facts_.nominal_fps)
                                                 : Duration(std::chrono::milliseconds(40));
    const std::int64_t stamp = frame_->best_effort_timestamp;
    if (stamp == AV_NOPTS_VALUE) {
      last_ = last_ ? *last_ + step : MediaTime();  // a bare stream without any clock
      return *last_;
    }
    const Duration at(av_rescale_q(stamp, stream_.time_base, kNanoseconds));
    if (!start_) start_ = at;
    MediaTime time(std::max(Duration::zero(), at - *start_));
    // Damaged films repeat stamps or go back; motions need time to go on.
    if (last_ && time <= *last_) time = *last_ + Duration(std::chrono::microseconds(1));
    last_ = time;
    return time;
  }

  FfmpegInput format_;
  Codec codec_;
  const AVStream& stream_;
  FfmpegPointer<AVFrame> frame_;
  FfmpegPointer<AVPacket> packet_;
  FilmFacts facts_;
  std::optional<Duration> start_;
  std::optional<Duration> claimed_length_;
  std::optional<MediaTime> last_;
  std::size_t decoded_ = 0;
  std::size_t hidden_ = 0;
  bool at_end_ = false;
  bool damaged_ = false, cut_off_ = false;
};

FilmDecoder::FilmDecoder(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
FilmDecoder::~FilmDecoder() = default;

Result<std::unique_ptr<FilmDecoder>> FilmDecoder::open(const fs::path& path) {
  keep_ffmpeg_quiet();
  if (const auto good = check_file(path); !good) return tl::unexpected(good.error());
  auto format = open_format(path);
  if (!format) return tl::unexpected(format.error());
  const auto stream = find_pictures(path, **format);
  if (!stream) return tl::unexpected(stream.error());
  auto codec = open_codec(path, **stream);
  if (!codec) return tl::unexpected(codec.error());
  const AVStream& pictures = **stream;
  return std::unique_ptr<FilmDecoder>(
      new FilmDecoder(std::make_unique<Implementation>(std::move(*format), std::move(*codec), pictures)));
}

const FilmFacts& FilmDecoder::facts() const {
  return implementation_->facts();
}

std::optional<DecodedPicture> FilmDecoder::next() {
  return implementation_->next();
}

bool FilmDecoder::is_damaged() const {
  return implementation_->is_damaged();
}

bool FilmDecoder::is_cut_off() const {
  return implementation_->is_cut_off();
}

}  // namespace posecoach
