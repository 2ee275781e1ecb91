# A program outside the tree finds the installed library, builds with it and runs.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
build_and_run_sky("${TEST_SOURCE}/find_package" "${WORK}/find_package" "-DCMAKE_PREFIX_PATH=${PREFIX}")
