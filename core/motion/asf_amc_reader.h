// Acclaim skeletons (ASF) and motions (AMC), as CMU's motion capture library has them. One joint stands at
// the beginning of each bone, and one more, "<bone>_end", at the end of each last bone.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/euler.h"
#include "core/motion/provenance.h"

namespace posecoach {

struct AsfBone {
  std::string name;
  int parent = -1;               // -1: none, the root itself; parents come before their children
  Vec3 end;                      // from the bone's beginning, in the file's units; the root has no length
  Quat axis = Quat(1, 0, 0, 0);  // of the frame in which its degrees of freedom turn
  std::vector<Axis> turns;       // in the order of the AMC's numbers; the first acts first
};

struct AsfDocument {
  std::vector<AsfBone> bones;  // the root first
  Vec3 root_position;
  std::vector<int> root_order;  // for each of the root's numbers in the AMC: 0-2 place x-z, 3-5 turn x-z
  double metres_per_unit = 1;   // as the file says
  bool degrees = true;          // angles in the ASF
};

// True for the contents of an ASF, false for those of an AMC.
bool is_asf(std::string_view text);

// Errors: Malformed with file and line; Unsupported (bones that move or stretch, over 4096 bones).
Result<AsfDocument> parse_asf(std::string_view file_name, std::string_view text);
Result<SkeletonFile> read_asf_skeleton(std::string_view file_name, std::string_view text);

// Frame numbers are taken as times at `frames_per_second`. Errors: Malformed with file and line; Incomplete
// (no frames).
Result<MotionFile> read_amc(std::string_view file_name, std::string_view text, const AsfDocument& skeleton,
                            double frames_per_second);

// Finds the skeleton beside the motion: "01_02.asf" or "01.asf" for "01_02.amc", else the only .asf in the
// folder. Errors: NotFound (no skeleton), those above.
Result<MotionFile> read_amc_file(const std::filesystem::path& path, std::string_view text,
                                 double frames_per_second);

}  // namespace posecoach
