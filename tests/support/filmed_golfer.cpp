#include "tests/support/filmed_golfer.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/body/landmark_body.h"
#include "core/motion/bundled_motion.h"
#include "core/retarget/retarget.h"
#include "tests/core/retarget/motions.h"

namespace posecoach {
namespace {

using Pose = std::vector<Vec3>;

Pose pose_of(const Motion& motion, int frame) {
  const auto positions = motion.positions(frame);
  return {positions.begin(), positions.end()};
}

bool is_hand_or_forearm(std::size_t joint) {
  const auto landmark = landmark_of_joint(static_cast<int>(joint));
  return landmark && *landmark >= Landmark::LeftWrist && *landmark <= Landmark::RightThumb;
}

// The hands go to and fro along the target line and a little up, as with a club that is shaken loose.
Pose waggled(const Pose& address, double t) {
  Pose pose = address;
  const double away = 0.035 * (1 - std::cos(2 * kPi * 1.2 * t));
  for (std::size_t j = 0; j < pose.size(); ++j)
    if (is_hand_or_forearm(j)) pose[j] += Vec3(-away, 0.2 * away, 0);
  return pose;
}

// To and fro before the camera; arms hang and swing apart.
Pose walked(const Skeleton& body, double t) {
  Pose pose(body.rest_positions().begin(), body.rest_positions().end());
  const double place = 0.8 * std::sin(0.9 * t), swing = 0.25 * std::sin(2 * kPi * 0.9 * t);
  const auto at = [&](Landmark l) -> Vec3& { return pose[static_cast<std::size_t>(landmark_joint(l))]; };
  for (const bool left : {true, false}) {
    const auto side = [&](Landmark l) { return left ? l : mirrored(l); };
    const double forward = left ? swing : -swing;
    const Vec3 shoulder = at(side(Landmark::LeftShoulder));
    const Vec3 elbow = shoulder + 0.29 * glm::normalize(Vec3(left ? 0.1 : -0.1, -1, forward));
    const Vec3 wrist = elbow + 0.26 * glm::normalize(Vec3(left ? 0.1 : -0.1, -1, 2 * forward + 0.2));
    const Vec3 shift = wrist - at(side(Landmark::LeftWrist));
    at(side(Landmark::LeftElbow)) = elbow;
    at(side(Landmark::LeftWrist)) = wrist;
    for (const Landmark l : {Landmark::LeftPinky, Landmark::LeftIndex, Landmark::LeftThumb})
      at(side(l)) += shift;
    for (const Landmark l :
         {Landmark::LeftKnee, Landmark::LeftAnkle, Landmark::LeftHeel, Landmark::LeftFootIndex})
      at(side(l)).z -= 0.8 * forward;
  }
  for (Vec3& p : pose) p.x += place;
  return pose;
}

class Filming {
 public:
  Filming(const GolferScript& script, const PinholeCamera& camera, const PoseNoise& noise, unsigned seed)
      : script_(script), stroke_(make_stroke(script)), noise_(noise), random_(seed) {
    film_.camera = camera;
    Image image = Image::black(camera.width_px, camera.height_px);
    std::fill(image.rgb.begin(), image.rgb.end(), std::uint8_t{120});
    film_.picture = std::make_shared<const Image>(std::move(image));
  }

  GolferFilm film() && {
    Pose last = pose_of(stroke_, 0);
    for (const GolferPart& part : script_.parts) add(part, last);
    return std::move(film_);
  }

 private:
  static Motion make_stroke(const GolferScript& script) {
    const Motion stroke =
        retarget(resample(bundled_motion(script.stroke).value(), script.fps * script.slower),
                 test_landmark_body(script.size))
            ->motion;
    return script.is_left_handed ? mirrored(stroke) : stroke;
  }

  Pose stroke_pose(int frame) const {
    Pose pose = pose_of(stroke_, frame);
    const Pose address = pose_of(stroke_, 0);
    for (std::size_t j = 0; j < pose.size(); ++j) pose[j] = glm::mix(address[j], pose[j], script_.length);
    return pose;
  }

  void add(const GolferPart& part, Pose& last) {
    using enum GolferPart::Kind;
    if (part.kind == Stroke) {
      film_.stroke_begin_s.push_back(now_s());
      for (int f = 0; f < stroke_.frame_count(); ++f) take(last = stroke_pose(f));
      film_.stroke_end_s.push_back(now_s());
      return;
    }
    if (part.kind == Rehearse) {
      const int turn = static_cast<int>(std::lround(part.seconds * script_.fps * script_.slower));
      for (int f = 0; f <= 2 * turn; ++f) take(last = stroke_pose(turn - std::abs(turn - f)));
      return;
    }
    const Pose from = last;
    const int frames = static_cast<int>(std::lround(part.seconds * script_.fps));
    for (int f = 0; f < frames; ++f) {
      const double t = f / script_.fps;
      Pose to = aim(part.kind, t);
      // From one part to the next in six tenths of a second.
      const double x = std::min(1.0, t / 0.6), part_done = x * x * (3 - 2 * x);
      for (std::size_t j = 0; j < to.size(); ++j) to[j] = glm::mix(from[j], to[j], part_done);
      last = to;
      if (part.kind == Away)
        take_nobody();
      else
        take(last);
    }
  }

  Pose aim(GolferPart::Kind kind, double t) const {
    const Skeleton& body = stroke_.skeleton();
    switch (kind) {
      case GolferPart::Kind::Waggle: {
        Pose pose = waggled(pose_of(stroke_, 0), t);
        return pose;
      }
      case GolferPart::Kind::Walk:
        return walked(body, t);
      case GolferPart::Kind::Finish:
        return stroke_pose(stroke_.frame_count() - 1);
      case GolferPart::Kind::TPose:
        return {body.rest_positions().begin(), body.rest_positions().end()};
      default:
        return pose_of(stroke_, 0);
    }
  }

  double now_s() const { return static_cast<double>(film_.times.size()) / script_.fps; }

  void take_nobody() {
    film_.times.push_back(media_time_from_seconds(now_s()));
    film_.people.emplace_back();
    film_.truth.emplace_back();
  }

  void take(const Pose& pose) {
    std::normal_distribution<double> normal;
    const PinholeCamera& camera = film_.camera;
    SeenPerson person;
    const Vec3 hips = camera.camera_from_world(pose[0]);
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const Vec3& p = pose[i + kLandmarkBodyDerivedJoints];
      person.image[i] = {*camera.project(p) + noise_.image_px * Vec2(normal(random_), normal(random_)), 0.95};
      person.world[i] = {camera.camera_from_world(p) - hips +
                             Vec3(noise_.world_m * normal(random_), noise_.world_m * normal(random_),
                                  noise_.depth_m * normal(random_)),
                         0.95};
    }
    film_.times.push_back(media_time_from_seconds(now_s()));
    film_.people.emplace_back(person);
    film_.truth.push_back(pose);
  }

  GolferScript script_;
  Motion stroke_;
  PoseNoise noise_;
  std::mt19937 random_;
  GolferFilm film_;
};

}  // namespace

PinholeCamera face_on_camera() {
  return make_camera_looking_at({0, 0.9, 4.0}, {0, 1.02, 0.1}, radians_from_degrees(54), 1280, 720);
}

PinholeCamera down_the_line_camera(bool is_left_handed) {
  return make_camera_looking_at({is_left_handed ? 3.9 : -3.9, 0.9, 0.28}, {0, 1.02, 0.28},
                                radians_from_degrees(54), 1280, 720);
}

GolferFilm film_golfer(const GolferScript& script, const PinholeCamera& camera, const PoseNoise& noise,
                       unsigned seed) {
  return Filming(script, camera, noise, seed).film();
}

Result<PoseObservation> KnowingEstimator::estimate(const Frame& frame) {
  if (frame.index >= film_->count()) return PoseObservation{frame.index, frame.time, std::nullopt};
  return PoseObservation{frame.index, frame.time, film_->people[frame.index]};
}

}  // namespace posecoach
