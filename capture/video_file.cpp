#include "capture/video_file.h"

#include "capture/film_decoder.h"
#include "capture/film_picture.h"
#include "core/base/log.h"

namespace posecoach {
namespace {

class VideoFile : public FrameSource {
 public:
  VideoFile(std::string name, std::unique_ptr<FilmDecoder> decoder)
      : decoder_(std::move(decoder)), pictures_(decoder_->facts().orientation) {
    info_.name = std::move(name);
    info_.nominal_fps = decoder_->facts().nominal_fps;
    info_.frame_count = decoder_->facts().frame_count;
  }

  // The first picture is decoded here: it tells the size, and whether this is a film at all.
  Result<void> begin() {
    auto frame = decode();
    if (!frame) return tl::unexpected(frame.error());
    if (!*frame) return fail(ErrorCode::Malformed, info_.name + ": not one picture in it can be decoded");
    info_.width = (*frame)->image->width;
    info_.height = (*frame)->image->height;
    first_ = std::move(*frame);
    return {};
  }

  const FrameSourceInfo& info() const override { return info_; }

  Result<std::optional<Frame>> next(std::stop_token stop) override {
    if (stop.stop_requested()) return fail(ErrorCode::Cancelled, "interrupted while reading " + info_.name);
    if (first_) return std::exchange(first_, std::nullopt);
    return decode();
  }

  std::string damage() const override {
    if (!decoder_->is_damaged() || count_ == 0) return {};
    return std::filesystem::path(info_.name).filename().string() + what_is_wrong() +
           ". Copy it from where it was recorded once more, or choose another film.";
  }

 private:
  Result<std::optional<Frame>> decode() {
    const auto decoded = decoder_->next();
    if (!decoded) {
      tell_about_damage();
      return std::nullopt;
    }
    auto image = pictures_.make(*decoded->frame);
    if (!image) return fail(image.error().code, info_.name + ": " + image.error().message);
    Frame frame;
    frame.index = count_++;
    frame.time = decoded->time;
    frame.image = std::make_shared<const Image>(std::move(*image));
    return frame;
  }

  void tell_about_damage() {
    if (!decoder_->is_damaged() || count_ == 0 || std::exchange(told_, true)) return;
    log::warning(info_.name + what_is_wrong());
  }

  std::string what_is_wrong() const {
    if (!decoder_->is_cut_off()) return " is damaged: some of its pictures are broken or missing";
    std::string words = " is cut off: " + std::to_string(count_);
    if (info_.frame_count) words += " of " + std::to_string(*info_.frame_count);
    return words + " pictures could be read";
  }

  FrameSourceInfo info_;
  std::unique_ptr<FilmDecoder> decoder_;
  FilmPictureMaker pictures_;
  std::optional<Frame> first_;
  std::size_t count_ = 0;
  bool told_ = false;
};

}  // namespace

Result<std::unique_ptr<FrameSource>> open_video_file(const std::filesystem::path& path) {
  auto decoder = FilmDecoder::open(path);
  if (!decoder) return tl::unexpected(decoder.error());
  auto film = std::make_unique<VideoFile>(path.string(), std::move(*decoder));
  if (const auto begun = film->begin(); !begun) return tl::unexpected(begun.error());
  return film;
}

}  // namespace posecoach
