// A folder under .unfinished/ that belongs to this process while it lives: NAME with NAME.lock beside it,
// locked. What a dead process left is not locked any more, by which it is known.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/disk.h"

namespace posecoach {

// What a folder is for, told by the start of its name, so that the next program knows what to do with it.
enum class DraftKind {
  Swing,  // a new swing: offered for recovery
  Again,  // a changed copy of a swing that is still in its place, or the old one after the exchange: removed
  Replaced,  // a swing on its way out while its new version moves in: put back where there is none
  Purged     // on its way out for good: removed
};

class DraftFolder {
 public:
  // New and empty under `parent`, which is made. `target` is remembered in the lock. Errors: Unreadable.
  static Result<DraftFolder> make(Disk& disk, const std::filesystem::path& parent, DraftKind kind,
                                  std::string_view target = {});
  // Only the name and its lock: for a folder that is to be renamed there.
  static Result<DraftFolder> reserve(Disk& disk, const std::filesystem::path& parent, DraftKind kind,
                                     std::string_view target = {});
  DraftFolder(DraftFolder&& other) noexcept;
  DraftFolder& operator=(DraftFolder&& other) noexcept;
  // Removes the folder, where it still is, and the lock.
  ~DraftFolder();

  // Leaves the folder to the next program, as if this one had died.
  void leave();

  const std::filesystem::path& path() const { return path_; }
  const std::string& target() const { return target_; }

 private:
  DraftFolder(Disk& disk, std::filesystem::path path, int lock, std::string target);
  void give_up();

  Disk* disk_;
  std::filesystem::path path_;
  int lock_ = -1;
  std::string target_;
};

// A folder whose process is gone.
struct AbandonedDraft {
  DraftKind kind;
  std::filesystem::path path;
  std::string target;
};

std::vector<AbandonedDraft> abandoned_drafts(const std::filesystem::path& parent);
// Locks of dead processes whose folder is gone.
void remove_orphaned_locks(Disk& disk, const std::filesystem::path& parent);
// Its folder has found its way: the lock goes too.
void forget_draft(Disk& disk, const std::filesystem::path& path);

// Three letters or digits that are hard to confuse.
std::string random_letters();

}  // namespace posecoach
