#include "core/motion/motion_file.h"

#include "core/base/file.h"
#include "core/motion/bvh_motion.h"
#include "core/motion/text_scanner.h"

namespace posecoach {
namespace fs = std::filesystem;

Result<MotionFormat> motion_format(const fs::path&) {
  return MotionFormat::Bvh;
}

Result<MotionFile> read_motion_file(const fs::path& path, const MotionReadOptions&) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  return read_bvh(path.string(), *text);
}

Result<SkeletonFile> read_skeleton_file(const fs::path& path, const MotionReadOptions&) {
  const auto text = read_file(path);
  if (!text) return tl::unexpected(text.error());
  return read_bvh_skeleton(path.string(), *text);
}

Result<void> write_motion_file(const fs::path& path, const Motion& motion,
                               const MotionProvenance& provenance) {
  const auto bytes = bvh_from_motion(motion, provenance);
  if (!bytes) return tl::unexpected(bytes.error());
  return write_file_atomically(path, *bytes);
}

}  // namespace posecoach
