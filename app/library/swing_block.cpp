#include "app/library/swing_block.h"

#include "core/base/file.h"
#include "core/base/log.h"

namespace posecoach {
namespace {

bool is_alike(const SwingFacts& a, const SwingFacts& b) {
  return a.person == b.person && a.stroke == b.stroke && a.view == b.view && a.coach == b.coach;
}

std::optional<BlockSwing> kept_answer(const Swing& swing) {
  const auto file = swing.file("analysis");
  if (!file) return std::nullopt;
  const Result<std::string> text = read_file(*file);
  Result<BlockSwing> answer =
      text ? block_swing_from_json(*text) : Result<BlockSwing>(tl::unexpected(text.error()));
  if (answer) return *std::move(answer);
  log::warning(swing.id + ": left out of the block: " + answer.error().message);
  return std::nullopt;
}

}  // namespace

Result<Block> block_until(Library& library, const Swing& swing, std::size_t most) {
  const Result<std::vector<Swing>> all = library.list({.order = SwingOrder::NewestFirst});
  if (!all) return tl::unexpected(all.error());
  std::vector<BlockSwing> answers;
  bool is_before = false;
  for (const Swing& one : *all) {
    is_before = is_before || one.id == swing.id;
    if (!is_before || !one.is_readable() || !is_alike(one.facts, swing.facts)) continue;
    if (answers.size() == most) break;
    if (std::optional<BlockSwing> answer = kept_answer(one)) answers.push_back(*std::move(answer));
  }
  return make_block(answers);
}

}  // namespace posecoach
