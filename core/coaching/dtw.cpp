#include "core/coaching/dtw.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/assert.h"

// One copy of the hot loops for machines with AVX2 and FMA, one for all others, chosen when the program
// starts. Sanitizers instrument that choice before they are ready themselves, and clang spells it otherwise.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define POSECOACH_VECTOR_CLONES __attribute__((target_clones("arch=haswell", "default")))
#else
#define POSECOACH_VECTOR_CLONES
#endif

namespace posecoach {
namespace {

constexpr std::size_t kLane = 16;

enum Step : std::uint8_t { Both, StudentOnly, CoachOnly, Start };

struct JointRows {
  const float *x, *y, *z, *weight;
};

// cost[j] += weight * |student joint - coach joint in frame j|
POSECOACH_VECTOR_CLONES void add_distances(const JointRows& coach, float x, float y, float z, float weight,
                                           float* __restrict cost, std::size_t count) {
  const float* __restrict cx = coach.x;
  const float* __restrict cy = coach.y;
  const float* __restrict cz = coach.z;
  for (std::size_t j = 0; j < count; ++j) {
    const float dx = cx[j] - x, dy = cy[j] - y, dz = cz[j] - z;
    cost[j] += weight * std::sqrt(dx * dx + dy * dy + dz * dz);
  }
}

// As above, where the coach's joints are doubtful too; `total` collects the weights.
POSECOACH_VECTOR_CLONES void add_doubtful_distances(const JointRows& coach, float x, float y, float z,
                                                    float weight, float* __restrict cost,
                                                    float* __restrict total, std::size_t count) {
  const float* __restrict cx = coach.x;
  const float* __restrict cy = coach.y;
  const float* __restrict cz = coach.z;
  const float* __restrict cw = coach.weight;
  for (std::size_t j = 0; j < count; ++j) {
    const float dx = cx[j] - x, dy = cy[j] - y, dz = cz[j] - z;
    const float both = weight * cw[j];
    cost[j] += both * std::sqrt(dx * dx + dy * dy + dz * dz);
    total[j] += both;
  }
}

POSECOACH_VECTOR_CLONES void divide_by_total(float joints, float* __restrict cost,
                                             const float* __restrict total, std::size_t count) {
  for (std::size_t j = 0; j < count; ++j) cost[j] *= joints / std::max(total[j], 1e-12F);
}

// The two predecessors that lie in the row above.
POSECOACH_VECTOR_CLONES void best_of_row_above(const double* __restrict above, double* __restrict best,
                                               std::uint8_t* __restrict steps, std::size_t count) {
  for (std::size_t j = 1; j < count; ++j) {
    best[j] = std::min(above[j - 1], above[j]);
    steps[j] = above[j] < above[j - 1] ? StudentOnly : Both;
  }
}

// Accumulates row after row; keeps one byte a cell and the last row.
class WarpTable {
 public:
  WarpTable(std::size_t rows, std::size_t columns, WarpEnds ends)
      : columns_(columns),
        ends_(ends),
        steps_(rows * columns),
        row_(columns),
        above_(columns),
        best_(columns) {}

  void add_row(const float* cost) {
    std::swap(row_, above_);
    std::uint8_t* steps = &steps_[rows_ * columns_];
    if (rows_ == 0) {
      std::fill(best_.begin(), best_.end(), std::numeric_limits<double>::infinity());
      std::fill(steps, steps + columns_, CoachOnly);
    } else {
      best_of_row_above(above_.data(), best_.data(), steps, columns_);
    }
    const bool starts_here = rows_ == 0 || ends_ == WarpEnds::OpenStudent;
    best_[0] = starts_here ? 0 : above_[0];
    steps[0] = starts_here ? Start : StudentOnly;
    double left = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < columns_; ++j) {
      if (left < best_[j]) steps[j] = CoachOnly;
      left = std::min(left, best_[j]) + static_cast<double>(cost[j]);
      row_[j] = left;
    }
    if (ends_ == WarpEnds::OpenStudent ? rows_ == 0 || row_.back() < end_cost_ : true) {
      end_cost_ = row_.back();
      end_row_ = rows_;
    }
    ++rows_;
  }

  Warp finish() const {
    Warp warp;
    warp.cost = end_cost_;
    std::size_t i = end_row_, j = columns_ - 1;
    for (;;) {
      warp.path.emplace_back(static_cast<int>(i), static_cast<int>(j));
      const std::uint8_t step = steps_[i * columns_ + j];
      if (step == Start) break;
      if (step != CoachOnly) --i;
      if (step != StudentOnly) --j;
    }
    std::reverse(warp.path.begin(), warp.path.end());
    return warp;
  }

 private:
  std::size_t columns_, rows_ = 0, end_row_ = 0;
  WarpEnds ends_;
  double end_cost_ = 0;
  std::vector<std::uint8_t> steps_;
  std::vector<double> row_, above_, best_;
};

// The student's weights of one frame, so that certain joints on the coach's side give a sum of `joints`.
std::vector<float> normalised_weights(const PoseSequence& poses, std::size_t frame) {
  std::vector<float> weights;
  float sum = 0;
  for (int k = 0; k < poses.joints(); ++k) sum += weights.emplace_back(poses.weight(k)[frame]);
  if (sum <= 0) return std::vector<float>(weights.size(), 1.0F);
  for (float& weight : weights) weight *= static_cast<float>(weights.size()) / sum;
  return weights;
}

JointRows rows_of(const PoseSequence& poses, int joint) {
  return {poses.x(joint).data(), poses.y(joint).data(), poses.z(joint).data(), poses.weight(joint).data()};
}

}  // namespace

PoseSequence::PoseSequence(int frames, int joints)
    : frames_(frames),
      joints_(joints),
      stride_((static_cast<std::size_t>(frames) + kLane - 1) / kLane * kLane),
      x_(stride_ * static_cast<std::size_t>(joints)),
      y_(x_.size()),
      z_(x_.size()),
      weight_(x_.size(), 1.0F) {
  POSECOACH_ASSERT(frames > 0 && joints > 0);
}

void PoseSequence::set(int frame, int joint, float x, float y, float z, float weight) {
  const std::size_t at = static_cast<std::size_t>(joint) * stride_ + static_cast<std::size_t>(frame);
  x_[at] = x;
  y_[at] = y;
  z_[at] = z;
  weight_[at] = weight;
  if (weight < 1) certain_ = false;
}

void cost_row(const PoseSequence& student, int student_frame, const PoseSequence& coach,
              std::vector<float>& costs) {
  POSECOACH_ASSERT(student.joints() == coach.joints());
  const auto i = static_cast<std::size_t>(student_frame);
  const std::size_t padded = coach.x(0).size();
  const std::vector<float> weights = normalised_weights(student, i);
  std::vector<float> total(coach.is_certain() ? 0 : padded, 0.0F);
  costs.assign(padded, 0.0F);
  for (int k = 0; k < student.joints(); ++k) {
    const float x = student.x(k)[i], y = student.y(k)[i], z = student.z(k)[i];
    const float weight = weights[static_cast<std::size_t>(k)];
    if (coach.is_certain())
      add_distances(rows_of(coach, k), x, y, z, weight, costs.data(), padded);
    else
      add_doubtful_distances(rows_of(coach, k), x, y, z, weight, costs.data(), total.data(), padded);
  }
  if (!coach.is_certain())
    divide_by_total(static_cast<float>(student.joints()), costs.data(), total.data(), padded);
}

Warp warp(const PoseSequence& student, const PoseSequence& coach, WarpEnds ends) {
  WarpTable table(static_cast<std::size_t>(student.frames()), static_cast<std::size_t>(coach.frames()), ends);
  std::vector<float> costs;
  for (int i = 0; i < student.frames(); ++i) {
    cost_row(student, i, coach, costs);
    table.add_row(costs.data());
  }
  return table.finish();
}

Warp warp(std::span<const float> costs, int columns, WarpEnds ends) {
  POSECOACH_ASSERT(columns > 0 && !costs.empty() && costs.size() % static_cast<std::size_t>(columns) == 0);
  const std::size_t rows = costs.size() / static_cast<std::size_t>(columns);
  WarpTable table(rows, static_cast<std::size_t>(columns), ends);
  for (std::size_t i = 0; i < rows; ++i) table.add_row(&costs[i * static_cast<std::size_t>(columns)]);
  return table.finish();
}

double pair_cost(const PoseSequence& student, int student_frame, const PoseSequence& coach, int coach_frame) {
  POSECOACH_ASSERT(student.joints() == coach.joints());
  const auto i = static_cast<std::size_t>(student_frame), j = static_cast<std::size_t>(coach_frame);
  const std::vector<float> weights = normalised_weights(student, i);
  double sum = 0, total = 0;
  for (int k = 0; k < student.joints(); ++k) {
    const double weight =
        static_cast<double>(weights[static_cast<std::size_t>(k)]) * static_cast<double>(coach.weight(k)[j]);
    sum += weight * std::hypot(static_cast<double>(student.x(k)[i] - coach.x(k)[j]),
                               static_cast<double>(student.y(k)[i] - coach.y(k)[j]),
                               static_cast<double>(student.z(k)[i] - coach.z(k)[j]));
    total += weight;
  }
  return sum * student.joints() / std::max(total, 1e-12);
}

}  // namespace posecoach
