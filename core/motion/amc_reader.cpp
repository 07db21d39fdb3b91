#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "core/base/assert.h"
#include "core/base/file.h"
#include "core/base/index.h"
#include "core/motion/asf_amc_reader.h"
#include "core/motion/rig.h"
#include "core/motion/text_scanner.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

tl::unexpected<Error> in_file(std::string_view file_name, const Error& error) {
  return fail(error.code, std::string(file_name) + ": " + error.message);
}

// Bones keep their order; the ends of last bones come after all of them.
Result<SkeletonFile> skeleton_from(const AsfDocument& document) {
  std::vector<Joint> joints;
  std::vector<bool> has_children(document.bones.size(), false);
  for (const AsfBone& bone : document.bones) {
    const Vec3 offset = bone.parent < 0 ? document.root_position : document.bones[index(bone.parent)].end;
    joints.push_back({bone.name, bone.parent, offset, {}});
    if (bone.parent >= 0) has_children[index(bone.parent)] = true;
  }
  for (std::size_t b = 0; b < document.bones.size(); ++b)
    if (!has_children[b] && glm::length(document.bones[b].end) > 0)
      joints.push_back({document.bones[b].name + "_end", static_cast<int>(b), document.bones[b].end, {}});
  const auto roles = map_roles(joints);
  for (std::size_t j = 0; j < joints.size(); ++j) joints[j].role = roles[j];
  auto frame = file_frame(joints);
  if (!frame) return tl::unexpected(frame.error());
  // What the file says counts when it makes a person.
  constexpr double kSmallestRatio = 0.5, kLargestRatio = 2;
  const double ratio = document.metres_per_unit / frame->metres_per_unit;
  if (ratio > kSmallestRatio && ratio < kLargestRatio) frame->metres_per_unit = document.metres_per_unit;
  auto skeleton = Skeleton::make(converted(std::move(joints), *frame));
  if (!skeleton) return tl::unexpected(skeleton.error());
  return SkeletonFile{*std::move(skeleton), {MotionFormat::AsfAmc, *std::move(frame), {}}};
}

class AmcReader {
 public:
  AmcReader(std::string_view file_name, std::string_view text, const AsfDocument& asf, SkeletonFile body)
      : scanner_(file_name, text), asf_(asf), body_(std::move(body)) {
    for (std::size_t b = 0; b < asf.bones.size(); ++b) bone_by_name_.emplace(asf.bones[b].name, b);
  }

  Result<MotionFile> run(double frames_per_second) {
    if (const auto read = head(); !read) return tl::unexpected(read.error());
    while (!scanner_.at_end())
      if (const auto read = frame(frames_per_second); !read) return tl::unexpected(read.error());
    if (times_.empty()) return scanner_.failure("the file has no frames", ErrorCode::Incomplete);
    auto motion =
        Motion::from_rotations(body_.skeleton, std::move(times_), std::move(roots_), std::move(locals_));
    if (!motion) return scanner_.failure(motion.error().message, motion.error().code);
    return MotionFile{*std::move(motion), std::move(body_.provenance)};
  }

 private:
  // Comments and keywords up to the number of the first frame.
  Result<void> head() {
    while (!scanner_.at_end()) {
      const std::string_view word = scanner_.peek();
      if (!word.starts_with('#') && !word.starts_with(':')) break;
      const std::string keyword = to_lower(scanner_.next());
      if (keyword == ":radians") degrees_ = false;
      if (keyword.starts_with('#')) scanner_.skip_line();
    }
    if (!parse_integer(scanner_.peek())) {
      const std::string_view word = scanner_.next();
      return scanner_.failure("this is not an AMC file: expected the number of the first frame, found " +
                              in_quotes(word));
    }
    return {};
  }

  Result<void> frame(double frames_per_second) {
    const std::string_view word = scanner_.next();
    const auto number = parse_integer(word);
    if (!number || *number < 0 || *number > 100'000'000)
      return scanner_.failure("expected the number of a frame, found " +
                              (word.empty() ? "the end of the file" : in_quotes(word)));
    if (times_.empty())
      first_number_ = *number;
    else if (*number <= last_number_)
      return scanner_.failure("frame " + std::to_string(*number) + " comes after frame " +
                              std::to_string(last_number_));
    last_number_ = *number;
    std::vector<Quat> turns(asf_.bones.size(), Quat(1, 0, 0, 0));
    std::vector<bool> seen(asf_.bones.size(), false);
    Vec3 root = asf_.root_position;
    while (!scanner_.at_end() && !parse_integer(scanner_.peek())) {
      const std::string_view name = scanner_.next();
      const auto bone = bone_by_name_.find(std::string(name));
      if (bone == bone_by_name_.end()) return scanner_.failure("the skeleton has no bone " + in_quotes(name));
      if (seen[bone->second]) return scanner_.failure(in_quotes(name) + " stands twice in one frame");
      seen[bone->second] = true;
      const auto read =
          bone->second == 0 ? read_root(root, turns[0]) : read_bone(bone->second, turns[bone->second]);
      if (!read) return read;
    }
    for (std::size_t b = 0; b < seen.size(); ++b)
      if (!seen[b] && (b == 0 || !asf_.bones[b].turns.empty()))
        return scanner_.failure("frame " + std::to_string(*number) + " says nothing about " +
                                in_quotes(asf_.bones[b].name));
    times_.push_back(
        media_time_from_seconds(static_cast<double>(*number - first_number_) / frames_per_second));
    append_pose(root, turns);
    return {};
  }

  Result<double> number_of(std::string_view bone) {
    double value = 0;
    if (scanner_.next_number(value)) return value;
    const std::string_view word = scanner_.next();
    return scanner_.failure(in_quotes(bone) + " needs a number, found " + in_quotes(word));
  }
  double radians(double angle) const { return degrees_ ? radians_from_degrees(angle) : angle; }
  static Quat in_axis(const AsfBone& bone, const Quat& turn) {
    return bone.axis * turn * glm::conjugate(bone.axis);
  }

  Result<void> read_root(Vec3& place, Quat& rotation) {
    Quat turn(1, 0, 0, 0);
    for (const int freedom : asf_.root_order) {
      const auto value = number_of("root");
      if (!value) return tl::unexpected(value.error());
      if (freedom < 3)
        place[freedom] += *value;
      else
        turn = rotation_about(static_cast<Axis>(freedom - 3), radians(*value)) * turn;
    }
    rotation = in_axis(asf_.bones[0], turn);
    return expect_line_end(asf_.bones[0]);
  }
  Result<void> read_bone(std::size_t b, Quat& rotation) {
    const AsfBone& bone = asf_.bones[b];
    Quat turn(1, 0, 0, 0);
    for (const Axis axis : bone.turns) {
      const auto value = number_of(bone.name);
      if (!value) return tl::unexpected(value.error());
      turn = rotation_about(axis, radians(*value)) * turn;
    }
    rotation = in_axis(bone, turn);
    return expect_line_end(bone);
  }
  // Or one number too many would be taken for the next frame's.
  Result<void> expect_line_end(const AsfBone& bone) {
    if (scanner_.at_line_end()) return {};
    return scanner_.failure(in_quotes(bone.name) + " has more numbers than degrees of freedom");
  }

  void append_pose(const Vec3& root, const std::vector<Quat>& turns) {
    const FileFrame& frame = body_.provenance.frame;
    roots_.push_back(frame.world_from_file * root * frame.metres_per_unit);
    for (int j = 0; j < body_.skeleton.size(); ++j) {
      const int parent = body_.skeleton.joint(j).parent;
      const Quat turn = index(j) < turns.size() ? turns[index(j)] : Quat(1, 0, 0, 0);
      const Quat before = parent == kNoJoint ? frame.world_from_file : frame.rest_from_file[index(parent)];
      locals_.push_back(glm::normalize(before * turn * glm::conjugate(frame.rest_from_file[index(j)])));
    }
  }

  TextScanner scanner_;
  const AsfDocument& asf_;
  SkeletonFile body_;
  std::unordered_map<std::string, std::size_t> bone_by_name_;
  bool degrees_ = true;
  long first_number_ = 0, last_number_ = 0;
  std::vector<MediaTime> times_;
  std::vector<Vec3> roots_;
  std::vector<Quat> locals_;
};

Result<fs::path> skeleton_beside(const fs::path& path) {
  const std::string stem = path.stem().string();
  const fs::path folder = path.parent_path();
  std::vector<std::string> names = {stem};
  for (const std::size_t cut : {stem.rfind('_'), stem.find('_')})
    if (cut != std::string::npos) names.push_back(stem.substr(0, cut));
  std::error_code ignored;
  for (const std::string& name : names)
    for (const char* ending : {".asf", ".ASF"})
      if (fs::exists(folder / (name + ending), ignored)) return folder / (name + ending);
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, ignored))
    if (to_lower(entry.path().extension().string()) == ".asf") all.push_back(entry.path());
  if (all.size() == 1) return all.front();
  return fail(ErrorCode::NotFound, path.string() + ": an AMC file needs its skeleton beside it, " +
                                       names.back() + ".asf; " +
                                       (all.empty() ? "there is none" : "there are several others"));
}

}  // namespace

Result<SkeletonFile> read_asf_skeleton(std::string_view file_name, std::string_view text) {
  const auto document = parse_asf(file_name, text);
  if (!document) return tl::unexpected(document.error());
  auto body = skeleton_from(*document);
  if (!body) return in_file(file_name, body.error());
  return body;
}

Result<MotionFile> read_amc(std::string_view file_name, std::string_view text, const AsfDocument& skeleton,
                            double frames_per_second) {
  POSECOACH_ASSERT(frames_per_second > 0);
  auto body = skeleton_from(skeleton);
  if (!body) return in_file(file_name, body.error());
  return AmcReader(file_name, text, skeleton, *std::move(body)).run(frames_per_second);
}

Result<MotionFile> read_amc_file(const fs::path& path, std::string_view text, double frames_per_second) {
  if (is_asf(text))
    return fail(ErrorCode::Incomplete,
                path.string() + ": this is a skeleton without a motion; give the .amc file");
  const auto beside = skeleton_beside(path);
  if (!beside) return tl::unexpected(beside.error());
  const auto skeleton_text = read_file(*beside);
  if (!skeleton_text) return tl::unexpected(skeleton_text.error());
  const auto skeleton = parse_asf(beside->string(), *skeleton_text);
  if (!skeleton) return tl::unexpected(skeleton.error());
  return read_amc(path.string(), text, *skeleton, frames_per_second);
}

}  // namespace posecoach
