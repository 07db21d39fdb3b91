// Bodies that can be asked for by name, for the simulated student and for trying things.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/body/standard_body.h"

namespace posecoach {

struct NamedBody {
  std::string_view name;
  BodyProportions proportions;
};

// "average" (the coach's, 1.80 m), "tall", "short", "long_arms", ...
std::span<const NamedBody> named_bodies();
std::optional<Skeleton> find_named_body(std::string_view name);

}  // namespace posecoach
