#include "app/bench/bench.h"
#include "core/motion/bundled_motion.h"
#include "core/transfer/clip_pool.h"
#include "core/transfer/trained.h"

namespace posecoach {

Result<void> bench_transfer(const BenchOptions&, std::vector<BenchRow>& rows) {
  const Result<Motion> motion = bundled_motion("swing");
  if (!motion) return tl::unexpected(motion.error());
  Result<PoseClip> clip = make_pose_clip("swing", *motion);
  if (!clip) return tl::unexpected(clip.error());
  std::vector<PoseClip> clips;
  clips.push_back(*std::move(clip));
  const PoseClipPool pool(std::move(clips));
  std::mt19937_64 random(1);
  SampleOptions options;
  options.source_pictures = 60;
  options.identity_pictures = 8;
  const TransferSample sample = random_sample(pool, random, options);
  for (const TransferMethod method :
       {TransferMethod::Network, TransferMethod::Paper, TransferMethod::Ratio}) {
    Result<std::unique_ptr<Transferer>> transferer = make_transferer(method);
    if (!transferer) return tl::unexpected(transferer.error());
    if (Result<void> set = (*transferer)->set_people(sample.source, sample.identity); !set) return set;
    rows.push_back(measure("2D pose transfer, " + std::string(to_string(method)), 200,
                           [&] { (void)(*transferer)->transfer(sample.source.front()); }));
  }
  return {};
}

}  // namespace posecoach
