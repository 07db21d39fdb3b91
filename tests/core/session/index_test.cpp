// The index is a copy: whatever happens to it, the list is what the folders say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <random>

#include "core/base/file.h"
#include "core/session/library.h"
#include "tests/core/session/swings.h"
#include "tests/core/session/test_disks.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using testing::SizeIs;

constexpr int kSwings = 12;

class IndexTest : public testing::Test {
 protected:
  void SetUp() override {
    library_ = Library::open(folder_.path(), disk_).value();
    for (int number = 0; number < kSwings; ++number) ASSERT_TRUE(add_swing(*library_, number));
    ASSERT_TRUE(library_->trash(library_->list()->at(0).id));
    truth_ = told(library_->list().value());
  }
  void reopen() {
    library_.reset();
    library_ = Library::open(folder_.path(), disk_).value();
  }
  void expect_truth(const std::string& after) {
    EXPECT_EQ(told(library_->list().value()), truth_) << after;
    EXPECT_THAT(library_->list({.shelf = Shelf::Trash}).value(), SizeIs(1)) << after;
    EXPECT_THAT(library_->list({.text = "number 3", .person = "anna"}).value(), SizeIs(1)) << after;
  }

  QuickDisk disk_;
  TemporaryFolder folder_;
  fs::path index_ = folder_.path() / "index.sqlite";
  std::unique_ptr<Library> library_;
  std::vector<std::string> truth_;
};

TEST_F(IndexTest, a_missing_empty_or_foreign_index_is_made_again) {
  const std::function<void()> harms[] = {
      [&] { fs::remove(index_); },
      [&] { EXPECT_TRUE(write_file_atomically(index_, "")); },
      [&] { EXPECT_TRUE(write_file_atomically(index_, "this is no database at all, not even a small one")); },
      [&] { EXPECT_TRUE(write_file_atomically(index_, std::string(50'000, '\xAB'))); },
      [&] {
        sqlite3* other = nullptr;
        fs::remove(index_);
        ASSERT_EQ(sqlite3_open(index_.c_str(), &other), SQLITE_OK);
        sqlite3_exec(other, "CREATE TABLE swings (x); PRAGMA user_version = 1", nullptr, nullptr, nullptr);
        sqlite3_close(other);
      },
      [&] {
        sqlite3* other = nullptr;
        ASSERT_EQ(sqlite3_open(index_.c_str(), &other), SQLITE_OK);
        sqlite3_exec(other, "PRAGMA user_version = 99", nullptr, nullptr, nullptr);
        sqlite3_close(other);
      },
  };
  for (const auto& harm : harms) {
    library_.reset();
    harm();
    reopen();
    expect_truth("a harm");
  }
}

TEST_F(IndexTest, an_index_damaged_anywhere_never_changes_the_list) {
  std::mt19937 random(3);
  for (int round = 0; round < 60; ++round) {
    reopen();
    ASSERT_TRUE(library_->list());
    library_.reset();
    std::string bytes = read_file(index_).value();
    ASSERT_GT(bytes.size(), 4096u);
    if (round % 3 == 0) bytes.resize(random() % bytes.size());
    for (int i = 0; i < 1 + round % 5 && !bytes.empty(); ++i)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    ASSERT_TRUE(write_file_atomically(index_, bytes));
    reopen();
    expect_truth("round " + std::to_string(round));
  }
}

TEST_F(IndexTest, an_index_damaged_while_it_is_open_never_changes_the_list) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    {
      std::fstream file(index_, std::ios::in | std::ios::out | std::ios::binary);
      for (int i = 0; i < 2000; ++i) {
        file.seekp(static_cast<std::streamoff>(random() % 30'000));
        file.put(static_cast<char>(random()));
      }
    }
    ASSERT_TRUE(add_swing(*library_, 100 + round));
    ASSERT_TRUE(library_->trash(library_->list()->at(0).id));
    EXPECT_THAT(told(library_->list().value()), truth_) << "round " << round;
  }
}

TEST_F(IndexTest, where_no_index_can_be_written_the_list_is_the_same) {
  library_.reset();
  for (const char* ending : {"", "-wal", "-shm"}) fs::remove(index_.string() + ending);
  fs::create_directory(index_);
  reopen();
  expect_truth("a folder in its place");
  EXPECT_TRUE(fs::is_directory(index_)) << "what is not ours is left alone";
}

TEST_F(IndexTest, two_programs_add_change_and_list_at_once) {
  library_.reset();
  constexpr int kEach = 15;
  std::vector<pid_t> children;
  const std::string star_id = truth_[0].substr(0, truth_[0].find(' '));
  for (int child = 0; child < 2; ++child) {
    const pid_t process = ::fork();
    if (process == 0) {
      const auto library = Library::open(folder_.path(), disk_);
      bool is_well = library.has_value();
      for (int i = 0; i < kEach && is_well; ++i) {
        is_well = add_swing(**library, 1000 + 100 * child + i).has_value();
        SwingChange change;
        if (child == 0)
          change.star = i + 1 == kEach;
        else
          change.notes = "note " + std::to_string(i);
        is_well = is_well && (*library)->change(star_id, change);
        const auto listed = (*library)->list();
        is_well = is_well && listed && listed->size() >= static_cast<std::size_t>(kSwings - 1 + i + 1);
      }
      ::_exit(is_well ? 0 : 1);
    }
    children.push_back(process);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "one of the programs failed";
  }
  reopen();
  EXPECT_THAT(library_->list().value(), SizeIs(kSwings - 1 + 2 * kEach));
  const Swing both = library_->find(star_id).value();
  EXPECT_TRUE(both.facts.star);
  EXPECT_EQ(both.facts.notes, "note " + std::to_string(kEach - 1));
  EXPECT_EQ(findings_text(*library_), "");
}

// The folder as this version wrote it, kept so that every later version opens it.
TEST(OldLibrary, swings_of_the_first_version_open) {
  const TemporaryFolder folder;
  fs::copy(POSECOACH_OLD_LIBRARY, folder.path(), fs::copy_options::recursive);
  const auto library = Library::open(folder.path()).value();
  const std::vector<Swing> swings = library->list({.order = SwingOrder::OldestFirst}).value();
  ASSERT_THAT(swings, SizeIs(3));
  EXPECT_EQ(swings[0].facts.person, "") << "only what must be there";
  EXPECT_EQ(swings[1].facts.person, "Søren");
  EXPECT_EQ(swings[1].facts.hand, Handedness::Left);
  EXPECT_TRUE(swings[1].facts.star);
  EXPECT_EQ(swings[1].facts.counters.captured, 117u);
  EXPECT_EQ(to_iso(swings[1].facts.recorded_at), "2026-06-01T12:05:00.250+02:00");
  EXPECT_EQ(swings[1].files.at("film.mkv").bytes, 5u);
  EXPECT_EQ(swings[2].facts.notes, "with fields of a later version");
  EXPECT_THAT(library->list({.shelf = Shelf::Trash}).value(), SizeIs(1));
  EXPECT_EQ(findings_text(*library), "");
}

}  // namespace
}  // namespace posecoach
