#include "core/session/library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/base/file.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"
#include "tests/core/session/swings.h"
#include "tests/core/session/test_disks.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class LibraryTest : public testing::Test {
 protected:
  std::string first_id(const SwingQuery& query = {}) { return library_->list(query).value().at(0).id; }
  fs::path file_of(const std::string& id, const char* name = kSwingFile) {
    return library_->folder() / id / name;
  }
  std::vector<std::string> notes_of(const SwingQuery& query) {
    std::vector<std::string> notes;
    const std::vector<Swing> swings = library_->list(query).value();
    for (const Swing& swing : swings)
      notes.push_back(swing.facts.notes.substr(swing.facts.notes.rfind(' ') + 1));
    return notes;
  }

  TemporaryFolder temporary_;
  std::unique_ptr<Library> library_ = Library::open(temporary_.path() / "library").value();
};

TEST_F(LibraryTest, a_kept_swing_is_a_plain_folder_with_everything_in_it) {
  SwingFacts facts = make_facts(0);
  facts.counters = {117, 2, 0, 31};
  SwingDraft draft = library_->begin(facts).value();
  ASSERT_TRUE(draft.add("film.mkv", "film"));
  const Motion motion = resample(bundled_motion("putt").value(), 30.0);
  ASSERT_TRUE(draft.add_student(motion, "film.mkv"));
  ASSERT_TRUE(draft.add_body(motion.skeleton()));
  ASSERT_TRUE(draft.add_coach(motion, "bundled:putt"));
  PoseTrack track{"film.mkv", 640, 480, {{0, MediaTime(), {}}}};
  ASSERT_TRUE(draft.add_track(track));
  Analysis analysis;
  analysis.coach.source = "bundled:putt";
  analysis.stroke = "putt";
  analysis.score.percent = 87.5;
  analysis.advice = {{AdviceKind::Timing, "Take the putter back more slowly.", 1, 1, 2.0}};
  ASSERT_TRUE(draft.add_analysis(analysis));
  ASSERT_TRUE(draft.add_thumbnail("jpeg"));
  const Swing kept = library_->keep(std::move(draft)).value();

  EXPECT_TRUE(kept.id.starts_with("2026-06-01/swing_120000_")) << kept.id;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kept.folder)) names.push_back(entry.path().filename());
  EXPECT_THAT(names, testing::UnorderedElementsAre("film.mkv", "pose.pose.json", "student.pose.json",
                                                   "student.body.json", "coach.pose.json", "analysis.json",
                                                   "thumb.jpg", "swing.json"));
  const Swing listed = library_->list().value().at(0);
  EXPECT_EQ(told({listed}), told({kept}));
  EXPECT_EQ(listed.facts.person, "Søren");
  EXPECT_EQ(listed.facts.coach, "bundled:putt");
  EXPECT_EQ(listed.facts.stroke, "putt");
  EXPECT_EQ(listed.facts.hand, Handedness::Left);
  EXPECT_EQ(listed.facts.score_percent, 87.5);
  EXPECT_EQ(listed.facts.advice, "Take the putter back more slowly.");
  EXPECT_EQ(listed.facts.counters.captured, 117u);
  EXPECT_EQ(listed.facts.counters.skipped_by_pose, 31u);
  EXPECT_EQ(listed.facts.recorded_at, facts.recorded_at);
  EXPECT_EQ(*listed.file("film"), kept.folder / "film.mkv");
  EXPECT_EQ(*listed.file("student"), kept.folder / "student.pose.json");
  EXPECT_EQ(*listed.file("student.body"), kept.folder / "student.body.json");
  EXPECT_EQ(listed.file("sound"), std::nullopt);
  EXPECT_EQ(read_motion_file(*listed.file("student"))->motion.frame_count(), motion.frame_count());
  EXPECT_EQ(findings_text(*library_), "");
}

TEST_F(LibraryTest, a_draft_that_is_not_kept_leaves_nothing) {
  {
    SwingDraft draft = library_->begin(make_facts(1)).value();
    ASSERT_TRUE(draft.add("film.mkv", "film"));
    EXPECT_THAT(library_->list().value(), IsEmpty());
    EXPECT_THAT(library_->leftovers(), IsEmpty()) << "a draft in use is no leftover";
  }
  EXPECT_TRUE(fs::is_empty(library_->folder() / ".unfinished"));
}

TEST_F(LibraryTest, swings_are_listed_newest_first_whoever_put_them_there) {
  for (const int number : {1, 3, 2}) ASSERT_TRUE(add_swing(*library_, number));
  EXPECT_THAT(notes_of({}), ElementsAre("3", "2", "1"));
  const std::string newest = first_id();
  fs::remove_all(library_->folder() / newest);
  EXPECT_THAT(notes_of({}), ElementsAre("2", "1"));
  fs::rename(library_->folder() / "2026-06-01", library_->folder() / "2026-06-02");
  EXPECT_TRUE(first_id().starts_with("2026-06-02/")) << "a folder that a person moved";
}

TEST_F(LibraryTest, a_search_finds_by_person_text_star_score_coach_and_date) {
  for (int number = 1; number <= 6; ++number) ASSERT_TRUE(add_swing(*library_, number));
  const std::string second = library_->list({.order = SwingOrder::OldestFirst}).value().at(1).id;
  SwingChange change;
  change.star = true;
  change.notes = "Good Tempo, ÉLAN 2";
  change.coach = "reference:pro";
  ASSERT_TRUE(library_->change(second, change));

  EXPECT_THAT(notes_of({.person = "soren"}), ElementsAre("6", "4", "2"));
  EXPECT_THAT(notes_of({.text = "tempo elan"}), ElementsAre("2"));
  EXPECT_THAT(notes_of({.text = "tempo nothing"}), IsEmpty());
  EXPECT_THAT(notes_of({.text = "%"}), IsEmpty()) << "no wildcard";
  EXPECT_THAT(notes_of({.star = StarFilter::Starred}), ElementsAre("2"));
  EXPECT_THAT(notes_of({.star = StarFilter::Plain}), SizeIs(5));
  EXPECT_THAT(notes_of({.coach = "reference:pro"}), ElementsAre("2"));
  EXPECT_THAT(notes_of({.score_from = 53.0, .score_to = 54.0}), ElementsAre("4", "3"));
  EXPECT_THAT(notes_of({.order = SwingOrder::WorstFirst, .limit = 2}), ElementsAre("1", "2"));
  EXPECT_THAT(notes_of({.order = SwingOrder::BestFirst, .limit = 1}), ElementsAre("6"));
  EXPECT_THAT(notes_of({.since = "2026-06-01", .until = "2026-06-01"}), SizeIs(6));
  EXPECT_THAT(notes_of({.since = "2026-06-02"}), IsEmpty());
  EXPECT_EQ(library_->list({.since = "June"}).error().code, ErrorCode::InvalidArgument);
}

TEST_F(LibraryTest, a_search_agrees_with_looking_at_every_swing) {
  std::mt19937 random(7);
  std::vector<Swing> all;
  for (int number = 0; number < 40; ++number) {
    SwingFacts facts = make_facts(static_cast<int>(random() % 5000));
    facts.star = random() % 2 == 0;
    if (random() % 4 == 0) facts.score_percent.reset();
    all.push_back(library_->keep(library_->begin(facts).value()).value());
  }
  for (int round = 0; round < 60; ++round) {
    SwingQuery query;
    if (random() % 2 == 0) query.person = "anna";
    if (random() % 2 == 0) query.star = StarFilter::Starred;
    if (random() % 2 == 0) query.score_from = 50.0 + static_cast<double>(random() % 3000);
    if (random() % 3 == 0) query.text = std::to_string(random() % 10);
    std::vector<Swing> expected;
    for (const Swing& swing : all) {
      const SwingFacts& facts = swing.facts;
      const bool fits =
          (query.person.empty() || facts.person == "Anna") && (query.star == StarFilter::Any || facts.star) &&
          (!query.score_from || (facts.score_percent && *facts.score_percent >= *query.score_from)) &&
          (query.text.empty() ||
           (facts.notes + day_of(facts.recorded_at)).find(query.text) != std::string::npos);
      if (fits) expected.push_back(swing);
    }
    EXPECT_EQ(told(library_->list(query).value()), told(expected)) << "round " << round;
  }
}

TEST_F(LibraryTest, one_broken_swing_is_listed_with_the_reason_and_stops_nobody) {
  for (int number = 1; number <= 3; ++number) ASSERT_TRUE(add_swing(*library_, number));
  const std::vector<Swing> before = library_->list().value();
  const struct {
    std::string text, reason;
  } rows[] = {
      {"", "swing.json:1: not valid JSON"},
      {"{\"schema\": \"posecoach.swing/1\",\n \"notes\": ", "swing.json:2: not valid JSON"},
      {"{\"schema\": \"posecoach.swing/2\"}", "newer version"},
      {"{\"schema\": \"other\"}", "posecoach.swing/1"},
      {"{\"schema\": \"posecoach.swing/1\", \"recorded_at\": \"yesterday\"}", "recorded_at"},
      {"{\"schema\": \"posecoach.swing/1\", \"recorded_at\": \"2026-06-01T12:00:00Z\", \"star\": 3}", "star"},
      {"{\"schema\": \"posecoach.swing/1\", \"recorded_at\": \"2026-06-01T12:00:00Z\", "
       "\"files\": {\"../../secret\": {}}}",
       "files"},
  };
  for (const auto& row : rows) {
    ASSERT_TRUE(write_file_atomically(file_of(before[1].id), row.text));
    const std::vector<Swing> listed = library_->list().value();
    ASSERT_THAT(listed, SizeIs(3)) << row.text;
    EXPECT_EQ(listed[2].id, before[1].id);
    EXPECT_THAT(listed[2].unreadable, HasSubstr(row.reason)) << row.text;
    EXPECT_EQ(told({listed[0], listed[1]}), told({before[0], before[2]}));
    EXPECT_THAT(findings_text(*library_), HasSubstr("unreadable: "));
  }
  fs::remove(file_of(before[1].id));
  EXPECT_THAT(library_->list()->at(2).unreadable, HasSubstr("no swing.json"));
  EXPECT_THAT(library_->list({.person = "Anna"}).value(), SizeIs(2)) << "a search is not about broken ones";
  EXPECT_TRUE(library_->trash(before[1].id)) << "it can be thrown away";
  EXPECT_THAT(library_->list().value(), SizeIs(2));
}

TEST_F(LibraryTest, a_change_keeps_what_it_does_not_know) {
  const Swing swing = add_swing(*library_, 1).value();
  std::string text = read_file(file_of(swing.id)).value();
  text.insert(text.find('{') + 1, "\"future\": {\"of\": [1, 2]},");
  ASSERT_TRUE(write_file_atomically(file_of(swing.id), text));
  SwingChange change;
  change.star = true;
  change.hand = Handedness::Left;
  ASSERT_TRUE(library_->change(swing.id, change));
  EXPECT_THAT(read_file(file_of(swing.id)).value(), HasSubstr("\"future\""));
  const Swing listed = library_->list().value().at(0);
  EXPECT_TRUE(listed.facts.star);
  EXPECT_EQ(listed.facts.hand, Handedness::Left);
  EXPECT_EQ(listed.facts.notes, swing.facts.notes);
  EXPECT_EQ(findings_text(*library_), "");
}

TEST_F(LibraryTest, what_was_thrown_away_comes_back_as_it_was) {
  for (int number = 1; number <= 2; ++number) ASSERT_TRUE(add_swing(*library_, number));
  const std::vector<Swing> before = library_->list().value();
  const Swing thrown = library_->trash(before[0].id).value();
  EXPECT_EQ(thrown.folder, library_->folder() / "Trash" / before[0].id);
  EXPECT_THAT(ids(library_->list().value()), ElementsAre(before[1].id));
  EXPECT_THAT(ids(library_->list({.shelf = Shelf::Trash}).value()), ElementsAre(before[0].id));
  EXPECT_EQ(library_->trash(before[0].id).error().code, ErrorCode::InvalidArgument);
  ASSERT_TRUE(library_->trash(before[1].id));
  EXPECT_FALSE(fs::exists(library_->folder() / "2026-06-01")) << "no empty day stays";
  for (const Swing& swing : before) ASSERT_TRUE(library_->restore(swing.id));
  EXPECT_EQ(told(library_->list().value()), told(before));
  EXPECT_EQ(library_->restore(before[0].id).error().code, ErrorCode::InvalidArgument);
  EXPECT_EQ(findings_text(*library_), "");
}

TEST_F(LibraryTest, nothing_is_put_in_the_place_of_something_else) {
  const Swing swing = add_swing(*library_, 1).value();
  ASSERT_TRUE(library_->trash(swing.id));
  fs::create_directories(library_->folder() / swing.id);
  const Result<Swing> restored = library_->restore("Trash/" + swing.id);
  EXPECT_FALSE(restored);
  const Result<Swing> named = library_->restore(swing.id);
  ASSERT_FALSE(named);
  EXPECT_TRUE(fs::exists(library_->folder() / "Trash" / swing.id / "film.mkv"));
}

TEST_F(LibraryTest, only_the_trash_is_purged) {
  for (int number = 1; number <= 3; ++number) ASSERT_TRUE(add_swing(*library_, number));
  const std::vector<Swing> all = library_->list().value();
  EXPECT_EQ(library_->purge(all[0].id).error().code, ErrorCode::NotFound);
  for (const Swing& swing : all) ASSERT_TRUE(library_->trash(swing.id));
  ASSERT_TRUE(library_->restore(all[2].id));
  ASSERT_TRUE(library_->purge(all[0].id));
  EXPECT_THAT(ids(library_->list({.shelf = Shelf::Trash}).value()), ElementsAre(all[1].id));
  EXPECT_EQ(library_->empty_trash().value(), 1u);
  EXPECT_THAT(ids(library_->list().value()), ElementsAre(all[2].id));
  EXPECT_TRUE(fs::is_empty(library_->folder() / ".unfinished"));
}

TEST_F(LibraryTest, a_swing_is_found_by_its_id_its_folder_s_name_or_its_last_letters) {
  const Swing swing = add_swing(*library_, 1).value();
  const std::string name = swing.id.substr(11), letters = swing.id.substr(swing.id.size() - 3);
  for (const std::string& id : {swing.id, name, letters}) EXPECT_EQ(library_->find(id)->id, swing.id) << id;
  EXPECT_EQ(library_->find("nothing").error().code, ErrorCode::NotFound);
  EXPECT_EQ(library_->find("").error().code, ErrorCode::NotFound);
  EXPECT_EQ(library_->find("../../etc").error().code, ErrorCode::NotFound);
  fs::create_directory(library_->folder() / "2026-07-01");
  fs::copy(swing.folder, library_->folder() / "2026-07-01" / name, fs::copy_options::recursive);
  EXPECT_EQ(library_->find(name).error().code, ErrorCode::InvalidArgument);
  EXPECT_TRUE(library_->find(swing.id));
}

TEST_F(LibraryTest, a_swing_analysed_again_is_replaced_in_one_step) {
  for (const bool can_exchange : {true, false}) {
    CountingDisk disk;
    disk.can_exchange = can_exchange;
    disk.can_link = can_exchange;
    library_ = Library::open(temporary_.path() / (can_exchange ? "a" : "b"), disk).value();
    const Swing before = add_swing(*library_, 1).value();
    SwingDraft draft = library_->begin_again(before.id).value();
    Analysis analysis;
    analysis.coach.source = "bundled:putt";
    analysis.score.percent = 12.25;
    ASSERT_TRUE(draft.add_analysis(analysis));
    EXPECT_EQ(read_file(file_of(before.id, "analysis.json")).value(), "{\"score\": {}}") << "not yet";
    const Swing after = library_->keep(std::move(draft)).value();
    EXPECT_EQ(after.id, before.id);
    EXPECT_EQ(after.facts.coach, "bundled:putt");
    EXPECT_EQ(after.facts.score_percent, 12.25);
    EXPECT_EQ(after.facts.notes, before.facts.notes);
    EXPECT_EQ(read_file(file_of(before.id, "film.mkv")).value(), film_bytes_of(1));
    EXPECT_EQ(told(library_->list().value()), told({after}));
    EXPECT_EQ(findings_text(*library_), "");
    EXPECT_TRUE(fs::is_empty(library_->folder() / ".unfinished"));
  }
}

TEST_F(LibraryTest, two_swings_of_the_same_second_are_two) {
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(add_swing(*library_, 1));
  EXPECT_THAT(library_->list().value(), SizeIs(30));
}

TEST_F(LibraryTest, a_disk_that_takes_half_of_every_write_gets_all_of_it) {
  StutteringDisk disk;
  library_ = Library::open(temporary_.path() / "stuttering", disk).value();
  const Swing swing = add_swing(*library_, 1).value();
  EXPECT_EQ(read_file(swing.folder / "film.mkv").value(), film_bytes_of(1));
  EXPECT_EQ(findings_text(*library_), "");
}

TEST_F(LibraryTest, a_library_that_cannot_be_made_is_one_line) {
  ASSERT_TRUE(write_file_atomically(temporary_.path() / "file", "x"));
  const auto opened = Library::open(temporary_.path() / "file" / "library");
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::Unreadable);
}

TEST_F(LibraryTest, check_finds_what_is_not_as_it_was_stored) {
  for (int number = 1; number <= 4; ++number) ASSERT_TRUE(add_swing(*library_, number));
  const std::vector<Swing> all = library_->list().value();
  EXPECT_EQ(findings_text(*library_), "");
  std::string film = film_bytes_of(4);
  film[100] ^= 1;
  ASSERT_TRUE(write_file_atomically(file_of(all[0].id, "film.mkv"), film));
  ASSERT_TRUE(write_file_atomically(file_of(all[1].id, "film.mkv"), "short"));
  fs::remove(file_of(all[2].id, "film.mkv"));
  ASSERT_TRUE(write_file_atomically(file_of(all[3].id, "stranger.txt"), ""));
  const std::vector<Finding> findings = library_->check().value();
  ASSERT_THAT(findings, SizeIs(4));
  EXPECT_THAT(findings[3].where + findings[3].what,
              HasSubstr(all[0].id + "film.mkv is not as it was stored"));
  EXPECT_THAT(findings[2].what, HasSubstr("film.mkv has 5 bytes instead of"));
  EXPECT_EQ(findings[1].what, "film.mkv is missing");
  EXPECT_THAT(findings[0].what, HasSubstr("stranger.txt does not belong"));
  const auto refuse = [](const fs::path&) -> Result<void> { return fail(ErrorCode::Malformed, "no film"); };
  EXPECT_THAT(library_->check(refuse).value(), SizeIs(5)) << "the one film that is as stored, and no film";
  const auto stop = [](std::string_view, double) { return false; };
  EXPECT_EQ(library_->check({}, stop).error().code, ErrorCode::Cancelled);
}

TEST_F(LibraryTest, a_thousand_swings_are_listed) {
  QuickDisk disk;
  library_ = Library::open(temporary_.path() / "thousand", disk).value();
  for (int number = 0; number < 1000; ++number)
    ASSERT_TRUE(library_->keep(library_->begin(make_facts(number)).value()));
  EXPECT_THAT(library_->list().value(), SizeIs(1000));
  EXPECT_THAT(library_->list({.text = "number 77"}).value(), SizeIs(19)) << "77, 177, ... and 770, 771, ...";
}

}  // namespace
}  // namespace posecoach
