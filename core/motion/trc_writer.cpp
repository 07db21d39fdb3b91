#include "core/base/json_text.h"
#include "core/motion/trc.h"

namespace posecoach {
namespace {

constexpr int kMetreDecimals = 7;
constexpr int kTimeDecimals = 9;

std::string one_cell(std::string_view name) {
  std::string cell(name);
  for (char& c : cell)
    if (static_cast<unsigned char>(c) < ' ') c = '_';
  return cell.empty() ? "_" : cell;
}

}  // namespace

std::string trc_from_motion(std::string_view file_name, const Motion& motion) {
  const std::string frames = std::to_string(motion.frame_count()),
                    joints = std::to_string(motion.joint_count());
  std::string rate;
  append_json_number(rate, motion.frame_rate() > 0 ? motion.frame_rate() : 1, 3);
  std::string out = "PathFileType\t4\t(X/Y/Z)\t" + one_cell(file_name) +
                    "\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\t"
                    "OrigNumFrames\n" +
                    rate + '\t' + rate + '\t' + frames + '\t' + joints + "\tm\t" + rate + "\t1\t" + frames +
                    "\nFrame#\tTime";
  for (const Joint& joint : motion.skeleton().joints()) out += '\t' + one_cell(joint.name) + "\t\t";
  out += "\n\t";
  for (int j = 1; j <= motion.joint_count(); ++j)
    for (const char axis : {'X', 'Y', 'Z'}) out += '\t' + (axis + std::to_string(j));
  out += "\n\n";
  for (int f = 0; f < motion.frame_count(); ++f) {
    out += std::to_string(f + 1) + '\t';
    append_json_number(out, to_seconds(motion.time(f)), kTimeDecimals);
    for (int j = 0; j < motion.joint_count(); ++j)
      for (int i = 0; i < 3; ++i) {
        out += '\t';
        if (motion.confidence(f, j) > 0) append_json_number(out, motion.position(f, j)[i], kMetreDecimals);
      }
    out += '\n';
  }
  return out;
}

}  // namespace posecoach
