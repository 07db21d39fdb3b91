#include "core/pipeline/picture_coach.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/median.h"
#include "core/body/landmark_body.h"
#include "core/body/mirror.h"
#include "core/coaching/text/picture_text.h"
#include "core/transfer/bone_lengths.h"
#include "core/transfer/doubts.h"
#include "core/transfer/pose2d_sources.h"

namespace posecoach {
namespace {

using enum Landmark;

// More pictures of a person than this teach nothing new about the bones.
constexpr int kMostPictures = 120;
constexpr int kStillFrames = 5;  // as few as coaching takes for a motion
constexpr Duration kStillStep = std::chrono::milliseconds(40);

// Where a landmark comes from: a joint of the transferred pose, and the landmark that the coach has there.
struct Anchor {
  Joint2d joint;
  Landmark landmark;
};

Anchor anchor_of(Landmark landmark) {
  switch (landmark) {
    case LeftShoulder:
      return {Joint2d::LeftShoulder, LeftShoulder};
    case RightShoulder:
      return {Joint2d::RightShoulder, RightShoulder};
    case LeftElbow:
      return {Joint2d::LeftElbow, LeftElbow};
    case RightElbow:
      return {Joint2d::RightElbow, RightElbow};
    case LeftWrist:
    case LeftPinky:
    case LeftIndex:
    case LeftThumb:
      return {Joint2d::LeftWrist, LeftWrist};
    case RightWrist:
    case RightPinky:
    case RightIndex:
    case RightThumb:
      return {Joint2d::RightWrist, RightWrist};
    case LeftHip:
      return {Joint2d::LeftHip, LeftHip};
    case RightHip:
      return {Joint2d::RightHip, RightHip};
    case LeftKnee:
      return {Joint2d::LeftKnee, LeftKnee};
    case RightKnee:
      return {Joint2d::RightKnee, RightKnee};
    case LeftAnkle:
    case LeftHeel:
    case LeftFootIndex:
      return {Joint2d::LeftAnkle, LeftAnkle};
    case RightAnkle:
    case RightHeel:
    case RightFootIndex:
      return {Joint2d::RightAnkle, RightAnkle};
    default:
      return {Joint2d::Nose, Nose};
  }
}

// What the camera saw in each frame: the lifted joints lie on the rays of their pixels.
std::vector<ImageKeypoints> seen_by_camera(const LiftedStudent& person) {
  std::vector<ImageKeypoints> frames(static_cast<std::size_t>(person.motion.frame_count()));
  for (int frame = 0; frame < person.motion.frame_count(); ++frame)
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const Landmark landmark = static_cast<Landmark>(i);
      const int joint = landmark_joint(landmark);
      const std::optional<Vec2> pixel = person.camera.project(person.motion.position(frame, joint));
      frames[static_cast<std::size_t>(frame)][landmark] = {
          pixel.value_or(Vec2{}), pixel ? person.motion.confidence(frame, joint) : 0.0};
    }
  return frames;
}

std::vector<Pose2d> pictures_of(const std::vector<ImageKeypoints>& frames) {
  const std::size_t count = std::min<std::size_t>(frames.size(), kMostPictures);
  std::vector<Pose2d> pictures;
  for (std::size_t i = 0; i < count; ++i)
    pictures.push_back(pose2d_from_landmarks(frames[i * frames.size() / count]));
  return pictures;
}

double hips_depth(const LiftedStudent& person) {
  std::vector<double> depths;
  for (int frame = 0; frame < person.motion.frame_count(); ++frame)
    depths.push_back(person.camera.camera_from_world(person.motion.position(frame, 0)).z);
  return median(std::move(depths));
}

Vec2 middle(const Pose2d& pose, Joint2d a, Joint2d b) {
  return 0.5 * (pose[a] + pose[b]);
}

// The middle of the ankles, or of the hips where no picture shows both ankles.
std::optional<Vec2> usual_place(const std::vector<Pose2d>& pictures, Joint2d left, Joint2d right) {
  std::vector<double> x, y;
  for (const Pose2d& pose : pictures) {
    if (!pose.is_seen(left) || !pose.is_seen(right)) continue;
    x.push_back(middle(pose, left, right).x);
    y.push_back(middle(pose, left, right).y);
  }
  if (x.empty()) return std::nullopt;
  return Vec2{median(std::move(x)), median(std::move(y))};
}

// Puts transferred poses onto the student's picture: the coach's feet move about the student's as they moved
// about their own place.
class Placing {
 public:
  Placing(const std::vector<Pose2d>& coach, const std::vector<Pose2d>& student, double ratio)
      : ratio_(ratio) {
    for (const auto& [left, right] : {std::pair{Joint2d::LeftAnkle, Joint2d::RightAnkle},
                                      std::pair{Joint2d::LeftHip, Joint2d::RightHip}}) {
      const std::optional<Vec2> from = usual_place(coach, left, right),
                                to = usual_place(student, left, right);
      if (!from || !to) continue;
      left_ = left;
      right_ = right;
      from_ = *from;
      to_ = *to;
      return;
    }
  }
  Pose2d placed(const Pose2d& transferred, const Pose2d& coach) const {
    Vec2 target = to_;
    if (coach.is_seen(left_) && coach.is_seen(right_))
      target += ratio_ * (middle(coach, left_, right_) - from_);
    return translated(transferred, target - middle(transferred, left_, right_));
  }

 private:
  double ratio_;
  Joint2d left_ = Joint2d::LeftHip, right_ = Joint2d::RightHip;
  Vec2 from_, to_;
};

Result<void> check_sides(View coach, View student) {
  const bool is_known = coach != View::Between && student != View::Between;
  if (!is_known || coach == student) return {};
  return fail(ErrorCode::Incomplete,
              "the coach is filmed " + std::string(to_string(coach)) + ", the student " +
                  std::string(to_string(student)) +
                  ": shapes are carried over only between pictures from the same side; use another "
                  "--retarget, or another film");
}

// How the coach's picture becomes the student's world, one frame at a time.
struct Carrying {
  const LiftedStudent& coach;
  const LiftedStudent& student;
  double ratio_px = 1;       // student's over coach's size in pixels
  double metres = 1;         // the same in metres
  double student_depth = 1;  // of the hips, metres
};

Vec3 onto_ray(const Carrying& carrying, const Vec2& pixel, double relative_depth_m) {
  const PinholeCamera& camera = carrying.student.camera;
  const double depth = std::max(0.1, carrying.student_depth + relative_depth_m);
  const Vec2 ray = (pixel - camera.centre_px) / camera.focal_px;
  return glm::transpose(camera.rotation_camera_from_world) *
         (Vec3{ray.x * depth, ray.y * depth, depth} - camera.translation_camera_from_world);
}

struct CarriedFrame {
  std::array<Vec3, kLandmarkBodyJointCount> positions;
  std::array<double, kLandmarkBodyJointCount> confidence;
};

CarriedFrame carry(const Carrying& carrying, int frame, const ImageKeypoints& seen,
                   const TransferredPose& placed) {
  const auto depth_of = [&](int joint) {
    return carrying.coach.camera.camera_from_world(carrying.coach.motion.position(frame, joint)).z;
  };
  const double hips = depth_of(0);
  std::array<Vec3, kLandmarkCount> points;
  std::array<double, kLandmarkCount> visibility{};
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const Landmark landmark = static_cast<Landmark>(i);
    const Anchor anchor = anchor_of(landmark);
    const Vec2 beside = seen[landmark].position_px - seen[anchor.landmark].position_px;
    points[i] = onto_ray(carrying, placed.pose[anchor.joint] + carrying.ratio_px * beside,
                         carrying.metres * (depth_of(landmark_joint(landmark)) - hips));
    const bool is_known = seen[anchor.landmark].visibility >= kLeastVisibility &&
                          placed.expected_error[index(anchor.joint)] < kFarOff;
    visibility[i] = is_known ? std::min(seen[landmark].visibility, 1.0) : 0.0;
  }
  return {landmark_body_positions(points), landmark_body_confidence(visibility)};
}

// Which joints the coach shows in only a part of his frames, in one line.
class Hidden {
 public:
  void count(const Pose2d& pose) {
    ++frames_;
    for (std::size_t i = 0; i < kJoint2dCount; ++i) counts_[i] += pose.seen[i] ? 0 : 1;
  }
  std::vector<Joint2d> joints() const {
    std::vector<Joint2d> hidden;
    for (std::size_t i = 0; i < kJoint2dCount; ++i)
      if (counts_[i] > kFewFrames * frames_) hidden.push_back(static_cast<Joint2d>(i));
    return hidden;
  }
  std::optional<std::string> told() const {
    std::string list;
    for (const Joint2d joint : joints()) {
      const std::size_t i = index(joint);
      std::string name(to_string(static_cast<Joint2d>(i)));
      std::replace(name.begin(), name.end(), '_', ' ');
      list += (list.empty() ? "" : ", ") + name + " (" + std::to_string(counts_[i]) + " of " +
              std::to_string(frames_) + " frames)";
    }
    if (list.empty()) return std::nullopt;
    return text::drawn_without(list);
  }

 private:
  static constexpr double kFewFrames = 0.05;
  int frames_ = 0;
  std::array<int, kJoint2dCount> counts_{};
};

}  // namespace

Result<PictureCoach> coach_in_picture(const LiftedStudent& coach, const LiftedStudent& student,
                                      Transferer& transferer) {
  if (const Result<void> checked = check_sides(coach.view, student.view); !checked)
    return tl::unexpected(checked.error());
  const std::vector<ImageKeypoints> coach_frames = seen_by_camera(coach);
  const std::vector<Pose2d> source = pictures_of(coach_frames),
                            identity = pictures_of(seen_by_camera(student));
  if (const Result<void> set = transferer.set_people(source, identity); !set)
    return tl::unexpected(set.error());
  // Both were measured by set_people too, so there is something to measure.
  const BoneLengths2d his = *measure_bone_lengths(identity), coachs = *measure_bone_lengths(source);
  const double ratio_px = his.stature / coachs.stature;
  const double student_depth = hips_depth(student);
  const double metres =
      ratio_px * (student_depth / student.camera.focal_px) / (hips_depth(coach) / coach.camera.focal_px);
  const Carrying carrying{coach, student, ratio_px, metres, student_depth};
  const Placing placing(source, identity, ratio_px);

  std::vector<Vec3> positions;
  std::vector<double> confidence;
  Hidden hidden;
  for (int frame = 0; frame < coach.motion.frame_count(); ++frame) {
    const ImageKeypoints& seen = coach_frames[static_cast<std::size_t>(frame)];
    const Pose2d pose = pose2d_from_landmarks(seen);
    TransferredPose transferred = transferer.transfer(pose);
    transferred.pose = placing.placed(transferred.pose, pose);
    hidden.count(pose);
    const CarriedFrame carried = carry(carrying, frame, seen, transferred);
    positions.insert(positions.end(), carried.positions.begin(), carried.positions.end());
    confidence.insert(confidence.end(), carried.confidence.begin(), carried.confidence.end());
  }
  const std::span<const MediaTime> times = coach.motion.times();
  Result<Motion> motion = Motion::from_positions(student.body, {times.begin(), times.end()},
                                                 std::move(positions), std::move(confidence));
  if (!motion) return tl::unexpected(motion.error());
  std::vector<std::string> doubts = doubts_about_lengths(coachs, his);
  if (const std::optional<std::string> line = hidden.told()) doubts.insert(doubts.begin(), *line);
  return PictureCoach{*std::move(motion), hidden.joints(), std::move(doubts)};
}

Result<PictureCoach> coach_on_body(const LiftedStudent& coach, const Skeleton& body, Transferer& transferer) {
  if (!is_landmark_body(body))
    return fail(ErrorCode::InvalidArgument,
                "a coach is carried over from pictures to bodies that a camera measured only");
  // The T-pose from the front shows every bone at its true length; so far away that there is no perspective.
  constexpr double kFarAway_m = 60, kPictureHeight_m = 3;
  constexpr int kSize_px = 3000;
  Result<Motion> rest = Motion::from_positions(body, {MediaTime{}},
                                               {body.rest_positions().begin(), body.rest_positions().end()});
  if (!rest) return tl::unexpected(rest.error());
  // Held as the coach's is: so his picture's plane does not stand upright in the world where his camera looks
  // down on him.
  const Vec3 sight = Vec3{0, 0, 1} * coach.camera.rotation_camera_from_world;
  const Vec3 towards = glm::normalize(Vec3{0, -sight.y, std::hypot(sight.x, sight.z)});
  const PinholeCamera camera = make_camera_looking_at(Vec3{0, 1, 0} + kFarAway_m * towards, {0, 1, 0},
                                                      kPictureHeight_m / kFarAway_m, kSize_px, kSize_px);
  const LiftedStudent student{*std::move(rest), body, camera, coach.view, 0};
  return coach_in_picture(coach, student, transferer);
}

LiftedStudent mirrored(const LiftedStudent& filmed) {
  const Mat3 flip(Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1});
  LiftedStudent result = filmed;
  result.motion = mirrored(filmed.motion);
  result.body = mirrored(filmed.body);
  PinholeCamera& camera = result.camera;
  camera.rotation_camera_from_world = flip * camera.rotation_camera_from_world * flip;
  camera.translation_camera_from_world = flip * camera.translation_camera_from_world;
  camera.centre_px.x = camera.width_px - camera.centre_px.x;
  if (result.view == View::FaceOn) result.aside_deg = -result.aside_deg;
  return result;
}

Result<PoseTrack> still_film(const PoseTrack& pictures) {
  const auto seen = std::find_if(pictures.frames.begin(), pictures.frames.end(),
                                 [](const PoseObservation& frame) { return frame.person.has_value(); });
  if (seen == pictures.frames.end())
    return fail(ErrorCode::NoPerson, pictures.source + ": nobody is seen in the picture");
  PoseTrack film{pictures.source, pictures.width, pictures.height, {}};
  for (int i = 0; i < kStillFrames; ++i)
    film.frames.push_back({static_cast<std::size_t>(i), MediaTime{} + i * kStillStep, seen->person});
  return film;
}

}  // namespace posecoach
