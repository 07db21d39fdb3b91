#include <random>

#include "app/bench/bench.h"
#include "core/coaching/compare.h"
#include "core/coaching/dtw.h"
#include "core/motion/bundled_motion.h"
#include "core/pipeline/analyze.h"

namespace posecoach {
namespace {

PoseSequence make_wandering_poses(int frames, int joints, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal(0, 0.02F);
  PoseSequence poses(frames, joints);
  for (int joint = 0; joint < joints; ++joint) {
    float x = 0, y = 0, z = 0;
    for (int frame = 0; frame < frames; ++frame)
      poses.set(frame, joint, x += normal(random), y += normal(random), z += normal(random));
  }
  return poses;
}

}  // namespace

Result<void> bench_coaching(const BenchOptions&, std::vector<BenchRow>& rows) {
  const PoseSequence student = make_wandering_poses(300, 20, 1), coach = make_wandering_poses(300, 20, 2);
  rows.push_back(measure("dtw_300x300x20", 200, [&] { (void)warp(student, coach); }));

  Result<AuthoredMotion> swing = bundled_authored_motion("swing");
  if (!swing) return tl::unexpected(swing.error());
  const Motion film = resample(swing->motion, 30.0);
  rows.push_back(measure("compare a 3.5 s swing at 30 fps with one at 120", 20,
                         [&] { (void)compare(film, swing->motion); }));
  const StudentInput input = student_from_motion("bench", film);
  rows.push_back(measure("analyze, retargeting included", 20, [&] {
    (void)analyze(input, {"bench", swing->motion});
  }));
  return {};
}

}  // namespace posecoach
