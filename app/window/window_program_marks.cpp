// What was marked by hand on the opened swing: shown at once, stored and analysed beside the window.
#include "app/library/stored_swing.h"
#include "app/window/memory.h"
#include "app/window/window_program.h"

namespace posecoach {
namespace {

// With the new answer; the pictures are the same.
std::shared_ptr<const AnalyzedSwing> answered_anew(const AnalyzedSwing& before, const StoredAnswer& answer) {
  auto swing = std::make_shared<AnalyzedSwing>(before);
  swing->pair = answer.pair;
  return swing;
}

}  // namespace

void WindowProgram::set_marks(const std::string& id, const Marks& marks) {
  if (!library_ || !model_.opened || model_.opened->id != id) return;
  if (id.empty())
    return tell(ToastKind::Information, "The swing is still being kept; try again in a moment.");
  model_.opened->marks = marks;
  if (!is_storing_marks_) store_marks();
}

// One after the other, always with the newest marks: who moves a position step by step waits for nothing.
void WindowProgram::store_marks() {
  const OpenedSwing& opened = *model_.opened;
  is_storing_marks_ = true;
  keeping_->start(
      "Storing what you marked",
      [this, id = opened.id, marks = opened.marks,
       before = opened.review->swing](const Progress& progress) -> Result<JobQueue::Finish> {
        // Whatever happens, the next marks may be stored.
        const auto done = [this, id, marks](std::shared_ptr<const AnalyzedSwing> swing) {
          return JobQueue::Finish([this, id, marks, swing = std::move(swing)] {
            is_storing_marks_ = false;
            if (!model_.opened || model_.opened->id != id) return;
            if (swing) model_.opened->review = make_review_swing(swing);
            if (swing) refresh_swings();
            if (!(model_.opened->marks == marks)) store_marks();
          });
        };
        const auto failed = [this](Error error) {
          return JobQueue::Finish([this, error = std::move(error)] {
            is_storing_marks_ = false;
            tell(ToastKind::Warning, error.message);
          });
        };
        const Result<Swing> swing = library_->find(id);
        if (!swing) return failed(swing.error());
        const Result<Marks> stored = read_marks(*swing);
        Result<SwingDraft> draft = library_->begin_again(id);
        if (!draft) return failed(draft.error());
        std::shared_ptr<const AnalyzedSwing> anew;
        if (!stored || stored->events != marks.events) {
          const Result<StoredAnswer> answer = analyze_marked(*swing, {}, marks, {pose_, {}, progress});
          if (!answer) return failed(answer.error());
          if (const Result<void> added = add_answer(*draft, *answer); !added) return failed(added.error());
          anew = answered_anew(*before, *answer);
        }
        if (const Result<void> added = draft->add(kMarksFile, marks_to_json(marks)); !added)
          return failed(added.error());
        if (const Result<Swing> kept = library_->keep(*std::move(draft), progress); !kept)
          return failed(kept.error());
        return done(std::move(anew));
      },
      false);
}

}  // namespace posecoach
