// How swings come into the library and leave it for good: everything that passes through .unfinished/.
#include <algorithm>
#include <cerrno>

#include "core/base/file.h"
#include "core/base/log.h"
#include "core/session/library.h"
#include "core/session/sha256.h"
#include "core/session/swing_folders.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr int kDraftTries = 20;

// What is in a draft besides swing.json, by name.
std::vector<fs::path> contents(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored) && entry->path().filename() != kSwingFile &&
        !is_temporary(entry->path()))
      files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Lengths and digests, with everything on the disk afterwards.
Result<std::map<std::string, StoredFile>> settle(Disk& disk, const fs::path& folder,
                                                 const Progress& progress) {
  std::map<std::string, StoredFile> stored;
  remove_dead_temporaries(disk, folder);
  for (const fs::path& file : contents(folder)) {
    Result<FileDigest> digest = digest_file(file, progress);
    if (!digest) return tl::unexpected(digest.error());
    if (const Result<void> synced = sync(disk, file); !synced) return tl::unexpected(synced.error());
    stored[file.filename().string()] = {digest->bytes, std::move(digest->sha256)};
  }
  return stored;
}

Result<void> link_or_copy(Disk& disk, const fs::path& from, const fs::path& to) {
  if (disk.link(from.c_str(), to.c_str()) == 0) return {};
  return copy_file(disk, from, to);
}

// What a dead recorder left, as far as it can be told.
SwingFacts facts_of(const fs::path& folder) {
  if (const Result<Swing> swing = read_swing(folder)) return swing->facts;
  SwingFacts facts;
  std::error_code failed;
  const auto changed = fs::last_write_time(folder, failed);
  const auto utc = failed ? std::chrono::system_clock::now() : std::chrono::file_clock::to_sys(changed);
  facts.recorded_at = wall_time_at(std::chrono::floor<std::chrono::milliseconds>(utc));
  return facts;
}

std::uint64_t film_bytes(const fs::path& folder) {
  for (const fs::path& file : contents(folder)) {
    std::error_code failed;
    const auto bytes = fs::file_size(file, failed);
    if (file.filename().string().starts_with("film.") && !failed) return bytes;
  }
  return 0;
}

}  // namespace

Result<SwingDraft> Library::begin(SwingFacts facts) {
  const std::scoped_lock lock(mutex_);
  if (facts.recorded_at.utc.time_since_epoch().count() == 0) facts.recorded_at = wall_time_now();
  Result<DraftFolder> folder = DraftFolder::make(disk_, unfinished(), DraftKind::Swing);
  if (!folder) return tl::unexpected(folder.error());
  SwingDraft draft(disk_, *std::move(folder), facts);
  if (const Result<void> described = draft.describe(facts); !described)
    return tl::unexpected(described.error());
  return draft;
}

Result<SwingDraft> Library::begin_again(std::string_view id) {
  const std::scoped_lock lock(mutex_);
  Result<Swing> swing = find_unlocked(id);
  if (!swing) return tl::unexpected(swing.error());
  if (swing->shelf == Shelf::Trash)
    return fail(ErrorCode::InvalidArgument, swing->id + " is in the trash; restore it first");
  Result<DraftFolder> folder = DraftFolder::make(disk_, unfinished(), DraftKind::Again, swing->id);
  if (!folder) return tl::unexpected(folder.error());
  SwingDraft draft(disk_, *std::move(folder), swing->facts);
  for (const fs::path& file : contents(swing->folder))
    if (const Result<void> taken = link_or_copy(disk_, file, draft.path(file.filename().string())); !taken)
      return tl::unexpected(taken.error());
  // For the keys in it that this version does not know.
  const fs::path facts_file = draft.path(kSwingFile);
  if (const Result<void> copied = copy_file(disk_, swing->folder / kSwingFile, facts_file); !copied)
    return tl::unexpected(copied.error());
  return draft;
}

Result<Swing> Library::keep(SwingDraft draft, const Progress& progress) {
  Result<Swing> kept = keep_contents(draft, progress);
  // A recording that cannot be kept now, on a full disk for one, is offered again later.
  if (!kept && kept.error().code != ErrorCode::Cancelled && draft.place_.target().empty())
    draft.place_.leave();
  return kept;
}

Result<Swing> Library::keep_contents(SwingDraft& draft, const Progress& progress) {
  // Digests take a while: nobody waits for them.
  Result<std::map<std::string, StoredFile>> files = settle(disk_, draft.folder(), progress);
  if (!files) return tl::unexpected(files.error());
  const std::scoped_lock lock(mutex_);
  if (const Result<void> stored = store_facts(draft.folder(), draft.facts(), *std::move(files)); !stored)
    return tl::unexpected(stored.error());
  const std::string& target = draft.place_.target();
  if (target.empty()) return put_in_place(draft.folder(), draft.facts().recorded_at);
  if (const Result<void> replaced = replace(draft, target); !replaced)
    return tl::unexpected(replaced.error());
  return read_swing(swing_folder(Shelf::Kept, target));
}

Result<void> Library::store_facts(const fs::path& folder, const SwingFacts& facts,
                                  std::map<std::string, StoredFile> files) {
  Swing swing;
  swing.facts = facts;
  swing.files = std::move(files);
  const fs::path file = folder / kSwingFile;
  return store_file(disk_, file, swing_to_json(swing, read_file(file, kLargestSwingFile).value_or("")));
}

// A name of its own, which no other program takes in the same moment.
Result<Swing> Library::put_in_place(const fs::path& folder, const WallTime& recorded_at) {
  const fs::path day = folder_ / day_of(recorded_at);
  for (int attempt = 0; attempt < kDraftTries; ++attempt) {
    if (const Result<void> made = make_folders(disk_, day); !made) return tl::unexpected(made.error());
    const fs::path place = day / ("swing_" + clock_of(recorded_at) + "_" + random_letters());
    if (disk_.rename_to_new(folder.c_str(), place.c_str()) == 0) {
      if (const Result<void> synced = sync(disk_, day); !synced) return tl::unexpected(synced.error());
      return read_swing(place);
    }
    if (errno != EEXIST && errno != ENOTEMPTY && errno != ENOENT)
      return tl::unexpected(disk_error("move into place", folder));
  }
  return fail(ErrorCode::Unreadable, "cannot find a free name for a swing in " + day.string());
}

// In one step where the file system can; else in two, of which finish_interrupted() makes up for the second.
Result<void> Library::replace(SwingDraft& draft, const std::string& target) {
  const fs::path place = swing_folder(Shelf::Kept, target);
  if (disk_.exchange(draft.folder().c_str(), place.c_str()) == 0) return sync(disk_, place.parent_path());
  if (errno != EINVAL && errno != ENOSYS && errno != ENOTSUP)
    return tl::unexpected(disk_error("replace", place));
  Result<DraftFolder> old = DraftFolder::reserve(disk_, unfinished(), DraftKind::Replaced, target);
  if (!old) return tl::unexpected(old.error());
  if (disk_.rename(place.c_str(), old->path().c_str()) != 0)
    return tl::unexpected(disk_error("replace", place));
  if (disk_.rename(draft.folder().c_str(), place.c_str()) == 0) return sync(disk_, place.parent_path());
  const Error error = disk_error("replace", place);
  if (disk_.rename(old->path().c_str(), place.c_str()) != 0) old->leave();
  return tl::unexpected(error);
}

Result<void> Library::purge_folder(const fs::path& folder) {
  Result<DraftFolder> place = DraftFolder::reserve(disk_, unfinished(), DraftKind::Purged);
  if (!place) return tl::unexpected(place.error());
  if (disk_.rename(folder.c_str(), place->path().c_str()) != 0)
    return tl::unexpected(disk_error("remove", folder));
  disk_.remove(folder.parent_path().c_str());
  return remove_folder(disk_, place->path());
}

Result<void> Library::purge(std::string_view id) {
  const std::scoped_lock lock(mutex_);
  const Result<std::vector<FoundSwing>> all = find_swings(folder_);
  if (!all) return tl::unexpected(all.error());
  std::vector<FoundSwing> found;
  for (const FoundSwing& swing : matching(*all, id))
    if (swing.shelf == Shelf::Trash) found.push_back(swing);
  if (found.size() != 1)
    return fail(found.empty() ? ErrorCode::NotFound : ErrorCode::InvalidArgument,
                "\"" + std::string(id) + "\" is no one swing of the trash; only what is there can be purged");
  return purge_folder(swing_folder(Shelf::Trash, found.front().id));
}

Result<std::size_t> Library::empty_trash() {
  const std::scoped_lock lock(mutex_);
  const Result<std::vector<FoundSwing>> all = find_swings(folder_);
  if (!all) return tl::unexpected(all.error());
  std::size_t purged = 0;
  for (const FoundSwing& swing : *all) {
    if (swing.shelf != Shelf::Trash) continue;
    if (const Result<void> done = purge_folder(swing_folder(Shelf::Trash, swing.id)); !done)
      return tl::unexpected(done.error());
    ++purged;
  }
  return purged;
}

std::vector<Leftover> Library::leftovers() {
  const std::scoped_lock lock(mutex_);
  std::vector<Leftover> leftovers;
  for (const AbandonedDraft& draft : abandoned_drafts(unfinished()))
    if (draft.kind == DraftKind::Swing)
      leftovers.push_back({draft.path, facts_of(draft.path), film_bytes(draft.path)});
  return leftovers;
}

Result<Swing> Library::recover(const Leftover& leftover) {
  Result<std::map<std::string, StoredFile>> files = settle(disk_, leftover.folder, {});
  if (!files) return tl::unexpected(files.error());
  const std::scoped_lock lock(mutex_);
  if (const Result<void> stored = store_facts(leftover.folder, leftover.facts, *std::move(files)); !stored)
    return tl::unexpected(stored.error());
  Result<Swing> kept = put_in_place(leftover.folder, leftover.facts.recorded_at);
  if (kept) forget_draft(disk_, leftover.folder);
  return kept;
}

Result<void> Library::discard(const Leftover& leftover) {
  const std::scoped_lock lock(mutex_);
  if (const Result<void> removed = remove_folder(disk_, leftover.folder); !removed) return removed;
  forget_draft(disk_, leftover.folder);
  return {};
}

// After a crash: halves of files go, swings on their way back come back where nothing took their place, and
// then everything that was on its way out and drafts in which nothing was written yet go too. Only what a
// recorder left is the user's to decide on.
void Library::finish_interrupted() {
  if (const Result<std::vector<FoundSwing>> swings = find_swings(folder_))
    for (const FoundSwing& swing : *swings)
      remove_dead_temporaries(disk_, swing_folder(swing.shelf, swing.id));
  std::vector<AbandonedDraft> drafts = abandoned_drafts(unfinished());
  for (const AbandonedDraft& draft : drafts) {
    if (draft.kind != DraftKind::Replaced || draft.target.empty()) continue;
    const fs::path place = swing_folder(Shelf::Kept, draft.target);
    if (disk_.rename_to_new(draft.path.c_str(), place.c_str()) == 0)
      log::info(draft.target + " is back as it was before it was interrupted");
  }
  for (const AbandonedDraft& draft : drafts) {
    std::error_code failed;
    if (draft.kind == DraftKind::Swing && !contents(draft.path).empty()) continue;
    // The only copy stays.
    if (draft.kind == DraftKind::Replaced && !fs::exists(swing_folder(Shelf::Kept, draft.target), failed))
      continue;
    if (!fs::exists(draft.path, failed) || remove_folder(disk_, draft.path)) forget_draft(disk_, draft.path);
  }
  remove_orphaned_locks(disk_, unfinished());
}

}  // namespace posecoach
