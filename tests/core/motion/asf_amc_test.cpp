#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/base/file.h"
#include "core/motion/asf_amc_reader.h"
#include "core/motion/motion_file.h"

namespace posecoach {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// Two bones on the root; the second's axes are turned, so that its rx is a turn about -z of the world.
constexpr std::string_view kAsf =
    ":version 1.10\n"
    ":name TEST\n"
    ":units\n"
    "  mass 1.0\n"
    "  length 0.45\n"
    "  angle deg\n"
    ":documentation\n"
    "  made by hand\n"
    ":root\n"
    "  order TX TY TZ RX RY RZ\n"
    "  axis XYZ\n"
    "  position 0 0 0\n"
    "  orientation 0 0 0\n"
    ":bonedata\n"
    "  begin\n"
    "    id 1\n"
    "    name upper\n"
    "    direction 0 2 0\n"
    "    length 10\n"
    "    axis 0 0 0 XYZ\n"
    "    dof rx rz\n"
    "    limits (-180 180)\n"
    "           (-180 180)\n"
    "  end\n"
    "  begin\n"
    "    id 2\n"
    "    name lower\n"
    "    direction 0 1 0\n"
    "    length 20\n"
    "    axis 0 90 0 XYZ\n"
    "    dof rx\n"
    "  end\n"
    ":hierarchy\n"
    "  begin\n"
    "    root upper\n"
    "    upper lower\n"
    "  end\n";

constexpr std::string_view kAmc =
    "#!OML:ASF nowhere\n"
    ":FULLY-SPECIFIED\n"
    ":DEGREES\n"
    "1\n"
    "root 1 2 3 0 0 0\n"
    "upper 0 0\n"
    "lower 90\n"
    "2\n"
    "root 1 2 3 0 0 90\n"
    "upper 90 90\n"
    "lower 0\n";

std::string with(std::string_view whole, std::string_view old_part, std::string_view new_part) {
  std::string text(whole);
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return text.replace(at, old_part.size(), new_part);
}

MotionFile sample() {
  return read_amc("a.amc", kAmc, parse_asf("a.asf", kAsf).value(), 120).value();
}

TEST(AsfReader, bones_have_length_direction_and_turned_axes) {
  const AsfDocument document = parse_asf("a.asf", kAsf).value();
  ASSERT_EQ(document.bones.size(), 3u);
  EXPECT_EQ(document.bones[1].name, "upper");
  EXPECT_LT(glm::distance(document.bones[1].end, {0, 10, 0}), 1e-12);
  EXPECT_LT(glm::distance(document.bones[2].axis * Vec3(1, 0, 0), {0, 0, -1}), 1e-12);
  EXPECT_NEAR(document.metres_per_unit, 0.0254 / 0.45, 1e-12);
}

TEST(AsfReader, the_skeleton_has_a_joint_at_each_bone_s_beginning_and_at_the_last_end) {
  const SkeletonFile file = read_asf_skeleton("a.asf", kAsf).value();
  ASSERT_EQ(file.skeleton.size(), 4);
  EXPECT_EQ(file.skeleton.joint(3).name, "lower_end");
  EXPECT_NEAR(file.skeleton.bone_length(1), 0, 1e-12);
  EXPECT_NEAR(file.skeleton.bone_length(2), 10 * 0.0254 / 0.45, 1e-9);
  EXPECT_NEAR(file.skeleton.bone_length(3), 20 * 0.0254 / 0.45, 1e-9);
}

TEST(AmcReader, angles_act_about_the_bone_s_axes_in_their_order) {
  const MotionFile file = sample();
  const double unit = file.provenance.frame.metres_per_unit;
  const auto& motion = file.motion;
  EXPECT_LT(glm::distance(motion.position(0, 0), Vec3(1, 2, 3) * unit), 1e-12);
  EXPECT_LT(glm::distance(motion.position(0, 2), Vec3(1, 12, 3) * unit), 1e-12);
  // 90 degrees about -z of the world tip the second bone from +y to +x.
  EXPECT_LT(glm::distance(motion.position(0, 3), Vec3(21, 12, 3) * unit), 1e-12);
  // The bone: rx takes +y to +z, rz leaves it there; the root's rz too.
  EXPECT_LT(glm::distance(motion.position(1, 2), Vec3(1, 2, 13) * unit), 1e-12);
  EXPECT_NEAR(motion.frame_rate(), 120, 1e-3);
}

TEST(AmcReader, radians_and_missing_frame_numbers_count) {
  std::string text = with(with(kAmc, ":DEGREES", ":RADIANS"), "lower 90", "lower 1.5707963267948966");
  text = with(text, "\n2\nroot", "\n5\nroot");
  const MotionFile file = read_amc("a.amc", text, parse_asf("a.asf", kAsf).value(), 100).value();
  EXPECT_NEAR(file.motion.position(0, 3).x, 21 * file.provenance.frame.metres_per_unit, 1e-9);
  EXPECT_NEAR(to_seconds(file.motion.time(1)), 0.04, 1e-9);
}

void expect_bad_asf(const std::string& text, const std::string& start, const std::string& what,
                    ErrorCode code = ErrorCode::Malformed) {
  const auto read = parse_asf("a.asf", text);
  ASSERT_FALSE(read) << what;
  EXPECT_EQ(read.error().code, code);
  EXPECT_THAT(read.error().message, StartsWith("a.asf:" + start));
  EXPECT_THAT(read.error().message, HasSubstr(what));
}

TEST(AsfReader, every_mistake_is_one_line_that_names_file_and_line) {
  expect_bad_asf("hello\n", "1: ", "this is not an ASF file");
  expect_bad_asf(":units\n", "1: ", "no :hierarchy");
  expect_bad_asf(with(kAsf, "length 0.45", "length 0"), "5: ", "must be greater than 0");
  expect_bad_asf(with(kAsf, "TX TY", "TX TQ"), "10: ", "\"TQ\" is no degree of freedom");
  expect_bad_asf(with(kAsf, "axis XYZ", "axis XXZ"), "11: ", "\"XXZ\" is no order of the axes");
  expect_bad_asf(with(kAsf, "direction 0 2 0", "direction 0 up 0"),
                 "18: ", "direction needs a number, found \"up\"");
  expect_bad_asf(with(kAsf, "direction 0 2 0", "direction 0 2"), "18: ", "direction needs a number");
  expect_bad_asf(with(kAsf, "direction 0 2 0", "direction 0 0 0"), "15: ", "\"upper\" has no direction");
  expect_bad_asf(with(kAsf, "length 10", "length ten"), "19: ", "length needs a number");
  expect_bad_asf(with(kAsf, "dof rx rz", "dof rx l"), "21: ", "\"l\" is not supported",
                 ErrorCode::Unsupported);
  expect_bad_asf(with(kAsf, "dof rx rz", "dof rx ry rz rx"), "21: ", "at most 3 axes");
  expect_bad_asf(with(kAsf, "name lower", "name upper"), "27: ", "a second bone is called \"upper\"");
  expect_bad_asf(with(kAsf, "root upper", "root uper"), "35: ", "there is no bone \"uper\"");
  expect_bad_asf(with(kAsf, "upper lower", "upper upper"), "36: ", "has two parents");
  expect_bad_asf(with(kAsf, "    upper lower\n  end\n", ""), "35: ", "ends within");
}

void expect_bad_amc(const std::string& text, const std::string& start, const std::string& what,
                    ErrorCode code = ErrorCode::Malformed) {
  const auto read = read_amc("a.amc", text, parse_asf("a.asf", kAsf).value(), 120);
  ASSERT_FALSE(read) << what;
  EXPECT_EQ(read.error().code, code);
  EXPECT_THAT(read.error().message, StartsWith("a.amc:" + start));
  EXPECT_THAT(read.error().message, HasSubstr(what));
}

TEST(AmcReader, every_mistake_is_one_line_that_names_file_and_line) {
  expect_bad_amc("", "1: ", "not an AMC file");
  expect_bad_amc(":DEGREES\n", "1: ", "not an AMC file");
  expect_bad_amc("root 1 2 3\n", "1: ", "expected the number of the first frame");
  expect_bad_amc(with(kAmc, "upper 0 0", "uper 0 0"), "6: ", "no bone \"uper\"");
  expect_bad_amc(with(kAmc, "upper 0 0", "upper 0 x"), "6: ", "\"upper\" needs a number, found \"x\"");
  expect_bad_amc(with(kAmc, "upper 0 0", "upper 0"), "7: ", "\"upper\" needs a number, found \"lower\"");
  expect_bad_amc(with(kAmc, "upper 0 0", "upper 0 0 0"), "6: ", "more numbers than degrees of freedom");
  expect_bad_amc(with(kAmc, "upper 0 0\n", ""), "7: ", "says nothing about \"upper\"");
  expect_bad_amc(with(kAmc, "lower 90", "upper 0 0"), "7: ", "stands twice");
  expect_bad_amc(with(kAmc, "\n2\n", "\n1\n"), "8: ", "frame 1 comes after frame 1");
  expect_bad_amc(with(kAmc, "lower 0\n", ""), "10: ", "says nothing about \"lower\"");
}

TEST(AmcReader, finds_the_skeleton_beside_the_motion) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "posecoach_amc_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  ASSERT_TRUE(write_file_atomically(folder / "07_03.amc", kAmc));
  EXPECT_EQ(read_motion_file(folder / "07_03.amc").error().code, ErrorCode::NotFound);
  ASSERT_TRUE(write_file_atomically(folder / "other.asf", kAsf));
  EXPECT_TRUE(read_motion_file(folder / "07_03.amc"));  // the only one
  ASSERT_TRUE(write_file_atomically(folder / "more.asf", "nonsense"));
  EXPECT_EQ(read_motion_file(folder / "07_03.amc").error().code, ErrorCode::NotFound);
  ASSERT_TRUE(write_file_atomically(folder / "07.asf", kAsf));
  EXPECT_NEAR(read_motion_file(folder / "07_03.amc", {.amc_frames_per_second = 60})->motion.frame_rate(), 60,
              1e-3);
  EXPECT_EQ(read_skeleton_file(folder / "07.asf")->skeleton.size(), 4);
  EXPECT_EQ(read_motion_file(folder / "07.asf").error().code, ErrorCode::Incomplete);
}

}  // namespace
}  // namespace posecoach
