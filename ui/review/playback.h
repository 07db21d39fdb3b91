// Playing, stepping and looping through a film, as one plain value: what the keys of a video player do to a
// position. Time is the film's own, picture by picture; nothing here knows a frame rate.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace posecoach {

// When each picture of a film is shown, in seconds, strictly increasing, and the film's named moments.
struct FilmMarks {
  std::span<const double> times_s;
  std::span<const int> events;  // pictures, in order
  // Where going to the moment before or after stops; empty: at the events.
  std::span<const int> stops = {};

  int count() const { return static_cast<int>(times_s.size()); }
  // How long the last picture stays: as long as most others.
  double last_stays_s() const;
};

enum class LoopMode { Once, Whole, Between };

// Pictures first and last of a part, both included.
struct Part {
  int first = 0, last = 0;
  bool operator==(const Part&) const = default;
};

struct Playback {
  int frame = 0;            // the picture that is shown
  double into_frame_s = 0;  // film time since it came on; below its duration
  bool is_playing = false;
  double speed = 1;
  int shuttle = 1;  // 1 forwards, -1 backwards, twice or four times as fast by the keys J and L
  LoopMode loop = LoopMode::Once;
  std::optional<int> in = {}, out = {};  // the marked part A-B

  // The part that playing stays within.
  Part part(int count) const;
  bool operator==(const Playback&) const = default;
};

inline constexpr double kSpeeds[] = {0.125, 0.25, 0.5, 0.75, 1, 1.5, 2};

enum class PlaybackCommand {
  PlayPause,
  StepBack,
  StepForward,
  JumpBack,  // a tenth of the film
  JumpForward,
  SmallJumpBack,  // a hundredth
  SmallJumpForward,
  PreviousEvent,
  NextEvent,
  ToStart,
  ToEnd,
  Slower,
  Faster,
  NormalSpeed,
  ShuttleBack,
  ShuttleForward,
  MarkIn,
  MarkOut,
  ToggleLoop,
  ClearMarks
};

// All of these return a playback that is valid for the film: its frame exists; of a film without pictures it
// is 0.
Playback applied(Playback playback, PlaybackCommand command, const FilmMarks& film);
// Stepping and jumping stop the film, so that the picture stays that was asked for.
Playback moved_to(Playback playback, int frame, const FilmMarks& film);
// After `elapsed_s` of the viewer's time.
Playback advanced(Playback playback, double elapsed_s, const FilmMarks& film);

// The picture that is shown at a time of the film.
int frame_at(double time_s, const FilmMarks& film);

}  // namespace posecoach
