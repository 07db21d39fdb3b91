#include "core/transfer/network/losses.h"

namespace posecoach {
namespace {

torch::Tensor bones_of(const torch::Tensor& poses) {
  static const auto [parents, children] = [] {
    // Made by whoever comes first, used in training too.
    const torch::InferenceMode ordinary(false);
    std::vector<int64_t> from, to;
    for (const Bone2d& bone : kBones2d) {
      from.push_back(static_cast<int64_t>(bone.parent));
      to.push_back(static_cast<int64_t>(bone.child));
    }
    return std::pair{torch::tensor(from), torch::tensor(to)};
  }();
  return poses.index_select(1, children) - poses.index_select(1, parents);
}

torch::Tensor sum_over_directions(const torch::Tensor& losses) {
  return losses.sum(2).mean();
}

}  // namespace

LinkProjection::LinkProjection(const std::vector<Link>& links, const std::vector<Vec2>& vectors) {
  std::vector<int64_t> i, j;
  for (const auto& [a, b] : links) {
    i.push_back(static_cast<int64_t>(a));
    j.push_back(static_cast<int64_t>(b));
  }
  first = torch::tensor(i);
  second = torch::tensor(j);
  directions = torch::empty({2, static_cast<int64_t>(vectors.size())});
  for (std::size_t d = 0; d < vectors.size(); ++d) {
    directions[0][static_cast<int64_t>(d)] = static_cast<float>(vectors[d].x);
    directions[1][static_cast<int64_t>(d)] = static_cast<float>(vectors[d].y);
  }
}

torch::Tensor LinkProjection::differences(const torch::Tensor& poses) const {
  const torch::Tensor projected = torch::matmul(poses, directions.to(poses.dtype()));
  return projected.index_select(1, first) - projected.index_select(1, second);
}

torch::Tensor virtual_link_loss(const torch::Tensor& source, const torch::Tensor& result,
                                const LinkProjection& links, double sigma) {
  const torch::Tensor before = links.differences(source), after = links.differences(result);
  const torch::Tensor in_order = torch::relu(sigma - before.sign() * after);
  return sum_over_directions(torch::where(before.abs() < sigma, after.square(), in_order));
}

torch::Tensor ranking_loss(const torch::Tensor& source, const torch::Tensor& result,
                           const LinkProjection& links, double sigma) {
  const torch::Tensor before = links.differences(source), after = links.differences(result);
  const torch::Tensor in_order = torch::nn::functional::softplus(-before.sign() * after);
  return sum_over_directions(torch::where(before.abs() < sigma, after.square(), in_order));
}

torch::Tensor angle_loss(const torch::Tensor& source, const torch::Tensor& result) {
  constexpr double kNoLength = 1e-6;
  const torch::Tensor before = bones_of(source), after = bones_of(result);
  const torch::Tensor squares = before.square().sum(2) * after.square().sum(2);
  const torch::Tensor has_direction = squares > kNoLength * kNoLength;
  // The inner `where` keeps the square root's gradient finite for bones that count nothing.
  const torch::Tensor product = torch::where(has_direction, squares, torch::ones_like(squares)).sqrt();
  const torch::Tensor cosine = (before * after).sum(2) / product;
  return torch::where(has_direction, (cosine - 1).abs(), torch::zeros_like(cosine)).mean();
}

}  // namespace posecoach
