#include "core/session/draft_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <random>
#include <utility>

#include "core/base/file.h"
#include "core/session/wall_time.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 4> kStarts = {"swing_", "again_", "replaced_", "purged_"};
constexpr std::string_view kLockEnding = ".lock";
constexpr int kFolderTries = 20;
constexpr std::size_t kLongestTarget = 4096;

fs::path lock_of(const fs::path& folder) {
  return folder.string() + std::string(kLockEnding);
}

// A dead process' lock is free; where the file system knows no locks, everything looks free.
bool is_locked(const fs::path& lock) {
  const int descriptor = ::open(lock.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool is_taken = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return is_taken;
}

// Somebody who tidied up may have removed the file between its making and its locking.
bool is_still_there(int descriptor, const fs::path& lock) {
  struct stat opened = {}, named = {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(lock.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace

std::string random_letters() {
  constexpr std::string_view kLetters = "abcdefghkmnpqrstuvwxyz23456789";
  static thread_local std::random_device random;
  std::uniform_int_distribution<std::size_t> pick(0, kLetters.size() - 1);
  std::string letters;
  for (int i = 0; i < 3; ++i) letters += kLetters[pick(random)];
  return letters;
}

DraftFolder::DraftFolder(Disk& disk, fs::path path, int lock, std::string target)
    : disk_(&disk), path_(std::move(path)), lock_(lock), target_(std::move(target)) {}

DraftFolder::DraftFolder(DraftFolder&& other) noexcept
    : disk_(other.disk_),
      path_(std::move(other.path_)),
      lock_(std::exchange(other.lock_, -1)),
      target_(std::move(other.target_)) {}

DraftFolder& DraftFolder::operator=(DraftFolder&& other) noexcept {
  if (this == &other) return *this;
  give_up();
  disk_ = other.disk_;
  path_ = std::move(other.path_);
  lock_ = std::exchange(other.lock_, -1);
  target_ = std::move(other.target_);
  return *this;
}

DraftFolder::~DraftFolder() {
  give_up();
}

void DraftFolder::give_up() {
  if (lock_ < 0) return;
  std::error_code failed;
  // What cannot be removed now is removed, or offered, at the next start.
  if (!fs::exists(path_, failed) || remove_folder(*disk_, path_)) disk_->remove(lock_of(path_).c_str());
  ::close(std::exchange(lock_, -1));
}

void DraftFolder::leave() {
  if (lock_ >= 0) ::close(std::exchange(lock_, -1));
}

Result<DraftFolder> DraftFolder::reserve(Disk& disk, const fs::path& parent, DraftKind kind,
                                         std::string_view target) {
  if (const Result<void> made = make_folders(disk, parent); !made) return tl::unexpected(made.error());
  const std::string start(kStarts[static_cast<std::size_t>(kind)]);
  for (int i = 0; i < kFolderTries; ++i) {
    const fs::path path =
        parent / (start + clock_of(wall_time_now()) + "_" + random_letters() + random_letters());
    const fs::path lock = lock_of(path);
    const int descriptor = disk.open(lock.c_str(), O_RDWR | O_CREAT | O_EXCL, 0644);
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) return tl::unexpected(disk_error("create", path));
    const bool is_taken = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (is_taken || !is_still_there(descriptor, lock)) {
      ::close(descriptor);
      continue;
    }
    DraftFolder folder(disk, path, descriptor, std::string(target));
    const ssize_t size = static_cast<ssize_t>(target.size());
    if ((size > 0 && disk.write(descriptor, target.data(), target.size()) != size) ||
        (size > 0 && disk.fsync(descriptor) != 0))
      return tl::unexpected(disk_error("write", lock));
    return folder;
  }
  return fail(ErrorCode::Unreadable, "cannot make a folder in " + parent.string());
}

Result<DraftFolder> DraftFolder::make(Disk& disk, const fs::path& parent, DraftKind kind,
                                      std::string_view target) {
  Result<DraftFolder> folder = reserve(disk, parent, kind, target);
  if (folder && disk.make_folder(folder->path_.c_str()) != 0)
    return tl::unexpected(disk_error("make the folder", folder->path_));
  return folder;
}

std::vector<AbandonedDraft> abandoned_drafts(const fs::path& parent) {
  std::vector<AbandonedDraft> drafts;
  std::error_code failed;
  for (fs::directory_iterator entry(parent, failed), end; !failed && entry != end; entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (!entry->is_directory(ignored) || is_locked(lock_of(entry->path()))) continue;
    for (std::size_t i = 0; i < kStarts.size(); ++i)
      if (name.starts_with(kStarts[i]))
        drafts.push_back({static_cast<DraftKind>(i), entry->path(),
                          read_file(lock_of(entry->path()), kLongestTarget).value_or("")});
  }
  return drafts;
}

void remove_orphaned_locks(Disk& disk, const fs::path& parent) {
  std::vector<fs::path> locks;
  std::error_code failed;
  for (fs::directory_iterator entry(parent, failed), end; !failed && entry != end; entry.increment(failed))
    if (entry->path().extension() == kLockEnding) locks.push_back(entry->path());
  for (const fs::path& lock : locks) {
    // Held while it is removed, so that nobody can take it in between.
    const int descriptor = ::open(lock.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) continue;
    const bool is_taken = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    std::error_code ignored;
    if (!is_taken && !fs::exists(fs::path(lock).replace_extension(), ignored)) disk.remove(lock.c_str());
    ::close(descriptor);
  }
}

void forget_draft(Disk& disk, const fs::path& path) {
  disk.remove(lock_of(path).c_str());
}

}  // namespace posecoach
