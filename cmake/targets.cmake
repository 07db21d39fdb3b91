# The only ways to make a target. Sources are listed, never globbed.
#
#   posecoach_library(NAME body SOURCES a.cpp PUBLIC posecoach_base PRIVATE some::heavy_library)
#   posecoach_test(NAME body SOURCES a_test.cpp LIBS posecoach_body [LABELS unit] [TORCH])
#
# TORCH: the test reads libtorch's headers (posecoach_use_torch), whose precompiled form excludes any other.
function(posecoach_library)
  cmake_parse_arguments(ARG "" "NAME" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target posecoach_${ARG_NAME})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    target_include_directories(${target} PUBLIC ${CMAKE_SOURCE_DIR})
    target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} posecoach_warnings)
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE ${CMAKE_SOURCE_DIR})
    target_link_libraries(${target} INTERFACE ${ARG_PUBLIC})
  endif()
endfunction()

# What is tested is optimised fully; optimising the tests too takes longer than they run, most of all with sanitizers.
set(POSECOACH_TEST_OPTIMISATION -O1)
if(POSECOACH_SANITIZE)
  set(POSECOACH_TEST_OPTIMISATION -O0)
endif()

function(posecoach_test)
  cmake_parse_arguments(ARG "TORCH" "NAME" "SOURCES;LIBS;LABELS" ${ARGN})
  set(target ${ARG_NAME}_test)
  add_executable(${target} ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE ${ARG_LIBS} posecoach_test_support posecoach_warnings
    GTest::gmock GTest::gtest_main)
  target_compile_options(${target} PRIVATE ${POSECOACH_TEST_OPTIMISATION})
  if(NOT ARG_TORCH)
    target_precompile_headers(${target} REUSE_FROM posecoach_test_headers)
  endif()
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  gtest_discover_tests(${target} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 240 DISCOVERY_TIMEOUT 60)
endfunction()
