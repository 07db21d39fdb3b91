#include "ui/widgets/sign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/base/file.h"

namespace posecoach {
namespace {

TEST(Sign, of_the_window_is_the_icon_on_the_desktop) {
  const std::string icon = read_file(POSECOACH_DESKTOP_ICON).value();
  std::size_t paths = 0;
  for (std::size_t at = icon.find("<path"); at != std::string::npos; at = icon.find("<path", at + 1)) ++paths;
  EXPECT_EQ(paths, sign_lines().size() + 1) << "the lines and the way of the club";
  for (const SignLine& line : sign_lines()) {
    std::ostringstream path;
    for (const Vec2& point : line.points)
      path << (path.tellp() == 0 ? "M" : " L") << point.x << " " << point.y;
    const std::size_t begin = icon.find("\"" + path.str() + "\"");
    ASSERT_NE(begin, std::string::npos) << path.str();
    // Two lines of the same way differ in their width.
    std::ostringstream width;
    width << "\"" << path.str() << "\"" << (line.ink == SignLine::Ink::Room ? " stroke=\"#1a2129\"" : "")
          << " stroke-width=\"" << line.width << "\"";
    EXPECT_THAT(icon, testing::HasSubstr(width.str()));
  }
}

}  // namespace
}  // namespace posecoach
