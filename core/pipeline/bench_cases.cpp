#include <algorithm>
#include <sstream>

#include "core/body/named_body.h"
#include "core/motion/bundled_motion.h"
#include "core/pipeline/fault_bench.h"

namespace posecoach {
namespace {

std::string in_words(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

Result<std::vector<BenchBody>> chosen_bodies(const std::vector<std::string>& names) {
  std::vector<BenchBody> all = bench_bodies();
  if (names.empty()) return all;
  std::vector<BenchBody> chosen;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const BenchBody& body) { return body.name == name; });
    if (found == all.end()) {
      std::string known;
      for (const BenchBody& body : all) known += (known.empty() ? "" : ", ") + body.name;
      return fail(ErrorCode::InvalidArgument, "there is no body \"" + name + "\"; there are: " + known);
    }
    chosen.push_back(*found);
  }
  return chosen;
}

}  // namespace

std::string_view to_string(BenchEye eye) {
  switch (eye) {
    case BenchEye::TrueJoints:
      return "joints";
    case BenchEye::FaceOn:
      return "face-on";
    case BenchEye::DownTheLine:
      break;
  }
  return "down-the-line";
}

std::vector<BenchBody> bench_bodies() {
  std::vector<BenchBody> bodies;
  for (const NamedBody& body : named_bodies()) bodies.push_back({std::string(body.name), body.proportions});
  bodies.push_back({"1.50m", {.height_m = 1.50}});
  bodies.push_back({"2.00m", {.height_m = 2.00}});
  bodies.push_back({"arms+25%", {.height_m = 1.70, .arms = 1.25}});
  bodies.push_back({"arms-20%", {.height_m = 1.75, .arms = 0.80}});
  bodies.push_back({"legs+25%", {.height_m = 1.80, .torso = 0.85, .thighs = 1.25, .shins = 1.25}});
  bodies.push_back({"legs-25%", {.height_m = 1.70, .torso = 1.15, .thighs = 0.75, .shins = 0.75}});
  return bodies;
}

std::string name_of(const BenchCase& one) {
  return one.motion + "-" +
         (one.fault ? std::string(one.fault->name) + "_" + in_words(one.amount) : std::string("faultless")) +
         "-" + one.body.name + "-" + (one.hand == Handedness::Left ? "left" : "right") + "-" +
         in_words(one.frames_per_second) + "fps-" + std::string(to_string(one.eye)) +
         (one.camera_turned_deg == 0
              ? ""
              : (one.camera_turned_deg > 0 ? "+" : "") + in_words(one.camera_turned_deg));
}

Result<AuthoredMotion> make_stroke_of(const BenchCase& one) {
  Result<GolfScript> script = bundled_script(one.motion);
  if (!script) return tl::unexpected(script.error());
  if (one.fault)
    if (const Result<void> applied = apply_fault(*script, {one.fault, one.amount}); !applied)
      return tl::unexpected(applied.error());
  return make_authored_motion(*script, make_standard_body(one.body.proportions), one.frames_per_second,
                              one.hand);
}

Result<std::vector<BenchCase>> make_bench_cases(const BenchPlan& plan) {
  const auto bodies = chosen_bodies(plan.bodies);
  if (!bodies) return tl::unexpected(bodies.error());
  for (const std::string& name : plan.faults)
    if (const auto known = choose_fault(name); !known) return tl::unexpected(known.error());
  const auto is_asked = [&plan](std::string_view fault) {
    return plan.faults.empty() ||
           std::find(plan.faults.begin(), plan.faults.end(), fault) != plan.faults.end();
  };
  std::vector<BenchCase> cases;
  // One eye at one frame rate from one place.
  const auto add = [&](BenchEye eye, double rate, double turned_deg) {
    for (std::size_t b = 0; b < bodies->size(); ++b) {
      const BenchBody& body = (*bodies)[b];
      for (const char* motion : {"swing", "putt"})
        for (const Handedness hand : {Handedness::Right, Handedness::Left})
          cases.push_back({motion, nullptr, 0, body, hand, rate, eye, turned_deg});
      const auto& faults = golf_faults();
      for (std::size_t f = 0; f < faults.size(); ++f) {
        if (!is_asked(faults[f].name)) continue;
        const Handedness hand = (b + f) % 2 == 0 ? Handedness::Right : Handedness::Left;
        for (const double part : plan.parts)
          cases.push_back({std::string(faults[f].motion), &faults[f],
                           std::min(part * faults[f].default_amount, faults[f].largest_amount), body, hand,
                           rate, eye, turned_deg});
      }
    }
  };
  for (const BenchEye eye : plan.eyes)
    for (const double rate : plan.frame_rates) {
      if (eye == BenchEye::TrueJoints) {
        add(eye, rate, 0);
        continue;
      }
      for (const double turned_deg : plan.camera_turns_deg) add(eye, rate, turned_deg);
    }
  return cases;
}

}  // namespace posecoach
