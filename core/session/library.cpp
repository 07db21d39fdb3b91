#include "core/session/library.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "core/base/file.h"
#include "core/session/swing_folders.h"
#include "core/session/swing_index.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr const char* kIndexFile = "index.sqlite";

IndexedSwing read_for_index(const fs::path& library, const FoundSwing& found) {
  const fs::path file = shelf_folder(library, found.shelf) / found.id / kSwingFile;
  Result<std::string> text = read_file(file, kLargestSwingFile);
  if (text) return {found.shelf, found.id, *std::move(text), {}};
  if (text.error().code == ErrorCode::NotFound) return {found.shelf, found.id, {}, "it has no swing.json"};
  return {found.shelf, found.id, {}, text.error().message};
}

Swing swing_of(const fs::path& library, const IndexedSwing& indexed) {
  const fs::path folder = shelf_folder(library, indexed.shelf) / indexed.id;
  Swing swing;
  swing.unreadable = indexed.unreadable;
  if (swing.is_readable()) {
    if (Result<Swing> read = swing_from_json(folder, indexed.text))
      swing = *std::move(read);
    else
      swing.unreadable = read.error().message;
  }
  swing.id = indexed.id;
  swing.shelf = indexed.shelf;
  swing.folder = folder;
  return swing;
}

// Where a file system knows no locks, programs do without.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
  }
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

Result<void> check_day(const std::string& day) {
  if (day.empty() || is_day(day)) return {};
  return fail(ErrorCode::InvalidArgument, "\"" + day + "\" is no date; write it as 2026-11-22");
}

}  // namespace

Library::Library(fs::path folder, Disk& disk)
    : folder_(std::move(folder)), disk_(disk), index_(std::make_unique<SwingIndex>(folder_ / kIndexFile)) {}
Library::~Library() = default;

Result<std::unique_ptr<Library>> Library::open(const fs::path& folder, Disk& disk) {
  std::error_code failed;
  const fs::path place = fs::absolute(folder, failed);
  if (const Result<void> made = make_folders(disk, place); !made) return tl::unexpected(made.error());
  std::unique_ptr<Library> library(new Library(place, disk));
  library->finish_interrupted();
  return library;
}

fs::path Library::swing_folder(Shelf shelf, std::string_view id) const {
  return shelf_folder(folder_, shelf) / id;
}

Result<std::vector<Swing>> Library::list(const SwingQuery& query) {
  for (const std::string* day : {&query.since, &query.until})
    if (const Result<void> checked = check_day(*day); !checked) return tl::unexpected(checked.error());
  const std::scoped_lock lock(mutex_);
  const Result<std::vector<FoundSwing>> found = find_swings(folder_);
  if (!found) return tl::unexpected(found.error());
  const auto read = [this](const FoundSwing& swing) { return read_for_index(folder_, swing); };
  std::vector<Swing> swings;
  for (const IndexedSwing& indexed : index_->list(*found, read, query))
    swings.push_back(swing_of(folder_, indexed));
  return swings;
}

Result<Swing> Library::find(std::string_view id) {
  const std::scoped_lock lock(mutex_);
  return find_unlocked(id);
}

Result<Swing> Library::find_unlocked(std::string_view id) const {
  const Result<std::vector<FoundSwing>> all = find_swings(folder_);
  if (!all) return tl::unexpected(all.error());
  const std::vector<FoundSwing> found = matching(*all, id);
  const std::string name(id);
  if (found.empty())
    return fail(ErrorCode::NotFound,
                "there is no swing \"" + name + "\" in " + folder_.string() + "; `library list` names them");
  if (found.size() > 1)
    return fail(ErrorCode::InvalidArgument, "\"" + name + "\" may be " + found[0].id + " or " + found[1].id +
                                                "; say which, as YYYY-MM-DD/NAME");
  Result<Swing> swing = read_swing(swing_folder(found.front().shelf, found.front().id));
  if (swing) swing->shelf = found.front().shelf;
  return swing;
}

Result<Swing> Library::change(std::string_view id, const SwingChange& change) {
  const std::scoped_lock lock(mutex_);
  Result<Swing> swing = find_unlocked(id);
  if (!swing) return swing;
  // Another program may be changing it too: read again what it left.
  const FolderLock other_programs(swing->folder);
  const Shelf shelf = swing->shelf;
  swing = read_swing(swing->folder);
  if (!swing) return swing;
  swing->shelf = shelf;
  SwingFacts& facts = swing->facts;
  if (change.star) facts.star = *change.star;
  if (change.notes) facts.notes = *change.notes;
  if (change.person) facts.person = *change.person;
  if (change.coach) facts.coach = *change.coach;
  if (change.view) facts.view = *change.view;
  if (change.hand) facts.hand = *change.hand;
  const fs::path file = swing->folder / kSwingFile;
  const Result<std::string> old = read_file(file, kLargestSwingFile);
  if (!old) return tl::unexpected(old.error());
  if (const Result<void> stored = store_file(disk_, file, swing_to_json(*swing, *old)); !stored)
    return tl::unexpected(stored.error());
  return swing;
}

Result<Swing> Library::move(std::string_view id, Shelf to) {
  Result<Swing> swing = find_unlocked(id);
  // An unreadable swing can be thrown away too.
  Shelf from = to == Shelf::Trash ? Shelf::Kept : Shelf::Trash;
  if (!swing) {
    const Result<std::vector<FoundSwing>> all = find_swings(folder_);
    const std::vector<FoundSwing> found = all ? matching(*all, id) : std::vector<FoundSwing>();
    if (found.size() != 1) return swing;
    const std::string reason = swing.error().message;
    swing = Swing{};
    swing->id = found.front().id;
    swing->shelf = found.front().shelf;
    swing->folder = swing_folder(swing->shelf, swing->id);
    swing->unreadable = reason;
  }
  if (swing->shelf != from)
    return fail(ErrorCode::InvalidArgument,
                swing->id + (to == Shelf::Trash ? " is in the trash already" : " is not in the trash"));
  const fs::path place = swing_folder(to, swing->id);
  int moved = -1;
  // Another program may tidy the empty day away between the two steps.
  for (int attempt = 0; attempt < 3 && moved != 0; ++attempt) {
    if (const Result<void> made = make_folders(disk_, place.parent_path()); !made)
      return tl::unexpected(made.error());
    moved = disk_.rename_to_new(swing->folder.c_str(), place.c_str());
    if (moved != 0 && errno != ENOENT) break;
  }
  if (moved != 0 && (errno == EEXIST || errno == ENOTEMPTY))
    return fail(ErrorCode::InvalidArgument, place.string() + " is in the way; rename or remove it first");
  if (moved != 0) return tl::unexpected(disk_error("move", swing->folder));
  for (const fs::path& day : {place.parent_path(), swing->folder.parent_path()})
    if (const Result<void> synced = sync(disk_, day); !synced) return tl::unexpected(synced.error());
  // Fails where the day still has swings, which is as well.
  disk_.remove(swing->folder.parent_path().c_str());
  swing->shelf = to;
  swing->folder = place;
  return swing;
}

Result<Swing> Library::trash(std::string_view id) {
  const std::scoped_lock lock(mutex_);
  return move(id, Shelf::Trash);
}

Result<Swing> Library::restore(std::string_view id) {
  const std::scoped_lock lock(mutex_);
  return move(id, Shelf::Kept);
}

}  // namespace posecoach
