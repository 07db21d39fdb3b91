#include "core/motion/openpose_reader.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/motion/text_scanner.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kBody25Joints = 25;
constexpr std::size_t kMostPeople = 1000;
constexpr std::size_t kMostBytes = std::size_t{1} << 24;

struct Pair {
  std::size_t openpose;
  Landmark landmark;
};
constexpr std::array kPairs = {
    Pair{0, Landmark::Nose},        Pair{2, Landmark::RightShoulder},   Pair{3, Landmark::RightElbow},
    Pair{4, Landmark::RightWrist},  Pair{5, Landmark::LeftShoulder},    Pair{6, Landmark::LeftElbow},
    Pair{7, Landmark::LeftWrist},   Pair{9, Landmark::RightHip},        Pair{10, Landmark::RightKnee},
    Pair{11, Landmark::RightAnkle}, Pair{12, Landmark::LeftHip},        Pair{13, Landmark::LeftKnee},
    Pair{14, Landmark::LeftAnkle},  Pair{15, Landmark::RightEye},       Pair{16, Landmark::LeftEye},
    Pair{17, Landmark::RightEar},   Pair{18, Landmark::LeftEar},        Pair{19, Landmark::LeftFootIndex},
    Pair{21, Landmark::LeftHeel},   Pair{22, Landmark::RightFootIndex}, Pair{24, Landmark::RightHeel}};

Result<ImageKeypoints> person_from(const nlohmann::json& person) {
  const auto found = person.is_object() ? person.find("pose_keypoints_2d") : person.end();
  if (found == person.end() || !found->is_array())
    return fail(ErrorCode::Malformed, "a person without \"pose_keypoints_2d\"");
  if (found->size() != 3 * kBody25Joints)
    return fail(ErrorCode::Unsupported, "a person of " + std::to_string(found->size()) +
                                            " numbers; only BODY_25 is supported, which has 75");
  std::array<double, 3 * kBody25Joints> numbers{};
  if (const auto read = json_numbers(*found, numbers.data(), numbers.size(), "\"pose_keypoints_2d\""); !read)
    return tl::unexpected(read.error());
  ImageKeypoints keypoints;
  for (const auto& [openpose, landmark] : kPairs) {
    const double* row = &numbers[3 * openpose];
    keypoints[landmark] = {{row[0], row[1]}, std::clamp(row[2], 0.0, 1.0)};
  }
  return keypoints;
}

double confidence_of(const ImageKeypoints& person) {
  double sum = 0;
  for (const ImageKeypoint& keypoint : person) sum += keypoint.visibility;
  return sum;
}

// Mean over what both have; far when they have nothing in common.
double distance_px(const ImageKeypoints& a, const ImageKeypoints& b) {
  double sum = 0, weight = 0;
  for (std::size_t l = 0; l < kLandmarkCount; ++l) {
    const double w = a[l].visibility * b[l].visibility;
    sum += w * glm::distance(a[l].position_px, b[l].position_px);
    weight += w;
  }
  return weight > 0 ? sum / weight : 1e9;
}

std::size_t frame_number(const std::string& stem, std::size_t otherwise) {
  const std::size_t end = stem.find_last_of("0123456789");
  if (end == std::string::npos) return otherwise;
  std::size_t begin = end;
  while (begin > 0 && stem[begin - 1] >= '0' && stem[begin - 1] <= '9') --begin;
  const auto number = parse_integer(std::string_view(stem).substr(begin, end + 1 - begin));
  return number && *number >= 0 ? static_cast<std::size_t>(*number) : otherwise;
}

}  // namespace

Result<std::vector<ImageKeypoints>> read_openpose_json(std::string_view file_name, std::string_view text) {
  std::vector<ImageKeypoints> people;
  bool has_people = false;
  JsonHandlers handlers;
  handlers.on_field = [&](const JsonPiece& piece) -> Result<void> {
    if (piece.key != "people") return {};
    has_people = true;
    if (!piece.value.is_array()) return fail(ErrorCode::Malformed, "\"people\" needs a list");
    return {};
  };
  handlers.on_element = [&](const JsonPiece& piece) -> Result<void> {
    if (piece.key != "people") return {};
    if (people.size() >= kMostPeople) return fail(ErrorCode::Unsupported, "more than 1000 people");
    auto person = person_from(piece.value);
    if (!person) return tl::unexpected(person.error());
    people.push_back(*person);
    return {};
  };
  if (const auto walked = walk_json(file_name, text, handlers); !walked)
    return tl::unexpected(walked.error());
  if (!has_people)
    return fail(ErrorCode::Malformed,
                std::string(file_name) + ":1: this is no OpenPose file: there are no \"people\" in it");
  return people;
}

Result<ImageTrack> read_openpose_folder(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (to_lower(it->path().extension().string()) == ".json") files.push_back(it->path());
  if (error)
    return fail(ErrorCode::NotFound, "cannot read the folder " + folder.string() + ": " + error.message());
  if (files.empty())
    return fail(ErrorCode::Incomplete, folder.string() + ": there is no OpenPose .json in this folder");
  std::sort(files.begin(), files.end());
  ImageTrack track{folder.string(), {}};
  std::optional<ImageKeypoints> followed;
  for (const fs::path& file : files) {
    const auto text = read_file(file, kMostBytes);
    if (!text) return tl::unexpected(text.error());
    const auto people = read_openpose_json(file.string(), *text);
    if (!people) return tl::unexpected(people.error());
    ImageObservation observation{frame_number(file.stem().string(), track.frames.size()), {}};
    if (!people->empty())
      observation.person =
          *std::max_element(people->begin(), people->end(), [&](const auto& a, const auto& b) {
            return followed ? distance_px(a, *followed) > distance_px(b, *followed)
                            : confidence_of(a) < confidence_of(b);
          });
    if (observation.person) followed = observation.person;
    track.frames.push_back(std::move(observation));
  }
  return track;
}

}  // namespace posecoach
