#include "app/window/memory.h"
#include "app/window/window_program.h"

namespace posecoach {

void WindowProgram::refresh_people() {
  model_.people.clear();
  const auto add = [&](const Person& person) {
    model_.people.push_back({person.name, person.name, person.hand.value_or(Handedness::Right),
                             person.height_m, person.body.has_value()});
  };
  bool is_there = false;
  for (const People::Listed& listed : people_.list()) {
    if (!listed.unreadable.empty()) continue;
    add(listed.person);
    is_there = is_there || listed.person.name == person_.name;
  }
  if (!is_there) add(person_);
  model_.person = person_.name;
}

void WindowProgram::apply_person() {
  Golfer golfer;
  golfer.body = person_.body;
  golfer.hand = person_.hand;
  golfer.height_m = person_.height_m;
  live_->runner().request([golfer](CoachPipeline& pipeline) { pipeline.set_person(golfer); });
}

void WindowProgram::choose_person(const std::string& name) {
  const Result<Person> found = people_.find(name);
  if (!found) return tell(ToastKind::Warning, found.error().message);
  person_ = *found;
  memory_->remembered.person = person_.name;
  memory_->save();
  refresh_people();
  apply_person();
  if (person_.coach != model_.coach && !model_.coach.empty()) choose_coach(person_.coach);
}

void WindowProgram::change_person(const std::function<void(Person&)>& change) {
  change(person_);
  if (const Result<void> saved = people_.save(person_); !saved)
    tell(ToastKind::Warning, saved.error().message);
  refresh_people();
  apply_person();
}

void WindowProgram::save_look() {
  Remembered& remembered = memory_->remembered;
  remembered.theme = model_.theme == ThemeKind::Light ? "light" : "dark";
  remembered.palette = model_.palette == Palette::ColourBlindSafe ? "colour-blind" : "red-green";
  remembered.text_size = model_.text_size;
  remembered.is_sound_on = model_.is_sound_on;
  memory_->save();
}

}  // namespace posecoach
