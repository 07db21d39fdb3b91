#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/library/export_swing.h"
#include "app/library/import_swing.h"
#include "app/library/library_subcommands.h"
#include "app/library/library_text.h"
#include "app/library/stored_swing.h"
#include "app/output_check.h"
#include "app/pose_options.h"
#include "app/progress_bar.h"
#include "core/base/log.h"
#include "core/session/places.h"
#include "core/session/references.h"

namespace posecoach {
namespace {

struct ImportArguments {
  std::vector<std::string> inputs;
  std::string hand = "auto", json;
  std::optional<double> height_m;
  ImportOptions options;
};

Result<void> import_inputs(const LibraryPlace& place, const ImportArguments& arguments,
                           const PoseTrackerOptions& pose) {
  const auto library = open_library(place);
  if (!library) return tl::unexpected(library.error());
  listen_to_interrupts();
  Imported all;
  {
    ProgressBar bar;
    ImportOptions options = arguments.options;
    if (arguments.hand != "auto")
      options.hand = arguments.hand == "left" ? Handedness::Left : Handedness::Right;
    options.load = {pose, {arguments.height_m, {}}, bar.progress()};
    for (const std::string& input : arguments.inputs) {
      Result<Imported> imported = import_swings(**library, input, options);
      if (!imported) return tl::unexpected(imported.error());
      std::move(imported->swings.begin(), imported->swings.end(), std::back_inserter(all.swings));
      std::move(imported->remarks.begin(), imported->remarks.end(), std::back_inserter(all.remarks));
    }
  }
  for (const std::string& remark : all.remarks)
    std::fprintf(stderr, "posecoach: %s\n", one_line(remark).c_str());
  if (arguments.json != "-") std::fputs(table_of(all.swings).c_str(), stdout);
  return write_json(arguments.json, json_of(**library, all.swings));
}

struct ExportArguments {
  std::string id, folder, coach;
  std::vector<std::string> files;
};

Result<void> export_files(const LibraryPlace& place, const ExportArguments& arguments,
                          const PoseTrackerOptions& pose) {
  if (const Result<void> checked = check_output_files(arguments.files, {}); !checked) return checked;
  const auto library = open_library(place);
  if (!library) return tl::unexpected(library.error());
  const Result<Swing> swing = (*library)->find(arguments.id);
  if (!swing) return tl::unexpected(swing.error());
  listen_to_interrupts();
  std::vector<std::filesystem::path> written;
  {
    ProgressBar bar;
    const ExportOptions options{
        arguments.coach, {pose, {}, bar.progress()}, Palette::RedGreen, library->get()};
    for (const std::string& file : arguments.files) {
      if (const Result<void> done = export_swing(*swing, file, options); !done) return done;
      written.emplace_back(file);
    }
    if (!arguments.folder.empty()) {
      Result<std::vector<std::filesystem::path>> files = export_everything(*swing, arguments.folder, options);
      if (!files) return tl::unexpected(files.error());
      written.insert(written.end(), files->begin(), files->end());
    }
  }
  for (const std::filesystem::path& file : written) std::printf("%s\n", file.c_str());
  return {};
}

Result<void> analyze_again(const LibraryPlace& place, const std::string& id, const std::string& coach,
                           const PoseTrackerOptions& pose) {
  const auto library = open_library(place);
  if (!library) return tl::unexpected(library.error());
  Result<Swing> swing = (*library)->find(id);
  if (!swing) return tl::unexpected(swing.error());
  listen_to_interrupts();
  {
    ProgressBar bar;
    const Result<StoredAnswer> answer = analyze_stored(*swing, coach, {pose, {}, bar.progress()});
    if (!answer) return tl::unexpected(answer.error());
    Result<SwingDraft> draft = (*library)->begin_again(swing->id);
    if (!draft) return tl::unexpected(draft.error());
    if (const Result<void> added = add_answer(*draft, *answer); !added) return added;
    if (const auto film = swing->file("film"))
      if (const Result<void> pictured = add_top_picture(*draft, *answer, *film); !pictured)
        log::warning(pictured.error().message);
    swing = (*library)->keep(*std::move(draft), bar.progress());
  }
  if (!swing) return tl::unexpected(swing.error());
  std::fputs(page_of(*swing).c_str(), stdout);
  return {};
}

Result<void> list_coaches() {
  for (const Reference& reference : References(find_places().references()).list())
    std::printf(
        "%-32s %s%s\n", one_line(reference.source).c_str(), one_line(reference.name).c_str(),
        reference.unreadable.empty() ? "" : one_line("  unreadable: " + reference.unreadable).c_str());
  return {};
}

Result<void> make_coach(const LibraryPlace& place, const std::string& what, const std::string& name) {
  References references(find_places().references());
  std::error_code failed;
  Result<Reference> made = fail(ErrorCode::Internal, "");
  if (std::filesystem::is_regular_file(what, failed)) {
    made = references.add_motion_file(what, name);
  } else {
    const auto library = open_library(place);
    if (!library) return tl::unexpected(library.error());
    const Result<Swing> swing = (*library)->find(what);
    if (!swing) return tl::unexpected(swing.error());
    made = references.add_swing(*swing, name);
  }
  if (!made) return tl::unexpected(made.error());
  std::printf("%s: use it as --coach %s\n", one_line(made->name).c_str(), made->source.c_str());
  return {};
}

void add_import(CLI::App& library, Action& action, const SharedLibraryPlace& place) {
  auto arguments = std::make_shared<ImportArguments>();
  CLI::App* command =
      library.add_subcommand("import", "Films, motions and swings of other libraries into the library");
  command->add_option("INPUTS", arguments->inputs, "Films, motion files, swings' or libraries' folders")
      ->required();
  command->add_option("--person", arguments->options.person, "Whose they are")->type_name("NAME");
  command->add_option("--notes", arguments->options.notes, "What is to be remembered")->type_name("TEXT");
  command->add_option("--coach", arguments->options.coach, "Compare them with this coach at once");
  command->add_option("--hand", arguments->hand, "The side that they are played from")
      ->capture_default_str()
      ->check(CLI::IsMember({"left", "right", "auto"}));
  command->add_option("--height", arguments->height_m, "How tall the person is, for films")
      ->check(CLI::Range(0.5, 2.6))
      ->type_name("METRES");
  command->add_option("--json", arguments->json, "Write them as JSON; - is standard output")
      ->type_name("FILE");
  const auto pose = add_pose_options(*command);
  command->callback([&action, place, arguments, pose] {
    action = [place, arguments, pose] { return import_inputs(*place, *arguments, *pose); };
  });
}

void add_export(CLI::App& library, Action& action, const SharedLibraryPlace& place) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = library.add_subcommand("export", "A swing as files for other programs and people");
  command->add_option("SWING", arguments->id, "Its id, or the last letters of it")->required();
  CLI::Option* files =
      command
          ->add_option("-o,--output", arguments->files,
                       "Files to write: .csv, .picture.csv, .bvh, .trc, .pose.json, .body.json, "
                       ".analysis.json, .html, .overlay.mp4, or the film with its own ending")
          ->type_name("FILE");
  CLI::Option* folder =
      command->add_option("--all", arguments->folder, "Everything that there is, into this folder")
          ->type_name("FOLDER");
  command->add_option("--coach", arguments->coach,
                      "The coach of page and drawn film, where not the kept one");
  const auto pose = add_pose_options(*command);
  command->callback([&action, place, arguments, pose, files, folder] {
    if (files->empty() && folder->empty()) throw CLI::RequiredError("--output or --all");
    action = [place, arguments, pose] { return export_files(*place, *arguments, *pose); };
  });
}

}  // namespace

void add_library_exchange(CLI::App& library, Action& action, const SharedLibraryPlace& place) {
  add_import(library, action, place);
  add_export(library, action, place);

  auto id = std::make_shared<std::string>(), coach = std::make_shared<std::string>();
  CLI::App* command =
      library.add_subcommand("analyze", "Compare a swing with a coach again, and keep the answer");
  command->add_option("SWING", *id, "Its id, or the last letters of it")->required();
  command->add_option("--coach", *coach, "The coach, where not the one before");
  const auto pose = add_pose_options(*command);
  command->callback([&action, place, id, coach, pose] {
    action = [place, id, coach, pose] { return analyze_again(*place, *id, *coach, *pose); };
  });

  command = library.add_subcommand("coaches", "The coaches to learn from: bundled ones and your own");
  command->callback([&action] { action = list_coaches; });

  auto what = std::make_shared<std::string>(), name = std::make_shared<std::string>();
  command = library.add_subcommand("make-coach", "A swing or a motion file becomes a coach");
  command->add_option("WHAT", *what, "A swing's id, or a motion file")->required();
  command->add_option("--name", *name, "What the coach is to be called");
  command->callback([&action, place, what, name] {
    action = [place, what, name] { return make_coach(*place, *what, *name); };
  });
}

}  // namespace posecoach
