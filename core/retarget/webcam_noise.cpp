#include "core/retarget/webcam_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/body/landmark_body.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// Standard deviations for a body of 1.75 m, centimetres: constant over a clip, wandering, frame by frame.
struct Spread {
  double constant = 0, wandering = 0, shaking = 0;
};
struct JointNoise {
  HumanoidJoint joint;
  Spread across, depth;
};
constexpr double kMeasuredHeight_m = 1.75;
constexpr std::array kJointNoise = {JointNoise{LeftHip, {1.8, 1.7, 0.4}, {2.4, 0.7, 0.15}},
                                    JointNoise{RightHip, {1.8, 1.7, 0.4}, {2.4, 0.7, 0.15}},
                                    JointNoise{LeftShoulder, {1.7, 2.4, 0.6}, {4.5, 4.2, 0.8}},
                                    JointNoise{RightShoulder, {1.7, 2.4, 0.6}, {4.5, 4.2, 0.8}},
                                    JointNoise{Head, {1.9, 1.3, 0.2}, {5.5, 6.7, 1.35}},
                                    JointNoise{LeftElbow, {3.5, 4.0, 1.0}, {6.2, 8.4, 1.8}},
                                    JointNoise{RightElbow, {3.5, 4.0, 1.0}, {6.2, 8.4, 1.8}},
                                    JointNoise{LeftWrist, {2.1, 3.0, 1.2}, {11.1, 10.7, 3.8}},
                                    JointNoise{RightWrist, {2.1, 3.0, 1.2}, {11.1, 10.7, 3.8}},
                                    JointNoise{LeftKnee, {0.95, 1.4, 0.55}, {9.4, 4.3, 0.6}},
                                    JointNoise{RightKnee, {0.95, 1.4, 0.55}, {9.4, 4.3, 0.6}},
                                    JointNoise{LeftAnkle, {1.85, 1.2, 0.45}, {16.8, 7.0, 0.8}},
                                    JointNoise{RightAnkle, {1.85, 1.2, 0.45}, {16.8, 7.0, 0.8}}};
// Of joints that hang on a measured one: added to its error.
constexpr Spread kHangingNoise = {1.5, 1.5, 0.5};
constexpr double kWanderingSeconds = 0.3;  // in which the wandering forgets

// A limb that is hidden for a while: less sure and further off; or lost: it stays where it was seen last.
struct Spell {
  double begin_s = 0, end_s = 0;
  bool lost = false;
};
constexpr double kHiddenShare = 0.25, kHiddenFactor = 1.5, kHiddenConfidence = 0.35;
constexpr double kLostShare = 0.12, kLostSeconds = 0.4;

constexpr std::array<std::array<HumanoidJoint, 3>, 4> kLimbs = {{{LeftElbow, LeftWrist, LeftWrist},
                                                                 {RightElbow, RightWrist, RightWrist},
                                                                 {LeftKnee, LeftAnkle, LeftToe},
                                                                 {RightKnee, RightAnkle, RightToe}}};

class Noise {
 public:
  Noise(const Motion& motion, std::mt19937_64& random)
      : motion_(motion), skeleton_(motion.skeleton()), random_(random) {
    unit_ = 0.01 * skeleton_.rest_height() / kMeasuredHeight_m;
    const double seconds = to_seconds(motion.duration());
    for (auto& spells : spells_) {
      if (uniform() < kHiddenShare) add_spell(spells, seconds, seconds * uniform(), false);
      if (uniform() < kLostShare) add_spell(spells, seconds, kLostSeconds * (0.5 + uniform()), true);
    }
    for (int j = 0; j < skeleton_.size(); ++j) start(j);
  }

  Motion noisy() {
    std::vector<Vec3> positions;
    std::vector<double> confidence;
    std::vector<Vec3> errors(index(skeleton_.size()));
    for (int frame = 0; frame < motion_.frame_count(); ++frame) {
      const double step =
          frame == 0 ? 1e9 : to_seconds(motion_.time(frame) - motion_.time(frame - 1)) / kWanderingSeconds;
      for (int j = 0; j < skeleton_.size(); ++j) {
        const Spell* spell = spell_of(j, to_seconds(motion_.time(frame) - motion_.time(0)));
        errors[index(j)] = error_of(j, step, errors) * (spell ? kHiddenFactor : 1.0);
        const Vec3 seen = motion_.position(frame, j) + errors[index(j)];
        const bool lost = spell && spell->lost && frame > 0;
        positions.push_back(lost ? positions[positions.size() - index(skeleton_.size())] : seen);
        confidence.push_back(lost ? 0.0 : spell ? kHiddenConfidence : 0.95);
      }
    }
    Result<Motion> made = Motion::from_positions(skeleton_, {motion_.times().begin(), motion_.times().end()},
                                                 std::move(positions), std::move(confidence));
    POSECOACH_ASSERT(made.has_value());
    return *std::move(made);
  }

 private:
  struct State {
    Spread across, depth;
    Vec3 constant, wandering;
    int first = kNoJoint, second = kNoJoint;  // joints whose errors it shares
  };

  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  Vec3 normal(double across, double depth) {
    std::normal_distribution<double> one;
    const double x = one(random_), y = one(random_), z = one(random_);
    return unit_ * Vec3(across * x, across * y, depth * z);
  }

  void add_spell(std::vector<Spell>& spells, double seconds, double length, bool lost) {
    const double begin = uniform() * std::max(0.0, seconds - length);
    spells.push_back({begin, begin + length, lost});
  }

  const Spell* spell_of(int joint, double time_s) const {
    for (int j = joint; j != kNoJoint; j = skeleton_.joint(j).parent) {
      const auto role = skeleton_.joint(j).role;
      if (!role) continue;
      for (std::size_t limb = 0; limb < kLimbs.size(); ++limb)
        if (std::find(kLimbs[limb].begin(), kLimbs[limb].end(), *role) != kLimbs[limb].end())
          for (const Spell& spell : spells_[limb])
            if (time_s >= spell.begin_s && time_s < spell.end_s) return &spell;
      break;
    }
    return nullptr;
  }

  // Measured joints err by themselves; the trunk errs with the hips and shoulders between which it lies; what
  // hangs on a joint errs with it.
  void start(int joint) {
    State state;
    const auto role = skeleton_.joint(joint).role;
    const auto known = std::find_if(kJointNoise.begin(), kJointNoise.end(),
                                    [&](const JointNoise& noise) { return role && noise.joint == *role; });
    if (known != kJointNoise.end()) {
      state.across = known->across;
      state.depth = known->depth;
    } else if (role && (*role == Pelvis || *role == Spine)) {
      state.first = skeleton_.find(LeftHip), state.second = skeleton_.find(RightHip);
    } else if (role && (*role == Chest || *role == Neck || *role == SpineMiddle || *role == LeftClavicle ||
                        *role == RightClavicle)) {
      state.first = skeleton_.find(LeftShoulder), state.second = skeleton_.find(RightShoulder);
      if (*role == SpineMiddle) state.second = skeleton_.find(LeftHip);
    } else {
      state.first = state.second = skeleton_.joint(joint).parent;
      if (role != HeadTop) state.across = state.depth = kHangingNoise;
    }
    state.constant = normal(state.across.constant, state.depth.constant);
    states_.push_back(state);
  }

  // Joints that are shared may come later in the tree: their last error is one frame old, which is near.
  Vec3 error_of(int joint, double step, const std::vector<Vec3>& errors) {
    State& state = states_[index(joint)];
    const double keep = std::exp(-step);
    const double fresh = std::sqrt(1 - keep * keep);
    state.wandering = keep * state.wandering + fresh * normal(state.across.wandering, state.depth.wandering);
    Vec3 error = state.constant + state.wandering + normal(state.across.shaking, state.depth.shaking);
    if (state.first != kNoJoint && state.second != kNoJoint)
      error += 0.5 * (errors[index(state.first)] + errors[index(state.second)]);
    return error;
  }

  const Motion& motion_;
  const Skeleton& skeleton_;
  std::mt19937_64& random_;
  double unit_ = 0;
  std::array<std::vector<Spell>, kLimbs.size()> spells_;
  std::vector<State> states_;
};

}  // namespace

Motion with_webcam_noise(const Motion& motion, std::mt19937_64& random) {
  return Noise(motion, random).noisy();
}

}  // namespace posecoach
