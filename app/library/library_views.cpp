#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "app/library/library_subcommands.h"
#include "app/library/library_text.h"
#include "app/library/swing_block.h"
#include "app/output_check.h"
#include "app/progress_bar.h"
#include "capture/video_file.h"
#include "core/base/file.h"

namespace posecoach {
namespace {

using Json = nlohmann::ordered_json;

struct ListArguments {
  SwingQuery query;
  bool is_trash = false, is_starred = false;
  std::string json;
};

Result<void> list(const LibraryPlace& place, const ListArguments& arguments) {
  SwingQuery query = arguments.query;
  if (arguments.is_trash) query.shelf = Shelf::Trash;
  if (arguments.is_starred) query.star = StarFilter::Starred;
  const auto library = open_library(place);
  if (!library) return tl::unexpected(library.error());
  const Result<std::vector<Swing>> swings = (*library)->list(query);
  if (!swings) return tl::unexpected(swings.error());
  if (arguments.json != "-") {
    if (swings->empty())
      std::printf("No such swings in %s\n", (*library)->folder().c_str());
    else
      std::fputs(table_of(*swings).c_str(), stdout);
  }
  return write_json(arguments.json, json_of(**library, *swings));
}

Result<void> show(const LibraryPlace& place, const std::string& id, const std::string& json) {
  const auto library = open_library(place);
  if (!library) return tl::unexpected(library.error());
  const Result<Swing> swing = (*library)->find(id);
  if (!swing) return tl::unexpected(swing.error());
  if (json != "-") std::fputs(page_of(*swing).c_str(), stdout);
  return write_json(json, json_of(**library, {*swing}));
}

Result<void> tell_block(const LibraryPlace& place, const std::string& id, std::size_t most,
                        const std::string& json) {
  const auto library = open_library(place);
  if (!library) return tl::unexpected(library.error());
  const Result<Swing> swing = (*library)->find(id);
  if (!swing) return tl::unexpected(swing.error());
  const Result<Block> block = block_until(**library, *swing, most);
  if (!block) return tl::unexpected(block.error());
  if (block->swings == 0)
    return fail(ErrorCode::Incomplete, swing->id + ": it has not been compared with a coach yet");
  if (json != "-") std::fputs(page_of(*block).c_str(), stdout);
  return json.empty() ? Result<void>() : write_file_atomically(json, to_json(*block));
}

// That at least its first picture can be seen.
Result<void> film_opens(const std::filesystem::path& film) {
  Result<std::unique_ptr<FrameSource>> source = open_video_file(film);
  if (!source) return tl::unexpected(source.error());
  const Result<std::optional<Frame>> frame = (*source)->next({});
  if (!frame) return tl::unexpected(frame.error());
  if (!*frame) return fail(ErrorCode::Incomplete, film.filename().string() + " has no pictures");
  return {};
}

Result<void> verify(const LibraryPlace& place, const std::string& json) {
  const auto library = open_library(place);
  if (!library) return tl::unexpected(library.error());
  Result<std::vector<Finding>> findings;
  {
    ProgressBar bar;
    findings = (*library)->check(film_opens, bar.progress());
  }
  if (!findings) return tl::unexpected(findings.error());
  const std::size_t swings = (*library)->list().value_or(std::vector<Swing>()).size() +
                             (*library)->list({.shelf = Shelf::Trash}).value_or(std::vector<Swing>()).size();
  Json answer{{"schema", "posecoach.library/1"},
              {"folder", (*library)->folder().string()},
              {"swings_checked", swings},
              {"findings", Json::array()}};
  for (const Finding& finding : *findings)
    answer["findings"].push_back({{"where", finding.where}, {"what", finding.what}});
  if (const Result<void> written = write_json(json, answer); !written) return written;
  if (json != "-")
    for (const Finding& finding : *findings)
      std::printf("%s: %s\n", one_line(finding.where).c_str(), one_line(finding.what).c_str());
  if (!findings->empty())
    return fail(ErrorCode::Malformed, std::to_string(findings->size()) +
                                          " of the library's things are not as they "
                                          "were stored; the others are well");
  if (json != "-") std::printf("All %zu swings are as they were stored.\n", swings);
  return {};
}

}  // namespace

void add_library_views(CLI::App& library, Action& action, const SharedLibraryPlace& place) {
  auto arguments = std::make_shared<ListArguments>();
  CLI::App* command = library.add_subcommand("list", "The swings, newest first, or those that fit");
  SwingQuery& query = arguments->query;
  command->add_option("--search", query.text, "Words in notes, person, coach, view, stroke or advice");
  command->add_option("--person", query.person, "Of this person");
  command->add_option("--coach", query.coach, "Compared with this coach");
  command->add_option("--since", query.since, "From this day on")->type_name("YYYY-MM-DD");
  command->add_option("--until", query.until, "Up to this day")->type_name("YYYY-MM-DD");
  command->add_option("--score-from", query.score_from, "With at least this score")->type_name("PERCENT");
  command->add_option("--score-to", query.score_to, "With at most this score")->type_name("PERCENT");
  command->add_flag("--star", arguments->is_starred, "Only those with a star");
  command->add_flag("--trash", arguments->is_trash, "Those in the trash");
  const std::map<std::string, SwingOrder> orders = {{"newest", SwingOrder::NewestFirst},
                                                    {"oldest", SwingOrder::OldestFirst},
                                                    {"best", SwingOrder::BestFirst},
                                                    {"worst", SwingOrder::WorstFirst}};
  command->add_option("--sort", query.order, "Which come first: newest, oldest, best, worst")
      ->transform(CLI::CheckedTransformer(orders))
      ->type_name("ORDER");
  command->add_option("--limit", query.limit, "At most so many")->type_name("NUMBER");
  command->add_option("--json", arguments->json, "Write them as JSON; - is standard output")
      ->type_name("FILE");
  command->callback(
      [&action, place, arguments] { action = [place, arguments] { return list(*place, *arguments); }; });

  auto id = std::make_shared<std::string>(), json = std::make_shared<std::string>();
  command = library.add_subcommand("show", "Everything about one swing");
  command->add_option("SWING", *id, "Its id, or the last letters of it")->required();
  command->add_option("--json", *json, "Write it as JSON; - is standard output")->type_name("FILE");
  command->callback(
      [&action, place, id, json] { action = [place, id, json] { return show(*place, *id, *json); }; });

  struct BlockArguments {
    std::string id, json;
    std::size_t most = kBlockSwings;
  };
  auto block = std::make_shared<BlockArguments>();
  command = library.add_subcommand("block", "A swing and those before it together: mean and spread");
  command->add_option("SWING", block->id, "Its id, or the last letters of it")->required();
  command->add_option("--last", block->most, "How many at most")
      ->capture_default_str()
      ->check(CLI::Range(2, 1000))
      ->type_name("NUMBER");
  command->add_option("--json", block->json, "Write it as JSON; - is standard output")->type_name("FILE");
  command->callback([&action, place, block] {
    action = [place, block] { return tell_block(*place, block->id, block->most, block->json); };
  });

  auto verify_json = std::make_shared<std::string>();
  command = library.add_subcommand("verify", "Whether every swing opens and is as it was stored");
  command->add_option("--json", *verify_json, "Write the findings as JSON; - is standard output")
      ->type_name("FILE");
  command->callback([&action, place, verify_json] {
    action = [place, verify_json] { return verify(*place, *verify_json); };
  });
}

}  // namespace posecoach
