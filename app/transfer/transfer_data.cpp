#include "app/transfer/transfer_data.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "core/base/log.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

// A rest pose alone says nothing about how people move.
constexpr int kFewestFrames = 30;
// What methods are measured with never trains them.
constexpr std::string_view kOnlyForMeasuring = "paired";

Result<std::vector<fs::path>> files_below(const fs::path& folder, std::string_view without = {}) {
  std::error_code reason;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator entry(folder, reason), end; !reason && entry != end;
       entry.increment(reason)) {
    if (entry->is_directory() && entry->path().filename() == without) entry.disable_recursion_pending();
    if (entry->is_regular_file()) files.push_back(entry->path());
  }
  if (reason)
    return fail(ErrorCode::NotFound, "cannot read the folder " + folder.string() + ": " + reason.message());
  std::sort(files.begin(), files.end());
  return files;
}

bool is_motion(const fs::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".bvh" || ending == ".amc" || ending == ".trc" || ending == ".c3d";
}

Result<PoseClip> read_clip(const fs::path& path, const std::string& name) {
  const Result<MotionFile> file = read_motion_file(path);
  if (!file) return tl::unexpected(file.error());
  Result<PoseClip> clip = make_pose_clip(name, file->motion);
  if (!clip) return fail(clip.error().code, path.string() + ": " + clip.error().message);
  return clip;
}

}  // namespace

Result<std::vector<PoseClip>> read_training_clips(const fs::path& folder) {
  const Result<std::vector<fs::path>> files = files_below(folder, kOnlyForMeasuring);
  if (!files) return tl::unexpected(files.error());
  std::vector<PoseClip> clips;
  for (const fs::path& path : *files) {
    if (!is_motion(path)) continue;
    Result<PoseClip> clip = read_clip(path, fs::relative(path, folder).string());
    if (!clip)
      log::warning("passed over: " + clip.error().message);
    else if (static_cast<int>(clip->poses.size()) >= kFewestFrames)
      clips.push_back(*std::move(clip));
  }
  if (clips.empty())
    return fail(ErrorCode::Incomplete, "there is no motion of a whole body in " + folder.string());
  for (const std::string& name : bundled_motion_names()) {
    const Result<Motion> motion = bundled_motion(name);
    if (!motion) return tl::unexpected(motion.error());
    Result<PoseClip> clip = make_pose_clip("bundled:" + name, *motion);
    if (!clip) return tl::unexpected(clip.error());
    clips.push_back(*std::move(clip));
  }
  return clips;
}

Result<std::vector<Character>> read_characters(const fs::path& folder) {
  const Result<std::vector<fs::path>> files = files_below(folder);
  if (!files) return tl::unexpected(files.error());
  std::map<std::string, Character> characters;
  std::map<std::string, int> performers;
  for (const fs::path& path : *files) {
    if (!is_motion(path)) continue;
    const std::string name = fs::relative(path.parent_path(), folder).string(), motion = path.stem().string();
    Result<PoseClip> clip = read_clip(path, motion);
    if (!clip) return tl::unexpected(clip.error());
    Character& character = characters[name];
    character.name = name;
    character.clips.push_back(*std::move(clip));
    ++performers[motion];
  }
  if (std::none_of(performers.begin(), performers.end(), [](const auto& entry) { return entry.second > 1; }))
    return fail(ErrorCode::Incomplete, folder.string() +
                                           ": no motion is there for two characters; wanted are "
                                           "CHARACTER/MOTION.bvh, the same motion under the same name");
  std::vector<Character> result;
  for (auto& [name, character] : characters) result.push_back(std::move(character));
  return result;
}

}  // namespace posecoach
