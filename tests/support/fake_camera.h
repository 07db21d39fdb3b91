// A camera driver that does what a test's script says: the other side of V4l2SystemCalls. It keeps a real
// driver's rules (formats are corrected, buffers are queued and dequeued in turn) and notes every break of
// them.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "capture/v4l2/camera_mode.h"
#include "capture/v4l2/system_calls.h"
#include "core/base/time.h"

namespace posecoach {

class FakeCamera : public V4l2SystemCalls {
 public:
  // What happens next, each once.
  struct Step {
    enum class Kind {
      Picture,      // `bytes` with `sequence` and the stamp of `at`
      Flagged,      // the same, but the driver says that it is damaged
      Nothing,      // the wait ends without a buffer
      Again,        // the wait says ready, but there is no buffer (EAGAIN)
      Interrupted,  // the wait ends with a signal
      Failing,      // the stream fails (EIO) until it is started again
      NewSize,      // the driver tells that the pictures' size changes
      Gone          // unplugged: from now on ENODEV
    };
    Kind kind = Kind::Picture;
    std::vector<std::uint8_t> bytes;
    std::uint32_t sequence = 0;
    Duration at{};  // CLOCK_MONOTONIC
  };

  // The pixels' size that it insists on, whatever is asked; 0: any of its modes.
  struct Habits {
    std::string name = "Fake camera";
    std::string driver = "fake";
    std::vector<CameraMode> modes = {};
    int only_width = 0, only_height = 0;
    std::size_t row_padding_bytes = 0;
    int open_error = 0;     // errno of every open
    int start_error = 0;    // errno of every STREAMON
    bool is_camera = true;  // else an output
    bool tells_rates = true;
    bool stamps_are_monotonic = true;
  };

  // A sensor that does not wait: each picture is there at its time, once, and goes into a buffer that the
  // program has queued. Where there is none it is lost, and its number is missing.
  struct Sensor {
    std::vector<std::vector<std::uint8_t>> pictures;
    Duration interval{};
    std::function<Duration()> clock;  // since any moment; the first picture comes at once
  };

  explicit FakeCamera(std::filesystem::path path, Habits habits);
  ~FakeCamera() override;

  void then(Step step);
  void then(Step::Kind kind) { then(Step{kind, {}, 0, {}}); }
  // After the script: one picture after another, or nothing (the default).
  void then_forever(std::vector<std::uint8_t> bytes);
  // The same, each made for the mode that was agreed, at this interval.
  using Scene = std::function<std::vector<std::uint8_t>(const ChosenMode& mode, std::uint32_t number)>;
  void then_forever(Scene scene, Duration interval);
  // Instead of a script.
  void look_with(Sensor sensor);
  // The device is there again, under another node; links in the file system decide what opens it.
  void plug_in_at(std::filesystem::path path);
  void unplug();

  // What it saw.
  std::vector<std::string> broken_rules() const;
  int opened() const;       // attempts
  int left_open() const;    // descriptors
  int left_mapped() const;  // buffers
  int started() const;      // STREAMON
  std::size_t steps_left() const;
  std::size_t pictures_lost() const;  // of the sensor's
  ChosenMode agreed() const;

  int open(const char* path, int flags) override;
  int close(int descriptor) override;
  int ioctl(int descriptor, unsigned long request, void* argument) override;
  void* mmap(std::size_t length, int protection, int flags, int descriptor, off_t offset) override;
  int munmap(void* address, std::size_t length) override;
  int poll(pollfd* descriptors, nfds_t count, int timeout_ms) override;

 private:
  struct Buffer {
    std::vector<std::uint8_t> memory;
    bool is_queued = false;
  };
  int answer(int descriptor, unsigned long request, void* argument);
  int enumerate_format(void* argument) const;
  int enumerate_size(void* argument) const;
  int enumerate_rate(void* argument) const;
  int describe(void* argument) const;
  int set_format(void* argument);
  int set_rate(void* argument);
  int request_buffers(void* argument);
  int query_buffer(void* argument);
  int queue_buffer(void* argument);
  int dequeue_buffer(void* argument);
  int start();
  int stop();
  std::size_t picture_bytes() const;
  void bury_buffers();
  void expose();
  void expect(bool kept, const char* rule);

  mutable std::mutex mutex_;
  std::filesystem::path path_;
  Habits habits_;
  std::deque<Step> steps_;
  std::optional<Sensor> sensor_;
  std::optional<Duration> sensor_began_;
  std::deque<Step> exposed_;  // in buffers that are not dequeued yet
  std::size_t taken_ = 0, lost_ = 0;
  Scene forever_;
  Duration forever_interval_ = std::chrono::milliseconds(2);
  std::uint32_t next_sequence_ = 0;
  bool is_gone_ = false, is_failing_ = false, is_streaming_ = false;
  ChosenMode agreed_;
  std::vector<Buffer> buffers_;
  std::deque<std::uint32_t> queued_;
  std::set<int> descriptors_, dead_descriptors_;
  std::map<void*, std::size_t> mapped_;
  std::vector<std::vector<std::uint8_t>> graveyard_;  // memory that is still mapped after its device went
  int next_descriptor_ = 1000, opened_ = 0, started_ = 0;
  std::vector<std::string> broken_rules_;
};

}  // namespace posecoach
