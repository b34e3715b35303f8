# Every operation has one name everywhere. A missing member of the set stops the configuration and
# is named. With ON_DEVICES it has a kernel and a shader too, and what runs and tests them.
function(zonegrid_operation name)
  set(files host/reference/${name}.h host/reference/${name}.cpp
            tests/ops/${name}_test.cpp bench/${name}_bench.cpp)
  if("ON_DEVICES" IN_LIST ARGN)
    list(APPEND files kernels/${name}.cl shaders/${name}.comp host/ops/${name}.h
                      host/ops/${name}.cpp tests/ops/${name}_device_test.cpp)
  endif()
  foreach(file IN LISTS files)
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${file})
      message(FATAL_ERROR "operation ${name}: ${file} is missing")
    endif()
  endforeach()
endfunction()
