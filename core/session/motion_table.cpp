#include "core/session/motion_table.h"

#include "core/base/json_text.h"
#include "core/body/humanoid.h"

namespace posecoach {
namespace {

constexpr int kTimeDecimals = 6, kMetreDecimals = 5, kPixelDecimals = 2, kConfidenceDecimals = 3;
constexpr const char* kEndOfLine = "\r\n";

void append_cell(std::string& out, double value, int decimals) {
  out += ',';
  append_json_number(out, value, decimals);
}

// A joint may be called anything; the header must stay one row of cells.
std::string cell_name(std::string name) {
  for (char& c : name)
    if (c == ',' || c == '"' || static_cast<unsigned char>(c) < ' ') c = '_';
  return name;
}

void append_frame(std::string& out, std::size_t frame, MediaTime time) {
  out += std::to_string(frame);
  append_cell(out, to_seconds(time), kTimeDecimals);
}

}  // namespace

std::string csv_from_motion(const Motion& motion, int first_frame) {
  std::string out = "frame,time_s";
  for (const Joint& joint : motion.skeleton().joints()) {
    const std::string name = cell_name(joint.role ? std::string(to_string(*joint.role)) : joint.name);
    for (const char* ending : {"_x_m", "_y_m", "_z_m", "_confidence"}) out += "," + name + ending;
  }
  out += kEndOfLine;
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    append_frame(out, static_cast<std::size_t>(first_frame + frame), motion.time(frame));
    for (int joint = 0; joint < motion.joint_count(); ++joint) {
      const double confidence = motion.confidence(frame, joint);
      const Vec3& at = motion.position(frame, joint);
      for (const double value : {at.x, at.y, at.z}) {
        if (confidence > 0)
          append_cell(out, value, kMetreDecimals);
        else
          out += ',';
      }
      append_cell(out, confidence, kConfidenceDecimals);
    }
    out += kEndOfLine;
  }
  return out;
}

std::string csv_from_track(const PoseTrack& track) {
  std::string out = "frame,time_s";
  for (std::size_t l = 0; l < kLandmarkCount; ++l)
    for (const char* ending : {"_x_px", "_y_px", "_visibility"})
      out += "," + std::string(to_string(static_cast<Landmark>(l))) + ending;
  out += kEndOfLine;
  for (const PoseObservation& seen : track.frames) {
    append_frame(out, seen.frame_index, seen.time);
    for (std::size_t l = 0; l < kLandmarkCount; ++l) {
      if (!seen.person) {
        out += ",,,";
        continue;
      }
      const ImageKeypoint& at = seen.person->image[l];
      append_cell(out, at.position_px.x, kPixelDecimals);
      append_cell(out, at.position_px.y, kPixelDecimals);
      append_cell(out, at.visibility, kConfidenceDecimals);
    }
    out += kEndOfLine;
  }
  return out;
}

}  // namespace posecoach
