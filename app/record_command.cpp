#include "app/record_command.h"

#include <CLI/CLI.hpp>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "app/progress_bar.h"
#include "capture/open_source.h"
#include "capture/recorder.h"
#include "capture/v4l2/camera_name.h"
#include "core/base/file.h"
#include "core/base/log.h"
#include "core/pipeline/frame_pump.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

constexpr Duration kLookEvery = std::chrono::milliseconds(50);
constexpr Duration kSilent = std::chrono::seconds(1);
constexpr double kLittleRoom_minutes = 5;

struct Options {
  std::string source, folder;
  double seconds = 0;  // 0: until Ctrl-C or the source's end
};

std::string wall_time_text() {
  const std::time_t now = std::time(nullptr);
  std::tm utc = {};
  ::gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

// The folder of the recording; what was made for it goes again when it stayed empty.
class RecordingFolder {
 public:
  static Result<std::unique_ptr<RecordingFolder>> make(const fs::path& path) {
    auto folder = std::unique_ptr<RecordingFolder>(new RecordingFolder);
    std::error_code failed;
    for (fs::path part = fs::absolute(path, failed); !failed && !part.empty() && !fs::exists(part, failed);
         part = part.parent_path())
      folder->made_.push_back(part);
    failed.clear();
    fs::create_directories(path, failed);
    if (failed)
      return fail(ErrorCode::Unreadable, "cannot record in " + path.string() + ": " + failed.message());
    return folder;
  }
  // Only folders without anything in them can be removed so.
  ~RecordingFolder() {
    std::error_code holds_something;
    for (const fs::path& part : made_)
      if (!part.filename().empty() && !fs::remove(part, holds_something)) return;
  }

 private:
  RecordingFolder() = default;
  std::vector<fs::path> made_;  // the innermost first
};

// What the user sees of a recording while it goes on, and why it ended.
class Watch {
 public:
  Watch(const Options& options, const FramePump& pump, const Recorder& recorder)
      : options_(options), pump_(pump), recorder_(recorder) {}

  // Returns when the recording is over; the error is one of the source before its first frame.
  Result<void> wait() {
    const Progress progress = bar_.progress();
    for (;; std::this_thread::sleep_for(kLookEvery)) {
      const PumpStatus pump = pump_.status();
      const RecorderStatus recorder = recorder_.status();
      if (pump.state == SourceState::Lost && pump.captured == 0)
        return fail(ErrorCode::Unreadable, pump.message);
      tell(pump);
      const double length_s = to_seconds(recorder.length);
      const double fraction = options_.seconds > 0 ? length_s / options_.seconds : -1;
      if (!report(progress, line(pump, recorder), fraction)) return ended("the user");
      if (recorder.failure) return ended(recorder.failure->message);
      if (pump.state == SourceState::Ended) return ended("the source's end");
      if (options_.seconds > 0 && length_s >= options_.seconds) return ended("the time that was asked for");
    }
  }

  const std::string& ended_by() const { return ended_by_; }

 private:
  Result<void> ended(std::string why) {
    ended_by_ = std::move(why);
    return {};
  }

  // Once for each change.
  void tell(const PumpStatus& pump) {
    SourceState state = pump.state;
    if (state == SourceState::Live && pump.captured > 0 && Clock::now() - pump.last_frame_at > kSilent)
      state = SourceState::Stalled;
    if (state == told_) return;
    if (state == SourceState::Lost) log::warning(pump.message + "; it is looked for, the recording waits");
    if (state == SourceState::Stalled)
      log::warning("no picture has come from " + pump.source + " for a second");
    const bool was_away = told_ == SourceState::Lost || told_ == SourceState::Stalled;
    if (state == SourceState::Live && was_away) log::info(pump.source + " is back");
    told_ = state;
  }

  static std::string line(const PumpStatus& pump, const RecorderStatus& recorder) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "recording %.1f s: %zu frames, %zu dropped, %llu lost by the camera, %zu waiting",
                  to_seconds(recorder.length), recorder.written, recorder.dropped,
                  static_cast<unsigned long long>(pump.lost_by_camera), recorder.queued);
    return text;
  }

  const Options& options_;
  const FramePump& pump_;
  const Recorder& recorder_;
  ProgressBar bar_;
  SourceState told_ = SourceState::Opening;
  std::string ended_by_;
};

std::string sidecar(const Options& options, const std::string& started_at, const std::string& ended_by,
                    const PumpStatus& pump, const FrameSourceInfo& info, const Recorder& recorder) {
  const RecorderStatus status = recorder.status();
  nlohmann::json frames = nlohmann::json::array();
  for (const RecordedFrame& frame : recorder.frames())
    frames.push_back({frame.index, to_seconds(frame.time)});
  const nlohmann::json all = {
      {"schema", "posecoach.recording/1"},
      {"source", options.source},
      {"film", status.path.filename().string()},
      {"started_at", started_at},
      {"ended_by", ended_by},
      {"mode",
       {{"width", info.width},
        {"height", info.height},
        {"nominal_fps", info.nominal_fps},
        {"codec", status.codec}}},
      {"seconds", to_seconds(status.length)},
      {"bytes", status.bytes},
      {"counters",
       {{"captured", pump.captured},
        {"lost_by_camera", pump.lost_by_camera},
        {"written", status.written},
        {"dropped", status.dropped},
        {"most_queued", status.most_queued}}},
      // The source's number and the time from the first of every picture in the film, in order.
      {"frames", frames}};
  return all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void tell_room(const std::string& folder) {
  const Result<RecordingRoom> room = recording_room(folder, 1280, 720, 60);
  if (room && room->minutes < kLittleRoom_minutes)
    log::warning("there is room for about " + std::to_string(static_cast<int>(room->minutes)) +
                 " minutes in " + folder);
}

Result<void> record(const Options& options) {
  listen_to_interrupts();
  const auto folder = RecordingFolder::make(options.folder);
  if (!folder) return tl::unexpected(folder.error());
  tell_room(options.folder);
  const std::string started_at = wall_time_text();
  std::mutex mutex;
  FrameSourceInfo info;
  auto recorder = Recorder::start(fs::path(options.folder) / "film.mkv");
  if (!recorder) return tl::unexpected(recorder.error());
  PumpStatus last;
  std::string ended_by;
  {
    FramePump pump(
        [&](const std::string& name) {
          auto source = open_source(name);
          if (!source) return source;
          const std::scoped_lock lock(mutex);
          info = (*source)->info();
          return source;
        },
        [](const PumpedFrame&) {});
    pump.set_tap([&](const Frame& frame) { (*recorder)->offer(frame); });
    pump.set_source({stable_camera_name(options.source)});
    Watch watch(options, pump, **recorder);
    if (auto waited = watch.wait(); !waited) return waited;
    last = pump.status();
    ended_by = watch.ended_by();
  }
  const Result<RecorderStatus> finished = (*recorder)->finish();
  if (!finished && (*recorder)->frames().empty()) return tl::unexpected(finished.error());
  const fs::path beside = fs::path(options.folder) / "recording.json";
  const auto written =
      write_file_atomically(beside, sidecar(options, started_at, ended_by, last, info, **recorder));
  if (!finished) return tl::unexpected(finished.error());
  if (!written) return written;
  std::printf("%s: %.1f s, %zu frames, %zu dropped\n", finished->path.c_str(), to_seconds(finished->length),
              finished->written, finished->dropped);
  return {};
}

}  // namespace

void add_record_command(CLI::App& cli, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      cli.add_subcommand("record", "Record a film; Ctrl-C ends it, a crash does not spoil it");
  command
      ->add_option(
          "--source", options->source,
          "camera:/dev/video0?width=1280&height=720&fps=60, camera: (the first), simulated:swing, a film")
      ->required();
  command->add_option("-o,--output", options->folder, "The folder for film.mkv and recording.json")
      ->required()
      ->type_name("DIR");
  command->add_option("--seconds", options->seconds, "Stop after so long")->check(CLI::PositiveNumber);
  command->callback([options, &action] { action = [options] { return record(*options); }; });
}

}  // namespace posecoach
