#include "core/body/named_body.h"

#include <array>

namespace posecoach {
namespace {

constexpr std::array<NamedBody, 11> kBodies = {{
    {"average", {.height_m = 1.80}},
    {"tall", {.height_m = 1.96}},
    {"short", {.height_m = 1.58}},
    {"child", {.height_m = 1.40, .shoulders = 0.95}},
    {"long_arms", {.height_m = 1.80, .arms = 1.12}},
    {"short_arms", {.height_m = 1.80, .arms = 0.90}},
    {"long_legs", {.height_m = 1.84, .torso = 0.94, .thighs = 1.07, .shins = 1.07}},
    {"short_legs", {.height_m = 1.74, .torso = 1.06, .thighs = 0.92, .shins = 0.92}},
    {"broad", {.height_m = 1.80, .shoulders = 1.15, .hips = 1.10}},
    {"slim", {.height_m = 1.80, .shoulders = 0.90, .hips = 0.92}},
    {"woman", {.height_m = 1.66, .shoulders = 0.92, .hips = 1.06}},
}};

}  // namespace

std::span<const NamedBody> named_bodies() {
  return kBodies;
}

std::optional<Skeleton> find_named_body(std::string_view name) {
  for (const NamedBody& body : kBodies)
    if (body.name == name) return make_standard_body(body.proportions);
  return std::nullopt;
}

}  // namespace posecoach
