#include "app/window/sounds.h"

#include <alsa/asoundlib.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <numbers>
#include <thread>
#include <utility>
#include <vector>

namespace posecoach {
namespace {

constexpr unsigned kRate_hz = 44100;

// Pairs of pitch in hertz and length in seconds.
std::vector<std::pair<double, double>> notes_of(Tone tone) {
  switch (tone) {
    case Tone::Ready:
      return {{880, 0.18}};
    case Tone::Swing:
      return {{660, 0.07}};
    case Tone::Answer:
      return {{660, 0.11}, {880, 0.16}};
    case Tone::Trouble:
      return {{330, 0.25}};
  }
  return {};
}

std::vector<std::int16_t> samples_of(Tone tone) {
  std::vector<std::int16_t> samples;
  for (const auto& [pitch, seconds] : notes_of(tone)) {
    const int count = static_cast<int>(seconds * kRate_hz);
    for (int i = 0; i < count; ++i) {
      // Soft at both ends: no clicks.
      const double edge = std::min({1.0, i / 400.0, (count - i) / 1200.0});
      const double wave = std::sin(2 * std::numbers::pi * pitch * i / kRate_hz);
      samples.push_back(static_cast<std::int16_t>(std::lround(9000 * edge * wave)));
    }
  }
  return samples;
}

// ALSA would write to standard error where there is no device.
void say_nothing(const char*, int, const char*, int, const char*, ...) {}

snd_pcm_t* open_device() {
  snd_lib_error_set_handler(say_nothing);
  snd_pcm_t* device = nullptr;
  if (snd_pcm_open(&device, "default", SND_PCM_STREAM_PLAYBACK, 0) < 0) return nullptr;
  constexpr unsigned kLatency_us = 100'000;
  if (snd_pcm_set_params(device, SND_PCM_FORMAT_S16, SND_PCM_ACCESS_RW_INTERLEAVED, 1, kRate_hz, 1,
                         kLatency_us) < 0) {
    snd_pcm_close(device);
    return nullptr;
  }
  return device;
}

}  // namespace

class Sounds::Player {
 public:
  Player() : device_(open_device()) {
    if (device_ != nullptr) thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  ~Player() {
    if (device_ == nullptr) return;
    thread_.request_stop();
    thread_.join();
    snd_pcm_close(device_);
  }
  bool has_device() const { return device_ != nullptr; }
  void play(Tone tone) {
    if (device_ == nullptr) return;
    const std::lock_guard lock(mutex_);
    if (waiting_.size() < 3) waiting_.push_back(tone);
    arrived_.notify_one();
  }

 private:
  void run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (arrived_.wait(lock, stop, [&] { return !waiting_.empty(); })) {
      const Tone tone = waiting_.front();
      waiting_.pop_front();
      lock.unlock();
      const std::vector<std::int16_t> samples = samples_of(tone);
      (void)snd_pcm_prepare(device_);
      (void)snd_pcm_writei(device_, samples.data(), samples.size());
      (void)snd_pcm_drain(device_);
      lock.lock();
    }
  }

  snd_pcm_t* device_;
  std::mutex mutex_;
  std::condition_variable_any arrived_;
  std::deque<Tone> waiting_;
  std::jthread thread_;
};

Sounds::Sounds() : player_(std::make_unique<Player>()) {}
Sounds::~Sounds() = default;

bool Sounds::has_device() const {
  return player_->has_device();
}

void Sounds::play(Tone tone) {
  player_->play(tone);
}

}  // namespace posecoach
