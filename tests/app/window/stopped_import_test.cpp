// An import that is stopped, from the window and from within, leaves nothing behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "app/library/import_swing.h"
#include "capture/simulated_student.h"
#include "capture/video_writer.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"
#include "tests/app/window/driven_window.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;

fs::path film_of_a_swing(const WindowPlaces& places) {
  SimulatedStudentOptions options;
  options.width = 256;
  options.height = 144;
  options.frames_per_second = 15;
  const auto student = SimulatedStudent::make(options).value();
  fs::path path = places.folder("film.mp4");
  const auto writer = VideoWriter::open(path, {.width = options.width, .height = options.height}).value();
  while (const auto frame = student->next({}).value()) EXPECT_TRUE(writer->write(*frame->image, frame->time));
  EXPECT_TRUE(writer->finish());
  return path;
}

// Whatever is no index: swings, trash, drafts.
std::vector<fs::path> files_in(const fs::path& library) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(library, failed))
    if (entry.is_regular_file() && entry.path().filename().string().find("index") == std::string::npos)
      files.push_back(entry.path());
  return files;
}

TEST(StoppedImport, leaves_nothing_in_the_library_wherever_it_is_stopped) {
  const WindowPlaces places;
  const fs::path film = film_of_a_swing(places), motion = places.folder("swing.bvh");
  ASSERT_TRUE(write_motion_file(motion, resample(bundled_motion("swing").value(), 30.0)));
  for (const fs::path& input : {film, motion}) {
    ImportOptions options;
    // A film is looked at where there is something to look with.
    if (input == motion || has_pose_networks()) options.coach = "bundled:swing";
    int reports = 0;
    options.load.progress = [&](std::string_view, double) { return ++reports > 0; };
    {
      const auto library = Library::open(places.folder("whole")).value();
      ASSERT_EQ(import_swings(*library, input, options).value().swings.size(), 1U);
    }
    if (reports == 0) continue;  // too quick to be stopped
    for (const int stop_at : std::set{1, (reports + 2) / 3, (reports + 1) / 2, reports}) {
      const fs::path folder = places.folder("stopped_" + input.stem().string() + std::to_string(stop_at));
      const auto library = Library::open(folder).value();
      int count = 0;
      options.load.progress = [&](std::string_view, double) { return ++count < stop_at; };
      const Result<Imported> imported = import_swings(*library, input, options);
      ASSERT_FALSE(imported) << "stopped at " << stop_at << " of " << reports;
      EXPECT_EQ(imported.error().code, ErrorCode::Cancelled);
      EXPECT_TRUE(library->list().value().empty());
      EXPECT_TRUE(library->list({.shelf = Shelf::Trash}).value().empty());
      EXPECT_TRUE(library->leftovers().empty());
      EXPECT_THAT(files_in(folder), testing::IsEmpty());
    }
  }
}

TEST(StoppedImport, its_progress_only_goes_up) {
  const WindowPlaces places;
  ImportOptions options;
  if (has_pose_networks()) options.coach = "bundled:swing";
  std::map<std::string, double> reached;
  options.load.progress = [&](std::string_view stage, double fraction) {
    double& before = reached.try_emplace(std::string(stage), 0.0).first->second;
    EXPECT_GE(fraction, before) << stage;
    EXPECT_LE(fraction, 1.0) << stage;
    before = fraction;
    return true;
  };
  const auto library = Library::open(places.library()).value();
  ASSERT_TRUE(import_swings(*library, film_of_a_swing(places), options));
  EXPECT_FALSE(reached.empty());
}

TEST(StoppedImport, in_the_window_says_that_nothing_was_kept_and_the_next_one_is_kept) {
  if (!has_pose_networks()) GTEST_SKIP() << "the pose models are not installed; run scripts/setup";
  const WindowPlaces places;
  const fs::path film = film_of_a_swing(places);
  DrivenWindow window({.source = "simulated:putt?size=320x240&fps=5"});
  window.press(intent::ImportFile{film.string()});
  EXPECT_EQ(window.state().screen, ScreenName::Library);
  const auto is_under_way = [](const WindowModel& now) {
    return !now.jobs.empty() && now.jobs.front().fraction > 0 && now.jobs.front().fraction < 1;
  };
  const Job job = window.wait_until(is_under_way).jobs.front();
  EXPECT_EQ(job.title, "Importing film.mp4");
  window.press(intent::CancelJob{job.id});
  const WindowModel& stopped = window.wait_until([](const WindowModel& now) { return now.jobs.empty(); });
  EXPECT_TRUE(has_toast(window.look(), "nothing of it is in the library"));
  EXPECT_TRUE(stopped.swings.empty());
  EXPECT_THAT(files_in(places.library()), testing::IsEmpty());

  window.press(intent::ImportFile{film.string()});
  const WindowModel& kept = window.wait_until([](const WindowModel& now) { return !now.swings.empty(); });
  ASSERT_EQ(kept.swings.size(), 1U);
  EXPECT_TRUE(has_toast(kept, "It is in the library"));
  EXPECT_TRUE(kept.swings[0].thumbnail);
}

}  // namespace
}  // namespace posecoach
