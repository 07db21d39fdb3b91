#include "core/coaching/swing_finder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kGap_s = 0.5;
constexpr double kMemory_s = 1.2;
// Takes the edge off trembling joints; a swing is slower.
constexpr double kSteadied_s = 0.04;
constexpr double kPostureFollows_s = 0.5;
// All lengths below are in torsos (hips to shoulders, about half a metre).
// At address the hands stay this close to each other and to their place for this long.
constexpr double kRest_s = 0.35, kRestWithin = 0.04, kFeetWithin = 0.12;
// A slow turn at the top of a putt is not a new address: that takes longer.
constexpr double kNewRest_s = 1.0, kRestFollows_s = 1.0;
// Hands spread so many times as far as they tremble, and a little more, are creeping.
constexpr double kCreeping = 2, kLeastCreeping = 0.004, kTremblingFollows_s = 4, kCalmsDown_s = 0.3;
// One trembling frame may be this many times as far off.
constexpr double kOutlier = 3;
constexpr double kGrip = 0.6;
// Down the line the hands are seen in front of the hips.
constexpr double kHandsInFront = 0.2;
constexpr double kNearRest = 0.05, kLeft = 0.11, kNearOfLeft = 0.5;
constexpr double kFeetLeft = 0.5;
// The least that a stroke goes back; what is larger swings up on both sides.
constexpr double kLeastBack = 0.11, kLargeStroke = 0.7;
constexpr double kPassesWithin = 0.35;
constexpr double kLeastThrough = 0.12, kThroughOfBack = 0.4;
constexpr double kLongestBack_s = 8, kLongestThrough_s = 1.6;
// A small stroke that has not come through by then was a waggle.
constexpr double kLongestWaggle_s = 0.7;
// A slow rehearsal is slow through the ball; one that stops there is none.
constexpr double kStopped_s = 0.8, kSlow = 1.25;
constexpr double kFinish_s = 0.25, kFinishWithin = 0.05, kSmallFinishWithin = 0.03;
// A short putt that still moves does so by no more than a long one that rests.
constexpr double kRestOfThrough = 0.1, kRestOfTrembling = 4;
constexpr double kFinishHeld = 0.6;
// From the address to the ball a full swing takes about so long; what takes longer is slow all the way.
constexpr double kUsualToBall_s = 1.2, kSlowest = 4;
// A small stroke goes through by this many times its way back at most; more is a backswing after a waggle.
// Seen from in front, a pose model lets the hands of a putt go back less than they do.
constexpr double kMostThroughOfBack = 4, kMostThroughOfPutt = 0.45;
// The least lengths of strokes are for hands that tremble so much at address; the less they do, the shorter a
// putt may be.
constexpr double kMuchTrembling = 0.012, kShortest = 0.35;

// Between two samples the hands went straight.
double nearest_to(const Vec3& place, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double length = glm::dot(way, way);
  const double part = length > 0 ? std::clamp(glm::dot(place - from, way) / length, 0.0, 1.0) : 0.0;
  return glm::distance(place, from + part * way);
}

}  // namespace

void SwingFinder::follow_posture(MediaTime time, const JointMoment& student) {
  if (posture_ && phase_ == Phase::Swinging) return;
  const PuttPosture now = putt_posture(student);
  if (!posture_ || samples_.empty()) {
    posture_ = now;
    return;
  }
  posture_ =
      between(*posture_, now, 1 - std::exp(-to_seconds(time - samples_.back().time) / kPostureFollows_s));
}

std::optional<SwingFinder::Sample> SwingFinder::sample_of(MediaTime time, const JointMoment& student,
                                                          const Sight& sight) {
  const double torso =
      glm::distance(student.middle(LeftShoulder, RightShoulder), student.middle(LeftHip, RightHip));
  if (torso < 0.1) return std::nullopt;
  // Bent or turned, a torso looks short: its length is the longest of late.
  torso_m_ = std::max(torso, torso_m_ - 0.0005 * torso_m_);
  follow_posture(time, student);
  Vec3 hands = Pendulum(*posture_, sight)
                   .hands(student.middle(LeftWrist, RightWrist) - student.middle(LeftHip, RightHip),
                          student.at(LeftShoulder) - student.at(RightShoulder)) /
               torso_m_;
  if (!samples_.empty()) {
    const double seconds = to_seconds(time - samples_.back().time);
    hands = glm::mix(samples_.back().hands, hands, 1 - std::exp(-seconds / kSteadied_s));
  }
  return Sample{time, hands, sight.seen(student.middle(LeftAnkle, RightAnkle)) / torso_m_};
}

std::optional<FoundSwing> SwingFinder::step(MediaTime time, const JointMoment& student, const Sight& sight) {
  double seconds = samples_.empty() ? 0 : to_seconds(time - samples_.back().time);
  if (seconds < 0 || seconds > kGap_s) {
    reset();
    seconds = 0;
  }
  const std::optional<Sample> sample = sample_of(time, student, sight);
  if (!sample) return std::nullopt;
  samples_.push_back(*sample);
  while (to_seconds(time - samples_.front().time) > kMemory_s) samples_.pop_front();
  if (phase_ != Phase::Searching && glm::distance(sample->hands, rest_) < near_rest()) near_rest_at_ = time;
  if (phase_ == Phase::Swinging) return follow(student, sight);
  search(student, sight, seconds);
  return std::nullopt;
}

std::optional<double> SwingFinder::trembling(double seconds, double hands_within) const {
  const Sample& last = samples_.back();
  if (to_seconds(last.time - samples_.front().time) < seconds) return std::nullopt;
  const Vec3 mean = mean_hands(seconds);
  double sum = 0;
  int count = 0;
  for (const Sample& sample : samples_) {
    if (to_seconds(last.time - sample.time) > seconds) continue;
    const double off = glm::distance(sample.hands, mean);
    if (off > kOutlier * hands_within || glm::distance(sample.feet, last.feet) > kFeetWithin)
      return std::nullopt;
    sum += off * off;
    ++count;
  }
  // Hands that are just leaving are far from where they were most of the time.
  const double spread = std::sqrt(sum / count);
  if (spread >= hands_within || glm::distance(last.hands, mean) >= kNearRest) return std::nullopt;
  return spread;
}

bool SwingFinder::is_resting(double seconds, double hands_within) const {
  return trembling(seconds, hands_within).has_value();
}

bool SwingFinder::is_creeping(double spread) const {
  return spread > kCreeping * trembling_ + kLeastCreeping;
}

double SwingFinder::shortest() const {
  return std::clamp(trembling_ / kMuchTrembling, kShortest, 1.0);
}

double SwingFinder::near_rest() const {
  return std::min(kNearRest, kNearOfLeft * shortest() * kLeft);
}

// A large stroke comes back to where the hands rested. Of a small one it is enough that the hands are as far
// as there on their way: a pose model does not let them come back quite.
bool SwingFinder::passes_rest() const {
  const Vec3 away = samples_.back().hands - stroke_.rest;
  const double back = glm::length(stroke_.back), within = std::max(near_rest(), kPassesWithin * back);
  const double nearest = samples_.size() < 2 ? glm::length(away)
                                             : nearest_to(stroke_.rest, samples_[samples_.size() - 2].hands,
                                                          samples_.back().hands);
  if (nearest <= within) return true;
  if (back >= kLargeStroke || back < shortest() * kLeastBack) return false;
  const double along = glm::dot(away, stroke_.back) / back;
  return along <= kPassesWithin * back && glm::length(away - along / back * stroke_.back) < back;
}

Vec3 SwingFinder::mean_hands(double seconds) const {
  Vec3 sum;
  int count = 0;
  for (const Sample& sample : samples_)
    if (to_seconds(samples_.back().time - sample.time) <= seconds) {
      sum += sample.hands;
      ++count;
    }
  return sum / static_cast<double>(count);
}

bool SwingFinder::has_hands_on_club(const JointMoment& student, const Sight& sight) const {
  const double apart = glm::length(sight.seen(student.at(LeftWrist) - student.at(RightWrist))) / torso_m_;
  const double shoulders = student.middle(LeftShoulder, RightShoulder).y;
  const double knees = student.middle(LeftKnee, RightKnee).y;
  const double hands = student.middle(LeftWrist, RightWrist).y;
  const Vec3 across = student.at(LeftHip) - student.at(RightHip);
  const bool sees_front = sight.direction && std::abs(glm::dot(*sight.direction, across)) >
                                                 0.7 * std::max(1e-6, glm::length(across));
  const Vec3& over_pelvis = samples_.back().hands;
  return apart < kGrip && hands < shoulders - 0.2 * torso_m_ && hands > knees - 0.1 * torso_m_ &&
         (!sees_front || std::hypot(over_pelvis.x, over_pelvis.z) > kHandsInFront);
}

void SwingFinder::search(const JointMoment& student, const Sight& sight, double seconds) {
  const Sample& now = samples_.back();
  const bool is_near = phase_ == Phase::AtAddress && glm::distance(now.hands, rest_) < kNearRest;
  const double rest_s = is_near || phase_ != Phase::AtAddress ? kRest_s : kNewRest_s;
  const std::optional<double> spread = trembling(rest_s, kRestWithin);
  if (spread && is_near) {
    // Hands that creep away do not take the rest along: a putt begins slowly.
    if (!is_creeping(*spread))
      rest_ += std::min(1.0, seconds / kRestFollows_s) * (mean_hands(kRest_s) - rest_);
    const double follows_s = *spread < trembling_ ? kCalmsDown_s : kTremblingFollows_s;
    trembling_ += std::min(1.0, seconds / follows_s) * (*spread - trembling_);
  } else if (spread && (phase_ != Phase::AtAddress || !is_creeping(*spread))) {
    give_up();
    if (has_hands_on_club(student, sight)) {
      phase_ = Phase::AtAddress;
      rest_ = mean_hands(kRest_s);
      trembling_ = *spread;
      rest_feet_ = now.feet;
      near_rest_at_ = now.time;
    }
  }
  if (phase_ != Phase::AtAddress) return;
  address_s_ += seconds;
  if (glm::distance(now.feet, rest_feet_) > kFeetLeft) return give_up();
  if (glm::distance(now.hands, rest_) < shortest() * kLeft) return;
  phase_ = Phase::Swinging;
  stroke_ = {near_rest_at_, rest_, rest_feet_, now.hands - rest_, {}, std::nullopt};
}

void SwingFinder::give_up() {
  phase_ = Phase::Searching;
  address_s_ = 0;
}

std::optional<FoundSwing> SwingFinder::follow(const JointMoment& student, const Sight& sight) {
  const Sample& now = samples_.back();
  if (stroke_.passed_at) return go_through();
  const Vec3 away = now.hands - stroke_.rest;
  const std::optional<double> spread = trembling(kNewRest_s, kRestWithin);
  const bool has_new_address = spread && !is_creeping(*spread) && has_hands_on_club(student, sight);
  if (has_new_address || glm::distance(now.feet, stroke_.feet) > kFeetLeft ||
      to_seconds(now.time - stroke_.begin) > kLongestBack_s) {
    give_up();
    return std::nullopt;
  }
  if (glm::length(away) > glm::length(stroke_.back)) stroke_.back = away;
  const double back = glm::length(stroke_.back);
  if (!passes_rest()) return std::nullopt;
  if (back >= shortest() * kLeastBack) {
    stroke_.passed_at = now.time;
    stroke_.through = glm::length(away) < back ? away : Vec3(0);
  } else if (glm::length(away) < near_rest()) {
    phase_ = Phase::AtAddress;  // a twitch
  }
  return std::nullopt;
}

double SwingFinder::slowness() const {
  return std::clamp(to_seconds(*stroke_.passed_at - stroke_.begin) / kUsualToBall_s, 1.0, kSlowest);
}

std::optional<FoundSwing> SwingFinder::go_through() {
  const Sample& now = samples_.back();
  const Vec3 away = now.hands - stroke_.rest;
  const double since_s = to_seconds(now.time - *stroke_.passed_at);
  const double back = glm::length(stroke_.back);
  if (glm::length(away) > glm::length(stroke_.through)) stroke_.through = away;
  const double through = glm::length(stroke_.through);
  const bool is_large = back >= kLargeStroke;
  if (!is_large && through > std::max(kMostThroughOfBack * back, kMostThroughOfPutt)) {
    stroke_.back = stroke_.through;
    stroke_.begin = near_rest_at_;
    stroke_.passed_at.reset();
    return std::nullopt;
  }
  const bool is_other_side = glm::dot(stroke_.through, stroke_.back) < 0;
  const bool went_through =
      through >= std::max(shortest() * kLeastThrough, kThroughOfBack * back) && (is_large || is_other_side);
  const bool is_held = glm::length(away) > kFinishHeld * through;
  // Hands in slow motion seem to rest: they must rest for as much longer.
  const double slower = is_large ? slowness() : 1;
  const double finish_s = kFinish_s * slower, longest_s = kLongestThrough_s * slower;
  const double small_within =
      std::clamp(kRestOfThrough * through, std::min(kRestOfTrembling * trembling_, kSmallFinishWithin),
                 kSmallFinishWithin);
  const bool rests = since_s >= finish_s && is_resting(finish_s, is_large ? kFinishWithin : small_within);
  const bool is_slow = is_large && slower > kSlow;
  const bool has_stopped = rests && glm::length(away) < kLeft && (!is_slow || since_s > kStopped_s);
  // Back twice, with a rest at the ball between.
  const bool has_rehearsed = has_stopped && !is_other_side;
  if (went_through && !has_rehearsed && ((rests && is_held) || (is_large && since_s > longest_s))) {
    const bool goes_up = stroke_.back.y > kLargeStroke;
    const FoundSwing found{goes_up ? StrokeKind::FullSwing : StrokeKind::Putt, stroke_.begin, now.time};
    give_up();
    return found;
  }
  if (has_rehearsed || (!went_through && (has_stopped || (!is_large && since_s > kLongestWaggle_s))))
    phase_ = Phase::AtAddress;  // a waggle; the stroke may follow at once
  else if ((rests && glm::length(away) >= kLeft) || since_s > 2 * longest_s)
    give_up();
  return std::nullopt;
}

}  // namespace posecoach
