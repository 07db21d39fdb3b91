# Files that the program carries inside itself, so that nothing depends on a path at run time. Relative paths
# are seen from the calling CMakeLists.txt.
#
#   posecoach_embed(posecoach_assets FILES motions/swing.json SYMBOLS swing_motion)
#
# and in a .cpp of that target: #include "core/base/embedded.h", POSECOACH_EMBEDDED(swing_motion) at namespace
# scope; then swing_motion() is the file as a std::string_view.
function(posecoach_embed target)
  cmake_parse_arguments(ARG "" "" "FILES;SYMBOLS" ${ARGN})
  foreach(file symbol IN ZIP_LISTS ARG_FILES ARG_SYMBOLS)
    set(out ${CMAKE_CURRENT_BINARY_DIR}/embedded/${symbol}.s)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE OUTPUT_VARIABLE path)
    file(CONFIGURE OUTPUT ${out} CONTENT
"    .section .rodata
    .global posecoach_embedded_${symbol}_begin
    .global posecoach_embedded_${symbol}_end
    .balign 16
posecoach_embedded_${symbol}_begin:
    .incbin \"${path}\"
posecoach_embedded_${symbol}_end:
    .byte 0
    .section .note.GNU-stack,\"\",@progbits
")
    # Compiled by the C++ driver, so that the project needs no second language.
    set_source_files_properties(${out} PROPERTIES OBJECT_DEPENDS ${path} LANGUAGE CXX
      COMPILE_OPTIONS "-xassembler")
    target_sources(${target} PRIVATE ${out})
  endforeach()
endfunction()
