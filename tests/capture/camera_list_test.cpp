#include "capture/v4l2/camera_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <fstream>

#include "capture/v4l2/camera_name.h"
#include "tests/support/fake_camera.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CameraListTest : public testing::Test {
 protected:
  fs::path device(const std::string& name) {
    const fs::path path = folder_.path() / name;
    std::ofstream(path) << "";
    return path;
  }
  fs::path link(const std::string& kind, const std::string& name, const fs::path& node) {
    const fs::path path = folder_.path() / "v4l" / kind / name;
    fs::create_directories(path.parent_path());
    fs::create_symlink(node, path);
    return path;
  }
  std::vector<CameraDescription> list(V4l2SystemCalls& driver) {
    return list_cameras({folder_.path(), &driver});
  }
  static FakeCamera::Habits habits() {
    FakeCamera::Habits habits;
    habits.name = "Webcam C1";
    habits.modes = {{V4L2_PIX_FMT_YUYV, 640, 480, {15, 30}},
                    {V4L2_PIX_FMT_H264, 1920, 1080, {30}},
                    {V4L2_PIX_FMT_MJPEG, 1280, 720, {30, 60}}};
    return habits;
  }
  TemporaryFolder folder_;
};

TEST_F(CameraListTest, tells_name_stable_path_and_the_modes_that_can_be_decoded) {
  const fs::path node = device("video2");
  const fs::path by_id = link("by-id", "usb-C1-video-index0", node);
  link("by-path", "pci-0000-video-index0", node);
  FakeCamera driver(node, habits());
  const auto cameras = list(driver);
  ASSERT_EQ(cameras.size(), 1U);
  EXPECT_EQ(cameras[0].name, "Webcam C1");
  EXPECT_EQ(cameras[0].driver, "fake");
  EXPECT_EQ(cameras[0].node, node);
  EXPECT_EQ(cameras[0].path, by_id);
  EXPECT_EQ(cameras[0].source(), "camera:" + by_id.string());
  EXPECT_EQ(cameras[0].problem, "");
  ASSERT_EQ(cameras[0].modes.size(), 2U);
  EXPECT_EQ(cameras[0].modes[0].width, 1280);
  EXPECT_EQ(cameras[0].modes[0].frame_rates, (std::vector<double>{60, 30}));
  EXPECT_EQ(cameras[0].modes[1].frame_rates, (std::vector<double>{30, 15}));
  EXPECT_EQ(driver.left_open(), 0);
}

TEST_F(CameraListTest, falls_back_to_the_place_and_then_to_the_number) {
  const fs::path node = device("video0");
  EXPECT_EQ(stable_camera_path(node, folder_.path()), node);
  const fs::path by_path = link("by-path", "pci-video-index0", node);
  EXPECT_EQ(stable_camera_path(node, folder_.path()), by_path);
  EXPECT_EQ(stable_camera_path(by_path, folder_.path()), by_path);
}

TEST_F(CameraListTest, leaves_out_what_is_no_camera_and_lists_what_cannot_be_opened) {
  const fs::path node = device("video0");
  device("video7");  // nobody answers there
  std::ofstream(folder_.path() / "videodisc") << "";
  FakeCamera output(node, {.is_camera = false});
  const auto without = list(output);
  ASSERT_EQ(without.size(), 1U);
  EXPECT_EQ(without[0].node.filename(), "video7");

  FakeCamera::Habits closed = habits();
  closed.open_error = EACCES;
  FakeCamera driver(node, closed);
  const auto cameras = list(driver);
  ASSERT_EQ(cameras.size(), 2U);
  EXPECT_THAT(cameras[0].problem, HasSubstr("group \"video\""));
}

TEST_F(CameraListTest, a_machine_without_cameras_has_none) {
  FakeCamera driver("/nowhere", habits());
  EXPECT_TRUE(list(driver).empty());
  EXPECT_TRUE(list_cameras({folder_.path() / "none", &driver}).empty());
}

TEST_F(CameraListTest, names_become_stable_and_keep_their_wishes) {
  const fs::path node = device("video1");
  const fs::path by_id = link("by-id", "usb-C1-video-index0", node);
  FakeCamera driver(node, habits());
  const CameraListOptions options = {folder_.path(), &driver};
  EXPECT_EQ(stable_camera_name("camera:" + node.string() + "?fps=60&width=640", options),
            "camera:" + by_id.string() + "?fps=60&width=640");
  EXPECT_EQ(stable_camera_name("camera:", options), "camera:" + by_id.string());
  EXPECT_EQ(stable_camera_name("simulated:swing", options), "simulated:swing");
  EXPECT_EQ(stable_camera_name("camera:/dev/none", options), "camera:/dev/none");
}

TEST(CameraName, says_what_is_wished) {
  const CameraName name = parse_camera_name("camera:/dev/video3?width=1920&height=1080&fps=59.94").value();
  EXPECT_EQ(name.path, "/dev/video3");
  EXPECT_EQ(name.wish.width, 1920);
  EXPECT_EQ(name.wish.height, 1080);
  EXPECT_EQ(name.wish.fps, 59.94);
  EXPECT_EQ(parse_camera_name("/dev/video3")->path, "/dev/video3");
  EXPECT_TRUE(parse_camera_name("camera:")->path.empty());
}

TEST(CameraName, names_the_setting_that_is_wrong) {
  for (const char* setting : {"width=9", "width=wide", "fps=0", "fps=", "height=99999", "zoom=2", "width"}) {
    const auto name = parse_camera_name(std::string("camera:/dev/video0?") + setting);
    ASSERT_FALSE(name) << setting;
    EXPECT_EQ(name.error().code, ErrorCode::InvalidArgument);
    const std::string key = std::string(setting).substr(0, std::string(setting).find('='));
    EXPECT_THAT(name.error().message, HasSubstr(key));
  }
}

}  // namespace
}  // namespace posecoach
