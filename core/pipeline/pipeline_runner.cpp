#include "core/pipeline/pipeline_runner.h"

#include <vector>

#include "core/base/latest_value.h"
#include "core/base/thread_name.h"
#include "core/coaching/text/set_up_text.h"
#include "core/pipeline/live_meter.h"

namespace posecoach {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Duration kLookAround = std::chrono::milliseconds(100);
constexpr Duration kStalled = std::chrono::seconds(1);

// A stalled or lost source has nobody before it.
void forget_student(CoachSnapshot& snapshot) {
  snapshot.person.reset();
  snapshot.student.reset();
  snapshot.camera.reset();
  snapshot.ghost.reset();
  snapshot.address_advice.clear();
}

}  // namespace

class PipelineRunner::Implementation {
 public:
  Implementation(std::unique_ptr<PoseEstimator> estimator, SourceOpener open, PipelineRunnerOptions options)
      : pipeline_(std::move(estimator), work_, std::move(options.pipeline)),
        published_(std::make_shared<const CoachSnapshot>()),
        pump_(
            std::move(open), [this](PumpedFrame frame) { receive(std::move(frame)); }, options.pump),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}

  ~Implementation() {
    thread_.request_stop();
    thread_.join();
  }

  void set_source(SourceChoice choice) {
    pump_.set_source(std::move(choice));
    frames_.wake();
  }
  void set_tap(std::function<void(const Frame&)> tap) { pump_.set_tap(std::move(tap)); }

  void request(std::function<void(CoachPipeline&)> action) {
    {
      const std::lock_guard lock(mutex_);
      requests_.push_back(std::move(action));
    }
    frames_.wake();
  }

  std::shared_ptr<const CoachSnapshot> snapshot() const {
    const std::lock_guard lock(mutex_);
    return published_;
  }
  std::optional<Frame> newest_frame() const {
    const std::lock_guard lock(mutex_);
    return newest_frame_;
  }

 private:
  // On the capture thread.
  void receive(PumpedFrame frame) {
    {
      const std::lock_guard lock(mutex_);
      newest_frame_ = frame.frame;
      capture_rate_.count(Clock::now());
    }
    frames_.put(std::move(frame));
  }

  void run(const std::stop_token& stop) {
    name_this_thread("coach-pose");
    while (!stop.stop_requested()) {
      serve_requests();
      if (std::optional<PumpedFrame> frame = frames_.take(stop, kLookAround))
        step(*frame);
      else
        look_around();
    }
  }

  void serve_requests() {
    std::vector<std::function<void(CoachPipeline&)>> requests;
    {
      const std::lock_guard lock(mutex_);
      requests.swap(requests_);
    }
    for (const auto& request : requests) request(pipeline_);
  }

  void step(const PumpedFrame& frame) {
    const PumpStatus status = pump_.status();
    if (frame.choice != status.choice) return;  // of a source that was given up meanwhile
    if (frame.choice != choice_)
      change_source(status);
    else if (frame.opening != opening_)
      pipeline_.start_take();
    opening_ = frame.opening;
    Result<CoachSnapshot> snapshot = pipeline_.step(frame.frame);
    const Clock::time_point now = Clock::now();
    pose_rate_.count(now);
    latency_.add(now - frame.arrived_at);
    if (snapshot) {
      publish(*std::move(snapshot), status, {});
    } else {
      CoachSnapshot without = *this->snapshot();
      without.frame = frame.frame;
      forget_student(without);
      publish(std::move(without), status, snapshot.error().message);
    }
  }

  void change_source(const PumpStatus& status) {
    choice_ = status.choice;
    pipeline_.change_source(status.source);
    overtaken_before_ = frames_.overtaken();
    pose_rate_.reset();
    latency_.reset();
  }

  // No frame has come: is it still there?
  void look_around() {
    const PumpStatus status = pump_.status();
    const std::shared_ptr<const CoachSnapshot> last = snapshot();
    const bool is_stalled =
        status.state == SourceState::Live && Clock::now() - status.last_frame_at > kStalled;
    const SourceState state = is_stalled ? SourceState::Stalled : status.state;
    const bool is_news = state != last->source_state || status.source != last->source ||
                         status.message != last->source_message;
    if (state == SourceState::Live || (!is_news && !is_stalled)) return;
    if (is_stalled && last->source_state == SourceState::Stalled) return;
    CoachSnapshot quiet = *last;
    if (state != SourceState::Ended) forget_student(quiet);
    if (status.choice != choice_) quiet.frame.reset();
    publish(std::move(quiet), status, {});
  }

  void publish(CoachSnapshot snapshot, const PumpStatus& status, const std::string& problem) {
    const Clock::time_point now = Clock::now();
    const bool is_stalled = status.state == SourceState::Live && now - status.last_frame_at > kStalled;
    snapshot.number = ++number_;
    snapshot.source = status.source;
    snapshot.source_state = is_stalled ? SourceState::Stalled : status.state;
    snapshot.source_message = is_stalled ? text::no_picture_from(status.source) : status.message;
    if (!problem.empty()) snapshot.source_message = problem;
    LiveCounters& counters = snapshot.counters;
    counters.captured = status.captured;
    counters.lost_by_camera = status.lost_by_camera;
    counters.skipped_by_pose = frames_.overtaken() - overtaken_before_;
    counters.pose_fps = pose_rate_.per_second(now);
    latency_.fill(counters);
    auto published = std::make_shared<CoachSnapshot>(std::move(snapshot));
    std::shared_ptr<const CoachSnapshot> old;  // dies after the lock
    const std::lock_guard lock(mutex_);
    published->counters.captured_fps = capture_rate_.per_second(now);
    old = std::exchange(published_, std::move(published));
  }

  ThreadedWork work_;
  CoachPipeline pipeline_;
  LatestValue<PumpedFrame> frames_;

  mutable std::mutex mutex_;
  std::vector<std::function<void(CoachPipeline&)>> requests_;
  std::shared_ptr<const CoachSnapshot> published_;
  std::optional<Frame> newest_frame_;
  RateMeter capture_rate_;

  // Of the pose thread alone.
  std::uint64_t choice_ = 0, opening_ = 0, number_ = 0, overtaken_before_ = 0;
  RateMeter pose_rate_;
  LatencyMeter latency_;

  FramePump pump_;       // stopped before what it feeds
  std::jthread thread_;  // last: it uses all of the above
};

PipelineRunner::PipelineRunner(std::unique_ptr<PoseEstimator> estimator, SourceOpener open,
                               PipelineRunnerOptions options)
    : implementation_(
          std::make_unique<Implementation>(std::move(estimator), std::move(open), std::move(options))) {}
PipelineRunner::~PipelineRunner() = default;

void PipelineRunner::set_source(SourceChoice choice) {
  implementation_->set_source(std::move(choice));
}
void PipelineRunner::request(std::function<void(CoachPipeline&)> action) {
  implementation_->request(std::move(action));
}
void PipelineRunner::set_tap(std::function<void(const Frame&)> tap) {
  implementation_->set_tap(std::move(tap));
}
std::shared_ptr<const CoachSnapshot> PipelineRunner::snapshot() const {
  return implementation_->snapshot();
}
std::optional<Frame> PipelineRunner::newest_frame() const {
  return implementation_->newest_frame();
}

}  // namespace posecoach
