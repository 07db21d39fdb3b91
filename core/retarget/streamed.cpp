#include "core/retarget/streamed.h"

#include "core/base/assert.h"

namespace posecoach {

StreamedRetargeter::StreamedRetargeter(Skeleton coach, Skeleton body, RetargetOptions options,
                                       double memory_s)
    : coach_(std::move(coach)), body_(std::move(body)), options_(std::move(options)), memory_s_(memory_s) {
  options_.contacts = Contacts::Off;
  if (options_.method != RetargetMethod::Network && options_.method != RetargetMethod::Paper &&
      options_.smoothing == InputSmoothing::Off)
    memory_s_ = 0;
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

Result<RetargetResult> retarget_streamed(const Motion& coach, const Skeleton& body,
                                         const RetargetOptions& options) {
  POSECOACH_ASSERT(options.method != RetargetMethod::Scale);
  StreamedRetargeter stream(coach.skeleton(), body, options);
  std::vector<Vec3> roots;
  std::vector<Quat> rotations;
  std::vector<double> confidence(static_cast<std::size_t>(coach.joint_count()));
  for (int f = 0; f < coach.frame_count(); ++f) {
    for (int j = 0; j < coach.joint_count(); ++j)
      confidence[static_cast<std::size_t>(j)] = coach.confidence(f, j);
    const Result<Motion> frame = stream.push(coach.time(f), coach.positions(f), confidence);
    if (!frame) return tl::unexpected(frame.error());
    roots.push_back(frame->position(0, 0));
    rotations.insert(rotations.end(), frame->rotations(0).begin(), frame->rotations(0).end());
  }
  Result<Motion> motion = Motion::from_rotations(body, {coach.times().begin(), coach.times().end()},
                                                 std::move(roots), std::move(rotations));
  if (!motion) return tl::unexpected(motion.error());
  const double bone_error = bone_length_error(*motion);
  return RetargetResult{*std::move(motion), bone_error, {}, {}};
}

}  // namespace posecoach
