#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "app/bench/bench.h"
#include "core/base/file.h"
#include "core/session/library.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr int kSwings = 1000, kSwingsADay = 20;

// Gone with all that is in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "posecoach_bench_XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

Result<void> fill(const fs::path& library) {
  for (int i = 0; i < kSwings; ++i) {
    Swing swing;
    swing.facts.recorded_at = wall_time_from_iso("2026-06-01T12:00:00Z").value();
    swing.facts.recorded_at.utc +=
        std::chrono::hours(24) * (i / kSwingsADay) + std::chrono::minutes(i % kSwingsADay);
    swing.facts.person = i % 3 == 0 ? "Anna" : "Bo";
    swing.facts.notes = "swing " + std::to_string(i);
    swing.facts.score_percent = i % 100;
    for (const char* name : {"film.mkv", "pose.pose.json", "student.pose.json", "analysis.json"})
      swing.files[name] = {1000, std::string(64, 'a')};
    const fs::path folder =
        library / day_of(swing.facts.recorded_at) / ("swing_" + clock_of(swing.facts.recorded_at) + "_abc");
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (const Result<void> written = write_file_atomically(folder / kSwingFile, swing_to_json(swing, {}));
        !written)
      return written;
  }
  return {};
}

}  // namespace

Result<void> bench_session(const BenchOptions&, std::vector<BenchRow>& rows) {
  const ScratchFolder folder;
  if (const Result<void> filled = fill(folder.path()); !filled) return filled;
  Result<std::unique_ptr<Library>> library = Library::open(folder.path());
  if (!library) return tl::unexpected(library.error());
  rows.push_back(make_bench_row("library: index of 1000 swings made",
                                {milliseconds_of([&] { (void)(*library)->list({.limit = 1}); })}));
  rows.push_back(measure("library: list of 1000 swings", 20, [&] { (void)(*library)->list(); }));
  rows.push_back(measure("library: search among 1000 swings", 20, [&] {
    (void)(*library)->list({.text = "swing 77", .person = "anna", .limit = 20});
  }));
  rows.push_back(measure("library: opened again", 10, [&] {
    const auto again = Library::open(folder.path());
    if (again) (void)(*again)->list({.limit = 1});
  }));
  return {};
}

}  // namespace posecoach
