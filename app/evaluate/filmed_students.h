// Films of simulated students as the pose networks see them, for the benches. Looking takes long, so what was
// seen may be kept in a folder and read from there the next time.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "capture/simulated_student.h"
#include "core/motion/pose_track.h"
#include "core/vision/pose_tracker.h"

namespace posecoach {

// What a bench's films have in common; who plays which stroke, and from where he is seen, is the bench's.
// Small pictures, enough for the pose networks, which look at 256 by 256 pixels: nobody else looks at them.
SimulatedStudentOptions bench_film(std::string motion, Skeleton body, Handedness hand,
                                   const CameraPlace& camera, double frames_per_second);

class FilmedStudents {
 public:
  // Makes the folder; an empty name keeps nothing. Errors: Unreadable.
  static Result<FilmedStudents> make(const std::string& folder, PoseTrackerOptions options);

  // Both from one look, as the live loop has them. Errors: as track().
  struct Looks {
    PoseTrack smoothed, unsmoothed;
  };
  Result<Looks> looks(const std::string& name, const SimulatedStudentOptions& film);

  // `name` tells this film from all others. Errors: those of student, pose stage and files.
  Result<PoseTrack> track(const std::string& name, const SimulatedStudentOptions& film);

 private:
  FilmedStudents(std::filesystem::path folder, PoseTrackerOptions options);

  std::filesystem::path file(const std::string& name) const;  // empty where nothing is kept
  Result<PoseTracker*> tracker();

  std::filesystem::path folder_;
  PoseTrackerOptions options_;
  std::unique_ptr<PoseTracker> tracker_;  // made when the first film is looked at
};

}  // namespace posecoach
