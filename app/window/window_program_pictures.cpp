#include "app/analyze/picture_retarget.h"
#include "app/window/window_program.h"

namespace posecoach {

// The pose stage looks at it beside the window; then it is a coach like any other, and kept.
void WindowProgram::look_at_coach(const std::string& file) {
  jobs_->start("Looking at " + std::filesystem::path(file).filename().string(),
               [this, file, pose = pose_](const Progress& progress) -> Result<JobQueue::Finish> {
                 Result<PoseTrack> pictures = load_coach_pictures(file, {pose, {}, progress});
                 if (!pictures) return tl::unexpected(pictures.error());
                 return JobQueue::Finish([this, pictures = *std::move(pictures)] {
                   const Result<Reference> reference = references_.add_pictures(pictures);
                   if (!reference) return tell(ToastKind::Warning, reference.error().message);
                   refresh_coaches();
                   choose_filmed_coach(*reference);
                 });
               });
}

void WindowProgram::choose_filmed_coach(const Reference& reference) {
  remember_coach(reference.source);
  jobs_->start(
      "Carrying over " + reference.name, [this, reference](const Progress&) -> Result<JobQueue::Finish> {
        const Result<PoseTrack> pictures = load_coach_pictures(reference.source, {});
        if (!pictures) return tl::unexpected(pictures.error());
        Result<FilmedCoach> coach = make_filmed_coach(*pictures);
        if (!coach) return tl::unexpected(coach.error());
        return JobQueue::Finish([this, reference, coach = *std::move(coach)] {
          // Somebody else may have been chosen meanwhile.
          if (model_.coach != reference.source) return;
          tell(ToastKind::Information,
               reference.name + (coach.is_still ? " is one picture: its pose is drawn on you, to stand in."
                                                : " is a film: what it shows is drawn on your picture."));
          live_->runner().request([coach](CoachPipeline& pipeline) { pipeline.set_coach(coach); });
        });
      });
}

}  // namespace posecoach
