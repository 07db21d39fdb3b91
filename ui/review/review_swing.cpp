#include "ui/review/review_swing.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "ui/review/find_golfer.h"

namespace posecoach {
namespace {

constexpr int kReplaySteps = 240;

Tempo tempo_of(double speed) {
  if (speed > 1.5) return Tempo::MuchFaster;
  if (speed > 1.1) return Tempo::Faster;
  if (speed < 1 / 1.5) return Tempo::MuchSlower;
  return speed < 1 / 1.1 ? Tempo::Slower : Tempo::Same;
}

std::vector<TempoPart> tempo_parts(const ReviewSwing& review) {
  std::vector<TempoPart> parts;
  const auto& steps = review.replay.steps;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    const auto time = [&](const ReplayStep& step) {
      const int last = review.picture_count() - 1;
      return review.times_s[index(std::clamp(step.student_frame, 0, last))];
    };
    const double begin = time(steps[i]), end = time(steps[i + 1]);
    const Tempo tempo = tempo_of(review.replay.speed_in_proportion(steps[i]));
    if (end <= begin) continue;
    if (!parts.empty() && parts.back().tempo == tempo)
      parts.back().end_s = end;
    else
      parts.push_back({begin, end, tempo});
  }
  return parts;
}

std::vector<std::optional<double>> apart_of(const Analysis& analysis, int pictures) {
  std::vector<std::pair<double, int>> sums(index(pictures));
  for (std::size_t i = 0; i < std::min(analysis.path.size(), analysis.path_error_m.size()); ++i) {
    const int picture = analysis.path[i].first;
    if (picture < 0 || picture >= pictures) continue;
    sums[index(picture)].first += analysis.path_error_m[i];
    ++sums[index(picture)].second;
  }
  std::vector<std::optional<double>> apart;
  for (const auto& [sum, count] : sums)
    apart.push_back(count > 0 ? std::optional(sum / count) : std::nullopt);
  return apart;
}

double front_of(const Motion& student, int frame) {
  const int left = student.skeleton().find(HumanoidJoint::LeftHip),
            right = student.skeleton().find(HumanoidJoint::RightHip);
  if (left == kNoJoint || right == kNoJoint) return 0;
  const Vec3 front =
      glm::cross(student.position(frame, left) - student.position(frame, right), Vec3(0, 1, 0));
  return std::atan2(front.x, front.z);
}

int motion_frame(const ReviewSwing& review, int picture) {
  const LiftedStudent& student = review.swing->student;
  return std::clamp(picture - student.first_frame, 0, student.motion.frame_count() - 1);
}

}  // namespace

std::shared_ptr<const ReviewSwing> make_review_swing(std::shared_ptr<const AnalyzedSwing> swing) {
  POSECOACH_ASSERT(swing != nullptr);
  auto review = std::make_shared<ReviewSwing>();
  review->swing = swing;
  for (const PoseObservation& seen : swing->track.frames) review->times_s.push_back(to_seconds(seen.time));
  const LiftedStudent& student = swing->student;
  const Analysis& analysis = swing->pair.analysis;
  const Motion& coach = swing->pair.coach;
  for (const SwingEvent& event : analysis.student_events) review->events.push_back(event.frame);
  for (int frame = 0; frame < coach.frame_count(); ++frame)
    review->coach_times_s.push_back(to_seconds(coach.time(frame) - coach.time(0)));
  std::vector<std::pair<int, int>> path = analysis.path;
  for (auto& [his, coachs] : path) his -= student.first_frame;
  review->placement = stand_on_feet(student.motion, coach, path);
  review->replay =
      make_replay({analysis, student.motion, student.first_frame, coach, Palette::RedGreen}, kReplaySteps);
  review->tempo = tempo_parts(*review);
  review->apart_m = apart_of(analysis, review->picture_count());
  review->golfer_px = find_golfer(*swing);
  review->front =
      front_of(student.motion, std::clamp(path.front().first, 0, student.motion.frame_count() - 1));
  return review;
}

BodiesAtPicture bodies_at(const ReviewSwing& review, int picture) {
  BodiesAtPicture bodies;
  const LiftedStudent& student = review.swing->student;
  const int frame = picture - student.first_frame;
  if (frame < 0 || frame >= student.motion.frame_count()) return bodies;
  PosedBody his{&student.motion.skeleton(), {}, {}};
  const auto positions = student.motion.positions(frame);
  his.positions.assign(positions.begin(), positions.end());
  for (int joint = 0; joint < student.motion.joint_count(); ++joint)
    his.confidence.push_back(student.motion.confidence(frame, joint));
  if (std::none_of(his.confidence.begin(), his.confidence.end(), [](double c) { return c > 0; }))
    return bodies;
  const Motion& coach = review.swing->pair.coach;
  bodies.coach_frame = review.placement.coach_frame[index(frame)];
  bodies.coach = PosedBody{&coach.skeleton(), review.placement.positions(coach, frame), {}};
  bodies.student = std::move(his);
  return bodies;
}

double coach_frame_at(const ReviewSwing& review, int picture) {
  return review.placement.coach_frame[index(motion_frame(review, picture))];
}

double coach_time_at(const ReviewSwing& review, int picture) {
  const double at = coach_frame_at(review, picture);
  const auto& times = review.coach_times_s;
  const auto first = static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(times.size()) - 1));
  const std::size_t second = std::min(first + 1, times.size() - 1);
  return times[first] + (at - static_cast<double>(first)) * (times[second] - times[first]);
}

int picture_of_coach_time(const ReviewSwing& review, double coach_s) {
  int best = 0;
  double nearest = 1e18;
  const int first = review.swing->student.first_frame;
  const int count = review.swing->student.motion.frame_count();
  for (int picture = first; picture < std::min(first + count, review.picture_count()); ++picture) {
    const double distance = std::abs(coach_time_at(review, picture) - coach_s);
    if (distance >= nearest) continue;
    nearest = distance;
    best = picture;
  }
  return best;
}

int matching_picture(const ReviewSwing& first, const ReviewSwing& second, int picture) {
  const int last_of_first = std::max(1, first.picture_count() - 1);
  const int last_of_second = std::max(0, second.picture_count() - 1);
  // Knots: the films' ends, and the events that both have.
  std::vector<std::pair<int, int>> knots = {{0, 0}};
  for (const SwingEvent& event : first.analysis().student_events)
    for (const SwingEvent& other : second.analysis().student_events)
      if (event.name == other.name && event.frame > knots.back().first && other.frame >= knots.back().second)
        knots.emplace_back(event.frame, other.frame);
  if (last_of_first > knots.back().first) knots.emplace_back(last_of_first, last_of_second);
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (picture > knots[i].first && i + 1 < knots.size()) continue;
    const auto& [from, other_from] = knots[i - 1];
    const auto& [to, other_to] = knots[i];
    const double share = static_cast<double>(picture - from) / std::max(1, to - from);
    const double matched = other_from + share * (other_to - other_from);
    return std::clamp(static_cast<int>(std::lround(matched)), 0, last_of_second);
  }
  return std::clamp(picture, 0, last_of_second);
}

}  // namespace posecoach
