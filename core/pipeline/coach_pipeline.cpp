#include "core/pipeline/coach_pipeline.h"

#include <algorithm>

#include "core/coaching/text/set_up_text.h"
#include "core/pipeline/address_watch.h"
#include "core/pipeline/body_measuring.h"
#include "core/pipeline/ghost_driver.h"
#include "core/pipeline/live_lift.h"
#include "core/pipeline/personal_coach.h"
#include "core/pipeline/set_up_check.h"
#include "core/pipeline/swing_loop.h"

namespace posecoach {
namespace {

// A pose stage that loses its person for a frame or two does not make the skeletons flicker.
constexpr double kHeld_s = 0.25;
// When the first seconds give a body, and when they give a better one.
// Counting people takes as long as a pose: now and then, and not while he swings.
constexpr double kCountEvery_s = 1.0;
// A student who turns about for a moment is not seen from another side.
constexpr int kWrongSidePoses = 30;
constexpr double kFirstBody_s = 1.2, kBetterBody_s = 3.5;

Sight sight_of(const PinholeCamera& camera) {
  return {glm::normalize(Vec3(0, 0, 1) * camera.rotation_camera_from_world)};
}

}  // namespace

class CoachPipeline::Implementation {
 public:
  Implementation(std::unique_ptr<PoseEstimator> estimator, BackgroundWork& work, CoachPipelineOptions options)
      : estimator_(std::move(estimator)),
        work_(work),
        options_(std::move(options)),
        loop_(work, options_.replay_s) {}

  Result<CoachSnapshot> step(const Frame& frame) {
    const Result<PoseObservation> seen = estimator_->estimate(frame);
    if (!seen) return tl::unexpected(seen.error());
    take_answers();
    CoachSnapshot snapshot;
    snapshot.number = ++number_;
    snapshot.frame = frame;
    snapshot.person = seen->person;
    const std::optional<LiveStudent> student = follow_student(frame, seen->person, snapshot);
    measure_body(frame.time, snapshot);
    step_loop(frame, as_judged(*seen), student, snapshot);
    if (const Result<void> counted = count_people(frame, student.has_value()); !counted)
      return tl::unexpected(counted.error());
    check_set_up(frame, seen->person, student, snapshot);
    look_at_address(frame.time, student, snapshot);
    snapshot.measured_body = measured_body_;
    say_what_is_wrong_with_coach(student, snapshot);
    return snapshot;
  }

  void set_coach(Motion motion, std::string source) {
    coach_ = std::make_shared<const CoachInput>(CoachInput{std::move(source), std::move(motion)});
    filmed_.reset();
    change_coach();
  }

  void set_coach(FilmedCoach coach) {
    filmed_ = std::make_shared<const FilmedCoach>(std::move(coach));
    coach_.reset();
    change_coach();
  }

  void set_person(Golfer golfer) {
    golfer_ = std::move(golfer);
    measured_body_ = golfer_.body ? std::make_shared<const Skeleton>(*golfer_.body) : nullptr;
    provisional_body_.reset();
    bodies_from_first_seconds_ = 0;
    apply_size();
    personalise();
  }

  void start_measuring() {
    measuring_.emplace(BodyMeasuringOptions{options_.count_down_s, options_.measuring_s, golfer_.height_m});
    // What is measured must not depend on what was measured before.
    lift_.set_size(std::nullopt, golfer_.height_m);
  }
  void stop_measuring() {
    measuring_.reset();
    apply_size();
  }
  SwingLoop& loop() { return loop_; }
  void set_pace(Pace pace, double speed) { ghost_.set_pace(pace, speed); }

  void start_take() { loop_.start_take(); }

  void change_source(std::string source) {
    options_.source = std::move(source);
    estimator_->reset();
    lift_.reset();
    lose_student();
    held_.reset();
    loop_.forget();
    checks_.reset();
    people_.reset();
    counted_at_.reset();
    if (measuring_) start_measuring();
  }

 private:
  struct Held {
    MediaTime time;
    BodyPose student;
    PinholeCamera camera;
    std::optional<Ghost> ghost;
  };

  // What is kept of a swing is what a film of it would give.
  PoseObservation as_judged(PoseObservation seen) const {
    if (std::optional<SeenPerson> unsmoothed = estimator_->unsmoothed()) seen.person = std::move(unsmoothed);
    return seen;
  }

  void change_coach() {
    ghost_.set_coach(nullptr);
    coach_message_.clear();
    personalise();
  }

  void lose_student() {
    ghost_.reset();
    hands_.reset();
    address_.reset();
    seen_since_.reset();
    wrong_side_poses_ = 0;
  }

  void apply_size() {
    lift_.set_size(measured_body_ ? std::optional(*measured_body_) : std::nullopt, golfer_.height_m);
  }

  std::optional<LiveStudent> follow_student(const Frame& frame, const std::optional<SeenPerson>& person,
                                            CoachSnapshot& snapshot) {
    std::optional<LiveStudent> student =
        lift_.step(frame.time, person, frame.image->width, frame.image->height);
    if (!student) {
      hold(frame.time, snapshot);
      return student;
    }
    if (!seen_since_) seen_since_ = frame.time;
    look_at_body(frame.time);
    const JointMoment moment = joint_moment(student->positions, student->confidence);
    const Sight sight = sight_of(student->camera);
    hands_.step(frame.time, moment, sight);
    snapshot.student = BodyPose{student_skeleton(),
                                {student->positions.begin(), student->positions.end()},
                                {student->confidence.begin(), student->confidence.end()}};
    snapshot.camera = student->camera;
    snapshot.ghost = ghost_.step(frame.time, moment, sight, hands_);
    held_ = Held{frame.time, *snapshot.student, *snapshot.camera, snapshot.ghost};
    return student;
  }

  void hold(MediaTime time, CoachSnapshot& snapshot) {
    if (held_ && to_seconds(time - held_->time) > kHeld_s) {
      held_.reset();
      lose_student();
    }
    if (!held_) return;
    snapshot.student = held_->student;
    snapshot.camera = held_->camera;
    snapshot.ghost = held_->ghost;
  }

  // A body for the ghost before it is measured.
  void look_at_body(MediaTime time) {
    if (measured_body_ || bodies_from_first_seconds_ >= 2) return;
    const double seconds = to_seconds(time - *seen_since_);
    if (seconds < (bodies_from_first_seconds_ == 0 ? kFirstBody_s : kBetterBody_s)) return;
    std::optional<Skeleton> body = lift_.provisional_body();
    if (!body) return;
    ++bodies_from_first_seconds_;
    provisional_body_ = std::make_shared<const Skeleton>(*std::move(body));
    personalise();
  }

  std::shared_ptr<const Skeleton> body() const { return measured_body_ ? measured_body_ : provisional_body_; }

  // The skeleton of what is seen has joints and names; until there is a body its lengths are anybody's.
  std::shared_ptr<const Skeleton> student_skeleton() {
    if (const auto known = body()) return known;
    if (!anybody_) {
      LandmarkBodyLengths lengths{};
      lengths.fill(0.2);
      anybody_ = std::make_shared<const Skeleton>(make_landmark_body(lengths));
    }
    return anybody_;
  }

  Handedness hand() const { return golfer_.hand.value_or(seen_hand_); }

  void personalise() {
    personal_ = {};
    if (!(coach_ || filmed_) || !body()) return;
    if (filmed_) {
      personal_ = Pending<Result<PersonalCoach>>(work_, [coach = filmed_, body = body(), hand = hand()] {
        return make_personal_coach(*coach, *body, hand);
      });
      return;
    }
    personal_ = Pending<Result<PersonalCoach>>(
        work_, [coach = coach_, body = body(), hand = hand(), retarget = options_.retarget] {
          return make_personal_coach(coach->motion, *body, hand, retarget);
        });
  }

  void take_answers() {
    // Not in the middle of a swing: the ghost would begin anew.
    if (ghost_.coach() && loop_.phase() == SwingFinder::Phase::Swinging) return;
    std::optional<Result<PersonalCoach>> personal = personal_.take();
    if (!personal) return;
    const std::string& source = filmed_ ? filmed_->source : coach_->source;
    coach_message_ = *personal ? (*personal)->message : source + ": " + personal->error().message;
    ghost_.set_coach(*personal ? std::make_shared<const PersonalCoach>(std::move(**personal)) : nullptr);
  }

  // Drawn over another side of the student, what was seen of the coach would mislead.
  void say_what_is_wrong_with_coach(const std::optional<LiveStudent>& student, CoachSnapshot& snapshot) {
    snapshot.coach_message = coach_message_;
    if (!filmed_ || !ghost_.coach() || !student) return;
    const std::optional<std::string> words = wrong_side(*filmed_, student->side.view);
    // Who holds his finish is turned, and stands where he stood.
    if (!words)
      wrong_side_poses_ = 0;
    else if (has_hands_down(joint_moment(student->positions, student->confidence)))
      ++wrong_side_poses_;
    if (wrong_side_poses_ < kWrongSidePoses) return;
    snapshot.coach_message = *words;
    snapshot.ghost.reset();
    if (held_) held_->ghost.reset();
  }

  void measure_body(MediaTime time, CoachSnapshot& snapshot) {
    if (!measuring_) return;
    if (std::optional<Skeleton> body = measuring_->step(time, lift_.placed())) {
      measured_body_ = std::make_shared<const Skeleton>(*std::move(body));
      apply_size();
      personalise();
    }
    snapshot.measuring = measuring_->state();
    if (measuring_->is_over()) stop_measuring();
  }

  void step_loop(const Frame& frame, const PoseObservation& seen, const std::optional<LiveStudent>& student,
                 CoachSnapshot& snapshot) {
    const auto before = loop_.swing();
    SwingComparison comparison{coach_, filmed_, {}, {}};
    comparison.lift.height_m = golfer_.height_m;
    if (measured_body_) comparison.lift.body = *measured_body_;
    comparison.options.hand = golfer_.hand;
    comparison.options.retarget = options_.retarget;
    std::optional<JointMoment> moment;
    if (student) moment = joint_moment(student->positions, student->confidence);
    loop_.step(frame, seen, moment, student ? sight_of(student->camera) : Sight{}, comparison,
               options_.source);
    if (loop_.swing() != before) learn_hand(loop_.swing()->pair.analysis);
    snapshot.loop = loop_.state();
    snapshot.swing = loop_.swing();
    snapshot.swing_message = loop_.message();
  }

  // The first swing tells with which hand he plays, if nobody has.
  void learn_hand(const Analysis& analysis) {
    const Handedness seen = analysis.student.hand.value_or(seen_hand_);
    if (seen == seen_hand_) return;
    seen_hand_ = seen;
    if (!golfer_.hand) personalise();
  }

  Result<void> count_people(const Frame& frame, bool is_somebody) {
    const bool is_due = !counted_at_ || to_seconds(frame.time - *counted_at_) >= kCountEvery_s;
    if (!is_somebody || !is_due || loop_.phase() == SwingFinder::Phase::Swinging) return {};
    counted_at_ = frame.time;
    const Result<std::optional<int>> people = estimator_->count_people(frame);
    if (!people) return tl::unexpected(people.error());
    people_ = *people;
    return {};
  }

  void check_set_up(const Frame& frame, const std::optional<SeenPerson>& person,
                    const std::optional<LiveStudent>& student, CoachSnapshot& snapshot) {
    const std::optional<CameraSide> side = student ? std::optional(student->side) : std::nullopt;
    const std::optional<StrokeKind> stroke = ghost_.coach() ? ghost_.coach()->kind : std::nullopt;
    snapshot.checks = checks_.step(frame.time, {person, side, people_, stroke, *frame.image});
    // Who is armed has walked away from the checks, and would wait for a short putt for ever.
    if (loop_.is_armed() && snapshot.swing_message.empty() && checks_.tells_putt_from_behind())
      snapshot.swing_message = text::set_up(text::SetUp::ArmedForPuttFromBehind);
  }

  void look_at_address(MediaTime time, const std::optional<LiveStudent>& student, CoachSnapshot& snapshot) {
    if (!student || !ghost_.coach() || !ghost_.coach()->kind) return;
    snapshot.address_advice = address_.step(time, *student, loop_.phase() == SwingFinder::Phase::AtAddress,
                                            *ghost_.coach(), hand());
  }

  std::unique_ptr<PoseEstimator> estimator_;
  BackgroundWork& work_;
  CoachPipelineOptions options_;
  std::uint64_t number_ = 0;

  Golfer golfer_;
  Handedness seen_hand_ = Handedness::Right;
  std::shared_ptr<const Skeleton> measured_body_, provisional_body_, anybody_;
  int bodies_from_first_seconds_ = 0;
  std::optional<BodyMeasuring> measuring_;

  LiveLift lift_;
  HandSpeed hands_;
  std::optional<MediaTime> seen_since_;
  std::optional<Held> held_;

  std::shared_ptr<const CoachInput> coach_;  // or
  std::shared_ptr<const FilmedCoach> filmed_;
  Pending<Result<PersonalCoach>> personal_;
  std::string coach_message_;
  int wrong_side_poses_ = 0;
  GhostDriver ghost_;

  SwingLoop loop_;
  SetUpChecks checks_;
  std::optional<int> people_;
  std::optional<MediaTime> counted_at_;
  AddressWatch address_;
};

CoachPipeline::CoachPipeline(std::unique_ptr<PoseEstimator> estimator, BackgroundWork& work,
                             CoachPipelineOptions options)
    : implementation_(std::make_unique<Implementation>(std::move(estimator), work, std::move(options))) {}
CoachPipeline::~CoachPipeline() = default;

Result<CoachSnapshot> CoachPipeline::step(const Frame& frame) {
  return implementation_->step(frame);
}
void CoachPipeline::set_coach(Motion motion, std::string source) {
  implementation_->set_coach(std::move(motion), std::move(source));
}
void CoachPipeline::set_coach(FilmedCoach coach) {
  implementation_->set_coach(std::move(coach));
}
void CoachPipeline::set_person(Golfer golfer) {
  implementation_->set_person(std::move(golfer));
}
void CoachPipeline::start_measuring() {
  implementation_->start_measuring();
}
void CoachPipeline::stop_measuring() {
  implementation_->stop_measuring();
}
void CoachPipeline::arm() {
  implementation_->loop().arm();
}
void CoachPipeline::disarm() {
  implementation_->loop().disarm();
}
void CoachPipeline::dismiss_replay() {
  implementation_->loop().dismiss_replay();
}
void CoachPipeline::set_pace(Pace pace, double speed) {
  implementation_->set_pace(pace, speed);
}
void CoachPipeline::start_take() {
  implementation_->start_take();
}
void CoachPipeline::change_source(std::string source) {
  implementation_->change_source(std::move(source));
}

}  // namespace posecoach
