#include "app/sample/sample_swing.h"

#include "capture/simulated_student.h"
#include "core/base/assert.h"
#include "core/motion/bundled_motion.h"

namespace posecoach {
namespace {

constexpr double kVisible = 0.95;

class DrawnPictures : public PictureStore {
 public:
  DrawnPictures(std::unique_ptr<SimulatedStudent> student) : student_(std::move(student)) {}

  std::size_t count() const override { return *student_->info().frame_count; }
  MediaTime time(std::size_t index) const override {
    return student_->authored().motion.time(static_cast<int>(index));
  }
  Result<std::shared_ptr<const Image>> picture(std::size_t index) override {
    return std::make_shared<const Image>(student_->draw(static_cast<int>(index)));
  }

 private:
  std::unique_ptr<SimulatedStudent> student_;
};

SeenPerson seen_in(const SimulatedStudent& student, int frame) {
  const LandmarkArray<Vec3> truth = student.landmarks(frame);
  const PinholeCamera& camera = student.camera();
  const Vec3 hips = camera.camera_from_world(0.5 * (truth[Landmark::LeftHip] + truth[Landmark::RightHip]));
  SeenPerson person;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const std::optional<Vec2> at = camera.project(truth[i]);
    POSECOACH_ASSERT(at.has_value());
    person.image[i] = {*at, kVisible};
    person.world[i] = {camera.camera_from_world(truth[i]) - hips, kVisible};
  }
  return person;
}

}  // namespace

Result<std::shared_ptr<const AnalyzedSwing>> make_sample_swing(const SampleSwing& options) {
  SimulatedStudentOptions played;
  played.name = "simulated:" + options.motion;
  played.motion = options.motion;
  played.body = make_standard_body({.height_m = options.height_m});
  played.hand = options.hand;
  played.frames_per_second = options.frames_per_second;
  played.width = options.width;
  played.height = options.height;
  if (!options.fault.empty()) {
    const Result<FaultChoice> fault = fault_from_string(options.fault);
    if (!fault) return tl::unexpected(fault.error());
    played.faults = {*fault};
  }
  Result<std::unique_ptr<SimulatedStudent>> student = SimulatedStudent::make(played);
  if (!student) return tl::unexpected(student.error());
  const Result<Motion> coach = bundled_motion(options.motion);
  if (!coach) return tl::unexpected(coach.error());
  const SimulatedStudent& film = **student;
  PoseTrack track{played.name, played.width, played.height, {}};
  for (int frame = 0; frame < film.authored().motion.frame_count(); ++frame)
    track.frames.push_back(
        {static_cast<std::size_t>(frame), film.authored().motion.time(frame), seen_in(film, frame)});
  Result<LiftedStudent> lifted = lift(track);
  if (!lifted) return tl::unexpected(lifted.error());
  Result<AnalyzedPair> pair =
      analyze(student_from_film(played.name, track, *lifted), {"bundled:" + options.motion, *coach});
  if (!pair) return tl::unexpected(pair.error());
  return std::make_shared<const AnalyzedSwing>(
      AnalyzedSwing{std::move(track), *std::move(lifted), *std::move(pair),
                    std::make_shared<DrawnPictures>(*std::move(student))});
}

}  // namespace posecoach
