// The files of the pose networks: where they are and how they become networks.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/vision/network.h"

namespace posecoach {

enum class PoseModel { Lite, Full, Heavy };

inline constexpr const char* kDetectorFileName = "pose_detection.tflite";
const char* landmark_file_name(PoseModel model);

// The folder `given` by the user, if any; otherwise $POSECOACH_MODELS, if set; otherwise the first that holds
// the file of $XDG_DATA_HOME/virtual-pose-coach/models (usually ~/.local/share/...),
// /usr/share/virtual-pose-coach/models. Error: NotFound, which says how to install the models.
Result<std::filesystem::path> find_model_file(const std::string& file_name,
                                              const std::optional<std::filesystem::path>& given);

struct TensorClaim {
  std::string name;
  std::vector<int> shape;
};

// Reads, simplifies and builds the network for the named outputs. Errors: the reader's, and Unsupported when
// input or outputs have other shapes than claimed.
Result<Network> load_network(const std::filesystem::path& file, const std::vector<int>& input_shape,
                             const std::vector<TensorClaim>& outputs);

}  // namespace posecoach
