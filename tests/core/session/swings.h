// Swings for the tests of the library.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "core/session/library.h"

namespace posecoach {

inline void PrintTo(const Swing& swing, std::ostream* out) {
  *out << swing.id << (swing.is_readable() ? "" : " unreadable: ") << swing.unreadable;
}

inline WallTime noon_plus(int minutes) {
  WallTime time = wall_time_from_iso("2026-06-01T12:00:00+02:00").value();
  time.utc += std::chrono::minutes(minutes);
  return time;
}

inline SwingFacts make_facts(int number) {
  SwingFacts facts;
  facts.recorded_at = noon_plus(number);
  facts.person = number % 2 == 0 ? "Søren" : "Anna";
  facts.coach = "bundled:swing";
  facts.view = "face-on";
  facts.hand = number % 3 == 0 ? Handedness::Left : Handedness::Right;
  facts.notes = "swing number " + std::to_string(number);
  facts.score_percent = 50.0 + number;
  return facts;
}

inline std::string film_bytes_of(int number) {
  return "film of swing " + std::to_string(number) + std::string(5000, 'x');
}

inline Result<Swing> add_swing(Library& library, int number) {
  Result<SwingDraft> draft = library.begin(make_facts(number));
  if (!draft) return tl::unexpected(draft.error());
  if (const Result<void> added = draft->add("film.mkv", film_bytes_of(number)); !added)
    return tl::unexpected(added.error());
  if (const Result<void> added = draft->add("analysis.json", "{\"score\": {}}"); !added)
    return tl::unexpected(added.error());
  return library.keep(*std::move(draft));
}

inline std::vector<std::string> ids(const std::vector<Swing>& swings) {
  std::vector<std::string> all;
  for (const Swing& swing : swings) all.push_back(swing.id);
  return all;
}

// One line for each swing that says everything about it; sorted.
inline std::vector<std::string> told(const std::vector<Swing>& swings) {
  std::vector<std::string> all;
  for (const Swing& swing : swings)
    all.push_back(swing.id + " " + swing.unreadable + swing_to_json(swing, {}));
  std::sort(all.begin(), all.end());
  return all;
}

inline std::string findings_text(Library& library) {
  std::string text;
  const std::vector<Finding> findings = library.check().value();
  for (const Finding& finding : findings) text += finding.where + ": " + finding.what + "\n";
  return text;
}

}  // namespace posecoach
