#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bvh_samples.h"
#include "core/motion/bvh_document.h"

namespace posecoach {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string with(std::string text, std::string_view old_part, std::string_view new_part) {
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return text.replace(at, old_part.size(), new_part);
}
std::string sample_with(std::string_view old_part, std::string_view new_part) {
  return with(std::string(samples::kThreeJoints), old_part, new_part);
}

void expect_malformed(const std::string& text, const std::string& where, const std::string& what) {
  const auto document = parse_bvh("swing.bvh", text);
  ASSERT_FALSE(document) << what;
  EXPECT_EQ(document.error().code, ErrorCode::Malformed);
  EXPECT_THAT(document.error().message, StartsWith("swing.bvh:" + where + ": "));
  EXPECT_THAT(document.error().message, HasSubstr(what));
  EXPECT_EQ(document.error().message.find('\n'), std::string::npos);
}

TEST(BvhParser, reads_joints_channels_and_numbers) {
  const BvhDocument document = parse_bvh("a.bvh", samples::kThreeJoints).value();
  ASSERT_EQ(document.joints.size(), 3u);
  EXPECT_EQ(document.joints[1].name, "middle");
  EXPECT_EQ(document.joints[1].parent, 0);
  EXPECT_EQ(document.joints[1].offset, Vec3(0, 100, 0));
  EXPECT_TRUE(document.joints[2].is_end_site);
  EXPECT_EQ(document.channel_count(), 9u);
  EXPECT_EQ(document.joints[0].channels[3], (BvhChannel{BvhChannel::Kind::Rotation, Axis::Z}));
  EXPECT_EQ(document.frame_count, 2u);
  EXPECT_EQ(document.frame_time_s, 0.04);
  EXPECT_EQ(document.values.at(9 + 3), 90);
}

TEST(BvhParser, carriage_returns_tabs_capitals_and_a_byte_order_mark_do_not_matter) {
  std::string text;
  for (const char c : samples::kThreeJoints) {
    if (c == '\n')
      text += " \r\n";
    else if (c == ' ')
      text += "\t \t";
    else
      text += c;
  }
  text = "\xEF\xBB\xBF" + with(with(text, "HIERARCHY", "Hierarchy"), "CHANNELS", "channels");
  const BvhDocument document = parse_bvh("a.bvh", text).value();
  EXPECT_EQ(document.values, parse_bvh("a.bvh", samples::kThreeJoints)->values);
}

TEST(BvhParser, reads_numbers_with_exponents_and_plus_signs) {
  const auto document = parse_bvh("a.bvh", sample_with("1 2 3 0 0 0 0 0 0", "+1.5e0 -2E-3 .5 0 0 0 0 0 0"));
  ASSERT_TRUE(document) << document.error().message;
  EXPECT_EQ(document->values[0], 1.5);
  EXPECT_EQ(document->values[1], -0.002);
  EXPECT_EQ(document->values[2], 0.5);
}

TEST(BvhParser, names_may_have_blanks_and_a_brace_on_the_same_line) {
  const auto document = parse_bvh("a.bvh", sample_with("JOINT middle\n", "JOINT Bip01 L Thigh "));
  ASSERT_TRUE(document) << document.error().message;
  EXPECT_EQ(document->joints[1].name, "Bip01 L Thigh");
}

TEST(BvhParser, a_file_may_end_after_its_hierarchy) {
  const std::string text(samples::kThreeJoints.substr(0, samples::kThreeJoints.find("MOTION")));
  EXPECT_EQ(parse_bvh("a.bvh", text)->frame_count, 0u);
  EXPECT_EQ(parse_bvh("a.bvh", text + "MOTION\nFrames: 0\nFrame Time: 0\n")->frame_count, 0u);
}

TEST(BvhParser, every_mistake_is_one_line_that_names_file_and_line) {
  expect_malformed("", "1", "does not begin with HIERARCHY");
  expect_malformed("# nothing\n", "1", "does not begin with HIERARCHY");
  expect_malformed(sample_with("ROOT base", "JOINT base"), "2", "expected ROOT");
  expect_malformed(sample_with("ROOT base\n{", "ROOT base\n"), "4", "expected {");
  expect_malformed(sample_with("OFFSET 0 100 0", "OFFSET 0 100"), "9",
                   "OFFSET needs a number, found \"CHANNELS\"");
  expect_malformed(sample_with("OFFSET 0 100 0", "OFFSET 0 1e100 0"), "8", "OFFSET needs a number");
  expect_malformed(sample_with("    OFFSET 0 100 0\n", ""), "13", "\"middle\" has no OFFSET");
  expect_malformed(sample_with("OFFSET 0 100 0", "OFFSET 0 1 0 OFFSET 0 1 0"), "8", "second OFFSET");
  expect_malformed(sample_with("CHANNELS 3", "CHANNELS 7"), "9", "count from 0 to 6");
  expect_malformed(sample_with("CHANNELS 3 X", "CHANNELS 4 X"), "10", "\"End\" is not a channel");
  expect_malformed(sample_with("CHANNELS 3 Xrotation", "CHANNELS 3 Xscale"), "9",
                   "\"Xscale\" is not a channel");
  expect_malformed(sample_with("Xposition Yposition", "Xposition Xposition"), "5", "twice");
  expect_malformed(sample_with("OFFSET 0 70 0", "OFFSET 0 70 0 CHANNELS 0"), "12",
                   "End Site has no CHANNELS");
  expect_malformed(sample_with("}\n}\nMOTION", "}\nMOTION"), "15", "found \"MOTION\"");
  expect_malformed(sample_with("Frames: 2", "Frames: two"), "17", "Frames: needs a count, found \"two\"");
  expect_malformed(sample_with("Frames: 2", "Frames: -2"), "17", "Frames: needs a count");
  expect_malformed(sample_with("Frame Time: 0.04", "Frame Time: 0"), "18", "frame time of 0.000000 seconds");
  expect_malformed(sample_with("Frame Time: 0.04", "Frame Time: 30"), "18",
                   "frame time of 30.000000 seconds");
  expect_malformed(sample_with("Frame Time: 0.04", "Frame Time: nan"), "18", "needs a number, found \"nan\"");
  expect_malformed(sample_with("1 2 3 90", "1 2 x 90"), "20",
                   "\"x\" is not a usable number (frame 2 of 2, number 3 of 9)");
  expect_malformed(sample_with("1 2 3 90", "1 2 inf 90"), "20", "\"inf\" is not a usable number");
  expect_malformed(sample_with("1 2 3 90", "1 2 1e300 90"), "20", "\"1e300\" is not a usable number");
  expect_malformed(sample_with("1 2 3 90 0 0 90 0 0\n", "1 2 3 90"), "20",
                   "ends too early, in frame 2 of 2, number 5 of 9");
  expect_malformed(sample_with("1 2 3 0 0 0 0 0 0\n", "1 2 3 0 0 0 0 0\n"), "20",
                   "more or fewer than 9 numbers");
  expect_malformed(sample_with("Frames: 2", "Frames: 1"), "20", "goes on with \"1\" after its 1 frames");
  expect_malformed(sample_with("Frames: 2", "Frames: 90000000"), "20", "ends too early");
}

TEST(BvhParser, refuses_a_second_skeleton) {
  const auto document = parse_bvh("two.bvh", sample_with("MOTION", "ROOT other\n{\nOFFSET 0 0 0\n}\nMOTION"));
  ASSERT_FALSE(document);
  EXPECT_EQ(document.error().code, ErrorCode::Unsupported);
}

TEST(BvhParser, refuses_hierarchies_without_end) {
  std::string text = "HIERARCHY ROOT a {";
  for (int i = 0; i < 5000; ++i) text += "OFFSET 0 1 0 JOINT a {";
  const auto document = parse_bvh("deep.bvh", text);
  ASSERT_FALSE(document);
  EXPECT_EQ(document.error().code, ErrorCode::Unsupported);
}

TEST(BvhParser, foreign_bytes_are_shown_as_question_marks) {
  expect_malformed(sample_with("OFFSET 0 100 0", "\x01\xFF\n"), "8", "found \"??\"");
}

TEST(BvhFormatter, what_is_written_reads_back_the_same) {
  const BvhDocument document = parse_bvh("a.bvh", samples::kThreeJoints).value();
  const auto again = parse_bvh("b.bvh", format_bvh(document));
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->values, document.values);
  ASSERT_EQ(again->joints.size(), document.joints.size());
  for (std::size_t j = 0; j < again->joints.size(); ++j) {
    EXPECT_EQ(again->joints[j].name, document.joints[j].name);
    EXPECT_EQ(again->joints[j].parent, document.joints[j].parent);
    EXPECT_EQ(again->joints[j].offset, document.joints[j].offset);
    EXPECT_EQ(again->joints[j].channels, document.joints[j].channels);
  }
}

}  // namespace
}  // namespace posecoach
