// The recorded swings of a folder: found, searched, kept, thrown away. The plain folders are the truth; an
// SQLite index beside them only makes finding quick, and is made again from them whenever it is missing,
// damaged or of another version. One broken swing never hides the others. Every call may be made from any
// thread (they wait for each other), and several programs may use one folder at a time.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/session/disk.h"
#include "core/session/swing.h"
#include "core/session/swing_draft.h"

namespace posecoach {

enum class SwingOrder { NewestFirst, OldestFirst, BestFirst, WorstFirst };
enum class StarFilter { Any, Starred, Plain };

struct SwingQuery {
  Shelf shelf = Shelf::Kept;
  std::string text =
      {};  // every word of it in notes, person, coach, view, stroke or advice; letter case aside
  std::string person = {};             // the whole name, letter case and accents aside
  std::string coach = {};              // the whole source
  std::string since = {}, until = {};  // days, "2026-11-22", both included
  StarFilter star = StarFilter::Any;
  std::optional<double> score_from = {}, score_to = {};  // percent
  SwingOrder order = SwingOrder::NewestFirst;
  std::size_t limit = 0;  // 0: all
};

// What is to change about a swing; empty: stays.
struct SwingChange {
  std::optional<bool> star;
  std::optional<std::string> notes, person, coach, view;
  std::optional<Handedness> hand;
};

// What a crash left: a recording that was never kept.
struct Leftover {
  std::filesystem::path folder;
  SwingFacts facts;  // as far as they were written
  std::uint64_t film_bytes = 0;
};

// One thing that is wrong, found by check().
struct Finding {
  std::string where;  // a swing's id, or a path seen from the library's folder
  std::string what;   // one line
};

class SwingIndex;

class Library {
 public:
  // Makes the folder. An index that cannot be written (a write-protected stick, a full disk) lives in memory.
  // Errors: Unreadable.
  static Result<std::unique_ptr<Library>> open(const std::filesystem::path& folder,
                                               Disk& disk = system_disk());
  ~Library();

  const std::filesystem::path& folder() const { return folder_; }

  // As the folders are now, whoever changed them. Unreadable swings come too, at the end, unless something
  // was searched for. Errors: Unreadable (the folder vanished), InvalidArgument (a date that is none).
  Result<std::vector<Swing>> list(const SwingQuery& query = {});
  // By its id, the folder's own name, or what is left of that without "swing_"; on both shelves. Errors:
  // NotFound, InvalidArgument (several), and those of read_swing.
  Result<Swing> find(std::string_view id);

  // A new swing. The draft is written into, then kept; `facts.recorded_at` of zero means now.
  Result<SwingDraft> begin(SwingFacts facts);
  // Everything onto the disk, then the rename: the swing is there whole or not at all. A new swing that
  // cannot be kept (disk full) stays among the leftovers, unless it was cancelled.
  Result<Swing> keep(SwingDraft draft, const Progress& progress = {});
  // A draft that starts with all that the swing holds: files may be added and replaced, then keep() puts it
  // in the swing's place in one step. For an analysis with another coach.
  Result<SwingDraft> begin_again(std::string_view id);
  Result<Swing> change(std::string_view id, const SwingChange& change);

  // To Trash/ in the library's folder and back. Errors: NotFound, Unreadable, InvalidArgument (there already;
  // something else is in its place).
  Result<Swing> trash(std::string_view id);
  Result<Swing> restore(std::string_view id);
  // For good: one swing of the trash, or all of it (how many).
  Result<void> purge(std::string_view id);
  Result<std::size_t> empty_trash();

  // Recordings that a crash left. A recovered one becomes a swing with whatever its files still hold.
  std::vector<Leftover> leftovers();
  Result<Swing> recover(const Leftover& leftover);
  Result<void> discard(const Leftover& leftover);

  // Every swing of both shelves: readable, its files there, of the length and with the SHA-256 that they were
  // stored with, readable as what they are; and leftovers. Nothing is changed. `film` opens a film, which is
  // not known here. Errors: Cancelled.
  using FilmCheck = std::function<Result<void>(const std::filesystem::path& film)>;
  Result<std::vector<Finding>> check(const FilmCheck& film = {}, const Progress& progress = {});

 private:
  Library(std::filesystem::path folder, Disk& disk);
  std::filesystem::path unfinished() const { return folder_ / ".unfinished"; }
  std::filesystem::path swing_folder(Shelf shelf, std::string_view id) const;
  Result<Swing> find_unlocked(std::string_view id) const;
  Result<Swing> move(std::string_view id, Shelf to);
  Result<void> purge_folder(const std::filesystem::path& folder);
  Result<Swing> keep_contents(SwingDraft& draft, const Progress& progress);
  Result<void> store_facts(const std::filesystem::path& folder, const SwingFacts& facts,
                           std::map<std::string, StoredFile> files);
  Result<Swing> put_in_place(const std::filesystem::path& folder, const WallTime& recorded_at);
  Result<void> replace(SwingDraft& draft, const std::string& target);
  void finish_interrupted();

  std::filesystem::path folder_;
  Disk& disk_;
  std::mutex mutex_;
  std::unique_ptr<SwingIndex> index_;
};

}  // namespace posecoach
