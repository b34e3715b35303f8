# Every operation has one name everywhere. A missing member of the set stops the configuration and
# is named.
function(zonegrid_operation name)
  foreach(file host/reference/${name}.h host/reference/${name}.cpp
               tests/ops/${name}_test.cpp bench/${name}_bench.cpp)
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${file})
      message(FATAL_ERROR "operation ${name}: ${file} is missing")
    endif()
  endforeach()
endfunction()
