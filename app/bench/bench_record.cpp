#include "app/bench/bench.h"
#include "capture/picture_encoder.h"
#include "capture/simulated_student.h"

namespace posecoach {

// What the recorder's thread does for a frame of a camera: 60 a second leave 16.7 ms.
Result<void> bench_record(const BenchOptions&, std::vector<BenchRow>& rows) {
  const auto student = SimulatedStudent::make({});
  if (!student) return tl::unexpected(student.error());
  std::vector<Image> pictures;
  for (int frame = 60; frame < 90; ++frame) pictures.push_back((*student)->draw(frame));
  for (const FilmCodec codec : {FilmCodec::H264, FilmCodec::Jpeg}) {
    const auto encoder = make_picture_encoder(codec, pictures[0].width, pictures[0].height, 60);
    if (!encoder && encoder.error().code == ErrorCode::Unsupported) continue;
    if (!encoder) return tl::unexpected(encoder.error());
    std::size_t next = 0;
    Result<void> failed;
    rows.push_back(measure(
        std::string("recording a picture, 1280x720, ") + (codec == FilmCodec::H264 ? "H.264" : "JPEG"), 90,
        [&] {
          const auto picture = (*encoder)->encode(pictures[next++ % pictures.size()]);
          if (!picture) failed = tl::unexpected(picture.error());
        }));
    if (!failed) return failed;
  }
  return {};
}

}  // namespace posecoach
