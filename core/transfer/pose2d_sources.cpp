#include "core/transfer/pose2d_sources.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/file.h"

namespace posecoach {
namespace {

using enum Joint2d;

constexpr std::array<std::pair<Joint2d, Landmark>, 13> kFromLandmarks = {{
    {Nose, Landmark::Nose},
    {LeftShoulder, Landmark::LeftShoulder},
    {RightShoulder, Landmark::RightShoulder},
    {LeftElbow, Landmark::LeftElbow},
    {RightElbow, Landmark::RightElbow},
    {LeftWrist, Landmark::LeftWrist},
    {RightWrist, Landmark::RightWrist},
    {LeftHip, Landmark::LeftHip},
    {RightHip, Landmark::RightHip},
    {LeftKnee, Landmark::LeftKnee},
    {RightKnee, Landmark::RightKnee},
    {LeftAnkle, Landmark::LeftAnkle},
    {RightAnkle, Landmark::RightAnkle},
}};

std::optional<Joint2d> joint_from_clip_name(std::string_view name) {
  if (name == "face") return Nose;
  for (std::size_t i = 0; i < kJoint2dCount; ++i)
    if (to_string(static_cast<Joint2d>(i)) == name) return static_cast<Joint2d>(i);
  return std::nullopt;
}

}  // namespace

Pose2d pose2d_from_landmarks(const ImageKeypoints& landmarks) {
  Pose2d pose;
  for (const auto& [joint, landmark] : kFromLandmarks) {
    pose[joint] = landmarks[landmark].position_px;
    pose.seen[index(joint)] = landmarks[landmark].visibility >= kLeastVisibility;
  }
  return with_midpoints(pose);
}

Result<std::vector<Pose2d>> read_clip_poses(const std::filesystem::path& path, std::size_t clip) {
  const Result<std::string> text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  try {
    const nlohmann::json file = nlohmann::json::parse(*text);
    std::vector<std::optional<Joint2d>> joints;
    for (const auto& name : file.at("joints"))
      joints.push_back(joint_from_clip_name(name.get<std::string>()));
    const nlohmann::json& clips = file.at("clips");
    if (clip >= clips.size())
      return fail(ErrorCode::InvalidArgument, path.string() + ": there is no clip " + std::to_string(clip) +
                                                  ", only 0 to " + std::to_string(clips.size()) +
                                                  " exclusive");
    std::vector<Pose2d> poses;
    for (const auto& frame : clips.at(clip).at("frames")) {
      Pose2d pose;
      for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!joints[i]) continue;
        pose[*joints[i]] = {frame.at(i).at(0).get<double>(), frame.at(i).at(1).get<double>()};
        pose.seen[index(*joints[i])] = true;
      }
      poses.push_back(with_midpoints(pose));
    }
    return poses;
  } catch (const nlohmann::json::exception& error) {
    return fail(ErrorCode::Malformed, path.string() + ": not a file of 2D clips: " + error.what());
  }
}

}  // namespace posecoach
