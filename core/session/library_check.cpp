// Whether everything in the library is as it was stored.
#include <algorithm>

#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/body/body_file.h"
#include "core/motion/motion_file.h"
#include "core/motion/pose_file.h"
#include "core/session/library.h"
#include "core/session/sha256.h"
#include "core/session/swing_folders.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kMotionEndings[] = {".pose.json", ".bvh", ".trc", ".c3d"};

Result<void> opens(const fs::path& file, const Library::FilmCheck& film) {
  const std::string name = file.filename().string();
  const auto outcome = [](const auto& result) -> Result<void> {
    if (!result) return tl::unexpected(result.error());
    return {};
  };
  if (name.starts_with("film.")) return film ? film(file) : Result<void>();
  if (name.ends_with(".body.json")) return outcome(read_body_file(file));
  if (name == "pose.pose.json") return outcome(read_pose_track(file));
  if (std::any_of(std::begin(kMotionEndings), std::end(kMotionEndings),
                  [&](std::string_view ending) { return name.ends_with(ending); }))
    return outcome(motion_format(file));
  if (!name.ends_with(".json")) return {};
  const Result<std::string> text = read_file(file);
  if (!text) return tl::unexpected(text.error());
  return walk_json(file.string(), *text, {});
}

Result<void> as_stored(const fs::path& file, const StoredFile& stored, const Library::FilmCheck& film,
                       const Progress& progress) {
  const Result<FileDigest> digest = digest_file(file, progress);
  if (!digest && digest.error().code == ErrorCode::NotFound)
    return fail(ErrorCode::NotFound, file.filename().string() + " is missing");
  if (!digest) return tl::unexpected(digest.error());
  if (digest->bytes != stored.bytes)
    return fail(ErrorCode::Malformed, file.filename().string() + " has " + std::to_string(digest->bytes) +
                                          " bytes instead of " + std::to_string(stored.bytes));
  if (digest->sha256 != stored.sha256)
    return fail(ErrorCode::Malformed, file.filename().string() + " is not as it was stored: SHA-256 differs");
  return opens(file, film);
}

}  // namespace

Result<std::vector<Finding>> Library::check(const FilmCheck& film, const Progress& progress) {
  std::vector<Finding> findings;
  const Result<std::vector<FoundSwing>> found = find_swings(folder_);
  if (!found) return tl::unexpected(found.error());
  for (std::size_t i = 0; i < found->size(); ++i) {
    const double done = static_cast<double>(i) / static_cast<double>(found->size());
    if (!report(progress, "checking", done)) return fail(ErrorCode::Cancelled, "stopped");
    const auto& [shelf, id, stamp] = (*found)[i];
    const std::string where = (shelf == Shelf::Trash ? "Trash/" : "") + id;
    const Result<Swing> swing = read_swing(swing_folder(shelf, id));
    if (!swing) {
      findings.push_back({where, "unreadable: " + swing.error().message});
      continue;
    }
    const auto may_go_on = [&](std::string_view stage, double) { return report(progress, stage, done); };
    for (const auto& [name, stored] : swing->files) {
      const Result<void> checked = as_stored(swing->folder / name, stored, film, may_go_on);
      if (!checked && checked.error().code == ErrorCode::Cancelled) return tl::unexpected(checked.error());
      if (!checked) findings.push_back({where, checked.error().message});
    }
    std::error_code failed;
    for (fs::directory_iterator entry(swing->folder, failed), end; !failed && entry != end;
         entry.increment(failed))
      if (const std::string name = entry->path().filename().string();
          name != kSwingFile && !swing->files.contains(name))
        findings.push_back({where, name + " does not belong to the swing"});
  }
  for (const Leftover& leftover : leftovers())
    findings.push_back({fs::relative(leftover.folder, folder_).string(),
                        "a recording of " + to_words(leftover.facts.recorded_at) +
                            " that was never finished: `library recover` keeps what there is of it"});
  return findings;
}

}  // namespace posecoach
