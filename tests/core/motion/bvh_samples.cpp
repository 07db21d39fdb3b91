#include "bvh_samples.h"

#include <vector>

#include "core/base/math.h"

namespace posecoach::samples {
namespace {

struct Bone {
  std::string_view name;
  Vec3 offset;  // metres, +Y up, facing +Z
  std::vector<Bone> children;
};

Bone leg(double side, std::string_view thigh, std::string_view shin, std::string_view foot) {
  return {thigh,
          {side * 0.09, -0.02, 0},
          {{shin, {0, -0.42, 0}, {{foot, {0, -0.42, 0}, {{"", {0, -0.06, 0.18}, {}}}}}}}};
}
Bone arm(double side, std::string_view collar, std::string_view upper, std::string_view fore,
         std::string_view hand) {
  return {collar,
          {side * 0.03, 0.1, 0},
          {{upper, {side * 0.15, 0, 0}, {{fore, {side * 0.3, 0, 0}, {{hand, {side * 0.26, 0, 0}, {}}}}}}}};
}

std::string vector_text(const Vec3& v, double scale, UpAxis up) {
  const Vec3 turned = up == UpAxis::Y ? v : Vec3(v.x, -v.z, v.y);
  std::string text;
  for (int i = 0; i < 3; ++i) text += ' ' + std::to_string(turned[i] * scale);
  return text;
}

void write_bone(std::string& out, const Bone& bone, std::string_view keyword, double scale, UpAxis up) {
  out += bone.name.empty() ? "End Site\n{\n" : std::string(keyword) + ' ' + std::string(bone.name) + "\n{\n";
  out += "OFFSET" + vector_text(bone.offset, scale, up) + '\n';
  if (keyword == "ROOT")
    out += "CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n";
  else if (!bone.name.empty())
    out += "CHANNELS 3 Zrotation Xrotation Yrotation\n";
  for (const Bone& child : bone.children) write_bone(out, child, "JOINT", scale, up);
  out += "}\n";
}

}  // namespace

std::string body_bvh(const RigNames& n, double units_per_metre, UpAxis up) {
  const Bone body = {n.hips,
                     {0, 0.95, 0},
                     {leg(1, n.left_thigh, n.left_shin, n.left_foot),
                      leg(-1, n.right_thigh, n.right_shin, n.right_foot),
                      {n.spine,
                       {0, 0.1, 0},
                       {{n.chest,
                         {0, 0.25, 0},
                         {arm(1, n.left_collar, n.left_arm, n.left_forearm, n.left_hand),
                          arm(-1, n.right_collar, n.right_arm, n.right_forearm, n.right_hand),
                          {n.neck, {0, 0.15, 0}, {{n.head, {0, 0.1, 0.01}, {{"", {0, 0.18, 0}, {}}}}}}}}}}}};
  std::string out = "HIERARCHY\n";
  write_bone(out, body, "ROOT", units_per_metre, up);
  out += "MOTION\nFrames: 2\nFrame Time: 0.0333333\n";
  const std::string place = vector_text({0.2, 0.95, 0.1}, units_per_metre, up);
  std::string others;
  for (int i = 0; i < 18 * 3; ++i) others += " 0";
  out += place + " 0 0 0" + others + '\n';
  out += place + (up == UpAxis::Y ? " 0 90 0" : " 90 0 0") + others + '\n';
  return out;
}

}  // namespace posecoach::samples
