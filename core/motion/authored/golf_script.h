// An authored golf motion before it has a body: named instants, and golf numbers keyed at them. Faults change
// a script; a GolferPoser turns it into a body's pose.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/motion/authored/golf_channels.h"
#include "core/motion/authored/key_curve.h"

namespace posecoach {

struct GolfInstant {
  std::string name;
  double time_s = 0;
};

// Physical sizes for the body that the script was written for; other bodies get a club that fits.
struct GolfClub {
  std::string head;           // "iron" or "putter"
  double grip_to_head_m = 0;  // from the point between the hands to the head's middle
  double grip_to_butt_m = 0;
};

struct GolfStance {
  double width_of_shoulders = 1;  // ankle distance over shoulder distance, of an average body
  double lead_flare_deg = 0;      // toes outwards
  double trail_flare_deg = 0;
  double knee_flex_deg = 0;  // at address
  double hips_back_cm = 0;   // middle of the hips behind the ankles at address, for a stature of 1.80 m
};

class GolfScript {
 public:
  // `name` stands in error messages. Errors: Malformed naming the key or event.
  static Result<GolfScript> parse(std::string_view json, std::string_view name);

  const std::string& name() const { return name_; }
  const GolfClub& club() const { return club_; }
  const GolfStance& stance() const { return stance_; }
  const std::vector<GolfInstant>& instants() const { return instants_; }
  // The last instant's time: the motion starts at 0.
  double duration_s() const { return instants_.back().time_s; }
  // Asserts that there is one of this name.
  double time_of(std::string_view instant) const;
  bool has_instant(std::string_view instant) const;

  GolfPose pose(double time_s) const;
  // Without what was added: the motion as it is written.
  GolfPose written_pose(double time_s) const;

  // Adds a smooth curve of its own on top of a channel; zero at instants that are not named and lie outside.
  struct Offset {
    std::string_view instant;
    double value = 0;
  };
  void add(GolfChannel channel, std::span<const Offset> offsets);
  // Makes the time from one instant to another `factor` times as long; everything after follows.
  void stretch(std::string_view from, std::string_view to, double factor);
  // Stands still for so long before everything else.
  void stand_first(double seconds);
  // Makes the written motion `factor` times as long: everything moves that part of its way from the address.
  // Times stay, as they do for golfers.
  void lengthen(double factor);

 private:
  struct Keys {
    GolfChannel channel;
    std::vector<std::pair<int, double>> values;  // instant, value
    KeyCurve curve = {};
    bool is_added = false;
  };
  int index_of(std::string_view instant) const;
  void rebuild();

  std::string name_;
  GolfClub club_;
  GolfStance stance_;
  std::vector<GolfInstant> instants_;
  std::vector<Keys> keys_;  // a channel's value is the sum over its entries
};

}  // namespace posecoach
