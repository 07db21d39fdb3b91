#include "core/vision/model_file.h"

#include <cstdlib>

#include "core/base/file.h"
#include "core/vision/tflite_reader.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostModelBytes = std::size_t{256} << 20;

std::vector<fs::path> model_folders() {
  const auto variable = [](const char* name) -> std::string {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
  };
  if (const std::string chosen = variable("POSECOACH_MODELS"); !chosen.empty()) return {chosen};
  std::vector<fs::path> folders;
  const fs::path inside = fs::path("virtual-pose-coach") / "models";
  if (const std::string data = variable("XDG_DATA_HOME"); !data.empty())
    folders.push_back(fs::path(data) / inside);
  else if (const std::string home = variable("HOME"); !home.empty())
    folders.push_back(fs::path(home) / ".local" / "share" / inside);
  folders.push_back(fs::path("/usr/share") / inside);
  return folders;
}

// Apart, so that the file's bytes are gone before the network is built.
Result<NetworkGraph> read_graph(const fs::path& file) {
  const auto bytes = read_file(file, kMostModelBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return read_tflite(*bytes, file.string());
}

}  // namespace

const char* landmark_file_name(PoseModel model) {
  switch (model) {
    case PoseModel::Lite:
      return "pose_landmark_lite.tflite";
    case PoseModel::Full:
      return "pose_landmark_full.tflite";
    case PoseModel::Heavy:
      return "pose_landmark_heavy.tflite";
  }
  return "";
}

Result<fs::path> find_model_file(const std::string& file_name, const std::optional<fs::path>& given) {
  const std::vector<fs::path> folders = given ? std::vector{*given} : model_folders();
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    if (fs::is_regular_file(folder / file_name, ignored)) return folder / file_name;
  }
  // The first is the user's own: a chosen folder, or where the set-up puts them, if there is a home.
  return fail(ErrorCode::NotFound,
              "the pose model " + file_name + " is not in " + folders.front().string() +
                  "; run scripts/setup, or posecoach-fetch-models of an installed program, or "
                  "name their folder with --models");
}

Result<Network> load_network(const fs::path& file, const std::vector<int>& input_shape,
                             const std::vector<TensorClaim>& outputs) {
  auto graph = read_graph(file);
  if (!graph) return tl::unexpected(graph.error());
  std::vector<std::string> names;
  for (const TensorClaim& output : outputs) names.push_back(output.name);
  auto simple = simplified_graph(std::move(*graph), names);
  const auto other_network = [&] {
    return fail(
        ErrorCode::Unsupported,
        file.string() + " is another network than its name says; run scripts/setup to install the models");
  };
  if (!simple || simple->at(simple->inputs[0]).shape != input_shape) return other_network();
  for (std::size_t i = 0; i < outputs.size(); ++i)
    if (simple->at(simple->outputs[i]).shape != outputs[i].shape) return other_network();
  auto network = Network::make(std::move(*simple));
  if (!network) return fail(network.error().code, file.string() + ": " + network.error().message);
  return network;
}

}  // namespace posecoach
