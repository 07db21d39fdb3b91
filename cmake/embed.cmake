# posecoach_embed(TARGET NAME files...): makes `namespace posecoach::assets { std::string_view NAME(); }`
# available from "<file>.h"-free generated sources, so that nothing depends on a path at run time.
#
#   posecoach_embed(posecoach_assets FILES motions/swing.json SYMBOLS swing_motion)
function(posecoach_embed target)
  cmake_parse_arguments(ARG "" "" "FILES;SYMBOLS" ${ARGN})
  foreach(file symbol IN ZIP_LISTS ARG_FILES ARG_SYMBOLS)
    set(out ${CMAKE_CURRENT_BINARY_DIR}/${symbol}.S)
    set(path ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    file(WRITE ${out}.new
"    .section .rodata
    .global posecoach_asset_${symbol}_begin
    .global posecoach_asset_${symbol}_end
    .balign 16
posecoach_asset_${symbol}_begin:
    .incbin \"${path}\"
posecoach_asset_${symbol}_end:
    .byte 0
    .section .note.GNU-stack,\"\",@progbits
")
    file(COPY_FILE ${out}.new ${out} ONLY_IF_DIFFERENT)
    set_source_files_properties(${out} PROPERTIES OBJECT_DEPENDS ${path} LANGUAGE CXX
      COMPILE_OPTIONS "-xassembler")
    target_sources(${target} PRIVATE ${out})
  endforeach()
endfunction()
