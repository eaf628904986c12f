# Installs the build tree to a fresh folder, builds the outside project against it and runs it, and
# runs the installed program. Arguments: BUILD_DIR, SOURCE_DIR, WORK_DIR, CXX, BUILD_TYPE, DOCDIR.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${ARGN}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build -G Ninja
    -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DDOCUMENTATION=${WORK_DIR}/prefix/${DOCDIR})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/outside)
run(${WORK_DIR}/build/example)
foreach(file LICENSE README.md docs/tutorial.md docs/pictures/poles.svg bench/README.md)
  if(NOT EXISTS ${WORK_DIR}/prefix/${DOCDIR}/${file})
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()
run(${WORK_DIR}/prefix/bin/cocoon --version)
