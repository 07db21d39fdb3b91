#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

#include "app/library/library_subcommands.h"
#include "app/library/library_text.h"

namespace posecoach {
namespace {

struct ChangeArguments {
  std::vector<std::string> ids;
  std::string json;
};

using Deed = std::function<Result<Swing>(Library& library, const std::string& id)>;

// One after the other; what was done before an error stays done.
Result<void> for_each(const LibraryPlace& place, const ChangeArguments& arguments, const char* done,
                      const Deed& deed) {
  const auto library = open_library(place);
  if (!library) return tl::unexpected(library.error());
  std::vector<Swing> swings;
  for (const std::string& id : arguments.ids) {
    Result<Swing> swing = deed(**library, id);
    if (!swing) return tl::unexpected(swing.error());
    if (arguments.json != "-") std::printf("%s: %s\n", one_line(swing->id).c_str(), done);
    swings.push_back(*std::move(swing));
  }
  return write_json(arguments.json, json_of(**library, swings));
}

CLI::App* add_change(CLI::App& library, Action& action, const SharedLibraryPlace& place, const char* name,
                     const char* help, const char* done, const Deed& deed) {
  auto arguments = std::make_shared<ChangeArguments>();
  CLI::App* command = library.add_subcommand(name, help);
  command->add_option("SWINGS", arguments->ids, "Their ids, or the last letters of them")->required();
  command->add_option("--json", arguments->json, "Write them as JSON; - is standard output")
      ->type_name("FILE");
  command->callback([&action, place, arguments, done, deed] {
    action = [place, arguments, done, deed] { return for_each(*place, *arguments, done, deed); };
  });
  return command;
}

Result<void> purge(const LibraryPlace& place, const std::vector<std::string>& ids) {
  const auto library = open_library(place);
  if (!library) return tl::unexpected(library.error());
  if (ids.empty()) {
    const Result<std::size_t> purged = (*library)->empty_trash();
    if (!purged) return tl::unexpected(purged.error());
    std::printf("%zu removed for good\n", *purged);
    return {};
  }
  for (const std::string& id : ids) {
    if (const Result<void> purged = (*library)->purge(id); !purged) return purged;
    std::printf("%s: removed for good\n", one_line(id).c_str());
  }
  return {};
}

Result<void> recover(const LibraryPlace& place, const std::string& what) {
  const auto library = open_library(place);
  if (!library) return tl::unexpected(library.error());
  const std::vector<Leftover> leftovers = (*library)->leftovers();
  if (leftovers.empty()) std::printf("Nothing was left unfinished.\n");
  for (const Leftover& leftover : leftovers) {
    if (what == "discard") {
      if (const Result<void> done = (*library)->discard(leftover); !done) return done;
      std::printf("the recording of %s: removed\n", to_words(leftover.facts.recorded_at).c_str());
      continue;
    }
    const Result<Swing> swing = (*library)->recover(leftover);
    if (!swing) return tl::unexpected(swing.error());
    std::printf("%s: recovered, %llu bytes of film\n", one_line(swing->id).c_str(),
                static_cast<unsigned long long>(leftover.film_bytes));
  }
  return {};
}

void add_edit(CLI::App& library, Action& action, const SharedLibraryPlace& place) {
  struct Edit {
    SwingChange change;
    std::string star, hand;
  };
  auto edit = std::make_shared<Edit>();
  CLI::App* command =
      add_change(library, action, place, "edit", "Star, notes, person, hand or view of swings", "changed",
                 [edit](Library& of, const std::string& id) {
                   SwingChange change = edit->change;
                   if (!edit->star.empty()) change.star = edit->star == "on";
                   if (!edit->hand.empty())
                     change.hand = edit->hand == "left" ? Handedness::Left : Handedness::Right;
                   return of.change(id, change);
                 });
  command->add_option("--star", edit->star, "A star for them, or none")->check(CLI::IsMember({"on", "off"}));
  command->add_option("--hand", edit->hand, "The side that they are played from")
      ->check(CLI::IsMember({"left", "right"}));
  command->add_option("--notes", edit->change.notes, "What is to be remembered")->type_name("TEXT");
  command->add_option("--person", edit->change.person, "Whose they are")->type_name("NAME");
  command->add_option("--view", edit->change.view, "Where the camera stood")
      ->check(CLI::IsMember({"face-on", "down-the-line", "between"}));
}

}  // namespace

void add_library_changes(CLI::App& library, Action& action, const SharedLibraryPlace& place) {
  add_edit(library, action, place);
  add_change(library, action, place, "trash", "Swings into the trash; restore brings them back",
             "in the trash; `posecoach library restore` brings it back",
             [](Library& of, const std::string& id) { return of.trash(id); });
  add_change(library, action, place, "restore", "Swings back out of the trash", "back",
             [](Library& of, const std::string& id) { return of.restore(id); });

  auto ids = std::make_shared<std::vector<std::string>>();
  auto is_all = std::make_shared<bool>(false);
  CLI::App* command = library.add_subcommand("purge", "Swings of the trash away for good");
  CLI::Option* named = command->add_option("SWINGS", *ids, "Their ids, or the last letters of them");
  command->add_flag("--all", *is_all, "The whole trash")->excludes(named);
  command->callback([&action, place, ids, is_all] {
    if (ids->empty() && !*is_all) throw CLI::RequiredError("SWINGS or --all");
    action = [place, ids] { return purge(*place, *ids); };
  });

  auto what = std::make_shared<std::string>("keep");
  command = library.add_subcommand("recover", "Recordings that a crash left unfinished become swings");
  command->add_option("--what", *what, "What is to become of them")
      ->capture_default_str()
      ->check(CLI::IsMember({"keep", "discard"}));
  command->callback([&action, place, what] { action = [place, what] { return recover(*place, *what); }; });
}

}  // namespace posecoach
