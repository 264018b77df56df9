# cutaway_embed(TARGET FUNCTION BASE DIR FILES ...)
# Adds to TARGET a generated source that defines
#   std::span<const cutaway::EmbeddedFile> cutaway::FUNCTION();
# with each file's name relative to BASE and its text; rebuilt when a file changes.

set(CUTAWAY_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_files.cmake)

function(cutaway_embed target function)
  cmake_parse_arguments(ARG "" "BASE" "FILES" ${ARGN})
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  list(TRANSFORM ARG_FILES PREPEND ${ARG_BASE}/ OUTPUT_VARIABLE paths)
  string(REPLACE ";" "|" names "${ARG_FILES}")
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DFUNCTION=${function} -DBASE=${ARG_BASE} "-DNAMES=${names}"
            -P ${CUTAWAY_EMBED_SCRIPT}
    DEPENDS ${paths} ${CUTAWAY_EMBED_SCRIPT}
    VERBATIM)
  # By itself: else each of its neighbours is compiled anew with it, and as another file in each build folder.
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${output})
endfunction()
