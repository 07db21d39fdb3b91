// Our transfer network: it learns how much longer each bone really is than the pictures show, and what
// scaling bones cannot do.
#pragma once

#include <span>

#include "core/transfer/bone_lengths.h"
#include "core/transfer/network/torch.h"
#include "core/transfer/pose2d.h"

namespace posecoach {

inline constexpr int64_t kPictureNumbers = 4 * static_cast<int64_t>(kBone2dCount);
inline constexpr int64_t kPersonNumbers = 2 * static_cast<int64_t>(kBone2dCount);

// One picture as numbers: bone vectors and lengths in measured statures, and which bones were seen.
void write_picture(const Pose2d& pose, double stature, float* out);
// A person's measured lengths: logarithms of the lengths in statures, and which were measured.
void write_person(const BoneLengths2d& lengths, float* out);

class TransferNetwork : public torch::nn::Module {
 public:
  TransferNetwork();

  struct Person {
    torch::Tensor code;         // [N, code]
    torch::Tensor log_lengths;  // [N, 14], of bones in measured statures
  };
  // pictures [N, K, kPictureNumbers], person [N, kPersonNumbers].
  Person encode(const torch::Tensor& pictures, const torch::Tensor& person);

  struct Result {
    torch::Tensor bones;           // [N, 14, 2], in the second person's measured statures
    torch::Tensor expected_error;  // [N, 15], same unit, of the joints
    torch::Tensor touch;           // [N], logit: the hands hold each other or one thing
  };
  Result forward(const torch::Tensor& pose, const Person& source, const Person& identity);

 private:
  torch::nn::Sequential picture_{nullptr}, person_{nullptr}, lengths_{nullptr}, correction_{nullptr};
  torch::nn::Linear bones_{nullptr}, error_{nullptr}, touch_{nullptr};
};

// [N, 14, 2] -> [N, 15, 2], the mid-hip at the origin.
torch::Tensor joints_from_bones(const torch::Tensor& bones);

}  // namespace posecoach
