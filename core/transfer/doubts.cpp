#include "core/transfer/doubts.h"

#include <algorithm>

namespace posecoach {
namespace {

// Against an average person of the same stature; real people stay above it, a bone seen end-on does not.
constexpr double kBelievable = 0.45;

std::string spoken(Joint2d joint) {
  std::string name(to_string(joint));
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// Left and right were measured as one, so each pair is named once, by its left side without the word.
std::string spoken_bone(std::size_t bone) {
  const auto plain = [](Joint2d joint) {
    std::string name = spoken(joint);
    if (name.starts_with("left ")) name.erase(0, 5);
    return name;
  };
  return plain(kBones2d[bone].parent) + " to " + plain(kBones2d[bone].child);
}

void add_short_bones(const BoneLengths2d& person, const std::string& whose,
                     std::vector<std::string>& doubts) {
  std::string list;
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    if (kBones2d[b].twin < b) continue;
    const double expected = kAverageBoneLengths[b] * person.stature;
    if (person.measured[b] && person.length[b] >= kBelievable * expected) continue;
    list += (list.empty() ? "" : ", ") + spoken_bone(b);
  }
  if (!list.empty()) doubts.push_back("no picture of " + whose + " shows the true length of: " + list);
}

}  // namespace

Vec2 guessed_bone(std::size_t bone) {
  const double length = kAverageBoneLengths[bone];
  switch (kBones2d[bone].child) {
    case Joint2d::Neck:
    case Joint2d::Nose:
      return {0, -length};
    case Joint2d::LeftShoulder:
    case Joint2d::LeftHip:
      return {length, 0};
    case Joint2d::RightShoulder:
    case Joint2d::RightHip:
      return {-length, 0};
    default:
      return {0, length};
  }
}

std::vector<std::string> doubts_about(const Pose2d& pose, const TransferredPose& result,
                                      const BoneLengths2d& source, const BoneLengths2d& identity) {
  std::vector<std::string> doubts;
  std::string missing, far_off;
  for (std::size_t i = 0; i < kJoint2dCount; ++i) {
    std::string* list = nullptr;
    if (!pose.seen[i])
      list = &missing;
    else if (result.expected_error[i] > kFarOff)
      list = &far_off;
    if (list != nullptr) *list += (list->empty() ? "" : ", ") + spoken(static_cast<Joint2d>(i));
  }
  if (!missing.empty()) doubts.push_back("not seen in the pose, so guessed: " + missing);
  if (!far_off.empty()) doubts.push_back("seen too little to be carried over well: " + far_off);
  for (std::string& doubt : doubts_about_lengths(source, identity)) doubts.push_back(std::move(doubt));
  return doubts;
}

std::vector<std::string> doubts_about_lengths(const BoneLengths2d& source, const BoneLengths2d& identity) {
  std::vector<std::string> doubts;
  add_short_bones(source, "the person who poses", doubts);
  add_short_bones(identity, "the person drawn", doubts);
  return doubts;
}

}  // namespace posecoach
