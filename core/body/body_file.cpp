#include "core/body/body_file.h"

#include <nlohmann/json.hpp>

#include "core/base/file.h"
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

int parent_index(const Json& parent, const std::vector<Joint>& before) {
  if (parent.is_null()) return kNoJoint;
  if (parent.is_number_integer()) {
    const auto number = parent.get<long long>();
    return number < 0 ? kNoJoint : static_cast<int>(std::min<long long>(number, 1 << 20));
  }
  const std::string name = parent.get<std::string>();
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i].name == name) return static_cast<int>(i);
  throw std::runtime_error("the parent " + name + " is not listed before its child");
}

std::vector<Joint> joints_from(const Json& list) {
  std::vector<Joint> joints;
  for (const Json& entry : list) {
    Joint joint;
    joint.name = entry.at("name").get<std::string>();
    joint.parent = parent_index(entry.at("parent"), joints);
    const auto& offset = entry.at("offset_m");
    if (!offset.is_array() || offset.size() != 3)
      throw std::runtime_error("the offset_m of " + joint.name + " needs 3 numbers");
    joint.offset = {offset[0].get<double>(), offset[1].get<double>(), offset[2].get<double>()};
    if (entry.contains("role") && !entry["role"].is_null()) {
      const std::string role = entry["role"].get<std::string>();
      joint.role = humanoid_joint_from_string(role);
      if (!joint.role) throw std::runtime_error("there is no role " + role);
    } else {
      joint.role = role_by_name(joint.name);
    }
    joints.push_back(std::move(joint));
  }
  return joints;
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
  const std::string file(name);
  try {
    const Json parsed = Json::parse(json);
    if (!parsed.is_object() || parsed.value("schema", "") != kSchema)
      return fail(ErrorCode::Malformed,
                  file + ": this is not a body file (its schema is not " + std::string(kSchema) + ")");
    Result<Skeleton> made = Skeleton::make(joints_from(parsed.at("joints")));
    if (!made) return fail(made.error().code, file + ": " + made.error().message);
    return made;
  } catch (const std::exception& error) {
    return fail(ErrorCode::Malformed, file + ": not a valid body file: " + error.what());
  }
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
