#include "app/library/library_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/library/library_subcommands.h"
#include "core/session/places.h"

namespace posecoach {

Result<std::unique_ptr<Library>> open_library(const LibraryPlace& place) {
  Result<std::unique_ptr<Library>> library =
      Library::open(place.folder.empty() ? find_places().library : std::filesystem::path(place.folder));
  const std::size_t left = library ? (*library)->leftovers().size() : 0;
  if (left > 0)
    std::fprintf(
        stderr,
        "posecoach: %zu recording%s never finished; `posecoach library recover` keeps what there is\n", left,
        left == 1 ? " was" : "s were");
  return library;
}

void add_library_command(CLI::App& cli, Action& action) {
  CLI::App* library =
      cli.add_subcommand("library", "The recorded swings: find, show, exchange, keep in order");
  library->require_subcommand(1);
  const auto place = std::make_shared<LibraryPlace>();
  library->add_option("--library", place->folder, "The library's folder, where it is not the usual one")
      ->type_name("FOLDER");
  add_library_views(*library, action, place);
  add_library_exchange(*library, action, place);
  add_library_changes(*library, action, place);
}

}  // namespace posecoach
