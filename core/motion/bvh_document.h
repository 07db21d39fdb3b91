// A BVH file as it stands: joints, channels and numbers in the file's own units, axes and angles (degrees).
// bvh_motion.h gives it meaning.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/motion/euler.h"

namespace posecoach {

struct BvhChannel {
  enum class Kind : unsigned char { Position, Rotation };
  Kind kind = Kind::Rotation;
  Axis axis = Axis::X;
  bool operator==(const BvhChannel&) const = default;
};

struct BvhJoint {
  std::string name;  // as in the file; empty for an End Site
  int parent = -1;   // parents come before their children
  Vec3 offset;
  std::vector<BvhChannel> channels;
  bool is_end_site = false;
};

struct BvhDocument {
  std::vector<BvhJoint> joints;
  double frame_time_s = 0;  // of a file without frames: 0
  std::size_t frame_count = 0;
  std::vector<double> values;  // frame-major, channels in the joints' order

  std::size_t channel_count() const;
};

// Errors: Malformed with file and line, Unsupported (more than 4096 joints, a second root). Tolerates any
// line ends, blanks and letter case, and a file that ends after its hierarchy (no frames).
Result<BvhDocument> parse_bvh(std::string_view file_name, std::string_view text);

std::string format_bvh(const BvhDocument& document);

}  // namespace posecoach
