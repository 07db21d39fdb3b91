// The main job from end to end with the real networks: a simulated body of known bones swings, is filmed,
// seen, measured and judged. Skipped where the networks are not installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/vision/model_file.h"
#include "tests/app/run_program.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

using nlohmann::json;

json read_json(const std::filesystem::path& path) {
  return json::parse(read_file(path).value());
}

double length(const json& offset) {
  return std::hypot(offset[0].get<double>(), offset[1].get<double>(), offset[2].get<double>());
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// One film of a tall player who sways, and what the program makes of it; made once for all tests.
class EndToEnd : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!find_model_file(kDetectorFileName, std::nullopt)) return;
    folder_ = std::make_unique<TemporaryFolder>();
    film_ = file("film.mp4");
    run({"simulate", "--body", "tall", "--fault", "sway=16", "--fps", "30", "-o", film_, "--truth",
         file("truth.json")});
    run({"pose", film_, "-o", file("seen.pose.json"), "--no-smoothing"});
    run({"body", file("seen.pose.json"), "-o", file("seen.body.json")});
    run({"analyze", "--coach", "bundled:swing", "--student", film_, "--json", file("analysis.json"),
         "--report", file("report.html"), "--video", file("coached.mp4")});
  }
  static void TearDownTestSuite() { folder_.reset(); }
  void SetUp() override {
    if (!folder_) GTEST_SKIP() << "the pose models are not installed; run scripts/setup";
  }
  static std::string file(const std::string& name) { return (folder_->path() / name).string(); }
  static void run(const std::vector<std::string>& arguments) {
    const ProgramRun done = run_posecoach(arguments);
    EXPECT_EQ(done.exit_code, 0) << arguments.front() << ": " << done.error;
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline std::string film_;
};

// Shoulders, elbows, wrists, hips, knees and ankles; the face and the fingers of a body of capsules lie
// further off.
TEST_F(EndToEnd, the_joints_of_arms_and_legs_are_seen_within_five_pixels_of_where_they_are) {
  const json truth = read_json(file("truth.json")), seen = read_json(file("seen.pose.json"));
  ASSERT_EQ(seen["joints"].size(), 33U);
  ASSERT_EQ(seen["joints"], truth["landmarks"]);
  ASSERT_EQ(seen["frames"].size(), truth["frames"].size());
  std::vector<double> distances_px;
  for (std::size_t k = 0; k < truth["frames"].size(); ++k) {
    const json& frame = seen["frames"][k];
    ASSERT_TRUE(frame["found"].get<bool>()) << k;
    EXPECT_NEAR(frame["time_s"].get<double>(), truth["frames"][k]["time_s"].get<double>(), 1e-4);
    for (const std::size_t i : {11U, 12U, 13U, 14U, 15U, 16U, 23U, 24U, 25U, 26U, 27U, 28U}) {
      const json &at = frame["image"][i], &is = truth["frames"][k]["landmarks_px"][i];
      if (is.is_null()) continue;
      distances_px.push_back(
          std::hypot(at[0].get<double>() - is[0].get<double>(), at[1].get<double>() - is[1].get<double>()));
    }
  }
  EXPECT_LE(median(distances_px), 5);
}

// Of every joint, the bone that leads to it.
std::map<std::string, double> limb_lengths(const json& body) {
  std::map<std::string, double> lengths;
  for (const json& joint : body["joints"]) lengths[joint["name"]] = length(joint["offset_m"]);
  return lengths;
}

TEST_F(EndToEnd, bone_ratios_are_measured_within_fifteen_percent) {
  const auto is = limb_lengths(read_json(file("truth.json"))["body"]);
  const auto seen = limb_lengths(read_json(file("seen.body.json")));
  // Each limb against the thigh, so that the height that nobody gave does not matter.
  for (const char* side : {"left_", "right_"}) {
    const std::string knee = std::string(side) + "knee";
    for (const char* joint : {"ankle", "elbow", "wrist"}) {
      const std::string name = std::string(side) + joint;
      ASSERT_TRUE(is.contains(name) && seen.contains(name)) << name;
      EXPECT_NEAR((seen.at(name) / seen.at(knee)) / (is.at(name) / is.at(knee)), 1, 0.15) << name;
    }
  }
}

TEST_F(EndToEnd, the_analysis_keeps_the_contract) {
  const json analysis = read_json(file("analysis.json"));
  EXPECT_EQ(analysis["schema"], "posecoach.analysis/1");
  for (const char* side : {"coach", "student"}) {
    EXPECT_TRUE(analysis[side]["source"].is_string());
    EXPECT_TRUE(analysis[side]["frames"].is_number_integer());
    EXPECT_TRUE(analysis[side]["joints"].is_number_integer());
    EXPECT_GT(analysis[side]["seconds"].get<double>(), 1);
  }
  EXPECT_EQ(analysis["student"]["hand"], "right");
  EXPECT_EQ(analysis["student"]["joints"], 33);
  EXPECT_TRUE(analysis["retarget"]["method"].is_string());
  EXPECT_LE(analysis["retarget"]["bone_length_error_max"].get<double>(), 1e-3);
  for (const char* number : {"raw", "mean_joint_error_m", "percent"})
    EXPECT_TRUE(analysis["score"][number].is_number()) << number;
  ASSERT_FALSE(analysis["path"].empty());
  for (const json& pair : analysis["path"]) {
    EXPECT_LT(pair[0].get<int>(), analysis["student"]["frames"].get<int>());
    EXPECT_LT(pair[1].get<int>(), analysis["coach"]["frames"].get<int>());
  }
  for (const char* side : {"coach", "student"})
    for (const json& event : analysis["events"][side])
      EXPECT_TRUE(event["name"].is_string() && event["frame"].is_number_integer() &&
                  event["time_s"].is_number());
  for (const json& phase : analysis["timing"])
    EXPECT_TRUE(phase["from"].is_string() && phase["to"].is_string() && phase["coach_s"].is_number() &&
                phase["student_s"].is_number() && phase["ratio"].is_number() && phase["advice"].is_string());
  for (const json& fault : analysis["spatial"])
    EXPECT_TRUE(fault["joint"].is_string() && fault["event"].is_string() &&
                fault["student_frame"].is_number_integer() && fault["coach_frame"].is_number_integer() &&
                fault["offset_m"].size() == 3 && fault["distance_m"].is_number() &&
                fault["advice"].is_string());
  for (const json& metric : analysis["metrics"]) {
    EXPECT_TRUE(metric["name"].is_string() && metric["unit"].is_string() &&
                metric["available"].is_boolean() && metric["reason"].is_string());
    EXPECT_NE(metric["available"].get<bool>(), !metric["reason"].get<std::string>().empty()) << metric;
  }
}

TEST_F(EndToEnd, the_sway_is_the_first_advice) {
  const json advice = read_json(file("analysis.json"))["advice"];
  ASSERT_GE(advice.size(), 1U);
  ASSERT_LE(advice.size(), 3U);
  EXPECT_EQ(advice[0]["kind"], "spatial");
  EXPECT_THAT(advice[0]["text"].get<std::string>(), testing::HasSubstr("hips"));
  EXPECT_THAT(advice[0]["text"].get<std::string>(), testing::HasSubstr("from the target"));
}

TEST_F(EndToEnd, the_page_and_the_film_are_there_and_the_page_needs_nothing_else) {
  const std::string page = read_file(file("report.html")).value();
  EXPECT_THAT(page, testing::HasSubstr("data:image/"));
  for (const char* outside : {"src=\"http", "href=\"http", "src=\"//", "@import", "url(http"})
    EXPECT_THAT(page, testing::Not(testing::HasSubstr(outside)));
  EXPECT_GT(std::filesystem::file_size(file("coached.mp4")), 10000U);
  for (const auto& entry : std::filesystem::directory_iterator(folder_->path()))
    EXPECT_THAT(entry.path().string(), testing::Not(testing::HasSubstr(".tmp")));
}

}  // namespace
}  // namespace posecoach
