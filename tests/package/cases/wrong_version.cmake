# Another major version is not accepted in place of this one.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
set(outside "${WORK}/wrong_version")
file(REMOVE_RECURSE "${outside}")
file(WRITE "${outside}/CMakeLists.txt"
    "cmake_minimum_required(VERSION 3.21)\nproject(outside LANGUAGES NONE)\nfind_package(airlight 999 CONFIG REQUIRED)\n"
)
expect_failure("version: ${VERSION}" "${CMAKE_COMMAND}" -S "${outside}" -B "${outside}/build" -G "${GENERATOR}"
    "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}" "-DCMAKE_PREFIX_PATH=${PREFIX}"
)
