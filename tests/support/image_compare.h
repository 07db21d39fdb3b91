// Pictures against pictures, with tolerances that have names; failures leave the pictures behind to be looked
// at.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/image/frame.h"

namespace posecoach {

// All in steps of 0 to 255, the largest of the three channels counts.
struct ImageTolerance {
  int max_difference = 0;       // of any pixel
  double mean_difference = 0;   // over all pixels
  int outlier_difference = 12;  // a pixel that differs by more is an outlier
  double outlier_fraction = 0;  // how many of them may be outliers
};

struct ImageDifference {
  int max = 0;
  double mean = 0;
  double outlier_fraction = 0;
};
// Asserts equal sizes.
ImageDifference image_difference(const Image& a, const Image& b, int outlier_difference);

// Edges of lit bodies fall on other samples and glyphs are rounded otherwise in another version of Mesa or on
// another processor: a few pixels of an outline may differ clearly, the picture as a whole may not.
inline constexpr ImageTolerance kRenderedTolerance = {120, 0.35, 12, 0.006};

// Compares with tests/data/golden/NAME.png. On failure NAME.actual.png and NAME.difference.png lie in
// test_pictures/ of the build. With POSECOACH_UPDATE_GOLDEN=1 in the environment it writes the golden
// picture.
testing::AssertionResult matches_golden(const Image& actual, const std::string& name,
                                        const ImageTolerance& tolerance = kRenderedTolerance);

}  // namespace posecoach
