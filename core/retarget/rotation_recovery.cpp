#include "core/retarget/rotation_recovery.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/body/forward_kinematics.h"
#include "core/body/two_bone_ik.h"

namespace posecoach {
namespace {

constexpr double kNoLength = 1e-9;

// The eigenvector of the largest eigenvalue of a symmetric 4x4 matrix, by Jacobi rotations.
std::array<double, 4> dominant_eigenvector(std::array<std::array<double, 4>, 4> a) {
  std::array<std::array<double, 4>, 4> v{};
  for (std::size_t i = 0; i < 4; ++i) v[i][i] = 1;
  for (int sweep = 0; sweep < 32; ++sweep) {
    double off = 0, all = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) (i == j ? all : off) += a[i][j] * a[i][j];
    if (off <= 1e-32 * all) break;
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = p + 1; q < 4; ++q) {
        if (a[p][q] == 0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = (theta >= 0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), s = t * c;
        for (std::size_t k = 0; k < 4; ++k) {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq;
          a[k][q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < 4; ++k) {
          const double pk = a[p][k], qk = a[q][k];
          a[p][k] = c * pk - s * qk;
          a[q][k] = s * pk + c * qk;
          const double vp = v[k][p], vq = v[k][q];
          v[k][p] = c * vp - s * vq;
          v[k][q] = s * vp + c * vq;
        }
      }
    }
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (a[i][i] > a[best][best]) best = i;
  return {v[0][best], v[1][best], v[2][best], v[3][best]};
}

// Whether the directions span more than a line (by over 3 degrees, or noise would decide).
bool span_a_plane(std::span<const DirectionPair> pairs) {
  for (std::size_t i = 1; i < pairs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double lengths = glm::length(pairs[i].from) * glm::length(pairs[j].from);
      if (glm::length(glm::cross(pairs[i].from, pairs[j].from)) > 0.05 * lengths) return true;
    }
  return false;
}

class Recovery {
 public:
  Recovery(const Skeleton& skeleton, const TPose& t_pose, std::span<const Vec3> positions)
      : skeleton_(skeleton), t_pose_(t_pose), positions_(positions) {}

  Quat turn_of(int joint, const Quat& parent_turn) {
    pairs_.clear();
    hints_.clear();
    for (const int child : skeleton_.children(joint)) {
      if (glm::length(t_pose_.offsets[index(child)]) > kNoLength) {
        add(child, joint, pairs_);
      } else {
        for (const int grandchild : skeleton_.children(child)) add(grandchild, joint, hints_);
      }
    }
    if (pairs_.empty()) std::swap(pairs_, hints_);
    if (pairs_.empty()) return parent_turn;
    if (span_a_plane(pairs_)) return best_rotation(pairs_);
    return turn_of_line(joint, parent_turn);
  }

 private:
  void add(int end, int start, std::vector<DirectionPair>& to) const {
    const Vec3 rest = t_pose_.positions[index(end)] - t_pose_.positions[index(start)];
    const Vec3 now = positions_[index(end)] - positions_[index(start)];
    if (glm::length(rest) > kNoLength && glm::length(now) > kNoLength)
      to.push_back({glm::normalize(rest), glm::normalize(now)});
  }

  // All bones lie along one line (a lone bone, or hips and shoulders with their joint between them): that
  // line exactly, and what spin there is from what else is near. Shoulders find it in the bone below them.
  Quat turn_of_line(int joint, const Quat& parent_turn) {
    Vec3 rest(0), now(0);
    for (const DirectionPair& pair : pairs_) {
      const double side = glm::dot(pair.from, pairs_[0].from) < 0 ? -1.0 : 1.0;
      rest += side * pair.from;
      now += side * pair.to;
    }
    if (glm::length(now) < kNoLength) return parent_turn;
    const Quat swing = swing_between(parent_turn * rest, now) * parent_turn;
    const int parent = skeleton_.joint(joint).parent;
    if (pairs_.size() > 1 && parent != kNoJoint) {
      std::vector<DirectionPair> below;
      add(joint, parent, below);
      if (!below.empty()) hints_ = below;
    }
    if (hints_.empty()) return swing;
    for (DirectionPair& hint : hints_) hint.from = swing * hint.from;
    return best_turn_about(glm::normalize(now), hints_) * swing;
  }

  const Skeleton& skeleton_;
  const TPose& t_pose_;
  std::span<const Vec3> positions_;
  std::vector<DirectionPair> pairs_, hints_;
};

}  // namespace

Quat best_rotation(std::span<const DirectionPair> pairs) {
  double s[3][3] = {};
  for (const DirectionPair& pair : pairs)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) s[i][j] += pair.weight * pair.from[i] * pair.to[j];
  const auto q = dominant_eigenvector(
      {{{s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]},
        {s[1][2] - s[2][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]},
        {s[2][0] - s[0][2], s[0][1] + s[1][0], -s[0][0] + s[1][1] - s[2][2], s[1][2] + s[2][1]},
        {s[0][1] - s[1][0], s[2][0] + s[0][2], s[1][2] + s[2][1], -s[0][0] - s[1][1] + s[2][2]}}});
  return glm::normalize(Quat(q[0], q[1], q[2], q[3]));
}

Quat best_turn_about(const Vec3& axis, std::span<const DirectionPair> pairs) {
  double sine = 0, cosine = 0;
  for (const DirectionPair& pair : pairs) {
    const Vec3 a = pair.from - axis * glm::dot(axis, pair.from);
    const Vec3 b = pair.to - axis * glm::dot(axis, pair.to);
    sine += pair.weight * glm::dot(axis, glm::cross(a, b));
    cosine += pair.weight * glm::dot(a, b);
  }
  if (std::hypot(sine, cosine) < 1e-12) return Quat(1, 0, 0, 0);
  return glm::angleAxis(std::atan2(sine, cosine), axis);
}

void recover_turns(const Skeleton& skeleton, const TPose& t_pose, std::span<const Vec3> positions,
                   std::span<Quat> turns) {
  POSECOACH_ASSERT(positions.size() == index(skeleton.size()) && turns.size() == positions.size());
  Recovery recovery(skeleton, t_pose, positions);
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joint(j).parent;
    turns[index(j)] = recovery.turn_of(j, parent == kNoJoint ? Quat(1, 0, 0, 0) : turns[index(parent)]);
  }
}

Motion with_rotations(const Motion& motion) {
  if (motion.has_rotations()) return motion;
  const Skeleton& skeleton = motion.skeleton();
  const TPose t_pose = make_t_pose(skeleton);
  const std::size_t joints = index(skeleton.size());
  std::vector<Quat> turns(joints), local(index(motion.frame_count()) * joints);
  std::vector<Vec3> roots;
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    recover_turns(skeleton, t_pose, motion.positions(frame), turns);
    for (std::size_t j = 0; j < joints; ++j) turns[j] = turns[j] * t_pose.rotations[j];
    local_rotations(skeleton, turns, std::span(local).subspan(index(frame) * joints, joints));
    roots.push_back(motion.position(frame, 0));
  }
  Result<Motion> made = Motion::from_rotations(skeleton, {motion.times().begin(), motion.times().end()},
                                               std::move(roots), std::move(local));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

}  // namespace posecoach
