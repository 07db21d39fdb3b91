# POSECOACH_SANITIZE: empty, "address,undefined" or "thread".
set(POSECOACH_SANITIZE "" CACHE STRING "Sanitizers for every target")
if(POSECOACH_SANITIZE)
  add_compile_options(-fsanitize=${POSECOACH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${POSECOACH_SANITIZE})
endif()
# Fuzz targets of clang's libFuzzer want the coverage of every library that they exercise.
if(POSECOACH_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "POSECOACH_FUZZ needs clang (-DCMAKE_CXX_COMPILER=clang++)")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
