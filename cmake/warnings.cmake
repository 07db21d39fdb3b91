# The one list of warnings; errors in CI (POSECOACH_WERROR).
add_library(posecoach_warnings INTERFACE)
target_compile_options(posecoach_warnings INTERFACE
  -Wall -Wextra -Wpedantic
  -Wconversion -Wsign-conversion   # sizes and indices are where video and file code breaks
  -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  -Wnull-dereference -Wdouble-promotion -Wformat=2 -Wimplicit-fallthrough
  $<$<BOOL:${POSECOACH_WERROR}>:-Werror>)
# GCC 12 reports false positives of these inside the standard library and GLM when optimising.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(posecoach_warnings INTERFACE -Wno-null-dereference -Wno-maybe-uninitialized
    -Wno-array-bounds -Wno-stringop-overflow -Wno-restrict)
endif()
