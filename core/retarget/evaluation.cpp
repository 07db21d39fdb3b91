#include "core/retarget/evaluation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/retarget/feet.h"
#include "core/retarget/grip.h"
#include "core/retarget/joint_limits.h"
#include "core/retarget/t_pose.h"
#include "core/retarget/webcam_noise.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kEvaluationRate = 30;

std::vector<HumanoidJoint> roles_of(const Skeleton& skeleton) {
  std::vector<HumanoidJoint> roles;
  for (const HumanoidJoint role : kHumanoidJoints)
    if (skeleton.has(role)) roles.push_back(role);
  return roles;
}

double chain_length(const Skeleton& skeleton, int end) {
  double length = 0;
  for (int j = end; j != kNoJoint && skeleton.joint(j).parent != kNoJoint; j = skeleton.joint(j).parent)
    length += skeleton.bone_length(j);
  return length;
}

double mean_slide_cm_s(const Motion& student, const FootContacts& contacts) {
  double way = 0, seconds = 0;
  for (const bool left : {true, false})
    for (const PlantedFoot& contact : left ? contacts.left : contacts.right) {
      const int joint = anchor_joint(student.skeleton(), contact.anchor, left);
      for (int f = contact.begin + 1; f < contact.end; ++f) {
        Vec3 step = student.position(f, joint) - student.position(f - 1, joint);
        step.y = 0;
        way += glm::length(step);
        seconds += to_seconds(student.time(f) - student.time(f - 1));
      }
    }
  return seconds > 0 ? 100 * way / seconds : 0;
}

double mean_jitter(const Motion& motion, const std::vector<int>& joints) {
  double sum = 0;
  int count = 0;
  for (int f = 0; f + 3 < motion.frame_count(); ++f) {
    const double dt = to_seconds(motion.time(f + 3) - motion.time(f)) / 3;
    const auto local = [&](int frame, int joint) {
      return motion.position(frame, joint) - motion.position(frame, 0);
    };
    for (const int j : joints) {
      sum += glm::length(local(f + 3, j) - 3.0 * local(f + 2, j) + 3.0 * local(f + 1, j) - local(f, j)) /
             (dt * dt * dt);
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

std::optional<double> mean_grip_error_cm(const Motion& predicted, const Motion& coach) {
  const std::vector<double> weights = grip_weights(coach);
  double sum = 0;
  int count = 0;
  for (int f = 0; f < coach.frame_count(); ++f) {
    if (weights[index(f)] < 1 - 1e-9) continue;
    sum += 100 * glm::distance(wrist_relation(predicted.skeleton(), predicted.positions(f)),
                               wrist_relation(coach.skeleton(), coach.positions(f)));
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

// Whole frames only, so that truth and prediction stay what the files say.
Motion at_evaluation_rate(const Motion& motion) {
  const int stride = std::max(1, static_cast<int>(std::lround(motion.frame_rate() / kEvaluationRate)));
  std::vector<MediaTime> times;
  for (int f = 0; f < motion.frame_count(); f += stride) times.push_back(motion.time(f));
  return resample(motion, times);
}

struct Pair {
  const CharacterMotion* coach;
  const CharacterMotion* truth;
  Structure structure;
};

std::string joined(const std::vector<HumanoidJoint>& roles) {
  std::string text;
  for (const HumanoidJoint role : roles) text += (text.empty() ? "" : " ") + std::string(to_string(role));
  return text;
}

std::vector<Pair> pairs_of(const std::vector<CharacterMotion>& motions, std::vector<std::string>& notes) {
  std::vector<Pair> pairs;
  for (const CharacterMotion& coach : motions)
    for (const CharacterMotion& truth : motions) {
      if (coach.name != truth.name || coach.character == truth.character) continue;
      if (coach.motion.frame_count() != truth.motion.frame_count()) {
        notes.push_back(coach.name + ": " + coach.character + " and " + truth.character +
                        " have different numbers of frames; left out");
        continue;
      }
      const bool same = roles_of(coach.motion.skeleton()) == roles_of(truth.motion.skeleton());
      pairs.push_back({&coach, &truth, same ? Structure::Intra : Structure::Cross});
    }
  return pairs;
}

void add(PairErrors& sum, const PairErrors& errors) {
  sum.root += errors.root;
  sum.local += errors.local;
  sum.global += errors.global;
  sum.eq16_cm += errors.eq16_cm;
  sum.bone_length = std::max(sum.bone_length, errors.bone_length);
  sum.beyond_limits_degrees = std::max(sum.beyond_limits_degrees, errors.beyond_limits_degrees);
  sum.slide_cm_s += errors.slide_cm_s;
  sum.coach_slide_cm_s += errors.coach_slide_cm_s;
  sum.jitter_m_s3 += errors.jitter_m_s3;
}

PairErrors mean_of(const std::vector<PairErrors>& all) {
  PairErrors mean;
  double grip = 0;
  int grips = 0;
  for (const PairErrors& errors : all) {
    add(mean, errors);
    if (!errors.grip_cm) continue;
    grip += *errors.grip_cm;
    ++grips;
  }
  const auto count = static_cast<double>(all.size());
  for (double* value : {&mean.root, &mean.local, &mean.global, &mean.eq16_cm, &mean.slide_cm_s,
                        &mean.coach_slide_cm_s, &mean.jitter_m_s3})
    *value /= count;
  if (grips > 0) mean.grip_cm = grip / grips;
  return mean;
}

std::vector<std::string> joint_notes(const std::vector<CharacterMotion>& motions) {
  std::map<std::string, std::vector<std::string>> characters_of_set;
  for (const CharacterMotion& motion : motions) {
    auto& characters = characters_of_set[joined(roles_of(motion.motion.skeleton()))];
    if (std::find(characters.begin(), characters.end(), motion.character) == characters.end())
      characters.push_back(motion.character);
  }
  std::vector<std::string> notes;
  for (const auto& [joints, characters] : characters_of_set) {
    std::string note;
    for (const std::string& character : characters) note += (note.empty() ? "" : ", ") + character;
    notes.push_back(note + ": " + std::to_string(std::count(joints.begin(), joints.end(), ' ') + 1) +
                    " joints: " + joints);
  }
  return notes;
}

// Every pair with noise of its own, the same for all methods.
std::vector<Motion> seen_by(EvaluationInput input, const std::vector<Pair>& pairs) {
  std::vector<Motion> coaches;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::mt19937_64 random(i + 1);
    const Motion& clean = pairs[i].coach->motion;
    coaches.push_back(input == EvaluationInput::Webcam ? with_webcam_noise(clean, random) : clean);
  }
  return coaches;
}

// Intra before cross, in the order of the pairs.
std::vector<EvaluationRow> rows_of(const std::vector<EvaluatedPair>& pairs) {
  std::vector<EvaluationRow> rows;
  std::vector<std::vector<PairErrors>> errors;
  for (const Structure structure : {Structure::Intra, Structure::Cross})
    for (const EvaluatedPair& pair : pairs) {
      if (pair.structure != structure) continue;
      const auto same = [&](const EvaluationRow& row) {
        return row.method == pair.method && row.structure == structure && row.input == pair.input &&
               row.contacts == pair.contacts;
      };
      auto row = std::find_if(rows.begin(), rows.end(), same);
      if (row == rows.end()) {
        rows.push_back({pair.method, structure, pair.input, pair.contacts, 0, {}});
        errors.emplace_back();
        row = rows.end() - 1;
      }
      errors[static_cast<std::size_t>(row - rows.begin())].push_back(pair.errors);
    }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].pairs = static_cast<int>(errors[i].size());
    rows[i].mean = mean_of(errors[i]);
  }
  return rows;
}

}  // namespace

double chain_height(const Skeleton& skeleton) {
  const auto first_of = [&](std::initializer_list<HumanoidJoint> roles) {
    for (const HumanoidJoint role : roles)
      if (skeleton.has(role)) return skeleton.find(role);
    return kNoJoint;
  };
  return chain_length(skeleton, first_of({LeftToeTip, LeftToe, LeftAnkle})) +
         chain_length(skeleton, first_of({HeadTop, Head, Neck}));
}

PairErrors compare(const Motion& predicted, const Motion& truth, const Motion& coach) {
  const Skeleton& skeleton = truth.skeleton();
  POSECOACH_ASSERT(predicted.joint_count() == truth.joint_count());
  POSECOACH_ASSERT(predicted.frame_count() == truth.frame_count() &&
                   coach.frame_count() == truth.frame_count());
  const double height = chain_height(skeleton);
  POSECOACH_ASSERT(height > 0);
  std::vector<int> joints;
  for (const HumanoidJoint role : roles_of(skeleton)) joints.push_back(skeleton.find(role));
  PairErrors errors;
  for (int f = 0; f < truth.frame_count(); ++f) {
    const Vec3 root = predicted.position(f, 0) - truth.position(f, 0);
    errors.root += glm::dot(root, root);
    for (const int j : joints) {
      const Vec3 off = predicted.position(f, j) - truth.position(f, j);
      errors.global += glm::dot(off, off);
      errors.local += glm::dot(off - root, off - root);
      const int parent = skeleton.joint(j).parent;
      const double bone = skeleton.bone_length(j);
      if (parent != kNoJoint && bone > 1e-6)
        errors.bone_length = std::max(
            errors.bone_length,
            std::abs(glm::distance(predicted.position(f, j), predicted.position(f, parent)) - bone) / bone);
    }
  }
  const double frames = truth.frame_count(), points = frames * static_cast<double>(joints.size());
  errors.eq16_cm = 100 * errors.global / points / height;
  errors.root /= 3 * frames * height * height;
  errors.local /= 3 * points * height * height;
  errors.global /= 3 * points * height * height;
  errors.grip_cm = mean_grip_error_cm(predicted, coach);
  const FootContacts contacts = find_foot_contacts(coach);
  errors.slide_cm_s = mean_slide_cm_s(predicted, contacts);
  errors.coach_slide_cm_s = mean_slide_cm_s(coach, contacts);
  errors.beyond_limits_degrees = joint_limit_excess(predicted).largest_degrees;
  errors.jitter_m_s3 = mean_jitter(predicted, joints);
  return errors;
}

std::vector<EvaluatedMethod> every_method() {
  std::vector<EvaluatedMethod> methods;
  for (const RetargetMethod method :
       {RetargetMethod::Network, RetargetMethod::Paper, RetargetMethod::Rotation, RetargetMethod::Direction,
        RetargetMethod::Scale}) {
    methods.push_back({std::string(to_string(method)), {}});
    methods.back().options.method = method;
  }
  return methods;
}

Result<Evaluation> evaluate_retarget(const std::vector<CharacterMotion>& motions,
                                     const EvaluationOptions& options, const Progress& progress) {
  std::vector<CharacterMotion> sampled;
  for (const CharacterMotion& motion : motions)
    sampled.push_back({motion.character, motion.name, at_evaluation_rate(motion.motion)});
  Evaluation evaluation;
  evaluation.notes = joint_notes(motions);
  const std::vector<Pair> pairs = pairs_of(sampled, evaluation.notes);
  if (pairs.empty())
    return fail(ErrorCode::Incomplete, "no two characters share a motion of the same name and length");

  const double all_runs =
      static_cast<double>(options.inputs.size() * options.methods.size() * 2 * pairs.size());
  double done = 0;
  for (const EvaluationInput input : options.inputs) {
    const std::vector<Motion> coaches = seen_by(input, pairs);
    for (const EvaluatedMethod& method : options.methods)
      for (const Contacts contacts : {Contacts::Off, Contacts::On}) {
        RetargetOptions retargeting = method.options;
        retargeting.contacts = contacts;
        retargeting.rotations = options.rotations;
        retargeting.smoothing =
            input == EvaluationInput::Webcam ? InputSmoothing::WhereDoubtful : InputSmoothing::Off;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
          const Pair& pair = pairs[i];
          if (!report(progress, "retargeting", done++ / all_runs))
            return fail(ErrorCode::Cancelled, "the evaluation was interrupted");
          const auto student = retarget(coaches[i], pair.truth->motion.skeleton(), retargeting);
          if (!student)
            return fail(student.error().code, pair.coach->character + " to " + pair.truth->character + ", " +
                                                  pair.coach->name + ": " + student.error().message);
          evaluation.pairs.push_back({method.name, pair.coach->name, pair.coach->character,
                                      pair.truth->character, pair.structure, input, contacts,
                                      compare(student->motion, pair.truth->motion, pair.coach->motion)});
        }
      }
  }
  evaluation.rows = rows_of(evaluation.pairs);
  return evaluation;
}

}  // namespace posecoach
