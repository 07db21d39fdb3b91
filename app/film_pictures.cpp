#include "app/film_pictures.h"

#include <map>
#include <utility>

#include "capture/video_file.h"
#include "core/image/image_codec.h"

namespace posecoach {
namespace {

class FilmPictures : public PictureStore {
 public:
  FilmPictures(std::filesystem::path film, std::vector<MediaTime> times, std::unique_ptr<FrameSource> source,
               const FilmPicturesOptions& options)
      : film_(std::move(film)), times_(std::move(times)), source_(std::move(source)), options_(options) {}

  std::size_t count() const override { return times_.size(); }
  MediaTime time(std::size_t index) const override { return times_[index]; }

  Result<std::shared_ptr<const Image>> picture(std::size_t index) override {
    if (const auto known = jpegs_.find(index); known != jpegs_.end()) {
      Result<Image> image = decode_image(known->second, film_.string());
      if (!image) return tl::unexpected(image.error());
      return std::make_shared<const Image>(*std::move(image));
    }
    if (index < next_ || !source_) {
      Result<std::unique_ptr<FrameSource>> again = open_video_file(film_);
      if (!again) return tl::unexpected(again.error());
      source_ = *std::move(again);
      next_ = 0;
    }
    for (;;) {
      Result<std::optional<Frame>> frame = source_->next({});
      if (!frame) return tl::unexpected(frame.error());
      if (!*frame)
        return fail(ErrorCode::Incomplete,
                    film_.string() + ": it ends before picture " + std::to_string(index));
      const std::size_t now = next_++;
      keep(now, *(*frame)->image, index);
      if (now == index) return (*frame)->image;
    }
  }

 private:
  // What is farthest from where the user looks goes first.
  void keep(std::size_t at, const Image& image, std::size_t wanted) {
    if (jpegs_.contains(at)) return;
    std::string jpeg = encode_jpeg(image, options_.quality);
    bytes_ += jpeg.size();
    jpegs_[at] = std::move(jpeg);
    const auto distance = [&](std::size_t index) { return index < wanted ? wanted - index : index - wanted; };
    while (bytes_ > options_.most_bytes && jpegs_.size() > 1) {
      const auto first = jpegs_.begin(), last = std::prev(jpegs_.end());
      const auto farthest = distance(first->first) >= distance(last->first) ? first : last;
      bytes_ -= farthest->second.size();
      jpegs_.erase(farthest);
    }
  }

  std::filesystem::path film_;
  std::vector<MediaTime> times_;
  std::unique_ptr<FrameSource> source_;
  FilmPicturesOptions options_;
  std::size_t next_ = 0;  // that the source gives
  std::map<std::size_t, std::string> jpegs_;
  std::size_t bytes_ = 0;
};

}  // namespace

Result<std::shared_ptr<PictureStore>> open_film_pictures(const std::filesystem::path& film,
                                                         std::vector<MediaTime> times,
                                                         const FilmPicturesOptions& options) {
  Result<std::unique_ptr<FrameSource>> source = open_video_file(film);
  if (!source) return tl::unexpected(source.error());
  return std::make_shared<FilmPictures>(film, std::move(times), *std::move(source), options);
}

}  // namespace posecoach
