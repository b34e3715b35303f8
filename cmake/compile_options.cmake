# Options every target of the project shares.
add_library(zonegrid_compile_options INTERFACE)
# The host's doubles decide cells (docs/model.md, section 3): no contraction, no reassociation.
target_compile_options(zonegrid_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wnon-virtual-dtor
  -Wold-style-cast -Wcast-qual -Wformat=2 -Wundef -ffp-contract=off)
if(ZONEGRID_WARNINGS_AS_ERRORS)
  target_compile_options(zonegrid_compile_options INTERFACE -Werror)
endif()
if(ZONEGRID_SANITIZE)
  target_compile_options(zonegrid_compile_options INTERFACE
    -fsanitize=${ZONEGRID_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(zonegrid_compile_options INTERFACE -fsanitize=${ZONEGRID_SANITIZE})
endif()

# Parsing Eigen and the standard library is most of a file's compile time. CI builds with them
# precompiled; the release and debug presets build without, which shows a missing #include.
option(ZONEGRID_PRECOMPILE_HEADERS "Precompile the headers that most files include" OFF)
function(zonegrid_precompile target)
  if(ZONEGRID_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} PRIVATE
      <Eigen/Geometry> <fmt/format.h> <algorithm> <array> <cmath> <cstdint> <filesystem>
      <functional> <map> <memory> <optional> <ranges> <span> <string> <vector> ${ARGN})
  endif()
endfunction()
