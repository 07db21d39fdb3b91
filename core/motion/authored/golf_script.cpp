#include "core/motion/authored/golf_script.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/assert.h"

namespace posecoach {

int GolfScript::index_of(std::string_view instant) const {
  for (std::size_t i = 0; i < instants_.size(); ++i)
    if (instants_[i].name == instant) return static_cast<int>(i);
  return -1;
}

bool GolfScript::has_instant(std::string_view instant) const {
  return index_of(instant) >= 0;
}

double GolfScript::time_of(std::string_view instant) const {
  const int i = index_of(instant);
  POSECOACH_ASSERT(i >= 0);
  return instants_[static_cast<std::size_t>(i)].time_s;
}

void GolfScript::rebuild() {
  for (Keys& keys : keys_) {
    std::vector<CurveKey> curve;
    for (const auto& [instant, value] : keys.values)
      curve.push_back({instants_[static_cast<std::size_t>(instant)].time_s, value});
    keys.curve = KeyCurve(curve);
  }
}

GolfPose GolfScript::pose(double time_s) const {
  GolfPose pose{};
  for (const Keys& keys : keys_) pose[keys.channel] += keys.curve.value(time_s);
  return pose;
}

GolfPose GolfScript::written_pose(double time_s) const {
  GolfPose pose{};
  for (const Keys& keys : keys_)
    if (!keys.is_added) pose[keys.channel] += keys.curve.value(time_s);
  return pose;
}

void GolfScript::add(GolfChannel channel, std::span<const Offset> offsets) {
  Keys keys{.channel = channel, .values = {}, .is_added = true};
  for (const Offset& offset : offsets) {
    const int instant = index_of(offset.instant);
    POSECOACH_ASSERT(instant >= 0 && (keys.values.empty() || keys.values.back().first < instant));
    keys.values.emplace_back(instant, offset.value);
  }
  keys_.push_back(std::move(keys));
  rebuild();
}

void GolfScript::stretch(std::string_view from, std::string_view to, double factor) {
  const double begin = time_of(from), end = time_of(to);
  POSECOACH_ASSERT(begin < end && factor > 0);
  for (GolfInstant& instant : instants_) {
    if (instant.time_s >= end)
      instant.time_s += (end - begin) * (factor - 1);
    else if (instant.time_s > begin)
      instant.time_s = begin + (instant.time_s - begin) * factor;
  }
  rebuild();
}

void GolfScript::stand_first(double seconds) {
  POSECOACH_ASSERT(seconds >= 0);
  for (GolfInstant& instant : instants_) instant.time_s += seconds;
  rebuild();
}

void GolfScript::lengthen(double factor) {
  POSECOACH_ASSERT(factor > 0);
  const double address = time_of("address");
  for (Keys& keys : keys_) {
    // How much the shaft is turned to the ball is no way.
    if (keys.is_added || keys.channel == GolfChannel::BallAim) continue;
    const double from = keys.curve.value(address);
    for (auto& [instant, value] : keys.values) value = from + factor * (value - from);
  }
  rebuild();
}

Result<GolfScript> GolfScript::parse(std::string_view json, std::string_view name) {
  const auto malformed = [&](const std::string& what) {
    return fail(ErrorCode::Malformed, std::string(name) + ": " + what);
  };
  try {
    const auto root = nlohmann::json::parse(json);
    if (root.at("schema") != "posecoach.golf_motion/1")
      return malformed("the schema is not posecoach.golf_motion/1");
    GolfScript script;
    script.name_ = root.at("name");
    const auto& club = root.at("club");
    script.club_ = {club.at("head"), club.at("grip_to_head_m"), club.at("grip_to_butt_m")};
    const auto& stance = root.at("stance");
    script.stance_ = {stance.at("width_of_shoulders"), stance.at("lead_flare_deg"),
                      stance.at("trail_flare_deg"), stance.at("knee_flex_deg"), stance.at("hips_back_cm")};
    for (const auto& instant : root.at("instants")) {
      script.instants_.push_back({instant.at("name"), instant.at("time_s")});
      const std::size_t count = script.instants_.size();
      if (count > 1 && script.instants_[count - 1].time_s <= script.instants_[count - 2].time_s)
        return malformed("time does not increase at " + script.instants_.back().name);
    }
    if (script.instants_.size() < 2) return malformed("a motion needs at least two instants");
    for (const auto& [key, values] : root.at("channels").items()) {
      const auto channel = golf_channel_from_string(key);
      if (!channel) return malformed("there is no channel " + key);
      Keys keys{.channel = *channel, .values = {}};
      for (const auto& [instant, value] : values.items()) {
        const int index = script.index_of(instant);
        if (index < 0) return malformed(key + " has a value at " + instant + ", which is no instant");
        keys.values.emplace_back(index, value.get<double>());
      }
      std::sort(keys.values.begin(), keys.values.end());
      script.keys_.push_back(std::move(keys));
    }
    script.rebuild();
    return script;
  } catch (const nlohmann::json::exception& error) {
    return malformed(error.what());
  }
}

}  // namespace posecoach
