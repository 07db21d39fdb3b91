#include "core/retarget/network/training.h"

#include <array>

#include "core/retarget/network/correction_trainer.h"
#include "core/retarget/network/paper_trainer.h"

namespace posecoach {
namespace {

struct NamedVariant {
  PaperVariant variant;
  std::string_view name;
};
constexpr std::array kVariants = {NamedVariant{PaperVariant::Paper, "paper"},
                                  NamedVariant{PaperVariant::RootBased, "root-based"},
                                  NamedVariant{PaperVariant::NoRowLoss, "no-row-loss"},
                                  NamedVariant{PaperVariant::RootCycle, "root-cycle"},
                                  NamedVariant{PaperVariant::NoDiscriminator, "no-discriminator"},
                                  NamedVariant{PaperVariant::RotationInput, "rotation-input"}};

constexpr double kGolfShare = 0.25;

}  // namespace

std::string_view to_string(PaperVariant variant) {
  return kVariants[static_cast<std::size_t>(variant)].name;
}

Result<PaperVariant> paper_variant_from_string(std::string_view name) {
  std::string known;
  for (const NamedVariant& one : kVariants) {
    if (one.name == name) return one.variant;
    known += (known.empty() ? "" : ", ") + std::string(one.name);
  }
  return fail(ErrorCode::InvalidArgument, "unknown variant '" + std::string(name) + "'; there are " + known);
}

Result<TrainingSummary> train_retargeting(const TrainingOptions& options) {
  Result<std::vector<TurnClip>> clips = load_training_clips(options.data);
  if (!clips) return tl::unexpected(clips.error());
  for (TurnClip& clip : *clips)
    if (clip.frames.size() < 64) clip.frames.clear();
  std::erase_if(*clips, [](const TurnClip& clip) { return clip.frames.empty(); });
  ClipSplit split = split_clips(*std::move(clips));
  if (split.held_out.empty())
    return fail(ErrorCode::Incomplete,
                options.data.string() + ": too few motions of two seconds or more (6 at the least)");
  repeat_golf(split.train, kGolfShare);
  try {
    if (options.method == TrainedMethod::Paper) {
      PaperTrainee trainee(std::move(split), options);
      return run_training(trainee, options);
    }
    CorrectionTrainee trainee(std::move(split), options);
    return run_training(trainee, options);
  } catch (const std::exception& error) {
    return fail(ErrorCode::Internal, std::string("training failed: ") + error.what());
  }
}

}  // namespace posecoach
