#include "core/body/body_file.h"

#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/body/body_measurement.h"
#include "core/body/landmark_body.h"

namespace posecoach {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::string_view kSchema = "posecoach.body/1";

std::optional<HumanoidJoint> role_by_name(const std::string& name) {
  if (auto role = humanoid_joint_from_string(name)) return role;
  for (const LandmarkJoint& joint : landmark_body_joints())
    if (joint.name == name) return joint.role;
  return std::nullopt;
}

// `parent`: null, a name, or a number that is the parent's place in the list.
Result<int> parent_index(const nlohmann::json& parent, const std::vector<Joint>& before) {
  if (parent.is_null()) return kNoJoint;
  if (parent.is_number_integer()) {
    const auto number = parent.get<long long>();
    if (number < 0) return kNoJoint;
    if (number < static_cast<long long>(before.size())) return static_cast<int>(number);
  }
  if (parent.is_string())
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i].name == parent.get<std::string>()) return static_cast<int>(i);
  return fail(ErrorCode::Malformed, "the parent of a joint is not listed before it");
}

Result<Joint> joint_from(const nlohmann::json& entry, const std::vector<Joint>& before) {
  Joint joint;
  const auto name = json_string(entry, "name");
  if (!name) return tl::unexpected(name.error());
  joint.name = *name;
  const auto parent = entry.find("parent");
  if (parent == entry.end()) return fail(ErrorCode::Malformed, "\"" + joint.name + "\" has no \"parent\"");
  const auto index = parent_index(*parent, before);
  if (!index) return tl::unexpected(index.error());
  joint.parent = *index;
  const auto offset = json_vector(entry, "offset_m");
  if (!offset) return tl::unexpected(offset.error());
  joint.offset = *offset;
  const auto role = entry.find("role");
  if (role == entry.end() || role->is_null()) {
    joint.role = role_by_name(joint.name);
    return joint;
  }
  if (role->is_string()) joint.role = humanoid_joint_from_string(role->get<std::string>());
  if (!joint.role) return fail(ErrorCode::Malformed, "\"" + joint.name + "\" has an unknown role");
  return joint;
}

}  // namespace

std::string body_to_json(const Skeleton& body) {
  Json file = {{"schema", kSchema}, {"height_m", stature(body)}, {"joints", Json::array()}};
  for (const Joint& joint : body.joints()) {
    Json entry = {{"name", joint.name}};
    entry["parent"] = joint.parent == kNoJoint ? Json() : Json(body.joint(joint.parent).name);
    if (joint.role) entry["role"] = to_string(*joint.role);
    entry["offset_m"] = {joint.offset.x, joint.offset.y, joint.offset.z};
    file["joints"].push_back(std::move(entry));
  }
  return file.dump(1) + "\n";
}

Result<Skeleton> body_from_json(std::string_view json, std::string_view name) {
  constexpr std::size_t kMostJoints = 4096;
  const std::string file(name);
  std::vector<Joint> joints;
  std::vector<std::size_t> lines;
  bool has_schema = false;
  JsonHandlers handlers;
  handlers.on_field = [&](const JsonPiece& piece) -> Result<void> {
    if (piece.key != "schema") return {};
    has_schema = piece.value.is_string() && piece.value.get<std::string>() == kSchema;
    if (!has_schema) return fail(ErrorCode::Malformed, "the schema is not " + std::string(kSchema));
    return {};
  };
  handlers.on_element = [&](const JsonPiece& piece) -> Result<void> {
    if (piece.key != "joints") return {};
    if (joints.size() >= kMostJoints) return fail(ErrorCode::Unsupported, "more than 4096 joints");
    auto joint = joint_from(piece.value, joints);
    if (!joint) return tl::unexpected(joint.error());
    joints.push_back(*std::move(joint));
    lines.push_back(piece.line);
    return {};
  };
  if (const auto walked = walk_json(name, json, handlers); !walked) return tl::unexpected(walked.error());
  if (!has_schema)
    return fail(ErrorCode::Malformed,
                file + ":1: this is not a body file: it has no \"schema\": \"" + std::string(kSchema) + "\"");
  if (joints.empty()) return fail(ErrorCode::Malformed, file + ":1: the body has no \"joints\"");
  auto body = Skeleton::make(joints);
  if (body) return body;
  // A name or role that stands twice, a second root: told at the joint that brings it in.
  std::size_t count = 1;
  while (Skeleton::make({joints.begin(), joints.begin() + static_cast<std::ptrdiff_t>(count)})) ++count;
  return fail(body.error().code, file + ":" + std::to_string(lines[count - 1]) + ": " + body.error().message);
}

Result<Skeleton> read_body_file(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, std::size_t{1} << 26);
  if (!text) return tl::unexpected(text.error());
  return body_from_json(*text, path.string());
}

Result<void> write_body_file(const std::filesystem::path& path, const Skeleton& body) {
  return write_file_atomically(path, body_to_json(body));
}

}  // namespace posecoach
