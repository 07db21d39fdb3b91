// Death at any moment, and a full disk at any moment: swings are there whole or not at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
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
using testing::AnyOf;
using testing::IsEmpty;
using testing::SizeIs;

// How the child ended: its exit code, or -1 when it was killed.
int run_in_child(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

using Work = std::function<Result<void>(Library&)>;

Result<void> outcome(const Result<Swing>& swing) {
  if (!swing) return tl::unexpected(swing.error());
  return {};
}

const struct {
  const char* name;
  Work work;
} kDeeds[] = {
    {"add", [](Library& library) { return outcome(add_swing(library, 9)); }},
    {"change",
     [](Library& library) {
       SwingChange change;
       change.notes = "changed";
       return outcome(library.change(library.list()->at(0).id, change));
     }},
    {"trash", [](Library& library) { return outcome(library.trash(library.list()->at(0).id)); }},
    {"restore",
     [](Library& library) {
       return outcome(library.restore(library.list({.shelf = Shelf::Trash})->at(0).id));
     }},
    {"purge",
     [](Library& library) { return library.purge(library.list({.shelf = Shelf::Trash})->at(0).id); }},
    {"analyse again",
     [](Library& library) -> Result<void> {
       Result<SwingDraft> draft = library.begin_again(library.list()->at(0).id);
       if (!draft) return tl::unexpected(draft.error());
       Analysis analysis;
       analysis.coach.source = "another";
       if (const Result<void> added = draft->add_analysis(analysis); !added) return added;
       return outcome(library.keep(*std::move(draft)));
     }},
};

// Two swings on the shelf, one in the trash.
void fill(const fs::path& folder) {
  QuickDisk disk;
  const auto library = Library::open(folder, disk).value();
  for (int number = 1; number <= 3; ++number) ASSERT_TRUE(add_swing(*library, number));
  ASSERT_TRUE(library->trash(library->list()->at(0).id));
}

std::vector<std::string> state_of(Library& library) {
  std::vector<std::string> state = told(library.list().value());
  state.push_back("trash:");
  const std::vector<std::string> trash = told(library.list({.shelf = Shelf::Trash}).value());
  state.insert(state.end(), trash.begin(), trash.end());
  // A swing's last letters are drawn anew each time.
  for (std::string& line : state)
    if (const auto at = line.find("swing_1209"); at != std::string::npos) line.erase(at + 13, 3);
  return state;
}

// Each deed with a disk that does something bad at its n-th call, for every n. `harm` runs the deed and says
// whether it came to its end.
void for_every_call(const std::function<bool(const fs::path&, const Work&, int)>& harm) {
  for (const auto& deed : kDeeds) {
    const TemporaryFolder start;
    fill(start.path());
    std::vector<std::string> before, after;
    {
      const TemporaryFolder done;
      fs::copy(start.path(), done.path(), fs::copy_options::recursive);
      const auto library = Library::open(done.path()).value();
      before = state_of(*library);
      ASSERT_TRUE(deed.work(*library));
      after = state_of(*library);
      ASSERT_NE(before, after);
    }
    bool has_ended = false;
    int n = 1;
    for (; !has_ended && n < 500; ++n) {
      const TemporaryFolder copy;
      fs::copy(start.path(), copy.path(), fs::copy_options::recursive);
      has_ended = harm(copy.path(), deed.work, n);
      const auto library = Library::open(copy.path()).value();
      EXPECT_THAT(state_of(*library), AnyOf(before, after)) << deed.name << ", call " << n;
      if (has_ended) {
        EXPECT_EQ(state_of(*library), after) << deed.name;
      }
      for (const Leftover& leftover : library->leftovers()) {
        EXPECT_EQ(leftover.facts.notes, "swing number 9");
        EXPECT_TRUE(library->discard(leftover));
      }
      EXPECT_EQ(findings_text(*library), "") << deed.name << ", call " << n;
      EXPECT_TRUE(!fs::exists(copy.path() / ".unfinished") || fs::is_empty(copy.path() / ".unfinished"))
          << deed.name << ", call " << n;
    }
    EXPECT_TRUE(has_ended) << deed.name;
    EXPECT_GT(n, 3) << deed.name << " made no calls";
  }
}

bool die_at(const fs::path& folder, const Work& work, int n, bool can_exchange) {
  return run_in_child([&] {
           DyingDisk disk(n);
           disk.can_exchange = can_exchange;
           const auto library = Library::open(folder, disk);
           return library && work(**library) ? 0 : 1;
         }) == 0;
}

TEST(Crash, death_at_any_call_leaves_the_old_or_the_new) {
  for_every_call(
      [](const fs::path& folder, const Work& work, int n) { return die_at(folder, work, n, true); });
}

TEST(Crash, so_it_is_where_the_file_system_cannot_exchange_folders) {
  for_every_call(
      [](const fs::path& folder, const Work& work, int n) { return die_at(folder, work, n, false); });
}

TEST(Crash, a_disk_that_fills_up_at_any_call_leaves_the_old_or_the_new) {
  for_every_call([](const fs::path& folder, const Work& work, int n) {
    FillingDisk disk(n);
    const auto library = Library::open(folder, disk);
    if (!library) return false;
    const Result<void> done = work(**library);
    if (!done) {
      EXPECT_THAT(done.error().message, testing::HasSubstr("No space left on device; make room"));
    }
    return done.has_value();
  });
}

TEST(Crash, a_recording_that_was_never_finished_is_offered_and_recovered) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_in_child([&] {
              const auto library = Library::open(folder.path()).value();
              SwingDraft draft = library->begin(make_facts(5)).value();
              (void)draft.add("film.mkv", film_bytes_of(5));
              ::raise(SIGKILL);
              return 0;
            }),
            -1);
  const auto library = Library::open(folder.path()).value();
  EXPECT_THAT(library->list().value(), IsEmpty());
  const std::vector<Leftover> leftovers = library->leftovers();
  ASSERT_THAT(leftovers, SizeIs(1));
  EXPECT_EQ(leftovers[0].facts.person, "Anna");
  EXPECT_EQ(leftovers[0].film_bytes, film_bytes_of(5).size());
  EXPECT_THAT(findings_text(*library), testing::HasSubstr("never finished"));
  const Swing swing = library->recover(leftovers[0]).value();
  EXPECT_EQ(swing.facts.notes, "swing number 5");
  EXPECT_EQ(read_file(*swing.file("film")).value(), film_bytes_of(5));
  EXPECT_EQ(findings_text(*library), "");
  EXPECT_TRUE(fs::is_empty(folder.path() / ".unfinished"));
}

TEST(Crash, a_draft_whose_facts_are_damaged_is_recovered_under_its_date) {
  const TemporaryFolder folder;
  const fs::path draft = folder.path() / ".unfinished" / "swing_120000_abcdef";
  fs::create_directories(draft);
  ASSERT_TRUE(write_file_atomically(draft / "film.mkv", "film"));
  ASSERT_TRUE(write_file_atomically(draft / "swing.json", "{\"schema\": \"pos"));
  const auto library = Library::open(folder.path()).value();
  const std::vector<Leftover> leftovers = library->leftovers();
  ASSERT_THAT(leftovers, SizeIs(1));
  const Swing swing = library->recover(leftovers[0]).value();
  EXPECT_TRUE(swing.id.starts_with(day_of(wall_time_now()).substr(0, 4))) << swing.id;
  EXPECT_EQ(findings_text(*library), "");
}

TEST(Crash, a_swing_that_does_not_fit_on_the_disk_is_kept_later) {
  const TemporaryFolder folder;
  CountingDisk counting;
  {
    const TemporaryFolder trial;
    const auto library = Library::open(trial.path(), counting).value();
    ASSERT_TRUE(add_swing(*library, 1));
  }
  FillingDisk full(counting.calls - 3);
  {
    const auto library = Library::open(folder.path(), full).value();
    EXPECT_FALSE(add_swing(*library, 1));
  }
  const auto library = Library::open(folder.path()).value();
  ASSERT_THAT(library->leftovers(), SizeIs(1)) << "a recording is never thrown away for want of room";
  ASSERT_TRUE(library->recover(library->leftovers()[0]));
  EXPECT_EQ(read_file(*library->list()->at(0).file("film")).value(), film_bytes_of(1));
}

TEST(Crash, killed_at_random_no_finished_swing_is_ever_lost) {
  const TemporaryFolder folder;
  std::mt19937 random(11);
  std::size_t finished = 0;
  for (int round = 0; round < 50; ++round) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      CountingDisk disk;
      const auto library = Library::open(folder.path(), disk).value();
      for (int number = 0;; ++number)
        if (!add_swing(*library, number) || !library->list() || ::write(ends[1], "k", 1) != 1) ::_exit(1);
    }
    ::close(ends[1]);
    char byte = 0;
    for (std::size_t awaited = random() % 4; awaited > 0 && ::read(ends[0], &byte, 1) == 1; --awaited)
      ++finished;
    ::usleep(static_cast<useconds_t>(random() % 20'000));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "round " << round << ": the child failed by itself";
    while (::read(ends[0], &byte, 1) == 1) ++finished;
    ::close(ends[0]);
  }
  const auto library = Library::open(folder.path()).value();
  EXPECT_GE(library->list()->size(), finished);
  EXPECT_GT(finished, 0u);
  for (const Leftover& leftover : library->leftovers()) EXPECT_TRUE(library->recover(leftover));
  EXPECT_EQ(findings_text(*library), "");
  const std::vector<Swing> all = library->list().value();
  for (const Swing& swing : all) EXPECT_TRUE(swing.is_readable()) << swing.unreadable;
}

}  // namespace
}  // namespace posecoach
