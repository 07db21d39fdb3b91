#include "core/base/assert.h"
#include "core/base/json_text.h"
#include "core/motion/pose_file.h"

namespace posecoach {
namespace {

constexpr int kPixelDecimals = 4;
constexpr int kMetreDecimals = 6;
constexpr int kVisibilityDecimals = 5;
constexpr int kTimeDecimals = 9;    // times are whole nanoseconds
constexpr int kExactDecimals = 12;  // what is to read back as the same motion

struct Value {
  double number;
  int decimals;
};

void append_row(std::string& out, std::initializer_list<Value> values) {
  out += '[';
  bool is_first = true;
  for (const auto& [number, decimals] : values) {
    if (!is_first) out += ',';
    is_first = false;
    append_json_number(out, number, decimals);
  }
  out += ']';
}

// `write_row(out, i)` for each of `count` rows.
template <typename WriteRow>
void append_rows(std::string& out, std::string_view key, std::size_t count, const WriteRow& write_row) {
  out += ", \"" + std::string(key) + "\": [";
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out += ',';
    write_row(i);
  }
  out += ']';
}

void append_frame_head(std::string& out, std::size_t frame_index, MediaTime time, bool is_found) {
  out += "{\"index\": " + std::to_string(frame_index) + ", \"time_s\": ";
  append_json_number(out, to_seconds(time), kTimeDecimals);
  out += std::string(", \"found\": ") + (is_found ? "true" : "false");
}

std::string head(std::string_view source, int width, int height) {
  return "{\"schema\": \"posecoach.pose/1\",\n \"source\": " + json_quoted(source) +
         ",\n \"width\": " + std::to_string(width) + ",\n \"height\": " + std::to_string(height) + ",\n";
}

std::string track_start(std::string_view source, int width, int height) {
  std::string start = head(source, width, height) + " \"joints\": [";
  for (std::size_t l = 0; l < kLandmarkCount; ++l)
    start += (l == 0 ? "" : ", ") + json_quoted(to_string(static_cast<Landmark>(l)));
  return start + "],\n \"frames\": [";
}

std::string frame_json(const PoseObservation& observation) {
  std::string out;
  append_frame_head(out, observation.frame_index, observation.time, observation.person.has_value());
  if (observation.person) {
    append_rows(out, "image", kLandmarkCount, [&](std::size_t l) {
      const ImageKeypoint& at = observation.person->image[l];
      append_row(out, {{at.position_px.x, kPixelDecimals},
                       {at.position_px.y, kPixelDecimals},
                       {at.visibility, kVisibilityDecimals}});
    });
    append_rows(out, "world", kLandmarkCount, [&](std::size_t l) {
      const WorldKeypoint& at = observation.person->world[l];
      append_row(out, {{at.position_m.x, kMetreDecimals},
                       {at.position_m.y, kMetreDecimals},
                       {at.position_m.z, kMetreDecimals},
                       {at.visibility, kVisibilityDecimals}});
    });
  }
  return out + '}';
}

void append_skeleton(std::string& out, const Skeleton& skeleton) {
  out += " \"skeleton\": [";
  for (int j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joint(j);
    out += j == 0 ? "\n  " : ",\n  ";
    out += "{\"name\": " + json_quoted(joint.name) + ", \"parent\": ";
    out += joint.parent == kNoJoint ? "null" : json_quoted(skeleton.joint(joint.parent).name);
    if (joint.role) out += ", \"role\": " + json_quoted(to_string(*joint.role));
    out += ", \"offset_m\": ";
    append_row(out, {{joint.offset.x, kExactDecimals},
                     {joint.offset.y, kExactDecimals},
                     {joint.offset.z, kExactDecimals}});
    out += '}';
  }
  out += "],\n";
}

void append_motion_frame(std::string& out, const Motion& motion, int f) {
  append_frame_head(out, static_cast<std::size_t>(f), motion.time(f), true);
  const Vec3 root = motion.position(f, 0);
  out += ", \"root_m\": ";
  append_row(out, {{root.x, kExactDecimals}, {root.y, kExactDecimals}, {root.z, kExactDecimals}});
  const auto joints = static_cast<std::size_t>(motion.joint_count());
  append_rows(out, "world", joints, [&](std::size_t j) {
    const int joint = static_cast<int>(j);
    const Vec3 from_root = motion.position(f, joint) - root;
    append_row(out, {{from_root.x, kExactDecimals},
                     {-from_root.y, kExactDecimals},
                     {-from_root.z, kExactDecimals},
                     {motion.confidence(f, joint), kVisibilityDecimals}});
  });
  if (motion.has_rotations())
    append_rows(out, "rotations", joints, [&](std::size_t j) {
      const Quat& q = motion.rotations(f)[j];
      append_row(
          out, {{q.w, kExactDecimals}, {q.x, kExactDecimals}, {q.y, kExactDecimals}, {q.z, kExactDecimals}});
    });
  out += '}';
}

}  // namespace

std::string pose_json_from_motion(const Motion& motion, std::string_view source) {
  std::string out = head(source, 0, 0) + " \"joints\": [";
  for (int j = 0; j < motion.joint_count(); ++j)
    out += (j == 0 ? "" : ", ") + json_quoted(motion.skeleton().joint(j).name);
  out += "],\n";
  append_skeleton(out, motion.skeleton());
  out += " \"frames\": [";
  for (int f = 0; f < motion.frame_count(); ++f) {
    out += f == 0 ? "\n  " : ",\n  ";
    append_motion_frame(out, motion, f);
  }
  return out + "\n]}\n";
}

std::string pose_json_from_track(const PoseTrack& track) {
  std::string out = track_start(track.source, track.width, track.height);
  for (std::size_t f = 0; f < track.frames.size(); ++f)
    out += (f == 0 ? "\n  " : ",\n  ") + frame_json(track.frames[f]);
  return out + "\n]}\n";
}

Result<PoseTrackWriter> PoseTrackWriter::create(const std::filesystem::path& path, std::string_view source,
                                                int width, int height) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  PoseTrackWriter writer(*std::move(file));
  if (const auto written = writer.file_.write(track_start(source, width, height)); !written)
    return tl::unexpected(written.error());
  return writer;
}

Result<void> PoseTrackWriter::add(const PoseObservation& observation) {
  const std::string separator = is_first_ ? "\n  " : ",\n  ";
  is_first_ = false;
  return file_.write(separator + frame_json(observation));
}

Result<void> PoseTrackWriter::finish() {
  if (const auto written = file_.write("\n]}\n"); !written) return written;
  return file_.commit();
}

Result<void> write_pose_track(const std::filesystem::path& path, const PoseTrack& track) {
  auto writer = PoseTrackWriter::create(path, track.source, track.width, track.height);
  if (!writer) return tl::unexpected(writer.error());
  for (const PoseObservation& observation : track.frames)
    if (const auto added = writer->add(observation); !added) return added;
  return writer->finish();
}

}  // namespace posecoach
