#include <charconv>

#include "core/base/assert.h"
#include "core/motion/bvh_document.h"

namespace posecoach {
namespace {

void append_number(std::string& out, double value) {
  char text[32];
  const auto [end, error] =
      std::to_chars(text, text + sizeof text, value == 0 ? 0.0 : value, std::chars_format::general, 9);
  POSECOACH_ASSERT(error == std::errc{});
  out.append(text, end);
}

void append_vector(std::string& out, const Vec3& v) {
  for (int i = 0; i < 3; ++i) {
    out += ' ';
    append_number(out, v[i]);
  }
}

std::string channel_name(const BvhChannel& channel) {
  const char axis = "XYZ"[static_cast<int>(channel.axis)];
  return axis + std::string(channel.kind == BvhChannel::Kind::Position ? "position" : "rotation");
}

int depth_of(const std::vector<BvhJoint>& joints, std::size_t joint) {
  int depth = 0;
  for (int up = joints[joint].parent; up >= 0; up = joints[static_cast<std::size_t>(up)].parent) ++depth;
  return depth;
}

void append_hierarchy(std::string& out, const std::vector<BvhJoint>& joints) {
  const auto indent = [&](int depth) { out.append(static_cast<std::size_t>(depth), '\t'); };
  int open = 0;  // braces
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const BvhJoint& joint = joints[j];
    const int depth = depth_of(joints, j);
    POSECOACH_ASSERT(depth <= open);
    while (open > depth) {
      indent(--open);
      out += "}\n";
    }
    indent(depth);
    out += joint.is_end_site ? "End Site" : (depth == 0 ? "ROOT " : "JOINT ") + joint.name;
    out += '\n';
    indent(depth);
    out += "{\n";
    ++open;
    indent(open);
    out += "OFFSET";
    append_vector(out, joint.offset);
    out += '\n';
    if (joint.is_end_site) continue;
    indent(open);
    out += "CHANNELS " + std::to_string(joint.channels.size());
    for (const BvhChannel& channel : joint.channels) out += ' ' + channel_name(channel);
    out += '\n';
  }
  while (open > 0) {
    indent(--open);
    out += "}\n";
  }
}

}  // namespace

std::string format_bvh(const BvhDocument& document) {
  std::string out = "HIERARCHY\n";
  append_hierarchy(out, document.joints);
  const std::size_t channels = document.channel_count();
  POSECOACH_ASSERT(document.values.size() == document.frame_count * channels);
  out += "MOTION\nFrames: " + std::to_string(document.frame_count) + "\nFrame Time: ";
  append_number(out, document.frame_time_s);
  out += '\n';
  out.reserve(out.size() + document.values.size() * 12);
  for (std::size_t i = 0; i < document.values.size(); ++i) {
    append_number(out, document.values[i]);
    out += (i + 1) % channels == 0 ? '\n' : ' ';
  }
  return out;
}

}  // namespace posecoach
