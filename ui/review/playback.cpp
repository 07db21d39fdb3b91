#include "ui/review/playback.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/index.h"
#include "core/base/median.h"

namespace posecoach {
namespace {

constexpr int kFastestShuttle = 4;

int clamped(int frame, int count) {
  return count > 0 ? std::clamp(frame, 0, count - 1) : 0;
}

double duration_of(int frame, const FilmMarks& film) {
  return frame + 1 < film.count() ? film.times_s[index(frame + 1)] - film.times_s[index(frame)]
                                  : film.last_stays_s();
}

double changed_speed(double speed, int by) {
  int nearest = 0;
  const int count = static_cast<int>(std::size(kSpeeds));
  for (int i = 0; i < count; ++i)
    if (std::abs(kSpeeds[i] - speed) < std::abs(kSpeeds[nearest] - speed)) nearest = i;
  return kSpeeds[std::clamp(nearest + by, 0, count - 1)];
}

Playback toggled(Playback playback, const FilmMarks& film) {
  playback.is_playing = !playback.is_playing && film.count() > 1;
  playback.shuttle = 1;
  // From the end, play starts over.
  const Part part = playback.part(film.count());
  if (playback.is_playing && playback.frame >= part.last) {
    playback.frame = part.first;
    playback.into_frame_s = 0;
  }
  return playback;
}

Playback shuttled(Playback playback, int direction) {
  const bool is_faster = playback.is_playing && playback.shuttle * direction > 0;
  playback.shuttle =
      is_faster ? direction * std::min(2 * std::abs(playback.shuttle), kFastestShuttle) : direction;
  playback.is_playing = true;
  return playback;
}

int event_after(const Playback& playback, const FilmMarks& film, int direction) {
  int found = direction > 0 ? film.count() - 1 : 0;
  for (const int event : film.stops.empty() ? film.events : film.stops) {
    if (direction > 0 && event > playback.frame) found = std::min(found, event);
    if (direction < 0 && event < playback.frame) found = std::max(found, event);
  }
  return found;
}

// A mark beyond the other one takes its place.
Playback marked(Playback playback, bool is_in) {
  (is_in ? playback.in : playback.out) = playback.frame;
  if (playback.in && playback.out && *playback.in > *playback.out) std::swap(playback.in, playback.out);
  if (playback.in && playback.out) playback.loop = LoopMode::Between;
  return playback;
}

Playback with_next_loop(Playback playback) {
  const bool has_part = playback.in && playback.out;
  playback.loop = playback.loop == LoopMode::Once    ? (has_part ? LoopMode::Between : LoopMode::Whole)
                  : playback.loop == LoopMode::Whole ? LoopMode::Once
                                                     : LoopMode::Whole;
  return playback;
}

Playback advanced_backwards(Playback playback, double film_s, const Part& part, const FilmMarks& film) {
  while (film_s > playback.into_frame_s) {
    film_s -= playback.into_frame_s;
    if (playback.frame <= part.first) {
      playback.into_frame_s = 0;
      if (playback.loop == LoopMode::Once) {
        playback.is_playing = false;
        return playback;
      }
      playback.frame = part.last + 1;
    }
    --playback.frame;
    playback.into_frame_s = duration_of(playback.frame, film);
  }
  playback.into_frame_s -= film_s;
  return playback;
}

Playback advanced_forwards(Playback playback, double film_s, const Part& part, const FilmMarks& film) {
  playback.into_frame_s += film_s;
  while (playback.into_frame_s >= duration_of(playback.frame, film)) {
    if (playback.frame >= part.last) {
      if (playback.loop == LoopMode::Once) {
        playback.is_playing = false;
        playback.into_frame_s = 0;
        return playback;
      }
      playback.into_frame_s -= duration_of(playback.frame, film);
      playback.frame = part.first;
    } else {
      playback.into_frame_s -= duration_of(playback.frame, film);
      ++playback.frame;
    }
  }
  return playback;
}

}  // namespace

double FilmMarks::last_stays_s() const {
  constexpr double kLone_s = 0.04;
  if (count() < 2) return kLone_s;
  std::vector<double> durations;
  for (std::size_t i = 1; i < times_s.size(); ++i) durations.push_back(times_s[i] - times_s[i - 1]);
  return median(std::move(durations));
}

Part Playback::part(int count) const {
  if (loop == LoopMode::Between && in && out) return {clamped(*in, count), clamped(*out, count)};
  return {0, std::max(0, count - 1)};
}

Playback moved_to(Playback playback, int frame, const FilmMarks& film) {
  playback.frame = clamped(frame, film.count());
  playback.into_frame_s = 0;
  playback.is_playing = false;
  playback.shuttle = 1;
  return playback;
}

Playback applied(Playback playback, PlaybackCommand command, const FilmMarks& film) {
  const int count = film.count();
  playback.frame = clamped(playback.frame, count);
  const int tenth = std::max(1, static_cast<int>(std::lround(count / 10.0))),
            hundredth = std::max(1, static_cast<int>(std::lround(count / 100.0)));
  const auto to = [&](int frame) { return moved_to(playback, frame, film); };
  switch (command) {
    case PlaybackCommand::PlayPause:
      return toggled(playback, film);
    case PlaybackCommand::StepBack:
      return to(playback.frame - 1);
    case PlaybackCommand::StepForward:
      return to(playback.frame + 1);
    case PlaybackCommand::JumpBack:
      return to(playback.frame - tenth);
    case PlaybackCommand::JumpForward:
      return to(playback.frame + tenth);
    case PlaybackCommand::SmallJumpBack:
      return to(playback.frame - hundredth);
    case PlaybackCommand::SmallJumpForward:
      return to(playback.frame + hundredth);
    case PlaybackCommand::PreviousEvent:
      return to(event_after(playback, film, -1));
    case PlaybackCommand::NextEvent:
      return to(event_after(playback, film, 1));
    case PlaybackCommand::ToStart:
      return to(0);
    case PlaybackCommand::ToEnd:
      return to(count - 1);
    case PlaybackCommand::Slower:
      playback.speed = changed_speed(playback.speed, -1);
      return playback;
    case PlaybackCommand::Faster:
      playback.speed = changed_speed(playback.speed, 1);
      return playback;
    case PlaybackCommand::NormalSpeed:
      playback.speed = 1;
      return playback;
    case PlaybackCommand::ShuttleBack:
      return shuttled(playback, -1);
    case PlaybackCommand::ShuttleForward:
      return shuttled(playback, 1);
    case PlaybackCommand::MarkIn:
      return marked(playback, true);
    case PlaybackCommand::MarkOut:
      return marked(playback, false);
    case PlaybackCommand::ToggleLoop:
      return with_next_loop(playback);
    case PlaybackCommand::ClearMarks:
      playback.in.reset();
      playback.out.reset();
      if (playback.loop == LoopMode::Between) playback.loop = LoopMode::Once;
      return playback;
  }
  return playback;
}

Playback advanced(Playback playback, double elapsed_s, const FilmMarks& film) {
  playback.frame = clamped(playback.frame, film.count());
  if (film.count() < 2) playback.is_playing = false;
  if (!playback.is_playing || !(elapsed_s > 0)) return playback;
  const Part part = playback.part(film.count());
  if (playback.frame < part.first || playback.frame > part.last) {
    playback.frame = playback.shuttle > 0 ? part.first : part.last;
    playback.into_frame_s = 0;
  }
  const double begin = film.times_s[index(part.first)];
  const double end = film.times_s[index(part.last)] + duration_of(part.last, film);
  double film_s = elapsed_s * playback.speed * std::abs(playback.shuttle);
  // Whole rounds of a loop change nothing.
  if (playback.loop != LoopMode::Once) film_s = std::fmod(film_s, end - begin);
  return playback.shuttle > 0 ? advanced_forwards(playback, film_s, part, film)
                              : advanced_backwards(playback, film_s, part, film);
}

int frame_at(double time_s, const FilmMarks& film) {
  const auto after = std::upper_bound(film.times_s.begin(), film.times_s.end(), time_s);
  return clamped(static_cast<int>(after - film.times_s.begin()) - 1, film.count());
}

}  // namespace posecoach
