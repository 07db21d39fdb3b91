// Swings of the library as the rest of the program knows them: what is read back to be compared, and answers
// to be kept.
#pragma once

#include <memory>
#include <string>

#include "app/load_motion.h"
#include "core/pipeline/analyze.h"
#include "core/pipeline/analyzed_swing.h"
#include "core/session/library.h"
#include "core/session/marks.h"

namespace posecoach {

// The student of a kept swing. With a film, its source is the film and the pose stage's answer is taken as it
// was kept (without one, the pose stage looks again); else the kept motion. Errors: Incomplete (neither film
// nor motion), and those of reading them.
Result<LoadedMotion> load_student(const Swing& swing, const LoadOptions& options = {});

struct StoredAnswer {
  LoadedMotion student;
  AnalyzedPair pair;
  Skeleton body;
};

// Compared with `coach`; empty: with the one that it was compared with before, and where that is gone, with
// his motion as it was kept. Positions that were moved by hand (core/session/marks.h) count. Errors:
// Incomplete (there was none), those of reading and comparing.
Result<StoredAnswer> analyze_stored(const Swing& swing, const std::string& coach,
                                    const LoadOptions& options = {});

// With these marks in place of the kept ones.
Result<StoredAnswer> analyze_marked(const Swing& swing, const std::string& coach, const Marks& marks,
                                    const LoadOptions& options = {});

// The same for the review, with the film's pictures. Errors: Incomplete (no film), and those above.
Result<AnalyzedSwing> load_analyzed_swing(const Swing& swing, const std::string& coach,
                                          const LoadOptions& options = {});

// Everything that is known about a swing into its draft, with a small picture of its top where its pictures
// are at hand; the film is the caller's.
Result<void> add_answer(SwingDraft& draft, const StoredAnswer& answer);
Result<void> add_answer(SwingDraft& draft, const AnalyzedSwing& swing);
// The golfer at the top of that film, as small as lists show him. Does nothing where nobody was seen in a
// film.
Result<void> add_top_picture(SwingDraft& draft, const StoredAnswer& answer,
                             const std::filesystem::path& film);
// A small picture for lists.
Result<void> add_picture(SwingDraft& draft, const Image& picture);

}  // namespace posecoach
