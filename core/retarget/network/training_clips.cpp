#include <algorithm>

#include "core/base/log.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"
#include "core/retarget/network/training.h"

namespace posecoach {

namespace fs = std::filesystem;

Result<std::vector<TurnClip>> load_training_clips(const fs::path& folder) {
  std::error_code code;
  if (!fs::is_directory(folder, code))
    return fail(ErrorCode::NotFound, folder.string() + ": no such folder of motions to train on");
  std::vector<fs::path> files;
  for (auto it = fs::recursive_directory_iterator(folder, code); it != fs::recursive_directory_iterator();
       it.increment(code)) {
    if (code) break;
    if (it->is_directory() && it->path().filename() == "paired") it.disable_recursion_pending();
    const std::string ending = it->path().extension().string();
    if (it->is_regular_file() && (ending == ".bvh" || ending == ".amc")) files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  std::vector<TurnClip> clips;
  for (const fs::path& file : files) {
    Result<MotionFile> read = read_motion_file(file, {.amc_frames_per_second = 60});
    Result<TurnClip> clip = read ? make_turn_clip(fs::relative(file, folder).string(), read->motion)
                                 : Result<TurnClip>(tl::unexpected(read.error()));
    if (clip)
      clips.push_back(*std::move(clip));
    else
      log::warning("not trained on: " + clip.error().message);
  }
  for (const std::string& name : bundled_motion_names()) {
    const Result<Motion> motion = bundled_motion(name);
    Result<TurnClip> clip = motion ? make_turn_clip("bundled:" + name, *motion)
                                   : Result<TurnClip>(tl::unexpected(motion.error()));
    if (clip) clips.push_back(*std::move(clip));
  }
  if (clips.empty()) return fail(ErrorCode::Incomplete, folder.string() + ": no .bvh or .amc motions in it");
  return clips;
}

ClipSplit split_clips(std::vector<TurnClip> clips) {
  ClipSplit split;
  for (std::size_t i = 0; i < clips.size(); ++i)
    (i % 8 == 5 ? split.held_out : split.train).push_back(std::move(clips[i]));
  return split;
}

void repeat_golf(std::vector<TurnClip>& clips, double share) {
  const auto is_golf = [](const TurnClip& clip) {
    return clip.name.find("golf") != std::string::npos || clip.name.starts_with("bundled:");
  };
  double golf = 0, other = 0;
  for (const TurnClip& clip : clips)
    (is_golf(clip) ? golf : other) += static_cast<double>(clip.frames.size());
  if (golf == 0) return;
  const int copies = static_cast<int>(share / (1 - share) * other / golf);
  const std::size_t given = clips.size();
  for (int copy = 1; copy < copies; ++copy)
    for (std::size_t i = 0; i < given; ++i)
      if (is_golf(clips[i])) clips.push_back(TurnClip(clips[i]));
}

}  // namespace posecoach
