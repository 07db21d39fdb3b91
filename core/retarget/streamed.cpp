#include "core/retarget/streamed.h"

#include "core/base/assert.h"

namespace posecoach {

StreamedRetargeter::StreamedRetargeter(Skeleton coach, Skeleton body, RetargetOptions options,
                                       double memory_s)
    : coach_(std::move(coach)), body_(std::move(body)), options_(std::move(options)), memory_s_(memory_s) {
  options_.contacts = Contacts::Off;
}

Result<Motion> StreamedRetargeter::push(MediaTime time, std::span<const Vec3> positions,
                                        std::span<const double> confidence) {
  POSECOACH_ASSERT(positions.size() == static_cast<std::size_t>(coach_.size()));
  POSECOACH_ASSERT(confidence.size() == positions.size());
  while (!frames_.empty() && to_seconds(time - frames_.front().time) > memory_s_) frames_.pop_front();
  std::vector<MediaTime> times;
  std::vector<Vec3> all;
  std::vector<double> sure;
  for (const Frame& frame : frames_) {
    times.push_back(frame.time);
    all.insert(all.end(), frame.positions.begin(), frame.positions.end());
    sure.insert(sure.end(), frame.confidence.begin(), frame.confidence.end());
  }
  times.push_back(time);
  all.insert(all.end(), positions.begin(), positions.end());
  sure.insert(sure.end(), confidence.begin(), confidence.end());
  const Result<Motion> window =
      Motion::from_positions(coach_, std::move(times), std::move(all), std::move(sure));
  if (!window) return tl::unexpected(window.error());
  const Result<RetargetResult> carried = retarget(*window, body_, options_);
  if (!carried) return tl::unexpected(carried.error());
  frames_.push_back({time, {positions.begin(), positions.end()}, {confidence.begin(), confidence.end()}});
  const int last = carried->motion.frame_count() - 1;
  return carried->motion.slice(last, last + 1);
}

}  // namespace posecoach
