// The SQLite index beside the swings: their swing.json texts with what is searched for, so that a list needs
// no walk through all files. It is only ever a copy; whatever is wrong with it, it is made again.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/session/library.h"
#include "core/session/swing.h"

namespace posecoach {

// One swing as found on disk. Two equal stamps mean an unchanged swing.json.
struct FoundSwing {
  Shelf shelf = Shelf::Kept;
  std::string id;
  std::string stamp;
};

struct IndexedSwing {
  Shelf shelf = Shelf::Kept;
  std::string id;
  std::string text;        // of swing.json
  std::string unreadable;  // why, where it is
};

class SwingIndex {
 public:
  // In `file`, or in memory where that is not possible.
  explicit SwingIndex(std::filesystem::path file);
  ~SwingIndex();

  // Reads the swing.json of one that was not known or has changed.
  using ReadSwing = std::function<IndexedSwing(const FoundSwing& found)>;
  // Brings the index up to `found`, then asks it. Never fails: a damaged index is made again, in memory in
  // the end.
  std::vector<IndexedSwing> list(const std::vector<FoundSwing>& found, const ReadSwing& read,
                                 const SwingQuery& query);

 private:
  class Database;
  void start_anew();

  std::filesystem::path file_;
  std::unique_ptr<Database> database_;
};

}  // namespace posecoach
