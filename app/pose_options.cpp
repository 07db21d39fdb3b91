#include "app/pose_options.h"

#include <CLI/CLI.hpp>

namespace posecoach {

const char* to_string(PoseModel model) {
  switch (model) {
    case PoseModel::Lite:
      return "lite";
    case PoseModel::Full:
      return "full";
    case PoseModel::Heavy:
      return "heavy";
  }
  return "";
}

std::shared_ptr<PoseTrackerOptions> add_pose_options(CLI::App& command) {
  auto options = std::make_shared<PoseTrackerOptions>();
  const auto set_model = [options](const std::string& name) {
    for (const PoseModel model : {PoseModel::Lite, PoseModel::Full, PoseModel::Heavy})
      if (name == to_string(model)) options->model = model;
  };
  command
      .add_option_function<std::string>("--model", set_model, "Pose network: lite, full (default) or heavy")
      ->check(CLI::IsMember({"lite", "full", "heavy"}))
      ->type_name("NAME");
  command
      .add_option_function<std::string>(
          "--models", [options](const std::string& folder) { options->models = folder; },
          "Folder of the pose networks (default: $POSECOACH_MODELS, then where scripts/setup puts them)")
      ->type_name("DIR");
  return options;
}

}  // namespace posecoach
