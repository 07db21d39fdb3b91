#include "core/base/embedded.h"

#include <gtest/gtest.h>

namespace posecoach {
namespace {

POSECOACH_EMBEDDED(embedded_test_file)

TEST(Embedded, file_is_inside_the_program_byte_for_byte) {
  EXPECT_EQ(embedded_test_file(), "a file inside the program\n");
  EXPECT_EQ(*embedded_test_file().end(), '\0');
}

}  // namespace
}  // namespace posecoach
