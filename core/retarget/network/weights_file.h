// Weights on disk: libtorch's archive with what the network is and under which options it was made.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/base/error.h"
#include "core/retarget/network/torch.h"

namespace posecoach {

// Parameters and buffers by their dotted names; and whole numbers by name.
struct WeightsFile {
  std::string kind;  // "posecoach.retarget.paper/1", ...
  std::map<std::string, int64_t> numbers;
  std::map<std::string, torch::Tensor> tensors;
};

Result<void> write_weights(const std::filesystem::path& path, const WeightsFile& weights);
// Errors: those of read_file; Malformed (no such archive).
Result<WeightsFile> read_weights(const std::filesystem::path& path);
Result<WeightsFile> read_weights(std::string_view bytes, const std::string& name);

std::map<std::string, torch::Tensor> tensors_of(const torch::nn::Module& module);
// Errors: Malformed naming the first tensor that is missing or has another shape.
Result<void> load_tensors(torch::nn::Module& module, const std::map<std::string, torch::Tensor>& tensors,
                          const std::string& name);

}  // namespace posecoach
