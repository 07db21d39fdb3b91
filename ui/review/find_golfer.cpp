#include "ui/review/find_golfer.h"

#include <algorithm>
#include <glm/common.hpp>

namespace posecoach {

std::optional<std::pair<Vec2, Vec2>> find_golfer(const AnalyzedSwing& swing) {
  constexpr double kSeen = 0.3;
  // A club reaches well above the head and beside the hands.
  constexpr double kAbove = 0.24, kBelow = 0.15, kBeside = 0.22;
  const Motion& motion = swing.student.motion;
  const auto& path = swing.pair.analysis.path;
  const int last = motion.frame_count() - 1, first_frame = swing.student.first_frame;
  const int begin = path.empty() ? 0 : std::clamp(path.front().first - first_frame, 0, last),
            end = path.empty() ? last : std::clamp(path.back().first - first_frame, begin, last);
  Vec2 from(1e9), to(-1e9);
  for (int frame = begin; frame <= end; ++frame)
    for (int joint = 0; joint < motion.joint_count(); ++joint) {
      if (motion.confidence(frame, joint) < kSeen) continue;
      const std::optional<Vec2> at = swing.student.camera.project(motion.position(frame, joint));
      if (!at) continue;
      from = glm::min(from, *at);
      to = glm::max(to, *at);
    }
  const double height = to.y - from.y;
  if (height < 8) return {};
  return std::pair(from - height * Vec2(kBeside, kAbove), to + height * Vec2(kBeside, kBelow));
}

}  // namespace posecoach
