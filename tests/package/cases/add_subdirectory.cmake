# The same program with the source tree as a subdirectory, which must bring nothing to build.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
build_and_run_sky("${TEST_SOURCE}/add_subdirectory" "${WORK}/add_subdirectory" "-DAIRLIGHT_SOURCE=${SOURCE}")
