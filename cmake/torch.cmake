# libtorch. Reading its headers takes half a minute a file, so they are compiled once, for every target that says
#
#   posecoach_use_torch(posecoach_retarget_network [WITHOUT a.cpp b.cpp])
#
# Files named after WITHOUT never see them.
find_package(OpenMP REQUIRED COMPONENTS CXX)
# Not Debian's TorchConfig.cmake: it adds the options of a whole CUDA build to every target.
find_path(TORCH_INCLUDE_DIR torch/csrc/api/include/torch/torch.h REQUIRED)
find_library(TORCH_LIBRARY torch REQUIRED)
find_library(TORCH_CPU_LIBRARY torch_cpu REQUIRED)
find_library(C10_LIBRARY c10 REQUIRED)
add_library(posecoach_torch INTERFACE)
target_include_directories(posecoach_torch SYSTEM INTERFACE ${TORCH_INCLUDE_DIR}
  ${TORCH_INCLUDE_DIR}/torch/csrc/api/include)
target_link_libraries(posecoach_torch INTERFACE ${TORCH_LIBRARY} ${TORCH_CPU_LIBRARY} ${C10_LIBRARY}
  OpenMP::OpenMP_CXX)

# A precompiled header belongs to a target with a source file, be it an empty one.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/torch_headers.cpp CONTENT "")
posecoach_library(NAME torch_headers SOURCES ${CMAKE_BINARY_DIR}/torch_headers.cpp PRIVATE posecoach_torch)
target_precompile_headers(posecoach_torch_headers PRIVATE <torch/torch.h>)
set_target_properties(posecoach_torch_headers PROPERTIES EXCLUDE_FROM_ALL ON)

# Under sanitizers these files would take three times as long, for templates of libtorch, which is not built with them
# either.
set(TORCH_COMPILE_OPTIONS)
if(POSECOACH_SANITIZE)
  set(TORCH_COMPILE_OPTIONS -fno-sanitize=all -g0 -O1)
endif()
target_compile_options(posecoach_torch_headers PRIVATE ${TORCH_COMPILE_OPTIONS})

function(posecoach_use_torch target)
  cmake_parse_arguments(ARG "" "" "WITHOUT" ${ARGN})
  target_link_libraries(${target} PRIVATE posecoach_torch)
  target_compile_options(${target} PRIVATE ${TORCH_COMPILE_OPTIONS})
  target_precompile_headers(${target} REUSE_FROM posecoach_torch_headers)
  if(ARG_WITHOUT)
    set_source_files_properties(${ARG_WITHOUT} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()
