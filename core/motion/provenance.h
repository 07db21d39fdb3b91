// A motion with what is needed to write a motion of the same body back into the same kind of file.
#pragma once

#include <string>
#include <vector>

#include "core/motion/bvh_document.h"
#include "core/motion/file_frame.h"
#include "core/motion/motion.h"

namespace posecoach {

enum class MotionFormat { Bvh, AsfAmc, C3d, Trc, PoseMotion, PoseTrack, BodyFile, OpenPoseFolder };

// One joint or End Site of a BVH file and what became of it.
struct BvhOrigin {
  BvhJoint joint;
  int skeleton_joint = kNoJoint;  // none: above the body's root, or an End Site of no length
  bool position_adds = false;     // its position channels are to be added to the offset, and are all 0
};

struct MotionProvenance {
  MotionFormat format = MotionFormat::Bvh;
  FileFrame frame;
  std::vector<BvhOrigin> bvh;  // in the file's order; empty for other formats
};

struct MotionFile {
  Motion motion;
  MotionProvenance provenance;
};

struct SkeletonFile {
  Skeleton skeleton;
  MotionProvenance provenance;
};

}  // namespace posecoach
