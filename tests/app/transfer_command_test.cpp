// `posecoach transfer` as its user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "tests/app/run_program.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class TransferCommand : public testing::Test {
 protected:
  std::string in_folder(const std::string& name) const { return (folder_.path() / name).string(); }
  TemporaryFolder folder_;
};

double height(const json& positions) {
  double low = 1e9, high = -1e9;
  for (const json& p : positions) {
    low = std::min(low, p[1].get<double>());
    high = std::max(high, p[1].get<double>());
  }
  return high - low;
}

TEST_F(TransferCommand, draws_every_frame_of_a_motion_on_another_person_by_every_method) {
  for (const std::string method : {"network", "paper", "ratio", "bones", "scale"}) {
    const std::string out = in_folder(method + ".json"), picture = in_folder(method + ".png");
    const ProgramRun run =
        run_posecoach({"transfer", "--pose", "bundled:swing", "--pose-turn", "20", "--identity",
                       "bundled:putt", "-o", out, "--method", method, "--picture", picture});
    ASSERT_EQ(run.exit_code, 0) << method << ": " << run.error;
    const json answer = json::parse(read_file(out).value());
    EXPECT_EQ(answer["schema"], "posecoach.transfer/1");
    EXPECT_EQ(answer["method"], method);
    EXPECT_EQ(answer["joints"].size(), 15U);
    ASSERT_GT(answer["frames"].size(), 100U);
    for (const json& frame : answer["frames"]) {
      ASSERT_EQ(frame["positions"].size(), 15U);
      EXPECT_EQ(frame["seen"].size(), 15U);
      // The person who putts is 1.8 m tall; nose to ankles is what is drawn of him.
      EXPECT_NEAR(height(frame["positions"]), 1.45, 0.4) << method;
    }
    EXPECT_EQ(read_file(picture).value().substr(1, 3), "PNG");
  }
}

TEST_F(TransferCommand, reads_the_clips_of_annotated_people) {
  const std::string clips = in_folder("clips.json");
  json frame = json::array();
  const json names = {"neck",      "belly",       "face",        "right_shoulder", "left_shoulder",
                      "right_hip", "left_hip",    "right_elbow", "left_elbow",     "right_knee",
                      "left_knee", "right_wrist", "left_wrist",  "right_ankle",    "left_ankle"};
  const double places[15][2] = {{50, 20}, {50, 45}, {50, 8},  {38, 20}, {62, 20},
                                {43, 52}, {57, 52}, {34, 36}, {66, 36}, {42, 75},
                                {58, 75}, {33, 52}, {67, 52}, {42, 98}, {58, 98}};
  for (const auto& place : places) frame.push_back({place[0], place[1]});
  const json file = {{"joints", names}, {"clips", {{{"label", "standing"}, {"frames", {frame, frame}}}}}};
  ASSERT_TRUE(write_file_atomically(clips, file.dump()));
  const ProgramRun run =
      run_posecoach({"transfer", "--pose", "bundled:swing", "--identity", clips + "#0", "-o", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  const json answer = json::parse(run.output);
  EXPECT_EQ(answer["identity"]["pictures"], 2);
  EXPECT_NEAR(height(answer["frames"][0]["positions"]), 90, 25);
}

TEST_F(TransferCommand, reads_folders_of_openpose) {
  // Somebody standing upright, BODY_25's first fifteen joints: nose, neck, right arm, left arm, mid-hip,
  // right leg, left leg.
  const double places[15][2] = {{50, 8},  {50, 20}, {38, 20}, {34, 36}, {33, 52},
                                {62, 20}, {66, 36}, {67, 52}, {50, 52}, {43, 52},
                                {42, 75}, {42, 98}, {57, 52}, {58, 75}, {58, 98}};
  json keypoints = json::array();
  for (const auto& [x, y] : places)
    for (const double value : {x, y, 0.9}) keypoints.push_back(value);
  while (keypoints.size() < 75) keypoints.push_back(0);
  const std::filesystem::path folder = folder_.path() / "openpose";
  std::filesystem::create_directory(folder);
  for (const char* name : {"a_000_keypoints.json", "a_001_keypoints.json"})
    ASSERT_TRUE(write_file_atomically(
        folder / name, json{{"version", 1.3}, {"people", {{{"pose_keypoints_2d", keypoints}}}}}.dump()));
  const ProgramRun run =
      run_posecoach({"transfer", "--pose", folder.string(), "--identity", "bundled:putt", "-o", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.error;
  EXPECT_EQ(json::parse(run.output)["frames"].size(), 2U);
}

TEST_F(TransferCommand, explains_in_one_line_what_is_wrong) {
  const struct {
    std::vector<std::string> arguments;
    int exit_code;
    std::string part;
  } cases[] = {
      {{"transfer", "--pose", "bundled:swing", "--identity", "bundled:nobody", "-o", "-"}, 1, "nobody"},
      {{"transfer", "--pose", "bundled:swing", "--identity", "bundled:putt", "-o", "-", "--method", "magic"},
       2,
       "--method"},
      {{"transfer", "--pose", "bundled:swing", "-o", "-"}, 2, "--identity"},
      {{"transfer", "--pose", in_folder("none.json") + "#0", "--identity", "bundled:putt", "-o", "-"},
       1,
       "none.json"},
      {{"train", "transfer", "--data", in_folder("nowhere"), "-o", in_folder("w.pt")}, 1, "nowhere"},
      {{"evaluate", "transfer", "--data", in_folder("nowhere")}, 1, "nowhere"},
      {{"analyze", "--coach", "bundled:swing", "--student", "bundled:swing", "--retarget", "transfer2d"},
       1,
       "transfer2d"},
  };
  for (const auto& [arguments, exit_code, part] : cases) {
    const ProgramRun run = run_posecoach(arguments);
    EXPECT_EQ(run.exit_code, exit_code) << testing::PrintToString(arguments) << run.error;
    EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << run.error;
    EXPECT_THAT(run.error, HasSubstr(part));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace posecoach
