# Installs the build tree BUILD into a fresh prefix below WORK, then builds and runs the project CONSUMER with it.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${result}:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G ${GENERATOR} -D CMAKE_BUILD_TYPE=${CONFIG}
    -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
    -D B4P_VERSION=${VERSION})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/plan_in_the_plane)

if(EXPERIMENTS)
  foreach(file IN ITEMS robots/panda.yaml robots/urdf/panda.urdf experiments/scenes/maze.yaml
          experiments/scenes/maze.certificate.json)
    if(NOT EXISTS ${prefix}/share/b4p/${file})
      message(FATAL_ERROR "share/b4p/${file} has not been installed")
    endif()
  endforeach()
  run(${CMAKE_COMMAND} -E env B4P_DATA_DIR=${prefix}/share/b4p ${prefix}/bin/b4p list)
endif()
