#include <thread>

#include "app/bench/bench.h"
#include "capture/simulated_student.h"
#include "core/image/image_codec.h"
#include "core/motion/bundled_motion.h"
#include "core/pipeline/pipeline_runner.h"
#include "core/pipeline/swing_loop.h"

namespace posecoach {
namespace {

// The simulated student as a perfect pose stage would see him, and one grey picture for all.
struct Seen {
  std::vector<SeenPerson> people;
  double fps = 30;
  std::shared_ptr<const Image> picture;

  Frame frame(std::size_t index) const {
    return {index, media_time_from_seconds(static_cast<double>(index) / fps), {}, picture};
  }
  PoseObservation observation(const Frame& frame) const {
    return {frame.index, frame.time, people[frame.index % people.size()]};
  }
};

Result<Seen> see_swing() {
  SimulatedStudentOptions options;
  options.frames_per_second = 30;
  const auto student = SimulatedStudent::make(options);
  if (!student) return tl::unexpected(student.error());
  const PinholeCamera& camera = (*student)->camera();
  Seen seen;
  Image image = Image::black(camera.width_px, camera.height_px);
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<std::uint8_t>(i * 2654435761U >> 26);
  seen.picture = std::make_shared<const Image>(std::move(image));
  for (int f = 0; f < (*student)->authored().motion.frame_count(); ++f) {
    const LandmarkArray<Vec3> points = (*student)->landmarks(f);
    const Vec3 hips =
        camera.camera_from_world(0.5 * (points[Landmark::LeftHip] + points[Landmark::RightHip]));
    SeenPerson person;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      person.image[i] = {camera.project(points[i]).value_or(Vec2(0)), 0.95};
      person.world[i] = {camera.camera_from_world(points[i]) - hips, 0.95};
    }
    seen.people.push_back(person);
  }
  return seen;
}

// `pose_time` is how long the pose stage takes.
class SeeingEstimator : public PoseEstimator {
 public:
  SeeingEstimator(Seen seen, Duration pose_time) : seen_(std::move(seen)), pose_time_(pose_time) {}
  Result<PoseObservation> estimate(const Frame& frame) override {
    if (pose_time_ > Duration(0)) std::this_thread::sleep_for(pose_time_);
    return seen_.observation(frame);
  }
  void reset() override {}

 private:
  Seen seen_;
  Duration pose_time_;
};

class SteadyCamera : public FrameSource {
 public:
  SteadyCamera(Seen seen, double fps) : seen_(std::move(seen)) { seen_.fps = fps; }
  const FrameSourceInfo& info() const override { return info_; }
  Result<std::optional<Frame>> next(std::stop_token stop) override {
    if (stop.stop_requested()) return std::optional<Frame>();
    return seen_.frame(next_++);
  }

 private:
  Seen seen_;
  FrameSourceInfo info_{"bench", 0, 0, 0, {}};
  std::size_t next_ = 0;
};

Result<void> bench_step(const Seen& seen, std::vector<BenchRow>& rows) {
  InlineWork work;
  CoachPipeline pipeline(std::make_unique<SeeingEstimator>(seen, Duration(0)), work);
  Result<Motion> coach = bundled_motion("swing");
  if (!coach) return tl::unexpected(coach.error());
  pipeline.set_coach(*std::move(coach), "bundled:swing");
  std::vector<double> times_ms;
  Result<void> failed;
  for (std::size_t i = 0; i < 600 && failed; ++i) {
    const double time_ms = milliseconds_of([&] {
      if (const auto snapshot = pipeline.step(seen.frame(i)); !snapshot)
        failed = tl::unexpected(snapshot.error());
    });
    // The body and the coach in it come within the first seconds.
    if (i >= 150) times_ms.push_back(time_ms);
  }
  if (failed)
    rows.push_back(make_bench_row("live step without pose, with ghost and checks", std::move(times_ms)));
  return failed;
}

void bench_answer(const Seen& seen, const Motion& coach, std::vector<BenchRow>& rows) {
  InlineWork work;
  SwingMemory memory(work);
  // Two seconds of standing, then the swing: a little over four seconds in all.
  for (std::size_t i = 0; i < 60 + seen.people.size(); ++i) {
    Frame frame = seen.frame(i);
    memory.add(frame, {i, frame.time, seen.people[i < 60 ? 0 : i - 60]});
  }
  const SwingComparison comparison{
      std::make_shared<const CoachInput>(CoachInput{"bundled:swing", coach}), {}, {}, {}};
  rows.push_back(measure("a swing's answer: lift and analyze", 10, [&] {
    (void)analyze_swing(memory.cut(MediaTime{}, MediaTime::max(), "bench"), comparison);
  }));
  rows.push_back(measure("a picture into the memory of the last seconds, 1280x720", 20,
                         [&] { (void)encode_jpeg(*seen.picture, 85); }));
}

// From capture to snapshot with a pose stage that skips every second picture: the first seconds against the
// last. A queue anywhere would let it rise.
void bench_lag(const Seen& seen, std::vector<BenchRow>& rows) {
  constexpr double kFps = 60;
  constexpr std::size_t kPoses = 240;
  PipelineRunner runner(std::make_unique<SeeingEstimator>(seen, std::chrono::milliseconds(20)),
                        [&](const std::string&) -> Result<std::unique_ptr<FrameSource>> {
                          return std::make_unique<SteadyCamera>(seen, kFps);
                        });
  runner.set_source({"bench"});
  std::vector<double> behind_ms;
  std::uint64_t last = 0;
  while (behind_ms.size() < kPoses) {
    const auto snapshot = runner.snapshot();
    if (snapshot->number == last || !snapshot->frame) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      continue;
    }
    last = snapshot->number;
    const auto newest = runner.newest_frame();
    behind_ms.push_back(1000 * to_seconds(newest->time - snapshot->frame->time));
  }
  const auto quarter = static_cast<std::ptrdiff_t>(kPoses / 4);
  rows.push_back(make_bench_row("shown picture behind the newest, first poses",
                                {behind_ms.begin(), behind_ms.begin() + quarter}));
  rows.push_back(make_bench_row("shown picture behind the newest, last poses",
                                {behind_ms.end() - quarter, behind_ms.end()}));
  const LiveCounters counters = runner.snapshot()->counters;
  rows.push_back(make_bench_row("capture to snapshot, pose stage of 20 ms", {counters.latency_median_ms}));
  rows.push_back(make_bench_row("capture to snapshot, 95th of a hundred", {counters.latency_p95_ms}));
}

}  // namespace

Result<void> bench_live(const BenchOptions&, std::vector<BenchRow>& rows) {
  const Result<Seen> seen = see_swing();
  if (!seen) return tl::unexpected(seen.error());
  const Result<Motion> coach = bundled_motion("swing");
  if (!coach) return tl::unexpected(coach.error());
  if (auto done = bench_step(*seen, rows); !done) return done;
  bench_answer(*seen, *coach, rows);
  bench_lag(*seen, rows);
  return {};
}

}  // namespace posecoach
