#include "core/body/landmarks.h"

#include <gtest/gtest.h>

namespace posecoach {
namespace {

TEST(Landmarks, mirror_swaps_left_and_right_in_the_name) {
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto landmark = static_cast<Landmark>(i);
    std::string name(to_string(landmark));
    if (const auto at = name.find("left"); at != std::string::npos)
      name.replace(at, 4, "right");
    else if (const auto right = name.find("right"); right != std::string::npos)
      name.replace(right, 5, "left");
    EXPECT_EQ(to_string(mirrored(landmark)), name);
  }
}

}  // namespace
}  // namespace posecoach
