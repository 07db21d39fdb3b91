#include "core/motion/bundled_motion.h"

#include "core/base/embedded.h"
#include "core/body/standard_body.h"

namespace posecoach {

POSECOACH_EMBEDDED(swing_motion)
POSECOACH_EMBEDDED(putt_motion)

const std::vector<std::string>& bundled_motion_names() {
  static const std::vector<std::string> kNames = {"swing", "putt"};
  return kNames;
}

Result<GolfScript> bundled_script(std::string_view name) {
  if (name == "swing") return GolfScript::parse(swing_motion(), "bundled:swing");
  if (name == "putt") return GolfScript::parse(putt_motion(), "bundled:putt");
  return fail(ErrorCode::NotFound,
              "there is no bundled motion \"" + std::string(name) + "\": use bundled:swing or bundled:putt");
}

Result<AuthoredMotion> bundled_authored_motion(std::string_view name) {
  const Result<GolfScript> script = bundled_script(name);
  if (!script) return tl::unexpected(script.error());
  return make_authored_motion(*script, make_standard_body({.height_m = 1.80}), 120);
}

Result<Motion> bundled_motion(std::string_view name) {
  Result<AuthoredMotion> authored = bundled_authored_motion(name);
  if (!authored) return tl::unexpected(authored.error());
  return std::move(authored->motion);
}

}  // namespace posecoach
