#include "ui/report/overlay_film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "ui/render/words.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kStillHeight_px = 560;
constexpr double kStillAspect = 0.75;
constexpr double kNearEvent_s = 0.07;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

// Joints that a golfer can be told about.
constexpr std::array kSpokenJoints = {Head,       LeftShoulder, RightShoulder, LeftElbow,
                                      RightElbow, LeftWrist,    RightWrist,    LeftHip,
                                      RightHip,   LeftKnee,     RightKnee};

struct Farthest {
  HumanoidJoint joint = Pelvis;
  Vec3 student, coach;
  double distance_m = 0;
};

// As the score sees it: with both pelvises in one place.
std::optional<Farthest> farthest_joint(const BodyState& student, const BodyState& coach) {
  const auto at = [](const BodyState& body, HumanoidJoint role) -> std::optional<Vec3> {
    const int joint = body.skeleton.find(role);
    if (joint == kNoJoint || (!body.confidence.empty() && body.confidence[index(joint)] < 0.5))
      return std::nullopt;
    return body.positions[index(joint)];
  };
  const auto his_root = at(student, Pelvis), coachs_root = at(coach, Pelvis);
  if (!his_root || !coachs_root) return std::nullopt;
  std::optional<Farthest> farthest;
  for (const HumanoidJoint role : kSpokenJoints) {
    const auto his = at(student, role), coachs = at(coach, role);
    if (!his || !coachs) continue;
    const double distance = glm::length((*his - *his_root) - (*coachs - *coachs_root));
    if (!farthest || distance > farthest->distance_m) farthest = Farthest{role, *his, *coachs, distance};
  }
  return farthest;
}

std::string caption_of(const std::string& phase, const std::optional<Farthest>& farthest) {
  if (!farthest) return phase;
  std::string joint = title_from_name(to_string(farthest->joint));
  if (!phase.empty()) joint[0] = static_cast<char>(joint[0] - 'A' + 'a');
  return (phase.empty() ? "" : phase + ": ") + joint + " " + decimal(100 * farthest->distance_m, 0) +
         " cm away";
}

struct Crop {
  int left = 0, top = 0, width = 0, height = 0;
};

// Around both bodies with some air, three parts wide and four high as far as the picture reaches.
Crop crop_around(const std::vector<Vec2>& points, int width, int height) {
  Vec2 low(1e9), high(-1e9);
  for (const Vec2& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  if (points.empty()) return {0, 0, width, height};
  const Vec2 air = 1.2 * (high - low);
  const double tall =
      std::min({std::max(air.y, air.x / kStillAspect), static_cast<double>(height), width / kStillAspect});
  const Vec2 size(kStillAspect * tall, tall);
  const Vec2 corner = glm::clamp(0.5 * (low + high) - 0.5 * size, Vec2(0), Vec2(width, height) - size);
  const auto whole = [](double value) { return static_cast<int>(std::floor(value)); };
  if (tall < 8) return {0, 0, width, height};
  return {whole(corner.x), whole(corner.y), whole(size.x), whole(size.y)};
}

Image cut_out(const Image& image, const Crop& crop) {
  Image result = Image::black(crop.width, crop.height);
  for (int y = 0; y < crop.height; ++y)
    std::copy_n(image.pixel(crop.left, crop.top + y), 3 * static_cast<std::size_t>(crop.width),
                result.pixel(0, y));
  return result;
}

}  // namespace

struct OverlayFilm::Bodies {
  int motion_frame = 0;
  std::vector<double> confidence;
  std::vector<Vec3> coach;
  BodyState student_state, coach_state;  // look into the vectors above, which a move leaves where they are

  Bodies(Bodies&&) = default;
  Bodies(const Comparison& comparison, const CoachPlacement& placement, int frame)
      : motion_frame(frame),
        confidence(index(comparison.student.joint_count())),
        coach(placement.positions(comparison.coach, frame)),
        student_state{comparison.student.skeleton(), comparison.student.positions(frame)},
        coach_state{comparison.coach.skeleton(), {}} {
    for (int joint = 0; joint < comparison.student.joint_count(); ++joint)
      confidence[index(joint)] = comparison.student.confidence(frame, joint);
    student_state.confidence = confidence;
    coach_state.positions = coach;
  }
  bool is_student_seen() const {
    return std::any_of(confidence.begin(), confidence.end(), [](double c) { return c > 0; });
  }
};

OverlayFilm::OverlayFilm(const Comparison& comparison, const PinholeCamera& camera, SceneRenderer& renderer)
    : comparison_(comparison),
      camera_(camera),
      renderer_(renderer),
      story_(make_overlay_story(comparison.analysis, comparison.palette)) {
  POSECOACH_ASSERT(!comparison.analysis.path.empty());
  std::vector<std::pair<int, int>> path = comparison.analysis.path;
  for (auto& [student, coach] : path) student -= comparison.first_frame;
  placement_ = stand_on_feet(comparison.student, comparison.coach, path, comparison.coach_yaw);
  const auto& errors = comparison.analysis.path_error_m;
  std::vector<std::pair<double, int>> sums(index(comparison.first_frame + comparison.student.frame_count()));
  for (std::size_t i = 0; i < std::min(errors.size(), comparison.analysis.path.size()); ++i) {
    const int frame = comparison.analysis.path[i].first;
    if (frame < 0 || index(frame) >= sums.size()) continue;
    sums[index(frame)].first += errors[i];
    ++sums[index(frame)].second;
  }
  apart_m_.resize(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i].second > 0) apart_m_[i] = sums[i].first / sums[i].second;
}

std::optional<OverlayFilm::Bodies> OverlayFilm::bodies_at(int motion_frame) const {
  if (motion_frame < 0 || motion_frame >= comparison_.student.frame_count()) return std::nullopt;
  return std::optional<Bodies>(std::in_place, comparison_, placement_, motion_frame);
}

OverlayMoment OverlayFilm::moment_at(const Frame& frame, const std::optional<Bodies>& bodies) const {
  const Analysis& analysis = comparison_.analysis;
  const auto film_frame = static_cast<double>(frame.index);
  const auto fraction = [](double value, int frames) { return frames > 1 ? value / (frames - 1) : 0.0; };
  OverlayMoment moment;
  moment.film = frame.image;
  moment.time_s = to_seconds(frame.time);
  moment.student_fraction = fraction(film_frame, analysis.student.frames);
  const double fps = analysis.student.seconds > 0 ? analysis.student.frames / analysis.student.seconds : 30;
  moment.phase = phase_title(analysis.student_events, film_frame, std::max(0.5, kNearEvent_s * fps));
  if (frame.index < apart_m_.size()) moment.apart_m = apart_m_[frame.index];
  if (bodies && bodies->is_student_seen()) {
    moment.student.emplace(bodies->student_state);
    moment.coach.emplace(bodies->coach_state);
    moment.coach_fraction =
        fraction(placement_.coach_frame[index(bodies->motion_frame)], analysis.coach.frames);
  }
  return moment;
}

Image OverlayFilm::draw(const Frame& frame) {
  const std::optional<Bodies> bodies = bodies_at(static_cast<int>(frame.index) - comparison_.first_frame);
  const PinholeCamera camera = scaled_to(camera_, frame.image->width, frame.image->height);
  renderer_.render(make_overlay_scene(story_, moment_at(frame, bodies), camera), camera);
  return renderer_.read_image();
}

ReportPicture OverlayFilm::draw_still(const Frame& frame, const FramePair& pair) {
  const std::optional<Bodies> bodies = bodies_at(static_cast<int>(frame.index) - comparison_.first_frame);
  const OverlayMoment moment = moment_at(frame, bodies);
  const PinholeCamera film_camera = scaled_to(camera_, frame.image->width, frame.image->height);
  std::vector<Vec2> points;
  for (const std::optional<BodyState>& body : {moment.student, moment.coach})
    if (body)
      for (const Vec3& p : body->positions)
        if (const std::optional<Vec2> at = film_camera.project(p)) points.push_back(*at);
  Crop crop = crop_around(points, frame.image->width, frame.image->height);

  const double scale = std::clamp(kStillHeight_px / crop.height, 0.05, 4.0);
  const auto larger = [&](int value) { return static_cast<int>(std::lround(value * scale)); };
  const PinholeCamera camera = scaled_to(film_camera, std::max(8, larger(frame.image->width)),
                                         std::max(8, larger(frame.image->height)));
  std::optional<Farthest> farthest;
  std::optional<OverlayHighlight> highlight;
  if (moment.student && moment.coach) farthest = farthest_joint(*moment.student, *moment.coach);
  if (farthest) highlight = {farthest->student, farthest->coach};
  renderer_.render(make_bodies_scene(moment, comparison_.palette, camera, highlight), camera);
  crop = {larger(crop.left), larger(crop.top), larger(crop.width), larger(crop.height)};
  crop.width = std::min(crop.width, camera.width_px - crop.left);
  crop.height = std::min(crop.height, camera.height_px - crop.top);
  return {pair.student_frame, pair.coach_frame, cut_out(renderer_.read_image(), crop),
          caption_of(moment.phase, farthest)};
}

Result<std::vector<ReportPicture>> draw_overlay_film(const Comparison& comparison,
                                                     const PinholeCamera& camera, SceneRenderer& renderer,
                                                     const NextFrame& next, const FrameSink& sink,
                                                     const Progress& progress) {
  OverlayFilm overlay(comparison, camera, renderer);
  const std::vector<FramePair>& worst = comparison.analysis.worst_frames;
  std::vector<std::optional<ReportPicture>> stills(worst.size());
  const double frames = std::max(1, comparison.analysis.student.frames);
  std::size_t found = 0;
  while (sink || found < worst.size()) {
    Result<std::optional<Frame>> frame = next();
    if (!frame) return tl::unexpected(frame.error());
    if (!*frame) break;
    const Frame& now = **frame;
    for (std::size_t i = 0; i < worst.size(); ++i)
      if (static_cast<std::size_t>(std::max(0, worst[i].student_frame)) == now.index && !stills[i]) {
        stills[i] = overlay.draw_still(now, worst[i]);
        ++found;
      }
    if (sink)
      if (const Result<void> taken = sink(overlay.draw(now), now); !taken)
        return tl::unexpected(taken.error());
    if (!report(progress, "drawing", std::min(1.0, (static_cast<double>(now.index) + 1) / frames)))
      return fail(ErrorCode::Cancelled, "interrupted while drawing the film");
  }
  std::vector<ReportPicture> pictures;
  for (std::optional<ReportPicture>& still : stills)
    if (still) pictures.push_back(std::move(*still));
  return pictures;
}

std::vector<ReportPicture> draw_motion_stills(const Comparison& comparison, SceneRenderer& renderer) {
  const Motion& student = comparison.student;
  std::vector<std::pair<int, int>> path = comparison.analysis.path;
  for (auto& [his, coachs] : path) his -= comparison.first_frame;
  const CoachPlacement placement = stand_on_feet(student, comparison.coach, path, comparison.coach_yaw);
  std::vector<ReportPicture> pictures;
  for (const FramePair& pair : comparison.analysis.worst_frames) {
    const int frame = std::clamp(pair.student_frame - comparison.first_frame, 0, student.frame_count() - 1);
    const std::vector<Vec3> coach = placement.positions(comparison.coach, frame);
    OverlayMoment moment;
    moment.student.emplace(BodyState{student.skeleton(), student.positions(frame)});
    moment.coach.emplace(BodyState{comparison.coach.skeleton(), coach});
    Vec3 low(1e9), high(-1e9);
    for (const BodyState* body : {&*moment.student, &*moment.coach})
      for (const Vec3& p : body->positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    const Vec3 middle = 0.5 * (low + high);
    const int left_hip = student.skeleton().find(LeftHip), right_hip = student.skeleton().find(RightHip);
    Vec3 front(0, 0, 1);
    if (left_hip != kNoJoint && right_hip != kNoJoint) {
      // At the first frame of the swing he stands square to the ball.
      const int address = std::clamp(path.front().first, 0, student.frame_count() - 1);
      const Vec3 across = student.position(address, left_hip) - student.position(address, right_hip);
      const Vec3 ahead = glm::cross(across, Vec3(0, 1, 0));
      if (glm::length(ahead) > 1e-6) front = glm::normalize(ahead);
    }
    const double reach = std::max(high.y - low.y, 0.75 * std::max(high.x - low.x, high.z - low.z));
    constexpr double kViewAngle = 0.5;
    const double distance = 0.62 * reach / std::tan(0.5 * kViewAngle);
    const PinholeCamera camera = make_camera_looking_at(
        middle + distance * front + Vec3(0, 0.12 * distance, 0), middle, kViewAngle, 420, 560);
    const std::optional<Farthest> farthest = farthest_joint(*moment.student, *moment.coach);
    std::optional<OverlayHighlight> highlight;
    if (farthest) highlight = {farthest->student, farthest->coach};
    Scene scene = make_bodies_scene(moment, comparison.palette, camera, highlight);
    scene.floor = Floor{};
    scene.floor->centre = {middle.x, low.y, middle.z};
    renderer.render(scene, camera);
    const double fps = comparison.analysis.student.seconds > 0
                           ? comparison.analysis.student.frames / comparison.analysis.student.seconds
                           : 30;
    pictures.push_back({pair.student_frame, pair.coach_frame, renderer.read_image(),
                        caption_of(phase_title(comparison.analysis.student_events, pair.student_frame,
                                               std::max(0.5, kNearEvent_s * fps)),
                                   farthest)});
  }
  return pictures;
}

}  // namespace posecoach
