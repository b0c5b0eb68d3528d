# triscope_embed(TARGET FUNCTION FILE…): puts files into the library, so that the program needs none at run time.
# Defines `std::span<const triscope::EmbeddedFile> triscope::FUNCTION()` (render/embedded.h); files keep their names.
# Run as a script (cmake -P) it writes the C++ file; FILES is a list separated by '|'.

if(CMAKE_SCRIPT_MODE_FILE)
  string(REPLACE "|" ";" files "${FILES}")
  set(arrays "")
  set(entries "")
  set(index 0)
  foreach(file IN LISTS files)
    file(READ "${file}" hex HEX)
    file(SIZE "${file}" size)
    get_filename_component(name "${file}" NAME)
    string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
    string(APPEND arrays "const unsigned char file${index}[] = {\n${bytes}};\n")
    string(APPEND entries "    {\"${name}\", {file${index}, ${size}}},\n")
    math(EXPR index "${index} + 1")
  endforeach()
  file(WRITE "${OUTPUT}"
       "#include <array>\n\n#include \"render/embedded.h\"\n\nnamespace triscope {\nnamespace {\n${arrays}"
       "const std::array<EmbeddedFile, ${index}> files{{\n${entries}}};\n}  // namespace\n\n"
       "std::span<const EmbeddedFile> ${FUNCTION}() { return files; }\n\n}  // namespace triscope\n")
  return()
endif()

function(triscope_embed target function)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/embedded/${function}.cpp")
  string(REPLACE ";" "|" files "${ARGN}")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND ${CMAKE_COMMAND} "-DFILES=${files}" "-DOUTPUT=${output}" "-DFUNCTION=${function}" -P
            "${PROJECT_SOURCE_DIR}/cmake/Embed.cmake"
    DEPENDS ${ARGN} "${PROJECT_SOURCE_DIR}/cmake/Embed.cmake"
    COMMENT "Embedding ${function}"
    VERBATIM)
  set_source_files_properties("${output}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)  # their names are all the same
  target_sources(${target} PRIVATE "${output}")
endfunction()
