#include "core/session/marks.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/file.h"
#include "tests/core/session/swings.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

Marks some_marks() {
  return {{{"top", 41}, {"impact", 57}},
          {{DrawingKind::Line, 12, {{10.5, 20}, {300, 180.25}}},
           {DrawingKind::Angle, 41, {{0, 0}, {50, 0}, {50, 70}}}},
          {12, 41}};
}

TEST(Marks, text_and_back_is_the_same) {
  const Result<Marks> back = marks_from_json("marks.json", marks_to_json(some_marks()));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(*back, some_marks());
  EXPECT_EQ(marks_from_json("marks.json", marks_to_json({})).value(), Marks());
}

TEST(Marks, what_cannot_be_is_an_error_that_names_the_file) {
  for (
      const char* text :
      {"", "[]", "{}", R"({"schema": "posecoach.marks/1", "events": [{"name": "top"}, {"frame": -1}]})",
       R"({"schema": "posecoach.marks/1", "drawings": [{"kind": "circle", "frame": 1}]})",
       R"({"schema": "posecoach.marks/1", "drawings": [{"kind": "line", "frame": 1, "points_px": [[1, 2]]}]})",
       R"({"schema": "posecoach.marks/1", "key_pictures": ["first"]})"}) {
    const Result<Marks> marks = marks_from_json("film/marks.json", text);
    ASSERT_FALSE(marks.has_value()) << text;
    EXPECT_NE(marks.error().message.find("film/marks.json"), std::string::npos) << marks.error().message;
  }
  EXPECT_EQ(marks_from_json("marks.json", R"({"schema": "posecoach.marks/9"})").error().code,
            ErrorCode::Unsupported);
}

TEST(Marks, damaged_text_never_does_harm) {
  const std::string whole = marks_to_json(some_marks());
  std::mt19937 random(11);
  for (int round = 0; round < 2000; ++round) {
    std::string text = whole;
    for (int change = 0; change < 3; ++change)
      text[random() % text.size()] = static_cast<char>(random() % 128);
    const Result<Marks> marks = marks_from_json("marks.json", text);
    if (!marks) continue;
    for (const Drawing& drawing : marks->drawings)
      EXPECT_EQ(drawing.points_px.size(), point_count(drawing.kind));
  }
}

TEST(Marks, an_angle_is_measured_at_its_corner) {
  EXPECT_NEAR(angle_deg({DrawingKind::Angle, 0, {{1, 0}, {0, 0}, {0, 5}}}), 90, 1e-12);
  EXPECT_NEAR(angle_deg({DrawingKind::Angle, 0, {{1, 0}, {0, 0}, {-3, 0}}}), 180, 1e-12);
  EXPECT_NEAR(angle_deg({DrawingKind::Angle, 0, {{1, 1}, {0, 0}, {2, 2}}}), 0, 1e-6);
  EXPECT_EQ(angle_deg({DrawingKind::Line, 0, {{1, 1}, {0, 0}}}), 0);
}

TEST(Marks, lie_beside_the_film_which_they_never_change) {
  const TemporaryFolder folder;
  auto library = Library::open(folder.path()).value();
  const Swing before = add_swing(*library, 1).value();
  const std::string film = read_file(*before.file("film")).value();
  EXPECT_EQ(read_marks(before).value(), Marks());
  SwingDraft draft = library->begin_again(before.id).value();
  ASSERT_TRUE(draft.add(kMarksFile, marks_to_json(some_marks())).has_value());
  const Swing after = library->keep(std::move(draft)).value();
  EXPECT_EQ(after.id, before.id);
  EXPECT_EQ(read_marks(after).value(), some_marks());
  EXPECT_EQ(read_file(*after.file("film")).value(), film);
  EXPECT_EQ(after.files.at("film.mkv").sha256, before.files.at("film.mkv").sha256);
  EXPECT_TRUE(library->check().value().empty());
}

}  // namespace
}  // namespace posecoach
