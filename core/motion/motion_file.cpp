#include "core/motion/motion_file.h"

#include <fstream>
#include <optional>

#include "core/base/file.h"
#include "core/body/body_file.h"
#include "core/motion/asf_amc_reader.h"
#include "core/motion/bvh_motion.h"
#include "core/motion/c3d_reader.h"
#include "core/motion/pose_file.h"
#include "core/motion/text_scanner.h"
#include "core/motion/trc.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kKnownKinds =
    ".bvh, .asf with .amc, .c3d, .trc, .pose.json, or a folder of OpenPose JSON";

constexpr std::size_t kSearched = std::size_t{1} << 16;
// Hours of motion; what is read takes several times as much memory.
constexpr std::size_t kMostBytes = std::size_t{1} << 28;

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

bool begins_with_word(std::string_view text, std::string_view word) {
  return equals_ignoring_case(text.substr(0, word.size()), word);
}

// An .asf is a skeleton, an .amc a motion; both begin with comments and keywords after colons.
bool has_keyword(std::string_view text, std::string_view keyword) {
  return to_lower(text.substr(0, kSearched)).find(keyword) != std::string::npos;
}

// A header of one block that points to parameters with a known processor type.
bool looks_like_c3d(std::string_view bytes) {
  constexpr std::size_t kBlock = 512;
  if (bytes.size() < kBlock || bytes[0] < 1 || bytes[1] != 0x50) return false;
  const std::size_t processor = (static_cast<std::size_t>(bytes[0]) - 1) * kBlock + 3;
  return processor < bytes.size() && bytes[processor] >= 84 && bytes[processor] <= 86;
}

std::optional<MotionFormat> format_by_content(std::string_view bytes) {
  constexpr std::size_t kHead = 4096;
  const std::string_view head = trimmed(without_byte_order_mark(bytes.substr(0, kHead)));
  if (begins_with_word(head, "HIERARCHY")) return MotionFormat::Bvh;
  if (head.starts_with("PathFileType")) return MotionFormat::Trc;
  if (looks_like_c3d(bytes)) return MotionFormat::C3d;
  if (head.starts_with('{')) {
    if (bytes.find("\"posecoach.body/1\"") != std::string_view::npos) return MotionFormat::BodyFile;
    if (bytes.find("\"posecoach.pose/1\"") == std::string_view::npos) return std::nullopt;
    return bytes.find("\"skeleton\"") != std::string_view::npos ? MotionFormat::PoseMotion
                                                                : MotionFormat::PoseTrack;
  }
  if ((head.starts_with('#') || head.starts_with(':')) &&
      (has_keyword(bytes, ":fully-specified") || has_keyword(bytes, ":degrees") ||
       has_keyword(bytes, ":bonedata") || has_keyword(bytes, ":radians")))
    return MotionFormat::AsfAmc;
  return std::nullopt;
}

// For a file whose contents say nothing: its reader then says what is wrong with it.
std::optional<MotionFormat> format_by_name(const fs::path& path) {
  const std::string name = to_lower(path.filename().string());
  if (name.ends_with(".bvh")) return MotionFormat::Bvh;
  if (name.ends_with(".trc")) return MotionFormat::Trc;
  if (name.ends_with(".c3d")) return MotionFormat::C3d;
  if (name.ends_with(".amc") || name.ends_with(".asf")) return MotionFormat::AsfAmc;
  if (name.ends_with(".body.json")) return MotionFormat::BodyFile;
  if (name.ends_with(".pose.json")) return MotionFormat::PoseTrack;
  return std::nullopt;
}

// Films, too, are asked what they are: their beginning must do.
Result<std::string> read_beginning(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error))
    return fail(ErrorCode::NotFound, "cannot open " + path.string() + ": no such file");
  std::ifstream file(path, std::ios::binary);
  std::string bytes(kSearched, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file && !file.eof()) return fail(ErrorCode::Unreadable, "cannot read " + path.string());
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

bool is_picture(const fs::path& path) {
  const std::string ending = to_lower(path.extension().string());
  return ending == ".jpg" || ending == ".jpeg" || ending == ".png" || ending == ".bmp" || ending == ".webp";
}

Result<MotionFormat> format_of_folder(const fs::path& path) {
  bool has_json = false, has_pictures = false;
  std::error_code error;
  for (fs::directory_iterator it(path, error), end; !error && it != end; it.increment(error)) {
    has_json |= to_lower(it->path().extension().string()) == ".json";
    has_pictures |= is_picture(it->path());
  }
  if (error)
    return fail(ErrorCode::Unreadable, "cannot read the folder " + path.string() + ": " + error.message());
  if (has_json && !has_pictures) return MotionFormat::OpenPoseFolder;
  return fail(ErrorCode::Unsupported, path.string() + " is no folder of OpenPose JSON");
}

Result<MotionFormat> format_of(const fs::path& path, std::string_view bytes) {
  if (bytes.empty()) return fail(ErrorCode::Malformed, path.string() + ":1: the file is empty");
  auto format = format_by_content(bytes);
  if (!format) format = format_by_name(path);
  if (!format)
    return fail(ErrorCode::Unsupported,
                path.string() + " is no motion file that can be read (" + std::string(kKnownKinds) + ")");
  return *format;
}

struct Content {
  MotionFormat format;
  std::string bytes;
};

Result<Content> read_content(const fs::path& path) {
  // A film is told by its beginning, without being read whole.
  const auto format = motion_format(path);
  if (!format) return tl::unexpected(format.error());
  if (*format == MotionFormat::OpenPoseFolder) return Content{*format, {}};
  auto bytes = read_file(path, kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return Content{*format, *std::move(bytes)};
}

MotionProvenance without_layout(MotionFormat format, const Skeleton& skeleton) {
  MotionProvenance provenance;
  provenance.format = format;
  provenance.frame.rest_from_file.assign(static_cast<std::size_t>(skeleton.size()), Quat(1, 0, 0, 0));
  return provenance;
}

Result<MotionFile> with_format(MotionFormat format, Result<Motion> motion) {
  if (!motion) return tl::unexpected(motion.error());
  MotionProvenance provenance = without_layout(format, motion->skeleton());
  return MotionFile{*std::move(motion), std::move(provenance)};
}

Result<MotionFile> markers_of(MotionFormat format, const std::string& name, Result<MarkerTrack> track) {
  if (!track) return tl::unexpected(track.error());
  return with_format(format, motion_from_markers(name, *std::move(track)));
}

Result<MotionFile> pose_motion(const std::string& name, std::string_view text) {
  auto content = read_pose_json(name, text);
  if (!content) return tl::unexpected(content.error());
  if (std::holds_alternative<PoseTrack>(*content))
    return fail(ErrorCode::Unsupported,
                name + ": this file says what was seen in a film; it is no motion in the world yet");
  return with_format(MotionFormat::PoseMotion, std::get<Motion>(*std::move(content)));
}

}  // namespace

Result<MotionFormat> motion_format(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return format_of_folder(path);
  const auto beginning = read_beginning(path);
  if (!beginning) return tl::unexpected(beginning.error());
  // Where in a JSON file its schema stands is free.
  if (!trimmed(without_byte_order_mark(*beginning)).starts_with('{') || beginning->size() < kSearched)
    return format_of(path, *beginning);
  const auto bytes = read_file(path, kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return format_of(path, *bytes);
}

Result<MotionFile> read_motion_file(const fs::path& path, const MotionReadOptions& options) {
  const auto content = read_content(path);
  if (!content) return tl::unexpected(content.error());
  const std::string name = path.string();
  switch (content->format) {
    case MotionFormat::Bvh:
      return read_bvh(name, content->bytes);
    case MotionFormat::AsfAmc:
      return read_amc_file(path, content->bytes, options.amc_frames_per_second);
    case MotionFormat::C3d:
      return markers_of(MotionFormat::C3d, name, read_c3d(name, content->bytes));
    case MotionFormat::Trc:
      return markers_of(MotionFormat::Trc, name, read_trc(name, content->bytes));
    case MotionFormat::PoseMotion:
    case MotionFormat::PoseTrack:
      return pose_motion(name, content->bytes);
    case MotionFormat::BodyFile:
      return fail(ErrorCode::Incomplete, name + ": this is a body without a motion");
    case MotionFormat::OpenPoseFolder:
      return fail(ErrorCode::Unsupported,
                  name +
                      ": a folder of OpenPose JSON has 2D joints only, and here a 3D motion is needed; "
                      "analyse the film itself instead");
  }
  return fail(ErrorCode::Internal, name + ": unknown kind of file");
}

Result<SkeletonFile> read_skeleton_file(const fs::path& path, const MotionReadOptions& options) {
  const auto content = read_content(path);
  if (!content) return tl::unexpected(content.error());
  const std::string name = path.string();
  if (content->format == MotionFormat::Bvh) return read_bvh_skeleton(name, content->bytes);
  if (content->format == MotionFormat::AsfAmc && is_asf(content->bytes))
    return read_asf_skeleton(name, content->bytes);
  if (content->format == MotionFormat::BodyFile) {
    auto body = body_from_json(content->bytes, name);
    if (!body) return tl::unexpected(body.error());
    MotionProvenance provenance = without_layout(MotionFormat::BodyFile, *body);
    return SkeletonFile{*std::move(body), std::move(provenance)};
  }
  auto file = read_motion_file(path, options);
  if (!file) return tl::unexpected(file.error());
  return SkeletonFile{file->motion.skeleton(), std::move(file->provenance)};
}

Result<void> check_motion_file_name(const fs::path& path) {
  const std::string name = to_lower(path.filename().string());
  for (const char* ending : {".bvh", ".trc", ".pose.json"})
    if (name.ends_with(ending)) return {};
  return fail(ErrorCode::InvalidArgument,
              path.string() +
                  ": a motion is written as .bvh, .trc or .pose.json; give the file one of these endings");
}

Result<void> write_motion_file(const fs::path& path, const Motion& motion,
                               const MotionProvenance& provenance) {
  if (const Result<void> named = check_motion_file_name(path); !named) return named;
  const std::string name = to_lower(path.filename().string());
  if (name.ends_with(".bvh")) {
    const auto text = bvh_from_motion(motion, provenance);
    if (!text) return fail(text.error().code, path.string() + ": " + text.error().message);
    return write_file_atomically(path, *text);
  }
  if (name.ends_with(".trc"))
    return write_file_atomically(path, trc_from_motion(path.filename().string(), motion));
  return write_file_atomically(path, pose_json_from_motion(motion, path.filename().string()));
}

}  // namespace posecoach
