// The small picture of an imported film shows the golfer as that of a swing recorded live does.
#include <gtest/gtest.h>

#include "app/library/stored_swing.h"
#include "capture/video_writer.h"
#include "core/image/image_codec.h"
#include "tests/app/window/driven_window.h"
#include "tests/support/plain_swing.h"

namespace posecoach {
namespace {

double mean_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
  return sum / static_cast<double>(a.rgb.size());
}

Image thumbnail_of(Library& library, const std::function<Result<void>(SwingDraft&)>& add) {
  SwingDraft draft = library.begin({}).value();
  const Result<void> added = add(draft);
  EXPECT_TRUE(added) << added.error().message;
  const Swing swing = library.keep(std::move(draft)).value();
  return read_image(swing.file("thumb").value()).value();
}

TEST(TopPicture, of_an_imported_film_is_cut_to_the_golfer_as_a_recorded_one) {
  const WindowPlaces places;
  const auto library = Library::open(places.library()).value();
  const auto swing = make_plain_swing("", 1.75);
  const std::filesystem::path film = places.folder("film.mp4");
  const auto first = swing->pictures->picture(0).value();
  {
    const auto writer = VideoWriter::open(film, {.width = first->width, .height = first->height}).value();
    for (std::size_t i = 0; i < swing->pictures->count(); ++i)
      ASSERT_TRUE(writer->write(*swing->pictures->picture(i).value(), swing->pictures->time(i)));
    ASSERT_TRUE(writer->finish());
  }
  const StoredAnswer answer{
      {film.string(), swing->student.motion, {}, SeenStudent{swing->track, swing->student}, 0},
      swing->pair,
      swing->student.body};
  const Image recorded = thumbnail_of(*library, [&](SwingDraft& draft) { return add_answer(draft, *swing); });
  const Image imported =
      thumbnail_of(*library, [&](SwingDraft& draft) { return add_top_picture(draft, answer, film); });
  const Image whole = thumbnail_of(*library, [&](SwingDraft& draft) { return add_picture(draft, *first); });
  ASSERT_EQ(imported.width, recorded.width);
  ASSERT_EQ(imported.height, recorded.height);
  // Films lose a little in compression.
  EXPECT_LT(mean_difference(imported, recorded), 4);
  EXPECT_GT(mean_difference(resized(whole, recorded.width, recorded.height), recorded), 10);
}

}  // namespace
}  // namespace posecoach
