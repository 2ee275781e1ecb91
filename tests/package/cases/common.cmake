# Included by every case; SOURCE, WORK, GENERATOR, MAKE_PROGRAM, CXX and VERSION come from the command line.
cmake_minimum_required(VERSION 3.21)
foreach(variable SOURCE WORK GENERATOR MAKE_PROGRAM CXX VERSION)
    if(NOT DEFINED ${variable})
        message(FATAL_ERROR "run by ctest, which defines ${variable}; see tests/package/CMakeLists.txt")
    endif()
endforeach()
get_filename_component(TEST_SOURCE "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
set(PREFIX "${WORK}/prefix")
set(LIBRARY_BUILD "${WORK}/library")

# Only what a case asks for may be found: neither an installed airlight nor the caller's search paths.
foreach(variable airlight_DIR airlight_ROOT CMAKE_PREFIX_PATH PKG_CONFIG_PATH DESTDIR CXXFLAGS)
    unset(ENV{${variable}})
endforeach()

# run(<command...>): prints the output and stops when the command fails.
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result COMMAND_ECHO STDOUT)
    if(NOT result EQUAL 0)
        string(JOIN " " command ${ARGN})
        message(FATAL_ERROR "failed (${result}): ${command}")
    endif()
endfunction()

# configure(<source> <build> <arguments...>): from scratch, with this project's compiler.
function(configure source build)
    file(REMOVE_RECURSE "${build}")
    run("${CMAKE_COMMAND}" -S "${source}" -B "${build}" -G "${GENERATOR}" "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}"
        "-DCMAKE_CXX_COMPILER=${CXX}" -DCMAKE_BUILD_TYPE=Release ${ARGN}
    )
endfunction()

# build_and_run_sky(<source> <build> <arguments...>): the outside program, from configuring to its output.
function(build_and_run_sky source build)
    configure("${source}" "${build}" ${ARGN})
    run("${CMAKE_COMMAND}" --build "${build}")
    run("${build}/sky")
endfunction()

# expect_failure(<pattern> <command...>): stops unless the command fails and says <pattern>.
function(expect_failure pattern)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output COMMAND_ECHO STDOUT)
    message("${output}")
    if(result EQUAL 0)
        message(FATAL_ERROR "succeeded, but must fail")
    endif()
    string(REGEX REPLACE "[ \n]+" " " output "${output}")
    if(NOT output MATCHES "${pattern}")
        message(FATAL_ERROR "failed as it must, but without saying '${pattern}'")
    endif()
endfunction()
