// A coach of whom there is only a film or a picture: in one student's proportions for the live picture, and
// compared with one student's film.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/body/mirror.h"
#include "core/pipeline/analyze.h"
#include "core/pipeline/lift.h"
#include "core/pipeline/personal_coach.h"
#include "core/transfer/transferer.h"

namespace posecoach {

// The name of this way among the retargeting methods.
inline constexpr const char* kTransfer2d = "transfer2d";

struct FilmedCoach {
  std::string source;    // what analyses call him
  LiftedStudent lifted;  // of a single picture: a film in which he does not move
  bool is_still = false;
  // Each piece of work has its own: a Transferer serves one thread.
  std::function<Result<std::unique_ptr<Transferer>>()> make_transferer;
};

// A film where he is seen often enough, else his first picture. Errors: NoPerson, those of lift().
Result<FilmedCoach> filmed_coach_from(const PoseTrack& pictures,
                                      std::function<Result<std::unique_ptr<Transferer>>()> make_transferer);

// He goes at the student's pace, or stands where he is a single picture; never turned about, since only what
// lies across the view is known of him. Errors: those of make_transferer, coach_on_body, and a film that
// coaching cannot use.
Result<PersonalCoach> make_personal_coach(const FilmedCoach& coach, const Skeleton& body, Handedness hand);

// Whether the student must be seen from another side for the two to be compared; what to do, in words.
std::optional<std::string> wrong_side(const FilmedCoach& coach, View student);

// A film of the coach is compared like any motion; a picture with the moment of the student's film that is
// most like it. Errors: those of make_transferer, coach_in_picture, analyze and analyze_picture.
Result<AnalyzedPair> analyze_in_picture(const FilmedCoach& coach, const StudentInput& input,
                                        const LiftedStudent& student, const AnalyzeOptions& options);

}  // namespace posecoach
