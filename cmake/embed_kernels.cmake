# Puts kernels/<operation>.cl (text, includes flattened) and shaders/<operation>.comp (SPIR-V) into a
# target. Each `__kernel` of a .cl file is an entry. Where an operation has several, its shader is built
# once for each, with -DPASS_<ENTRY> in capitals. Included files are named from the project's root.

# Appends `text`, with its includes replaced and #line where the text's origin changes, to `result`.
function(zonegrid_flatten root file result)
  file(READ ${root}/${file} rest)
  set(flat "#line 1 \"${file}\"\n")
  set(line 1)
  while(rest MATCHES "(^|\n)#include \"([^\"\n]*)\"\n")
    set(included ${CMAKE_MATCH_2})
    set(directive "#include \"${included}\"\n")
    string(FIND "${rest}" "${directive}" at)
    string(SUBSTRING "${rest}" 0 ${at} before)
    string(REGEX MATCHALL "\n" newlines "${before}")
    list(LENGTH newlines lines)
    math(EXPR line "${line} + ${lines} + 1")
    zonegrid_flatten(${root} ${included} inner)
    string(APPEND flat "${before}${inner}#line ${line} \"${file}\"\n")
    string(LENGTH "${directive}" length)
    math(EXPR at "${at} + ${length}")
    string(SUBSTRING "${rest}" ${at} -1 rest)
  endwhile()
  set(${result} "${flat}${rest}" PARENT_SCOPE)
endfunction()

# Sets `result` to the names of the kernels in a .cl file.
function(zonegrid_entries file result)
  file(STRINGS ${file} lines REGEX "^__kernel .*void [a-z0-9_]+\\(")
  list(TRANSFORM lines REPLACE "^__kernel .*void ([a-z0-9_]+)\\(.*" "\\1")
  set(${result} "${lines}" PARENT_SCOPE)
endfunction()

# Run at build time: cmake -D root= -D spirv_folder= -D output= -D operations=a,b -P embed_kernels.cmake
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  string(REPLACE "," ";" operations "${operations}")
  set(arrays "")
  set(sources "")
  set(shaders "")
  foreach(operation IN LISTS operations)
    zonegrid_flatten(${root} kernels/${operation}.cl text)
    # Bytes, not a string literal: compilers limit how long that may be.
    file(WRITE ${output}.text "${text}")
    file(READ ${output}.text bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    string(APPEND arrays "constexpr char ${operation}_source[] = {${bytes}};\n")
    string(APPEND sources
      "    {\"${operation}\", {${operation}_source, sizeof(${operation}_source)}},\n")
    zonegrid_entries(${root}/kernels/${operation}.cl entries)
    foreach(entry IN LISTS entries)
      file(READ ${spirv_folder}/${operation}.${entry}.spv words HEX)
      string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${words}")
      string(APPEND arrays
        "constexpr std::uint32_t ${operation}_${entry}_spirv[] = {${words}};\n")
      string(APPEND shaders
        "    {\"${operation}\", \"${entry}\", ${operation}_${entry}_spirv},\n")
    endforeach()
  endforeach()
  file(REMOVE ${output}.text)
  file(WRITE ${output} "// Written by cmake/embed_kernels.cmake.
#include \"device/embedded_code.h\"

namespace zonegrid::device {

namespace {

${arrays}
constexpr EmbeddedSource all_sources[] = {
${sources}};

constexpr EmbeddedShader all_shaders[] = {
${shaders}};

} // namespace

std::span<const EmbeddedSource> embedded_sources() { return all_sources; }

std::span<const EmbeddedShader> embedded_shaders() { return all_shaders; }

} // namespace zonegrid::device
")
  return()
endif()

function(zonegrid_embed_kernels target)
  find_program(ZONEGRID_GLSLANG glslangValidator REQUIRED)
  find_program(ZONEGRID_SPIRV_VAL spirv-val REQUIRED)
  set(root ${PROJECT_SOURCE_DIR})
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/kernels)
  file(MAKE_DIRECTORY ${folder})
  file(GLOB includes CONFIGURE_DEPENDS ${root}/kernels/params/*.h ${root}/kernels/parts/*.cl
       ${root}/shaders/parts/*.glsl)
  list(APPEND includes ${root}/kernels/common.cl ${root}/shaders/common.glsl
       ${root}/host/model/constants.h)
  file(GLOB kernels CONFIGURE_DEPENDS ${root}/kernels/*.cl)
  list(REMOVE_ITEM kernels ${root}/kernels/common.cl)
  set(operations "")
  set(spirv "")
  foreach(kernel IN LISTS kernels)
    get_filename_component(operation ${kernel} NAME_WE)
    list(APPEND operations ${operation})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${kernel})
    zonegrid_entries(${kernel} entries)
    list(LENGTH entries entry_count)
    if(entry_count EQUAL 0)
      message(FATAL_ERROR "kernels/${operation}.cl has no line '__kernel ... void NAME('")
    endif()
    foreach(entry IN LISTS entries)
      set(pass "")
      if(entry_count GREATER 1)
        string(TOUPPER -DPASS_${entry} pass)
      endif()
      set(binary ${folder}/${operation}.${entry}.spv)
      list(APPEND spirv ${binary})
      add_custom_command(OUTPUT ${binary}
        COMMAND ${ZONEGRID_GLSLANG} --quiet --target-env vulkan1.1 -S comp -I${root} ${pass}
                -o ${binary} ${root}/shaders/${operation}.comp
        COMMAND ${ZONEGRID_SPIRV_VAL} --target-env vulkan1.1 ${binary}
        DEPENDS ${root}/shaders/${operation}.comp ${includes}
        COMMENT "SPIR-V of ${operation}.${entry}"
        VERBATIM)
    endforeach()
  endforeach()
  set(script ${root}/cmake/embed_kernels.cmake)
  set(output ${folder}/embedded_code.cpp)
  list(JOIN operations "," operation_list)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D root=${root} -D spirv_folder=${folder} -D output=${output}
            -D operations=${operation_list} -P ${script}
    DEPENDS ${kernels} ${spirv} ${includes} ${script}
    COMMENT "Embedding the kernels"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
