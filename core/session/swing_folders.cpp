#include "core/session/swing_folders.h"

#include <sys/stat.h>

#include <algorithm>

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr const char* kTrash = "Trash";

// Changes whenever swing.json is another or has been written again.
std::string stamp_of(const fs::path& folder) {
  struct stat status = {};
  if (::stat((folder / kSwingFile).c_str(), &status) != 0) return "missing";
  return std::to_string(status.st_mtim.tv_sec) + "." + std::to_string(status.st_mtim.tv_nsec) + " " +
         std::to_string(status.st_size) + " " + std::to_string(status.st_ino);
}

std::vector<fs::path> folders_in(const fs::path& folder, std::error_code& failed) {
  std::vector<fs::path> folders;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && !entry->path().filename().string().starts_with("."))
      folders.push_back(entry->path());
  }
  return folders;
}

}  // namespace

fs::path shelf_folder(const fs::path& library, Shelf shelf) {
  return shelf == Shelf::Trash ? library / kTrash : library;
}

Result<std::vector<FoundSwing>> find_swings(const fs::path& library) {
  std::vector<FoundSwing> swings;
  for (const Shelf shelf : {Shelf::Kept, Shelf::Trash}) {
    std::error_code failed;
    const std::vector<fs::path> days = folders_in(shelf_folder(library, shelf), failed);
    if (failed && shelf == Shelf::Kept)
      return fail(ErrorCode::Unreadable, "cannot read " + library.string() + ": " + failed.message());
    for (const fs::path& day : days) {
      if (!is_day(day.filename().string())) continue;
      // A day that cannot be read does not hide the others; nor may it vanish from the list.
      for (const fs::path& folder : folders_in(day, failed))
        swings.push_back({shelf, (day.filename() / folder.filename()).string(), stamp_of(folder)});
    }
  }
  std::sort(swings.begin(), swings.end(), [](const FoundSwing& a, const FoundSwing& b) {
    return std::tie(a.id, a.shelf) < std::tie(b.id, b.shelf);
  });
  return swings;
}

std::vector<FoundSwing> matching(const std::vector<FoundSwing>& swings, std::string_view id) {
  std::vector<FoundSwing> exact, by_end;
  for (const FoundSwing& swing : swings) {
    const std::string_view name = std::string_view(swing.id).substr(swing.id.find('/') + 1);
    if (swing.id == id)
      exact.push_back(swing);
    else if (name == id || (!id.empty() && name.ends_with("_" + std::string(id))))
      by_end.push_back(swing);
  }
  return exact.empty() ? by_end : exact;
}

}  // namespace posecoach
