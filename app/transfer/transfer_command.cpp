#include "app/transfer/transfer_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "app/output_check.h"
#include "app/pose_options.h"
#include "app/progress_bar.h"
#include "app/transfer/pose2d_input.h"
#include "core/base/file.h"
#include "core/transfer/contact_sheet.h"
#include "core/transfer/trained.h"

namespace posecoach {
namespace {

struct Arguments {
  std::string pose, identity, output, picture;
  std::string method = std::string(to_string(kDefaultTransferMethod));
  double pose_turn_degrees = 0, identity_turn_degrees = 0;
};

constexpr std::size_t kSheetRows = 6;
// More pictures of a person than this teach nothing new about their bones.
constexpr std::size_t kMostPictures = 120;

std::vector<Pose2d> pictures_of(const std::vector<TimedPose2d>& poses) {
  const std::size_t count = std::min(poses.size(), kMostPictures);
  std::vector<Pose2d> pictures;
  for (std::size_t i = 0; i < count; ++i) pictures.push_back(poses[i * poses.size() / count].pose);
  return pictures;
}

// Frames that show as different poses as possible, in the order of time.
std::vector<std::size_t> different_frames(const std::vector<TimedPose2d>& poses, std::size_t count) {
  const auto difference = [&](std::size_t a, std::size_t b) {
    const Pose2d from = centred(poses[a].pose), to = centred(poses[b].pose);
    double sum = 0;
    for (std::size_t i = 0; i < kJoint2dCount; ++i)
      if (from.seen[i] && to.seen[i]) sum += glm::length(from.positions[i] - to.positions[i]);
    return sum;
  };
  std::vector<std::size_t> chosen = {0};
  std::vector<double> nearest(poses.size(), std::numeric_limits<double>::max());
  while (chosen.size() < std::min(count, poses.size())) {
    for (std::size_t i = 0; i < poses.size(); ++i)
      nearest[i] = std::min(nearest[i], difference(i, chosen.back()));
    const auto farthest = std::max_element(nearest.begin(), nearest.end());
    if (*farthest <= 0) break;
    chosen.push_back(static_cast<std::size_t>(farthest - nearest.begin()));
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

nlohmann::json json_of(const TimedPose2d& input, const TransferredPose& result) {
  nlohmann::json joints = nlohmann::json::array(), errors = nlohmann::json::array(),
                 seen = nlohmann::json::array();
  for (std::size_t i = 0; i < kJoint2dCount; ++i) {
    const Vec2& p = result.pose.positions[i];
    joints.push_back({p.x, p.y});
    if (result.expected_error[i] >= 0)
      errors.push_back(result.expected_error[i]);
    else
      errors.push_back(nullptr);
    seen.push_back(input.pose.seen[i]);
  }
  return {{"index", input.frame},
          {"time_s", input.time_s},
          {"positions", std::move(joints)},
          {"seen", std::move(seen)},
          {"expected_error", std::move(errors)}};
}

Result<void> run(const Arguments& arguments, const PoseTrackerOptions& options) {
  if (const Result<void> checked =
          check_output_files({arguments.output, arguments.picture}, {arguments.pose, arguments.identity});
      !checked)
    return checked;
  const Result<TransferMethod> method = transfer_method_from_string(arguments.method);
  if (!method) return tl::unexpected(method.error());
  Result<std::unique_ptr<Transferer>> transferer = make_transferer(*method);
  if (!transferer) return tl::unexpected(transferer.error());
  ProgressBar bar;
  const auto poses = read_poses2d(arguments.pose, arguments.pose_turn_degrees, options, bar.progress());
  if (!poses) return tl::unexpected(poses.error());
  const auto shown =
      read_poses2d(arguments.identity, arguments.identity_turn_degrees, options, bar.progress());
  if (!shown) return tl::unexpected(shown.error());
  const std::vector<Pose2d> identity = pictures_of(*shown);
  if (Result<void> set = (*transferer)->set_people(pictures_of(*poses), identity); !set) return set;

  nlohmann::json names = nlohmann::json::array(), frames = nlohmann::json::array();
  for (std::size_t i = 0; i < kJoint2dCount; ++i) names.push_back(to_string(static_cast<Joint2d>(i)));
  const Vec2 place = bounding_box(identity.front()).centre();
  std::vector<SheetRow> sheet;
  std::map<std::string, std::size_t> doubts;
  const std::vector<std::size_t> drawn = different_frames(*poses, kSheetRows);
  for (std::size_t i = 0; i < poses->size(); ++i) {
    TransferredPose result = (*transferer)->transfer((*poses)[i].pose);
    result.pose = translated(result.pose, place - bounding_box(result.pose).centre());
    for (const std::string& doubt : result.doubts) ++doubts[doubt];
    frames.push_back(json_of((*poses)[i], result));
    if (std::binary_search(drawn.begin(), drawn.end(), i))
      sheet.push_back(
          {(*poses)[i].pose, identity[i * identity.size() / poses->size()], std::move(result), std::nullopt});
  }
  nlohmann::json said = nlohmann::json::array();
  for (const auto& [doubt, count] : doubts) {
    said.push_back({{"text", doubt}, {"frames", count}});
    if (arguments.output != "-")
      std::fprintf(stderr, "%s (%zu of %zu frames)\n", doubt.c_str(), count, poses->size());
  }
  const nlohmann::json answer = {
      {"schema", "posecoach.transfer/1"},
      {"method", arguments.method},
      {"pose", arguments.pose},
      {"identity", {{"source", arguments.identity}, {"pictures", identity.size()}}},
      {"joints", std::move(names)},
      {"doubts", std::move(said)},
      {"frames", std::move(frames)}};
  if (!arguments.picture.empty())
    if (Result<void> written = write_file_atomically(arguments.picture, contact_sheet_png(sheet)); !written)
      return written;
  return write_file_atomically(arguments.output, answer.dump(1) + "\n");
}

}  // namespace

void add_transfer_command(CLI::App& cli, Action& action) {
  CLI::App* command =
      cli.add_subcommand("transfer", "A 2D pose in another person's proportions, from pictures alone");
  auto arguments = std::make_shared<Arguments>();
  command
      ->add_option(
          "--pose", arguments->pose,
          "Who poses: a film, a folder of pictures, a .pose.json, a motion, bundled:swing, or FILE#N, a clip")
      ->required()
      ->type_name("P");
  command->add_option("--identity", arguments->identity, "Whose proportions: as --pose")
      ->required()
      ->type_name("I");
  command->add_option("-o,--output", arguments->output, "The JSON file to write, or - for standard output")
      ->required()
      ->type_name("FILE");
  command->add_option("--method", arguments->method, "network, paper, ratio, bones or scale")
      ->capture_default_str()
      ->check(CLI::IsMember({"network", "paper", "ratio", "bones", "scale"}))
      ->type_name("NAME");
  command->add_option("--picture", arguments->picture, "Draw some of the frames into this PNG")
      ->type_name("FILE");
  command
      ->add_option("--pose-turn", arguments->pose_turn_degrees,
                   "Look at a 3D motion from the side, in degrees")
      ->type_name("DEGREES");
  command->add_option("--identity-turn", arguments->identity_turn_degrees, "The same for the identity")
      ->type_name("DEGREES");
  const auto options = add_pose_options(*command);
  command->callback(
      [&action, arguments, options] { action = [arguments, options] { return run(*arguments, *options); }; });
}

}  // namespace posecoach
