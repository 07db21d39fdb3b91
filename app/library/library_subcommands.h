// The parts of `posecoach library`. Each adds its subcommands; `place` is where the library is, known once
// the command line is read.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/commands.h"
#include "core/session/library.h"

namespace posecoach {

struct LibraryPlace {
  std::string folder;  // as --library said it; empty: the usual place
};
using SharedLibraryPlace = std::shared_ptr<const LibraryPlace>;

// Tells on standard error of recordings that a crash left.
Result<std::unique_ptr<Library>> open_library(const LibraryPlace& place);

// list, show, block, verify
void add_library_views(CLI::App& library, Action& action, const SharedLibraryPlace& place);
// edit, trash, restore, purge, recover
void add_library_changes(CLI::App& library, Action& action, const SharedLibraryPlace& place);
// import, export, analyze, coaches, make-coach
void add_library_exchange(CLI::App& library, Action& action, const SharedLibraryPlace& place);

}  // namespace posecoach
