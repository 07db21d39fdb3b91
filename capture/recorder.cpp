#include "capture/recorder.h"

#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <ctime>
#include <deque>
#include <mutex>
#include <thread>

#include "capture/matroska_file.h"
#include "capture/picture_encoder.h"
#include "core/base/assert.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kFlushEvery = std::chrono::milliseconds(500);
constexpr auto kSyncEvery = std::chrono::seconds(5);
constexpr auto kLookAtDiskEvery = std::chrono::seconds(1);
// The codec is chosen from so many frames, or from what came in this time.
constexpr std::size_t kTrialFrames = 8;
constexpr auto kLongestTrial = std::chrono::milliseconds(300);
// A codec keeps up when it needs at most this part of the time between two frames: other threads are busy
// too.
constexpr double kMostBusy = 0.5;
// Bits that a pixel of a golfer before a room or a garden takes, until the recording itself tells.
constexpr double kH264BitsPerPixel = 0.15;

double thread_seconds() {
  timespec time = {};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Needs a permission that ordinary users rarely have; without it the queue alone keeps the frames.
void take_priority() {
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), -10);
}

std::size_t bytes_of(const Frame& frame) {
  return frame.image->rgb.size();
}

Result<std::uint64_t> free_bytes(const fs::path& place) {
  struct statvfs facts = {};
  if (::statvfs(place.c_str(), &facts) != 0)
    return fail(errno == ENOENT ? ErrorCode::NotFound : ErrorCode::Unreadable,
                "cannot record in " + place.string() + ": " + std::strerror(errno));
  return std::uint64_t{facts.f_bavail} * facts.f_frsize;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace

class Recorder::Implementation {
 public:
  Implementation(fs::path path, const RecorderOptions& options, std::unique_ptr<MatroskaFile> file)
      : path_(std::move(path)), options_(options), file_(std::move(file)) {
    status_.path = path_;
    thread_ = std::thread([this] { run(); });
  }
  ~Implementation() { finish().has_value(); }

  bool offer(const Frame& frame) {
    POSECOACH_ASSERT(frame.image != nullptr && !frame.image->empty());
    {
      const std::scoped_lock lock(mutex_);
      ++status_.offered;
      // One frame always finds room, however large.
      const bool is_full = !queue_.empty() && queued_bytes_ + bytes_of(frame) > options_.most_queued_bytes;
      if (is_full || is_closing_ || status_.failure) {
        ++status_.dropped;
        return false;
      }
      queue_.push_back(frame);
      queued_bytes_ += bytes_of(frame);
      status_.most_queued = std::max(status_.most_queued, queue_.size());
    }
    wake_.notify_one();
    return true;
  }

  RecorderStatus status() const {
    const std::scoped_lock lock(mutex_);
    RecorderStatus now = status_;
    now.queued = queue_.size();
    return now;
  }

  Result<RecorderStatus> finish() {
    {
      const std::scoped_lock lock(mutex_);
      is_closing_ = true;
    }
    wake_.notify_one();
    if (thread_.joinable()) thread_.join();
    const RecorderStatus now = status();
    if (now.failure) return tl::unexpected(*now.failure);
    return now;
  }

  const std::vector<RecordedFrame>& frames() const { return frames_; }

 private:
  struct TriedFrame {
    Frame frame;
    EncodedPicture picture;
  };

  void run() {
    ::pthread_setname_np(::pthread_self(), "coach-record");
    take_priority();
    const Result<void> done = record();
    if (done) return;
    file_->abandon();
    const bool is_empty = frames_.empty();
    if (is_empty) ::unlink(path_.c_str());
    const std::scoped_lock lock(mutex_);
    status_.failure = done.error();
    if (!is_empty) {
      char seconds[32];
      std::snprintf(seconds, sizeof seconds, "%.1f", to_seconds(status_.length));
      status_.failure->message +=
          std::string("; the recording ended after ") + seconds + " s, and the film holds what came before";
    }
    status_.dropped += queue_.size();
    queue_.clear();
    queued_bytes_ = 0;
  }

  Result<void> record() {
    for (;;) {
      std::optional<Frame> frame;
      bool is_closing = false;
      {
        std::unique_lock lock(mutex_);
        wake_.wait_for(lock, kFlushEvery / 4, [&] { return is_closing_ || !queue_.empty(); });
        is_closing = is_closing_;
        if (!queue_.empty()) {
          frame = std::move(queue_.front());
          queue_.pop_front();
          queued_bytes_ -= bytes_of(*frame);
        }
      }
      if (frame) {
        if (auto taken = take(*frame); !taken) return taken;
      } else if (is_closing) {
        return close();
      }
      if (auto kept = keep(); !kept) return kept;
    }
  }

  Result<void> take(const Frame& frame) {
    if (!trial_ended_) return try_codec(frame);
    const Result<EncodedPicture> picture = encoder_->encode(*frame.image);
    if (!picture) return tl::unexpected(picture.error());
    return write(frame, *picture);
  }

  Result<void> try_codec(const Frame& frame) {
    if (!encoder_) {
      trial_began_ = Clock::now();
      const FilmCodec first = options_.codec == RecorderCodec::Jpeg ? FilmCodec::Jpeg : FilmCodec::H264;
      if (auto made = use(first, *frame.image); !made) {
        const bool may_choose = options_.codec == RecorderCodec::Automatic;
        if (!may_choose || made.error().code != ErrorCode::Unsupported) return made;
        if (made = use(FilmCodec::Jpeg, *frame.image); !made) return made;
      }
    }
    const double before = thread_seconds();
    Result<EncodedPicture> picture = encoder_->encode(*frame.image);
    if (!picture) return tl::unexpected(picture.error());
    // The first one warms up.
    if (!tried_.empty()) trial_cost_s_ += thread_seconds() - before;
    tried_.push_back({frame, *std::move(picture)});
    const bool is_open =
        options_.codec == RecorderCodec::Automatic && encoder_->stream().codec == FilmCodec::H264;
    return is_open && tried_.size() < kTrialFrames ? Result<void>() : end_trial();
  }

  Result<void> use(FilmCodec codec, const Image& image) {
    auto encoder = make_picture_encoder(codec, image.width, image.height, options_.nominal_fps);
    if (!encoder) return tl::unexpected(encoder.error());
    encoder_ = *std::move(encoder);
    return {};
  }

  bool is_too_slow() const {
    if (options_.codec != RecorderCodec::Automatic || tried_.size() < 2 ||
        encoder_->stream().codec == FilmCodec::Jpeg)
      return false;
    const auto steps = static_cast<double>(tried_.size() - 1);
    const double step_s = to_seconds(tried_.back().frame.time - tried_.front().frame.time) / steps;
    return step_s > 0 && trial_cost_s_ / steps > kMostBusy * step_s;
  }

  Result<void> end_trial() {
    trial_ended_ = true;
    const bool starts_again = is_too_slow();
    if (starts_again)
      if (auto made = use(FilmCodec::Jpeg, *tried_.front().frame.image); !made) return made;
    if (auto begun = file_->begin(encoder_->stream()); !begun) return begun;
    {
      const std::scoped_lock lock(mutex_);
      status_.codec = encoder_->stream().codec == FilmCodec::H264 ? "H.264" : "JPEG";
    }
    for (TriedFrame& tried : tried_) {
      if (starts_again) {
        Result<EncodedPicture> picture = encoder_->encode(*tried.frame.image);
        if (!picture) return tl::unexpected(picture.error());
        tried.picture = *std::move(picture);
      }
      if (auto written = write(tried.frame, tried.picture); !written) return written;
    }
    tried_.clear();
    return {};
  }

  Result<void> write(const Frame& frame, const EncodedPicture& picture) {
    if (!first_time_) first_time_ = frame.time;
    const Duration time = frame.time - *first_time_;
    if (auto written = file_->write(picture.bytes, picture.is_key, time); !written) return written;
    frames_.push_back({frame.index, time});
    const std::scoped_lock lock(mutex_);
    ++status_.written;
    status_.length = time;
    return {};
  }

  // What is due besides the frames.
  Result<void> keep() {
    const auto now = Clock::now();
    if (!trial_ended_ && !tried_.empty() && now - trial_began_ > kLongestTrial)
      if (auto ended = end_trial(); !ended) return ended;
    if (now - looked_at_disk_ > kLookAtDiskEvery) {
      looked_at_disk_ = now;
      if (auto looked = look_at_disk(); !looked) return looked;
    }
    if (!trial_ended_ || now - flushed_ < kFlushEvery) return {};
    flushed_ = now;
    const bool syncs = now - synced_ > kSyncEvery;
    if (syncs) synced_ = now;
    auto flushed = file_->flush(syncs ? MatroskaFile::Sync::Disk : MatroskaFile::Sync::System);
    const std::scoped_lock lock(mutex_);
    status_.bytes = file_->bytes();
    return flushed;
  }

  Result<void> look_at_disk() {
    const Result<std::uint64_t> free = free_bytes(folder_of(path_));
    if (!free) return {};  // the next write will tell
    if (*free < options_.reserved_disk_bytes)
      return fail(ErrorCode::Unreadable, "cannot write " + path_.string() + ": the disk is full");
    const std::scoped_lock lock(mutex_);
    const double rate = static_cast<double>(status_.bytes) / std::max(1.0, to_seconds(status_.length));
    const auto room = static_cast<double>(*free - options_.reserved_disk_bytes);
    status_.minutes_left = rate > 0 ? room / rate / 60 : 0;
    return {};
  }

  Result<void> close() {
    if (!trial_ended_ && !tried_.empty())
      if (auto ended = end_trial(); !ended) return ended;
    if (frames_.empty())
      return fail(ErrorCode::Incomplete, "cannot write " + path_.string() + ": no pictures came");
    if (auto finished = file_->finish(); !finished) return finished;
    std::error_code ignored;
    const auto size = fs::file_size(path_, ignored);
    const std::scoped_lock lock(mutex_);
    status_.bytes = size;
    return {};
  }

  const fs::path path_;
  const RecorderOptions options_;

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Frame> queue_;
  std::size_t queued_bytes_ = 0;
  bool is_closing_ = false;
  RecorderStatus status_;

  // Of the recording thread.
  std::unique_ptr<MatroskaFile> file_;
  std::unique_ptr<PictureEncoder> encoder_;
  std::vector<TriedFrame> tried_;
  double trial_cost_s_ = 0;
  bool trial_ended_ = false;
  Clock::time_point trial_began_, flushed_ = Clock::now(), synced_ = Clock::now(), looked_at_disk_;
  std::optional<MediaTime> first_time_;
  std::vector<RecordedFrame> frames_;

  std::thread thread_;
};

Recorder::Recorder(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
Recorder::~Recorder() = default;

Result<std::unique_ptr<Recorder>> Recorder::start(const fs::path& path, const RecorderOptions& options) {
  if (path.extension() != ".mkv")
    return fail(ErrorCode::InvalidArgument, "cannot record to " + path.string() + ": its name ends in .mkv");
  const Result<std::uint64_t> free = free_bytes(folder_of(path));
  if (!free) return tl::unexpected(free.error());
  if (*free < options.reserved_disk_bytes)
    return fail(ErrorCode::Unreadable, "cannot record to " + path.string() +
                                           ": the disk is full; make room, or choose another folder");
  auto file = MatroskaFile::create(path);
  if (!file) return tl::unexpected(file.error());
  return std::unique_ptr<Recorder>(
      new Recorder(std::make_unique<Implementation>(path, options, *std::move(file))));
}

bool Recorder::offer(const Frame& frame) {
  return implementation_->offer(frame);
}
RecorderStatus Recorder::status() const {
  return implementation_->status();
}
Result<RecorderStatus> Recorder::finish() {
  return implementation_->finish();
}
const std::vector<RecordedFrame>& Recorder::frames() const {
  return implementation_->frames();
}

Result<RecordingRoom> recording_room(const fs::path& folder, int width, int height, double fps) {
  fs::path place = folder.empty() ? fs::path(".") : folder;
  std::error_code ignored;
  while (!fs::exists(place, ignored) && place.has_parent_path() && place != place.parent_path())
    place = place.parent_path();
  if (!fs::exists(place, ignored)) place = ".";
  const Result<std::uint64_t> free = free_bytes(place);
  if (!free) return tl::unexpected(free.error());
  const std::uint64_t reserved = RecorderOptions{}.reserved_disk_bytes;
  const double bytes_a_second = kH264BitsPerPixel / 8 * width * height * fps;
  const auto room = static_cast<double>(*free > reserved ? *free - reserved : 0);
  return RecordingRoom{*free, bytes_a_second > 0 ? room / bytes_a_second / 60 : 0};
}

}  // namespace posecoach
