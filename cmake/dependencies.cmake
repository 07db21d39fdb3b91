# Every library from outside, found once; NOTICE lists them with their licences.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(glm REQUIRED)
find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs)
find_package(OpenMP REQUIRED COMPONENTS CXX)
pkg_check_modules(FFMPEG REQUIRED IMPORTED_TARGET libavformat libavcodec libavutil libswscale)
pkg_check_modules(OSMESA IMPORTED_TARGET osmesa)
find_package(SQLite3 REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS OpenGL EGL)
find_package(glfw3 REQUIRED)
if(POSECOACH_TESTS)
  find_package(GTest REQUIRED)
endif()

# OpenCV's CMake package has no imported include property for plain SYSTEM use of single modules.
add_library(posecoach_opencv INTERFACE)
target_include_directories(posecoach_opencv SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
target_link_libraries(posecoach_opencv INTERFACE opencv_core opencv_imgproc opencv_imgcodecs)

# Debian's dnnl-config.cmake insists on an OpenCL SDK that the CPU library never uses.
find_path(DNNL_INCLUDE_DIR oneapi/dnnl/dnnl.hpp REQUIRED)
find_library(DNNL_LIBRARY dnnl REQUIRED)
add_library(posecoach_onednn INTERFACE)
target_include_directories(posecoach_onednn SYSTEM INTERFACE ${DNNL_INCLUDE_DIR})
target_link_libraries(posecoach_onednn INTERFACE ${DNNL_LIBRARY} OpenMP::OpenMP_CXX)
