# The library alone configures without any dependency of tests, tools or examples, and installs.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
file(REMOVE_RECURSE "${PREFIX}")
configure("${SOURCE}" "${LIBRARY_BUILD}"
    -DAIRLIGHT_BUILD_TESTS=OFF -DAIRLIGHT_BUILD_TOOLS=OFF -DAIRLIGHT_BUILD_EXAMPLES=OFF -DAIRLIGHT_BUILD_STUDY=OFF
    -DCMAKE_DISABLE_FIND_PACKAGE_doctest=ON -DCMAKE_DISABLE_FIND_PACKAGE_OpenEXR=ON
    -DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON
    -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON -DCMAKE_DISABLE_FIND_PACKAGE_Clang=ON
)
run("${CMAKE_COMMAND}" --build "${LIBRARY_BUILD}")

# Nothing was compiled: with everything off there are only headers.
file(GLOB_RECURSE compiled "${LIBRARY_BUILD}/*.o" "${LIBRARY_BUILD}/*.a")
list(FILTER compiled EXCLUDE REGEX "/CMakeFiles/[0-9.]+/")
if(compiled)
    message(FATAL_ERROR "compiled with every option off: ${compiled}")
endif()

run("${CMAKE_COMMAND}" --install "${LIBRARY_BUILD}" --prefix "${PREFIX}")
foreach(file include/airlight/airlight.hpp share/airlight/glsl/airlight.glsl share/airlight/glsl/manifest.json
             share/cmake/airlight/airlight-config.cmake share/pkgconfig/airlight.pc
)
    if(NOT EXISTS "${PREFIX}/${file}")
        message(FATAL_ERROR "not installed: ${file}")
    endif()
endforeach()

# Every header and every shader of the source tree is there, and nothing else.
foreach(pair "include;include;*.hpp" "glsl;share/airlight/glsl;*.glsl")
    list(GET pair 0 from)
    list(GET pair 1 to)
    list(GET pair 2 pattern)
    file(GLOB_RECURSE expected RELATIVE "${SOURCE}/${from}" "${SOURCE}/${from}/${pattern}")
    file(GLOB_RECURSE installed RELATIVE "${PREFIX}/${to}" "${PREFIX}/${to}/${pattern}")
    if(NOT expected STREQUAL installed)
        message(FATAL_ERROR "in ${from}: ${expected}\ninstalled: ${installed}")
    endif()
endforeach()
