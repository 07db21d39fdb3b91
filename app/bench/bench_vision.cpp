#include <unistd.h>

#include <optional>

#include "app/bench/bench.h"
#include "app/pose_options.h"
#include "capture/open_source.h"
#include "capture/simulated_student.h"
#include "capture/video_writer.h"
#include "core/image/sampling.h"
#include "core/vision/detector.h"
#include "core/vision/landmark_model.h"

namespace posecoach {
namespace {

constexpr PoseModel kModels[] = {PoseModel::Lite, PoseModel::Full, PoseModel::Heavy};

std::optional<std::filesystem::path> models_of(const BenchOptions& options) {
  if (options.models.empty()) return std::nullopt;
  return options.models;
}

// The networks take the same time for any picture.
Image make_waves(int width, int height) {
  Image image = Image::black(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        image.pixel(x, y)[channel] = static_cast<std::uint8_t>((x * (channel + 2) + y * y / 7) & 255);
  return image;
}

void bench_crop(std::vector<BenchRow>& rows) {
  const Image image = make_waves(1280, 720);
  const RegionOfInterest region{{600, 380}, 560, 0.2};
  std::vector<float> out(3 * 256 * 256);
  rows.push_back(measure("crop 256x256 from 1280x720", 200, [&] {
    sample_square(image, region.square(), 256, OutsidePicture::RepeatsTheEdge, {1.0F / 255.0F, 0.0F}, out);
  }));
}

Result<void> bench_networks(const BenchOptions& options, std::vector<BenchRow>& rows) {
  const Image image = make_waves(1280, 720);
  const RegionOfInterest region{{600, 380}, 560, 0.2};
  const auto detector_file = find_model_file(kDetectorFileName, models_of(options));
  if (!detector_file) return tl::unexpected(detector_file.error());
  auto detector = Detector::load(*detector_file);
  if (!detector) return tl::unexpected(detector.error());
  rows.push_back(measure("detector, picture to people", 60, [&] { (void)detector->detect(image); }));
  for (const PoseModel model : kModels) {
    const auto file = find_model_file(landmark_file_name(model), models_of(options));
    if (!file) return tl::unexpected(file.error());
    auto landmarks = LandmarkModel::load(*file);
    if (!landmarks) return tl::unexpected(landmarks.error());
    rows.push_back(measure(std::string("landmarks ") + to_string(model) + ", picture to joints",
                           model == PoseModel::Heavy ? 20 : 60,
                           [&] { (void)landmarks->estimate(image, region); }));
  }
  return {};
}

// Decoding, crop, network and filters, frame after frame.
Result<void> bench_film(const BenchOptions& options, PoseModel model, Search search,
                        std::vector<BenchRow>& rows) {
  PoseTrackerOptions tracker_options;
  tracker_options.model = model;
  tracker_options.search = search;
  tracker_options.models = models_of(options);
  auto tracker = PoseTracker::make(tracker_options);
  if (!tracker) return tl::unexpected(tracker.error());
  auto source = open_source(options.film);
  if (!source) return tl::unexpected(source.error());
  std::vector<double> times_ms;
  Result<void> failed;
  bool goes_on = true;
  while (goes_on && failed && times_ms.size() < 200) {
    const double time_ms = milliseconds_of([&] {
      const auto frame = (*source)->next({});
      goes_on = frame && *frame;
      if (!frame) failed = tl::unexpected(frame.error());
      if (!goes_on) return;
      if (const auto seen = (*tracker)->estimate(**frame); !seen) failed = tl::unexpected(seen.error());
    });
    if (goes_on) times_ms.push_back(time_ms);
  }
  if (!failed) return failed;
  const char* way = search == Search::InEveryFrame ? ", detector in every frame" : ", tracking";
  rows.push_back(
      make_bench_row(std::string("film to joints, ") + to_string(model) + way, std::move(times_ms)));
  return {};
}

Result<void> bench_films(const BenchOptions& options, std::vector<BenchRow>& rows) {
  for (const PoseModel model : kModels)
    if (auto done = bench_film(options, model, Search::WhenLost, rows); !done) return done;
  return bench_film(options, PoseModel::Full, Search::InEveryFrame, rows);
}

// The simulated student's swing at 1280x720, for machines without a film.
Result<void> write_simulated_film(const std::filesystem::path& path) {
  constexpr std::size_t kFrames = 80;
  SimulatedStudentOptions student_options;
  student_options.frames_per_second = 30;
  auto student = SimulatedStudent::make(student_options);
  if (!student) return tl::unexpected(student.error());
  const FrameSourceInfo& info = (*student)->info();
  auto writer = VideoWriter::open(path, {info.width, info.height, info.nominal_fps});
  if (!writer) return tl::unexpected(writer.error());
  for (std::size_t i = 0; i < kFrames; ++i) {
    const auto frame = (*student)->next({});
    if (!frame) return tl::unexpected(frame.error());
    if (!*frame) break;
    if (auto written = (*writer)->write(*(*frame)->image, (*frame)->time); !written) return written;
  }
  return (*writer)->finish();
}

Result<void> bench_simulated_film(BenchOptions options, std::vector<BenchRow>& rows) {
  std::error_code reason;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(reason);
  if (reason)
    return fail(ErrorCode::Unreadable, "there is no folder for temporary files: " + reason.message());
  const std::filesystem::path film = folder / ("posecoach_bench_" + std::to_string(::getpid()) + ".mp4");
  auto done = write_simulated_film(film);
  options.film = film.string();
  if (done) done = bench_films(options, rows);
  std::filesystem::remove(film, reason);
  return done;
}

}  // namespace

Result<void> bench_vision(const BenchOptions& options, std::vector<BenchRow>& rows) {
  bench_crop(rows);
  if (auto done = bench_networks(options, rows); !done) return done;
  return options.film.empty() ? bench_simulated_film(options, rows) : bench_films(options, rows);
}

}  // namespace posecoach
