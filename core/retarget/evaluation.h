// How far retargeted motions are from what the other character really did: the error of the papers' tables,
// and what it does not see (bone lengths, grip, sliding feet, jitter).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/retarget/retarget.h"

namespace posecoach {

// Chain length, metres: left toe to root plus head to root, over the canonical joints of the T-pose. What the
// papers' code divides errors by; not a stature.
double chain_height(const Skeleton& skeleton);

// All over the canonical joints of the target's skeleton (extras such as fingers, hair and clothes do not
// count).
struct PairErrors {
  // The "code metric": mean over frames, joints and x, y, z of the squared difference, over chain_height
  // squared.
  double root = 0;    // of the root alone
  double local = 0;   // with the root at the origin
  double global = 0;  // in the world
  // Equation 16 as printed: mean over frames and joints of the squared distance over the chain height, in
  // centimetres; it depends on the unit.
  double eq16_cm = 0;
  double bone_length = 0;         // largest relative error
  std::optional<double> grip_cm;  // mean error of the wrists' relation while the coach's hands hold together
  double slide_cm_s = 0;          // mean speed along the floor of feet that the coach has planted
  double coach_slide_cm_s = 0;    // the coach's own
  double beyond_limits_degrees = 0;  // knees and elbows, worst frame (core/retarget/joint_limits.h)
  double jitter_m_s3 = 0;            // mean third derivative of the joints, root at the origin
};
// Three motions of the same frames; `predicted` and `truth` on the same skeleton. Asserts that.
PairErrors compare(const Motion& predicted, const Motion& truth, const Motion& coach);

struct CharacterMotion {
  std::string character, name;
  Motion motion;
};

// The coach's motion as it is, or as a webcam would give it (core/retarget/webcam_noise.h), smoothed alike
// before every method.
enum class EvaluationInput { Clean, Webcam };

// A method under a name of its own; contacts and smoothing are the evaluation's.
struct EvaluatedMethod {
  std::string name;
  RetargetOptions options;
};
std::vector<EvaluatedMethod> every_method();

struct EvaluationOptions {
  RotationSource rotations = RotationSource::FileFirst;
  std::vector<EvaluationInput> inputs = {EvaluationInput::Clean};
  std::vector<EvaluatedMethod> methods = every_method();
};

enum class Structure { Intra, Cross };  // same or different set of canonical joints
struct EvaluationRow {
  std::string method;
  Structure structure = Structure::Intra;
  EvaluationInput input = EvaluationInput::Clean;
  Contacts contacts = Contacts::Off;
  int pairs = 0;
  PairErrors mean;  // over the pairs; the largest for bone_length
};
// What a row is the mean of.
struct EvaluatedPair {
  std::string method, motion, coach, student;
  Structure structure = Structure::Intra;
  EvaluationInput input = EvaluationInput::Clean;
  Contacts contacts = Contacts::Off;
  PairErrors errors;
};

struct Evaluation {
  std::vector<EvaluationRow> rows;  // only structures that occur
  std::vector<EvaluatedPair> pairs;
  std::vector<std::string> notes;  // joint sets, pairs that were left out and why
};

// All ordered pairs of characters that share a motion's name, at 30 frames per second, every method with and
// without contacts. Errors: Incomplete (no pair), Cancelled, those of retarget.
Result<Evaluation> evaluate_retarget(const std::vector<CharacterMotion>& motions,
                                     const EvaluationOptions& options = {}, const Progress& progress = {});

}  // namespace posecoach
