#include "core/session/references.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <locale>

#include "core/base/file.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"
#include "core/motion/pose_file.h"
#include "core/session/motion_table.h"
#include "tests/core/session/swings.h"
#include "tests/core/session/test_disks.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::SizeIs;

Motion short_putt() {
  return resample(bundled_motion("putt").value(), 30.0);
}

class ReferencesTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  References references_{folder_.path() / "references"};
  std::unique_ptr<Library> library_ = Library::open(folder_.path() / "library").value();
};

TEST_F(ReferencesTest, the_bundled_coaches_are_always_there) {
  const std::vector<Reference> all = references_.list();
  ASSERT_THAT(all, SizeIs(bundled_motion_names().size()));
  for (const Reference& reference : all) {
    EXPECT_TRUE(reference.is_bundled());
    EXPECT_TRUE(load_reference(references_, reference.source)) << reference.source;
    EXPECT_EQ(references_.remove(reference.source).error().code, ErrorCode::InvalidArgument);
  }
  EXPECT_EQ(references_.find("reference:none").error().code, ErrorCode::NotFound);
  EXPECT_THAT(references_.find("nobody").error().message, HasSubstr("bundled:swing"));
}

TEST_F(ReferencesTest, a_swing_becomes_a_coach_with_one_call) {
  const Motion motion = short_putt();
  SwingFacts facts = make_facts(2);
  facts.stroke = "putt";
  SwingDraft draft = library_->begin(facts).value();
  ASSERT_TRUE(draft.add_student(motion, "film.mkv"));
  ASSERT_TRUE(draft.add_body(motion.skeleton()));
  const Swing swing = library_->keep(std::move(draft)).value();
  const Reference reference = references_.add_swing(swing).value();
  EXPECT_EQ(reference.name, "Søren, 2026-06-01 12:02");
  EXPECT_EQ(reference.source, "reference:soren_2026_06_01_12_02");
  EXPECT_EQ(reference.stroke, "putt");
  EXPECT_EQ(reference.hand, facts.hand);
  EXPECT_EQ(reference.origin, swing.id);
  // It is a copy: the swing may go.
  ASSERT_TRUE(library_->trash(swing.id));
  ASSERT_EQ(library_->empty_trash().value(), 1u);
  const Motion loaded = load_reference(references_, reference.source).value();
  ASSERT_EQ(loaded.frame_count(), motion.frame_count());
  for (int joint = 0; joint < motion.joint_count(); ++joint)
    EXPECT_LT(glm::distance(loaded.position(7, joint), motion.position(7, joint)), 1e-9);
  EXPECT_EQ(references_.find("søren, 2026-06-01 12:02")->source, reference.source);
  ASSERT_TRUE(references_.remove(reference.source));
  EXPECT_THAT(references_.list(), SizeIs(bundled_motion_names().size()));
}

TEST_F(ReferencesTest, a_picture_becomes_a_coach_and_the_same_one_when_it_comes_again) {
  PoseTrack picture{"/pictures/Pro at the top.jpg", 640, 480, {PoseObservation{}}};
  picture.frames[0].person.emplace();
  const Reference reference = references_.add_pictures(picture).value();
  EXPECT_EQ(reference.source, "reference:pro_at_the_top");
  EXPECT_EQ(reference.origin, "Pro at the top.jpg");
  EXPECT_TRUE(reference.is_pictures);
  const Result<PoseTrack> kept = read_pose_track(reference.motion);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->width, 640);
  EXPECT_TRUE(kept->frames[0].person);
  EXPECT_EQ(load_reference(references_, reference.source).error().code, ErrorCode::Unsupported);
  picture.source = "elsewhere/Pro at the top.jpg";
  EXPECT_EQ(references_.add_pictures(picture)->source, reference.source);
  picture.width = 320;
  EXPECT_EQ(references_.add_pictures(picture)->name, "Pro at the top 2") << "another picture of that name";
  EXPECT_THAT(references_.list(), SizeIs(bundled_motion_names().size() + 2));
}

TEST_F(ReferencesTest, a_motion_file_becomes_a_coach_with_one_call) {
  const fs::path file = folder_.path() / "My Pro.bvh";
  ASSERT_TRUE(write_motion_file(file, short_putt()));
  EXPECT_EQ(references_.add_motion_file(file)->source, "reference:my_pro");
  EXPECT_EQ(references_.add_motion_file(file).error().code, ErrorCode::InvalidArgument)
      << "the name is taken";
  EXPECT_EQ(references_.add_motion_file(file, "Another")->name, "Another");
  EXPECT_EQ(references_.add_motion_file(folder_.path() / "none.bvh").error().code, ErrorCode::NotFound);
  EXPECT_THAT(references_.list(), SizeIs(bundled_motion_names().size() + 2));
}

TEST_F(ReferencesTest, a_swing_without_motion_is_told_so) {
  const Swing swing = add_swing(*library_, 1).value();
  EXPECT_EQ(references_.add_swing(swing).error().code, ErrorCode::Incomplete);
}

TEST_F(ReferencesTest, a_broken_one_is_listed_with_the_reason) {
  fs::create_directories(folder_.path() / "references/broken");
  fs::create_directories(folder_.path() / "references/.hidden");
  const Reference broken = references_.list().back();
  EXPECT_EQ(broken.source, "reference:broken");
  EXPECT_THAT(broken.unreadable, HasSubstr("reference.json"));
  EXPECT_FALSE(references_.find("reference:broken"));
  EXPECT_TRUE(references_.remove("reference:broken"));
}

TEST_F(ReferencesTest, a_disk_that_fills_up_leaves_no_half_coach) {
  bool is_done = false;
  for (int n = 1; !is_done && n < 60; ++n) {
    FillingDisk disk(n);
    is_done =
        References(folder_.path() / "references", disk).add_motion(short_putt(), {.name = "Pro"}).has_value();
    for (const Reference& reference : references_.list()) EXPECT_EQ(reference.unreadable, "") << n;
    if (!is_done && references_.find("reference:pro")) {
      ASSERT_TRUE(references_.remove("reference:pro"));
    }
  }
  EXPECT_TRUE(is_done);
  EXPECT_TRUE(references_.find("Pro"));
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line)
    if (c == ',')
      cells.emplace_back();
    else if (c != '\r')
      cells.back() += c;
  return cells;
}

std::vector<std::vector<std::string>> table_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t at = 0; at < csv.size();) {
    const std::size_t end = csv.find('\n', at);
    rows.push_back(cells_of(csv.substr(at, end - at)));
    at = end + 1;
  }
  return rows;
}

TEST(MotionTable, holds_every_frame_with_units_in_the_header) {
  const Motion motion = short_putt();
  const auto rows = table_of(csv_from_motion(motion, 10));
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(motion.frame_count()) + 1);
  EXPECT_EQ(rows[0][0], "frame");
  EXPECT_EQ(rows[0][1], "time_s");
  const auto at = std::find(rows[0].begin(), rows[0].end(), "left_wrist_y_m");
  ASSERT_NE(at, rows[0].end());
  const auto column = static_cast<std::size_t>(at - rows[0].begin());
  const int wrist = motion.skeleton().find(HumanoidJoint::LeftWrist);
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const int frame = static_cast<int>(row) - 1;
    ASSERT_EQ(rows[row].size(), rows[0].size());
    EXPECT_EQ(rows[row][0], std::to_string(frame + 10));
    EXPECT_NEAR(std::stod(rows[row][1]), to_seconds(motion.time(frame)), 1e-6);
    EXPECT_NEAR(std::stod(rows[row][column]), motion.position(frame, wrist).y, 1e-5);
  }
}

struct CommaLocale : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(MotionTable, writes_a_point_whatever_the_locale) {
  const std::string before = csv_from_motion(short_putt(), 12345);
  const std::locale usual = std::locale::global(std::locale(std::locale(), new CommaLocale));
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "da_DK.UTF-8"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  const std::string after = csv_from_motion(short_putt(), 12345);
  std::locale::global(usual);
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(before, after);
}

TEST(MotionTable, what_was_not_seen_is_an_empty_cell) {
  Skeleton skeleton = Skeleton::make({{"a, \"b\"", kNoJoint, {}, {}}}).value();
  const Motion motion = Motion::from_positions(skeleton, {MediaTime(), MediaTime(Duration(500'000'000))},
                                               {{1, 2, 3}, {4, 5, 6}}, {1.0, 0.0})
                            .value();
  EXPECT_EQ(
      csv_from_motion(motion),
      "frame,time_s,a_ _b__x_m,a_ _b__y_m,a_ _b__z_m,a_ _b__confidence\r\n0,0,1,2,3,1\r\n1,0.5,,,,0\r\n");
  PoseTrack track{"film", 100, 100, {}};
  SeenPerson person;
  person.image[Landmark::Nose] = {{12.5, 7.25}, 0.75};
  track.frames.push_back({4, MediaTime(Duration(250'000'000)), person});
  track.frames.push_back({5, MediaTime(Duration(300'000'000)), {}});
  const auto rows = table_of(csv_from_track(track));
  EXPECT_EQ(rows[0][2], "nose_x_px");
  EXPECT_THAT(std::vector(rows[1].begin(), rows[1].begin() + 5),
              testing::ElementsAre("4", "0.25", "12.5", "7.25", "0.75"));
  EXPECT_THAT(std::vector(rows[2].begin(), rows[2].begin() + 4), testing::ElementsAre("5", "0.3", "", ""));
  EXPECT_EQ(rows[2].size(), rows[0].size());
}

}  // namespace
}  // namespace posecoach
