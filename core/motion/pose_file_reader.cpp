#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/base/index.h"
#include "core/base/json_text.h"
#include "core/motion/pose_file.h"
#include "core/motion/rig.h"

namespace posecoach {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kSchema = "posecoach.pose/1";
constexpr std::size_t kMostJoints = 4096;

// A frame as it stands in the file; whether it fits the joints is known at the end only.
struct RawFrame {
  std::size_t line = 0;
  std::size_t frame_index = 0;
  MediaTime time;
  bool is_found = false;
  std::vector<std::array<double, 3>> image;
  std::vector<std::array<double, 4>> world;
  std::vector<std::array<double, 4>> rotations;
  Vec3 root;
};

template <std::size_t kWidth>
Result<std::vector<std::array<double, kWidth>>> rows_in(const Json& object, const char* key) {
  std::vector<std::array<double, kWidth>> rows;
  const auto found = object.find(key);
  if (found == object.end() || found->is_null()) return rows;
  if (!found->is_array() || found->size() > kMostJoints)
    return fail(ErrorCode::Malformed, std::string("\"") + key + "\" needs a list, one entry a joint");
  for (const Json& row : *found) {
    rows.emplace_back();
    const std::string what = std::string("\"") + key + "\"[" + std::to_string(rows.size() - 1) + "]";
    if (const auto read = json_numbers(row, rows.back().data(), kWidth, what); !read)
      return tl::unexpected(read.error());
  }
  return rows;
}

class PoseJsonReader {
 public:
  explicit PoseJsonReader(std::string_view file_name) : file_name_(file_name) {}

  Result<std::variant<PoseTrack, Motion>> run(std::string_view text) {
    JsonHandlers handlers;
    handlers.on_field = [this](const JsonPiece& piece) { return field(piece.key, piece.value); };
    handlers.on_element = [this](const JsonPiece& piece) -> Result<void> {
      if (piece.key == "frames") return frame(piece.value, piece.line);
      if (piece.key == "joints") return joint_name(piece.value);
      if (piece.key == "skeleton") return skeleton_joint(piece.value);
      return {};
    };
    if (const auto walked = walk_json(file_name_, text, handlers); !walked)
      return tl::unexpected(walked.error());
    if (!has_schema_) return failure("there is no \"schema\": \"" + std::string(kSchema) + "\" in it");
    if (!has_frames_) return failure("there are no \"frames\" in it");
    if (has_skeleton_) return motion();
    return track();
  }

 private:
  tl::unexpected<Error> failure(const std::string& message, ErrorCode code = ErrorCode::Malformed) const {
    return fail(code, std::string(file_name_) + ": " + message);
  }

  tl::unexpected<Error> failure_in(const RawFrame& raw, const std::string& message) const {
    return fail(ErrorCode::Malformed,
                std::string(file_name_) + ":" + std::to_string(raw.line) + ": " + message);
  }

  Result<void> field(std::string_view key, const Json& value) {
    if (key == "schema") {
      if (!value.is_string() || value.get<std::string>() != kSchema)
        return fail(ErrorCode::Malformed, "the schema is not \"" + std::string(kSchema) + "\"");
      has_schema_ = true;
    } else if (key == "source" && value.is_string()) {
      track_.source = value.get<std::string>();
    } else if (key == "width" || key == "height") {
      const double size = value.is_number() ? value.get<double>() : -1;
      if (!(size >= 0 && size <= 1e5))
        return fail(ErrorCode::Malformed, "\"" + std::string(key) + "\" needs a number of pixels");
      (key == "width" ? track_.width : track_.height) = static_cast<int>(size);
    } else if (key == "frames" || key == "skeleton" || key == "joints") {
      if (!value.is_array()) return fail(ErrorCode::Malformed, "\"" + std::string(key) + "\" needs a list");
      if (key == "frames") has_frames_ = true;
      if (key == "skeleton") has_skeleton_ = true;
    }
    return {};
  }

  Result<void> joint_name(const Json& name) {
    if (!name.is_string()) return fail(ErrorCode::Malformed, "\"joints\" needs names");
    if (names_.size() >= kMostJoints) return fail(ErrorCode::Unsupported, "more than 4096 joints");
    names_.push_back(name.get<std::string>());
    return {};
  }

  Result<void> skeleton_joint(const Json& element) {
    if (joints_.size() >= kMostJoints) return fail(ErrorCode::Unsupported, "more than 4096 joints");
    Joint joint;
    const auto name = json_string(element, "name");
    if (!name) return tl::unexpected(name.error());
    joint.name = *name;
    const auto offset = json_vector(element, "offset_m");
    if (!offset) return tl::unexpected(offset.error());
    joint.offset = *offset;
    const auto parent = element.find("parent");
    if (parent != element.end() && parent->is_string()) {
      for (std::size_t j = 0; j < joints_.size(); ++j)
        if (joints_[j].name == parent->get<std::string>()) joint.parent = static_cast<int>(j);
      if (joint.parent == kNoJoint)
        return fail(ErrorCode::Malformed, "the parent of \"" + joint.name + "\" does not come before it");
    }
    if (const auto role = element.find("role"); role != element.end() && role->is_string()) {
      joint.role = humanoid_joint_from_string(role->get<std::string>());
      if (!joint.role) return fail(ErrorCode::Malformed, "\"" + joint.name + "\" has an unknown role");
      has_roles_ = true;
    }
    joints_.push_back(std::move(joint));
    return {};
  }

  Result<void> frame(const Json& element, std::size_t line) {
    RawFrame raw;
    raw.line = line;
    const auto seconds = json_number(element, "time_s");
    if (!seconds) return tl::unexpected(seconds.error());
    if (std::abs(*seconds) > 1e9) return fail(ErrorCode::Malformed, "\"time_s\" is not a usable time");
    raw.time = media_time_from_seconds(*seconds);
    if (!frames_.empty() && raw.time <= frames_.back().time)
      return fail(ErrorCode::Malformed,
                  "the time of frame " + std::to_string(frames_.size()) + " does not increase");
    raw.frame_index = frames_.size();
    if (const auto at = element.find("index"); at != element.end()) {
      if (!at->is_number_unsigned()) return fail(ErrorCode::Malformed, "\"index\" needs a frame number");
      raw.frame_index = at->get<std::size_t>();
    }
    const auto found = element.find("found");
    if (found == element.end() || !found->is_boolean())
      return fail(ErrorCode::Malformed, "\"found\" needs true or false");
    raw.is_found = found->get<bool>();
    auto image = rows_in<3>(element, "image");
    if (!image) return tl::unexpected(image.error());
    auto world = rows_in<4>(element, "world");
    if (!world) return tl::unexpected(world.error());
    auto rotations = rows_in<4>(element, "rotations");
    if (!rotations) return tl::unexpected(rotations.error());
    raw.image = *std::move(image);
    raw.world = *std::move(world);
    raw.rotations = *std::move(rotations);
    if (element.contains("root_m")) {
      const auto root = json_vector(element, "root_m");
      if (!root) return tl::unexpected(root.error());
      raw.root = *root;
    }
    frames_.push_back(std::move(raw));
    return {};
  }

  Result<std::variant<PoseTrack, Motion>> track() {
    if (names_.size() != kLandmarkCount)
      return failure("\"joints\" needs the " + std::to_string(kLandmarkCount) +
                     " landmarks' names, and has " + std::to_string(names_.size()));
    for (std::size_t l = 0; l < kLandmarkCount; ++l)
      if (names_[l] != to_string(static_cast<Landmark>(l)))
        return failure("\"joints\" are not the landmarks in their order: number " + std::to_string(l) +
                       " should be " + std::string(to_string(static_cast<Landmark>(l))));
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      const RawFrame& raw = frames_[f];
      PoseObservation observation{raw.frame_index, raw.time, {}};
      if (raw.is_found) {
        if (raw.image.size() != kLandmarkCount || raw.world.size() != kLandmarkCount)
          return failure_in(raw, "the frame does not have " + std::to_string(kLandmarkCount) +
                                     " joints in \"image\" and \"world\"");
        SeenPerson person;
        for (std::size_t l = 0; l < kLandmarkCount; ++l) {
          const auto& [x, y, visibility] = raw.image[l];
          person.image[l] = {{x, y}, visibility};
          const auto& [wx, wy, wz, world_visibility] = raw.world[l];
          person.world[l] = {{wx, wy, wz}, world_visibility};
        }
        observation.person = person;
      }
      track_.frames.push_back(std::move(observation));
    }
    return std::move(track_);
  }

  Result<std::variant<PoseTrack, Motion>> motion() {
    if (!has_roles_) {
      const auto roles = map_roles_of_tree();
      for (std::size_t j = 0; j < roles.size(); ++j) joints_[j].role = roles[j];
    }
    Result<Skeleton> skeleton = Skeleton::make(std::move(joints_));
    if (!skeleton) return failure(skeleton.error().message, skeleton.error().code);
    const auto joint_count = index(skeleton->size());
    if (frames_.empty()) return failure("the motion has no frames", ErrorCode::Incomplete);
    const bool has_rotations = !frames_.front().rotations.empty();
    std::vector<MediaTime> times;
    std::vector<Vec3> roots, positions;
    std::vector<Quat> rotations;
    std::vector<double> confidence;
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      const RawFrame& raw = frames_[f];
      if (raw.world.size() != joint_count || raw.rotations.size() != (has_rotations ? joint_count : 0))
        return failure_in(
            raw, "the frame does not have the skeleton's " + std::to_string(joint_count) + " joints");
      times.push_back(raw.time);
      roots.push_back(raw.root);
      for (const auto& [x, y, z, seen] : raw.world) {
        positions.push_back(raw.root + Vec3(x, -y, -z));
        confidence.push_back(seen);
      }
      for (const auto& [w, x, y, z] : raw.rotations) {
        const Quat turn(w, x, y, z);
        if (std::abs(glm::length(turn) - 1) > 1e-3)
          return failure_in(raw, "the frame has rotations that are not of unit length");
        rotations.push_back(glm::normalize(turn));
      }
    }
    auto made = has_rotations ? Motion::from_rotations(*std::move(skeleton), std::move(times),
                                                       std::move(roots), std::move(rotations))
                              : Motion::from_positions(*std::move(skeleton), std::move(times),
                                                       std::move(positions), std::move(confidence));
    if (!made) return failure(made.error().message, made.error().code);
    return *std::move(made);
  }

  // Only a valid tree can be looked through; an invalid one is refused right after.
  std::vector<std::optional<HumanoidJoint>> map_roles_of_tree() const {
    if (!Skeleton::make(joints_)) return {};
    return map_roles(joints_);
  }

  std::string_view file_name_;
  bool has_schema_ = false, has_frames_ = false, has_skeleton_ = false, has_roles_ = false;
  PoseTrack track_;
  std::vector<std::string> names_;
  std::vector<Joint> joints_;
  std::vector<RawFrame> frames_;
};

}  // namespace

Result<std::variant<PoseTrack, Motion>> read_pose_json(std::string_view file_name, std::string_view text) {
  return PoseJsonReader(file_name).run(text);
}

Result<PoseTrack> read_pose_track(const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  auto content = read_pose_json(path.string(), *text);
  if (!content) return tl::unexpected(content.error());
  if (!std::holds_alternative<PoseTrack>(*content))
    return fail(ErrorCode::Unsupported, path.string() + ": this is a motion, not what was seen in a film");
  return std::get<PoseTrack>(*std::move(content));
}

}  // namespace posecoach
