#include "capture/picture_folder.h"

#include <algorithm>
#include <vector>

#include "core/base/assert.h"
#include "core/image/image_codec.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Cuts the leading digits off `text`, without zeros in front.
std::string_view take_number(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return digits;
}

bool is_picture(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

class PictureFolder : public FrameSource {
 public:
  PictureFolder(const fs::path& folder, std::vector<fs::path> files, const Image& first, double rate)
      : files_(std::move(files)), seconds_per_picture_(1 / rate) {
    info_ = {folder.string(), first.width, first.height, rate, files_.size()};
  }

  const FrameSourceInfo& info() const override { return info_; }

  Result<std::optional<Frame>> next(std::stop_token stop) override {
    if (stop.stop_requested()) return fail(ErrorCode::Cancelled, "interrupted while reading " + info_.name);
    if (next_ == files_.size()) return std::nullopt;
    const fs::path& file = files_[next_];
    auto image = read_image(file);
    if (!image) return tl::unexpected(image.error());
    if (image->width != info_.width || image->height != info_.height)
      return fail(ErrorCode::Malformed, file.string() + " is " + size_text(image->width, image->height) +
                                            ", but the folder's first picture is " +
                                            size_text(info_.width, info_.height));
    Frame frame;
    frame.index = next_;
    frame.time = media_time_from_seconds(static_cast<double>(next_) * seconds_per_picture_);
    frame.image = std::make_shared<const Image>(std::move(*image));
    ++next_;
    return frame;
  }

 private:
  static std::string size_text(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height) + " pixels";
  }

  FrameSourceInfo info_;
  std::vector<fs::path> files_;
  double seconds_per_picture_;
  std::size_t next_ = 0;
};

}  // namespace

bool comes_before(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a;
  const std::string_view whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a[0]) && is_digit(b[0])) {
      const std::string_view number_a = take_number(a);
      const std::string_view number_b = take_number(b);
      if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
      if (number_a != number_b) return number_a < number_b;
      continue;
    }
    if (a[0] != b[0]) return a[0] < b[0];
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;  // 007 and 7
}

Result<std::unique_ptr<FrameSource>> open_picture_folder(const fs::path& folder,
                                                         const PictureFolderOptions& options) {
  POSECOACH_ASSERT(options.pictures_per_second > 0);
  std::error_code reason;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, reason), end; !reason && entry != end; entry.increment(reason))
    if (std::error_code ignored; is_picture(entry->path()) && entry->is_regular_file(ignored))
      files.push_back(entry->path());
  if (reason) {
    const bool missing = reason == std::errc::no_such_file_or_directory;
    return fail(missing ? ErrorCode::NotFound : ErrorCode::Unreadable,
                "cannot read the folder " + folder.string() + ": " + reason.message());
  }
  if (files.empty())
    return fail(ErrorCode::Incomplete, "there are no pictures (.png, .jpg) in the folder " + folder.string());
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return comes_before(a.filename().native(), b.filename().native());
  });
  const auto first = read_image(files.front());
  if (!first) return tl::unexpected(first.error());
  return std::make_unique<PictureFolder>(folder, std::move(files), *first, options.pictures_per_second);
}

}  // namespace posecoach
