// Files that are chosen in the window, and recordings that a sudden end left behind.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <thread>

#include "app/window/memory.h"
#include "app/window/window_program.h"
#include "core/session/wall_time.h"
#include "ui/render/words.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 17> kEndings = {".mp4", ".mkv",  ".mov", ".avi", ".webm", ".m4v",
                                                       ".mpg", ".mpeg", ".ts",  ".3gp", ".bvh",  ".amc",
                                                       ".c3d", ".trc",  ".mts", ".wmv", ".json"};

bool is_importable(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

std::string size_words(std::uint64_t bytes) {
  const double mega = static_cast<double>(bytes) / 1e6;
  if (mega >= 1000) return decimal(mega / 1000, 1) + " GB";
  if (mega >= 10) return decimal(mega, 0) + " MB";
  return mega >= 0.1 ? decimal(mega, 1) + " MB" : decimal(mega * 1000, 0) + " kB";
}

std::string detail_of(const fs::directory_entry& entry) {
  std::error_code failed;
  const auto bytes = entry.file_size(failed);
  std::string words = failed ? std::string() : size_words(bytes);
  const auto changed = entry.last_write_time(failed);
  if (failed) return words;
  const auto utc = std::chrono::floor<std::chrono::milliseconds>(std::chrono::file_clock::to_sys(changed));
  return words + " · " + to_words(wall_time_at(utc));
}

std::vector<FolderEntry> usual_places(const fs::path& library) {
  std::vector<FolderEntry> places;
  const auto add = [&](const std::string& name, const fs::path& path) {
    std::error_code failed;
    if (!path.empty() && fs::is_directory(path, failed)) places.push_back({name, path.string(), "", true});
  };
  const char* const home = std::getenv("HOME");
  const fs::path own = home == nullptr ? fs::path() : fs::path(home);
  add("Videos", library.parent_path());
  add("Home", own);
  add("Desktop", own / "Desktop");
  add("Downloads", own / "Downloads");
  // Sticks and cameras.
  const char* const user = std::getenv("USER");
  for (const char* const root : {"/media", "/run/media"}) {
    std::error_code failed;
    const fs::path mounts = user == nullptr ? fs::path(root) : fs::path(root) / user;
    for (fs::directory_iterator mount(mounts, failed), end; !failed && mount != end; mount.increment(failed))
      add(mount->path().filename().string(), mount->path());
  }
  add("Computer", "/");
  return places;
}

}  // namespace

void WindowProgram::list_folder(const std::string& path) {
  FolderListing listing;
  listing.places = usual_places(places_.library);
  std::error_code failed;
  fs::path folder = path;
  if (folder.empty() || !fs::is_directory(folder, failed))
    folder = listing.places.empty() ? fs::path("/") : fs::path(listing.places.front().path);
  listing.path = folder.string();
  if (folder.has_parent_path() && folder.parent_path() != folder)
    listing.parent = folder.parent_path().string();
  fs::directory_iterator entry(folder, failed);
  if (failed) listing.message = failed.message();
  for (const fs::directory_iterator end; !failed && entry != end; entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    const bool is_folder = entry->is_directory(ignored);
    if (name.starts_with(".") || (!is_folder && !is_importable(entry->path()))) continue;
    listing.entries.push_back(
        {name, entry->path().string(), is_folder ? std::string() : detail_of(*entry), is_folder});
  }
  std::sort(listing.entries.begin(), listing.entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
  });
  model_.listing = std::move(listing);
}

void WindowProgram::show_folder(const std::string& path) {
  std::string program = "xdg-open", folder = path;
  const std::array<char*, 3> arguments = {program.data(), folder.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0)
    return tell(ToastKind::Information, "It is in " + path);
  std::thread([child] { (void)waitpid(child, nullptr, 0); }).detach();
}

// The same that `library recover` finds.
void WindowProgram::look_for_leftovers() {
  model_.leftovers.clear();
  if (!library_) return;
  leftovers_ = library_->leftovers();
  for (const Leftover& leftover : leftovers_)
    model_.leftovers.push_back(
        {leftover.folder.string(), "Recording of " + to_words(leftover.facts.recorded_at),
         (leftover.film_bytes > 0 ? size_words(leftover.film_bytes) + " of film" : "no film") +
             (leftover.facts.person.empty() ? "" : " · " + leftover.facts.person)});
}

void WindowProgram::settle_leftover(const std::string& folder, Shelf shelf) {
  const auto found = std::find_if(leftovers_.begin(), leftovers_.end(),
                                  [&](const Leftover& leftover) { return leftover.folder == folder; });
  if (!library_ || found == leftovers_.end()) return;
  // Not offered twice; if it cannot be kept it stays among them for the next start.
  std::erase_if(model_.leftovers, [&](const LeftoverEntry& entry) { return entry.folder == folder; });
  jobs_->start(
      "Keeping the recording", [this, leftover = *found, shelf](const Progress&) -> Result<JobQueue::Finish> {
        Result<Swing> swing = library_->recover(leftover);
        if (!swing) return tl::unexpected(swing.error());
        if (shelf == Shelf::Trash) swing = library_->trash(swing->id);
        if (!swing) return tl::unexpected(swing.error());
        return JobQueue::Finish([this, id = swing->id, shelf] {
          refresh_swings();
          if (shelf == Shelf::Kept)
            tell(ToastKind::Good, "The recording is in the library.", "Review", intent::OpenSwing{id});
          else
            tell(ToastKind::Information, "The recording is in the trash.", "Undo", intent::RestoreSwing{id});
        });
      });
}

}  // namespace posecoach
