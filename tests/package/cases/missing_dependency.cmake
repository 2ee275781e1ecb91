# A dependency that is missing is named with the Debian package that has it.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
set(build "${WORK}/missing_dependency")

function(expect_message package missing)
    file(REMOVE_RECURSE "${build}")
    expect_failure("${package}" "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${build}" -G "${GENERATOR}"
        "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}" "-DCMAKE_CXX_COMPILER=${CXX}"
        -DAIRLIGHT_BUILD_TESTS=OFF -DAIRLIGHT_BUILD_TOOLS=OFF -DAIRLIGHT_BUILD_EXAMPLES=OFF -DAIRLIGHT_BUILD_STUDY=OFF
        "-DCMAKE_DISABLE_FIND_PACKAGE_${missing}=ON" ${ARGN}
    )
endfunction()

expect_message(libglm-dev glm)
expect_message(libopenexr-dev OpenEXR -DAIRLIGHT_BUILD_EXAMPLES=ON)
expect_message(libpng-dev PNG -DAIRLIGHT_BUILD_EXAMPLES=ON)
expect_message(doctest-dev doctest -DAIRLIGHT_BUILD_TESTS=ON)
expect_message(nlohmann-json3-dev nlohmann_json -DAIRLIGHT_BUILD_TESTS=ON)
