// The program as its user meets it: exit codes, one line of explanation, no half-written files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "core/base/file.h"
#include "tests/app/run_program.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CommandLine : public testing::Test {
 protected:
  std::string in_folder(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string make_file(const std::string& name, const std::string& bytes) const {
    EXPECT_TRUE(write_file_atomically(folder_.path() / name, bytes));
    return in_folder(name);
  }
  void expect_one_line(const std::vector<std::string>& arguments, int exit_code,
                       const std::string& part) const {
    const ProgramRun run = run_posecoach(arguments);
    const std::string command = testing::PrintToString(arguments);
    EXPECT_EQ(run.exit_code, exit_code) << command << run.error;
    EXPECT_EQ(run.output, "") << command;
    EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << command << run.error;
    EXPECT_THAT(run.error, testing::StartsWith("posecoach: ")) << command;
    EXPECT_THAT(run.error, HasSubstr(part)) << command;
  }
  TemporaryFolder folder_;
};

TEST_F(CommandLine, wrong_usage_is_one_line_and_two) {
  expect_one_line({"nonsense"}, 2, "nonsense");
  expect_one_line({"analyze"}, 2, "posecoach analyze --help");
  expect_one_line({"analyze", "--coach", "a", "--student", "b", "--hand", "up"}, 2, "--hand");
  expect_one_line({"evaluate"}, 2, "evaluate --help");
  expect_one_line({"simulate", "-o", "a.mp4", "--fault", "nope"}, 2, "early_extension");
  expect_one_line({"simulate"}, 2, "--output");
  expect_one_line({"body", "x", "-o", "y", "--height", "9"}, 2, "--height");
}

TEST_F(CommandLine, every_command_explains_itself) {
  for (const char* command : {"analyze", "pose", "body", "retarget", "simulate", "evaluate", "bench"}) {
    const ProgramRun run = run_posecoach({command, "--help"});
    EXPECT_EQ(run.exit_code, 0) << command;
    EXPECT_THAT(run.output, HasSubstr(std::string("posecoach ") + command));
  }
}

TEST_F(CommandLine, a_motion_that_cannot_be_read_is_named_with_its_place) {
  const std::string junk(700, '\x01');
  fs::create_directory(folder_.path() / "folder");
  const struct {
    std::string motion;
    std::string part;
  } rows[] = {
      {in_folder("missing.bvh"), "missing.bvh"},
      {in_folder("folder"), "no pictures"},
      {make_file("empty.bvh", ""), "empty.bvh:1: the file is empty"},
      {make_file("empty.mp4", ""), "empty.mp4:1: the file is empty"},
      {make_file("junk.bvh", junk), "junk.bvh:1:"},
      {make_file("junk.c3d", junk), "junk.c3d: byte 0:"},
      {make_file("junk.trc", junk), "junk.trc:1:"},
      {make_file("junk.pose.json", junk), "junk.pose.json:1:"},
      {make_file("junk.mp4", junk), "junk.mp4"},
      {make_file("short.bvh", "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0"), "short.bvh:4:"},
      {make_file("line\nbreak.bvh", "HIERARCHY\nROOT"), "line?break.bvh"},
      {"bundled:nothing", "bundled:swing"},
      {"simulated:nothing", "swing or putt"},
  };
  for (const auto& row : rows) {
    expect_one_line({"analyze", "--coach", row.motion, "--student", "bundled:swing"}, 1, row.part);
    expect_one_line({"analyze", "--coach", "bundled:swing", "--student", row.motion}, 1, row.part);
    expect_one_line({"body", row.motion, "-o", in_folder("out.body.json")}, 1, row.part);
  }
  EXPECT_FALSE(fs::exists(in_folder("out.body.json")));
}

TEST_F(CommandLine, a_renamed_motion_is_read_all_the_same) {
  const std::string bvh = in_folder("swing.bvh");
  ASSERT_EQ(run_posecoach({"retarget", "--motion", "bundled:swing", "--body", "bundled:swing", "-o", bvh})
                .exit_code,
            0);
  for (const char* name : {"swing.mp4", "swing.c3d", "swing", "sw\xC3\xB6 ng.pose.json"}) {
    fs::copy_file(bvh, in_folder(name));
    const ProgramRun run = run_posecoach({"body", in_folder(name), "-o", "-"});
    EXPECT_EQ(run.exit_code, 0) << name << run.error;
    EXPECT_THAT(run.output, HasSubstr("posecoach.body/1")) << name;
  }
}

TEST_F(CommandLine, strokes_of_two_kinds_are_not_compared) {
  expect_one_line({"analyze", "--coach", "bundled:putt", "--student", "bundled:swing"}, 1, "the same kind");
}

TEST_F(CommandLine, outputs_that_cannot_be_written_are_told_before_the_work) {
  const std::vector<std::string> analyze = {"analyze", "--coach", in_folder("missing"), "--student", "x"};
  const auto with = [](std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  fs::create_directory(folder_.path() / "folder");
  expect_one_line(with(analyze, {"--json", in_folder("none/a.json")}), 1, "there is no folder");
  expect_one_line(with(analyze, {"--report", in_folder("folder")}), 1, "is a folder");
  expect_one_line(with(analyze, {"--video", "-"}), 1, "a film needs a file");
  expect_one_line(with(analyze, {"--json", "-", "--report", "-"}), 1, "two outputs");
  expect_one_line({"simulate", "-o", in_folder("none/a.mp4")}, 1, "there is no folder");
  expect_one_line({"body", "bundled:swing", "-o", in_folder("folder")}, 1, "is a folder");
  expect_one_line(
      {"retarget", "--motion", "bundled:swing", "--body", "bundled:swing", "-o", in_folder("a.x")}, 1,
      ".bvh, .trc or .pose.json");
  const std::string film = make_file("film.mp4", "precious");
  expect_one_line({"pose", film, "-o", film}, 1, "also what is read");
  EXPECT_EQ(read_file(film).value(), "precious");
}

TEST_F(CommandLine, missing_models_are_one_line_that_says_how_to_get_them) {
  expect_one_line({"analyze", "--coach", "bundled:swing", "--student", "simulated:swing?fps=5", "--models",
                   in_folder("none")},
                  1, "scripts/setup");
}

TEST_F(CommandLine, interrupted_work_leaves_no_file) {
  const ProgramRun run = run_posecoach({"simulate", "--fps", "1000", "-o", in_folder("film.mp4")},
                                       Interrupt::AfterFirstFile, folder_.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << run.error;
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

}  // namespace
}  // namespace posecoach
