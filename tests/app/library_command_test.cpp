// The library as its user meets it on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/body/body_file.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"
#include "core/session/library.h"
#include "tests/app/run_program.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class LibraryCommand : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("POSECOACH_LIBRARY", library_.c_str(), 1);
    ::setenv("XDG_DATA_HOME", in_folder("data").c_str(), 1);
  }
  std::string in_folder(const std::string& name) const { return (folder_.path() / name).string(); }
  ProgramRun run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "library");
    return run_posecoach(arguments);
  }
  std::string run_well(const std::vector<std::string>& arguments) const {
    const ProgramRun ran = run(arguments);
    EXPECT_EQ(ran.exit_code, 0) << testing::PrintToString(arguments) << ran.error;
    return ran.output;
  }
  void expect_one_line(const std::vector<std::string>& arguments, int exit_code,
                       const std::string& part) const {
    const ProgramRun ran = run(arguments);
    EXPECT_EQ(ran.exit_code, exit_code) << testing::PrintToString(arguments) << ran.output;
    EXPECT_EQ(std::count(ran.error.begin(), ran.error.end(), '\n'), 1) << ran.error;
    EXPECT_THAT(ran.error, HasSubstr(part));
  }
  json listed(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"list", "--json", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return json::parse(run_well(arguments));
  }
  // A swing of which only the motion is known.
  std::string import_swing(const std::string& name) const {
    const std::string file = in_folder(name + ".bvh");
    EXPECT_TRUE(write_motion_file(file, resample(bundled_motion("swing").value(), 30.0)));
    const json answer = json::parse(run_well({"import", file, "--person", name, "--json", "-"}));
    return answer.at("swings").at(0).at("id").get<std::string>();
  }

  TemporaryFolder folder_;
  std::string library_ = in_folder("library");
};

TEST_F(LibraryCommand, an_empty_library_lists_nothing) {
  EXPECT_THAT(run_well({"list"}), HasSubstr("No such swings in " + library_));
  const json answer = listed();
  EXPECT_EQ(answer.at("schema"), "posecoach.library/1");
  EXPECT_TRUE(answer.at("swings").empty());
  EXPECT_THAT(run_well({"verify"}), HasSubstr("All 0 swings"));
}

TEST_F(LibraryCommand, a_swing_goes_through_its_whole_life) {
  const std::string anna = import_swing("Anna"), bo = import_swing("Bo");
  EXPECT_EQ(listed().at("swings").size(), 2u);
  EXPECT_EQ(listed({"--person", "ANNA"}).at("swings").at(0).at("id"), anna);
  EXPECT_THAT(run_well({"list"}), testing::AllOf(HasSubstr(anna), HasSubstr("Bo")));

  run_well({"edit", anna, "--star", "on", "--notes", "best of the day", "--hand", "left"});
  const json starred = listed({"--star", "--search", "best day"});
  ASSERT_EQ(starred.at("swings").size(), 1u);
  EXPECT_EQ(starred.at("swings").at(0).at("hand"), "left");
  EXPECT_THAT(run_well({"show", anna}), HasSubstr("best of the day"));

  EXPECT_THAT(run_well({"trash", anna}), HasSubstr("in the trash"));
  EXPECT_EQ(listed().at("swings").size(), 1u);
  EXPECT_EQ(listed({"--trash"}).at("swings").at(0).at("id"), anna);
  run_well({"restore", anna});
  EXPECT_EQ(listed().at("swings").size(), 2u);
  run_well({"trash", anna, bo});
  EXPECT_THAT(run_well({"purge", "--all"}), HasSubstr("2 removed"));
  EXPECT_TRUE(listed({"--trash"}).at("swings").empty());
}

TEST_F(LibraryCommand, the_last_swings_of_one_person_are_told_together) {
  const std::string first = import_swing("Anna");
  import_swing("Bo");
  const std::string last = import_swing("Anna");
  expect_one_line({"block", last}, 1, "not been compared");
  for (const std::string& id : {first, last}) run_well({"analyze", id, "--coach", "bundled:swing"});
  EXPECT_THAT(run_well({"block", last}), testing::AllOf(HasSubstr("2 swings"), HasSubstr("Tempo")));
  const json block = json::parse(run_well({"block", last, "--json", "-"}));
  EXPECT_EQ(block.at("schema"), "posecoach.block/1");
  EXPECT_EQ(block.at("swings"), 2);
  EXPECT_NEAR(block.at("score_percent").at("deviation").get<double>(), 0, 1e-9);
  EXPECT_EQ(json::parse(run_well({"block", first, "--json", "-"})).at("swings"), 1);
}

TEST_F(LibraryCommand, wrong_use_and_broken_things_are_one_line) {
  const std::string id = import_swing("Anna");
  expect_one_line({}, 2, "library --help");
  expect_one_line({"list", "--sort", "sideways"}, 2, "--sort");
  expect_one_line({"list", "--since", "June"}, 1, "2026-11-22");
  expect_one_line({"show", "nothing"}, 1, "there is no swing");
  expect_one_line({"purge"}, 2, "--all");
  expect_one_line({"purge", id}, 1, "trash");
  expect_one_line({"export", id}, 2, "--output");
  expect_one_line({"export", id, "-o", in_folder("x.csv"), "-o", in_folder("x.csv")}, 1, "two outputs");
  expect_one_line({"export", id, "-o", in_folder("x.doc")}, 1, ".csv");
  expect_one_line({"export", id, "-o", in_folder("x.html")}, 1, "--coach");
  expect_one_line({"export", id, "-o", in_folder("x.picture.csv")}, 1, "no joints in the picture");
  expect_one_line({"import", in_folder("none.mp4")}, 1, "none.mp4");
  EXPECT_TRUE(write_file_atomically(in_folder("junk.mp4"), std::string(700, 'j')));
  expect_one_line({"import", in_folder("junk.mp4")}, 1, "junk.mp4");
  fs::create_directory(in_folder("empty"));
  expect_one_line({"import", in_folder("empty")}, 1, "neither swings nor films");
  EXPECT_EQ(listed().at("swings").size(), 1u) << "a failed import leaves nothing";
  EXPECT_EQ(run({"recover"}).output, "Nothing was left unfinished.\n");

  EXPECT_TRUE(write_file_atomically(fs::path(library_) / id / "swing.json", "{"));
  EXPECT_THAT(run_well({"list"}), HasSubstr("unreadable: "));
  EXPECT_EQ(run({"verify"}).exit_code, 1);
}

TEST_F(LibraryCommand, verify_names_what_is_not_as_it_was_stored) {
  const std::string id = import_swing("Anna");
  EXPECT_THAT(run_well({"verify"}), HasSubstr("All 1 swings"));
  std::string bvh = read_file(fs::path(library_) / id / "student.bvh").value();
  bvh[bvh.size() - 5] ^= 1;
  EXPECT_TRUE(write_file_atomically(fs::path(library_) / id / "student.bvh", bvh));
  const ProgramRun ran = run({"verify", "--json", "-"});
  EXPECT_EQ(ran.exit_code, 1);
  const json answer = json::parse(ran.output);
  ASSERT_EQ(answer.at("findings").size(), 1u);
  EXPECT_EQ(answer.at("findings").at(0).at("where"), id);
  EXPECT_THAT(answer.at("findings").at(0).at("what").get<std::string>(), HasSubstr("SHA-256"));
}

TEST_F(LibraryCommand, what_is_exported_reads_back_as_the_same_motion) {
  const std::string id = import_swing("Anna");
  const Motion motion = read_motion_file(in_folder("Anna.bvh"))->motion;
  run_well({"export", id, "-o", in_folder("out.bvh"), "-o", in_folder("out.trc"), "-o",
            in_folder("out.pose.json"), "-o", in_folder("out.csv")});
  for (const char* name : {"out.bvh", "out.trc", "out.pose.json"}) {
    const Motion back = read_motion_file(in_folder(name))->motion;
    ASSERT_EQ(back.frame_count(), motion.frame_count()) << name;
    for (const HumanoidJoint role :
         {HumanoidJoint::LeftWrist, HumanoidJoint::RightAnkle, HumanoidJoint::LeftHip}) {
      const int joint = motion.skeleton().find(role), back_joint = back.skeleton().find(role);
      ASSERT_NE(back_joint, kNoJoint) << name;
      const Vec3 there = motion.position(20, joint) - motion.position(0, joint);
      const Vec3 here = back.position(20, back_joint) - back.position(0, back_joint);
      EXPECT_LT(glm::distance(here, there), 1e-3) << name;
    }
  }
  const std::string csv = read_file(in_folder("out.csv")).value();
  EXPECT_THAT(csv, testing::StartsWith("frame,time_s,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), motion.frame_count() + 1);
}

TEST_F(LibraryCommand, a_library_on_a_stick_is_imported_once) {
  import_swing("Anna");
  import_swing("Bo");
  const std::string own = in_folder("own");
  const json first = json::parse(run_well({"--library", own, "import", library_, "--json", "-"}));
  EXPECT_EQ(first.at("swings").size(), 2u);
  const std::string id = first.at("swings").at(0).at("id").get<std::string>();
  EXPECT_THAT(run_well({"--library", own, "verify"}), HasSubstr("All 2 swings"));
  // Back and forth: what came from here is known again.
  const ProgramRun again = run({"--library", own, "import", (fs::path(own) / id).string()});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.error, HasSubstr("is here already"));
}

TEST_F(LibraryCommand, a_swing_becomes_a_coach_that_others_are_compared_with) {
  const std::string id = import_swing("Anna");
  EXPECT_THAT(run_well({"make-coach", id, "--name", "My Pro"}), HasSubstr("--coach reference:my_pro"));
  EXPECT_THAT(run_well({"coaches"}),
              testing::AllOf(HasSubstr("bundled:putt"), HasSubstr("reference:my_pro")));
  EXPECT_THAT(run_well({"analyze", id, "--coach", "reference:my_pro"}), HasSubstr("Score     100"));
  const json swing = listed().at("swings").at(0);
  EXPECT_EQ(swing.at("coach"), "reference:my_pro");
  EXPECT_TRUE(swing.at("files").contains("analysis.json"));
  EXPECT_THAT(run_well({"verify"}), HasSubstr("All 1 swings"));
  const ProgramRun direct =
      run_posecoach({"analyze", "--coach", "reference:my_pro", "--student", "bundled:swing", "--json", "-"});
  EXPECT_EQ(direct.exit_code, 0) << direct.error;
  expect_one_line({"analyze", id, "--coach", "reference:nobody"}, 1, "reference:my_pro");
}

TEST_F(LibraryCommand, a_film_is_kept_as_it_came) {
  ASSERT_EQ(
      run_posecoach({"simulate", "--size", "128x128", "--fps", "10", "-o", in_folder("Phone.MP4")}).exit_code,
      0);
  const std::string film = read_file(in_folder("Phone.MP4")).value();
  const std::string id =
      json::parse(run_well({"import", in_folder("Phone.MP4"), "--json", "-"})).at("swings").at(0).at("id");
  EXPECT_EQ(read_file(fs::path(library_) / id / "film.mp4").value(), film);
  EXPECT_TRUE(fs::exists(fs::path(library_) / id / "thumb.jpg"));
  EXPECT_THAT(run_well({"verify"}), HasSubstr("All 1 swings"));
  run_well({"export", id, "-o", in_folder("copy.mp4")});
  EXPECT_EQ(read_file(in_folder("copy.mp4")).value(), film);
  expect_one_line({"export", id, "-o", in_folder("copy.mkv")}, 1, "its film as .mp4");
}

}  // namespace
}  // namespace posecoach
