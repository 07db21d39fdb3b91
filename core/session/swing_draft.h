// A swing in the making: a folder with a temporary name, locked while its maker lives. Until Library::keep it
// is no swing; if the program dies, it is a leftover that the library finds and offers (library.h).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/coaching/analysis.h"
#include "core/motion/motion.h"
#include "core/motion/pose_track.h"
#include "core/session/draft_folder.h"
#include "core/session/swing.h"

namespace posecoach {

class SwingDraft {
 public:
  // Not kept: removed with all that is in it.
  SwingDraft(SwingDraft&&) noexcept = default;
  SwingDraft& operator=(SwingDraft&&) noexcept = default;

  // Recorders may write new files there by themselves: path("film.mkv"). keep() takes whatever is there.
  // Files that are there already are replaced through add(), never written into: they may be links.
  const std::filesystem::path& folder() const { return place_.path(); }
  std::filesystem::path path(std::string_view name) const { return place_.path() / name; }
  // What keep() will write.
  SwingFacts& facts() { return facts_; }
  const SwingFacts& facts() const { return facts_; }

  Result<void> add(std::string_view name, std::string_view bytes);
  Result<void> add_copy(std::string_view name, const std::filesystem::path& from,
                        const Progress& progress = {});
  Result<void> add_track(const PoseTrack& track);
  Result<void> add_student(const Motion& student, std::string_view source);
  Result<void> add_body(const Skeleton& body);
  Result<void> add_coach(const Motion& coach_in_student_body, std::string_view source);
  // Also takes over score, advice, stroke, hand, coach and length into the facts.
  Result<void> add_analysis(const Analysis& analysis);
  Result<void> add_thumbnail(std::string_view jpeg);

  // Writes the facts already now, so that a recovery knows them. Errors: Unreadable.
  Result<void> describe(const SwingFacts& facts);

 private:
  friend class Library;
  SwingDraft(Disk& disk, DraftFolder folder, SwingFacts facts);

  Disk* disk_;
  DraftFolder place_;
  SwingFacts facts_;
};

}  // namespace posecoach
