# The shader of the README compiles against the installed GLSL, whole and in parts, without a warning.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
find_program(GLSLANG glslangValidator)
if(NOT GLSLANG)
    message(FATAL_ERROR "glslangValidator is not installed (Debian: apt-get install glslang-tools)")
endif()
file(READ "${TEST_SOURCE}/example/sky.frag" whole)
string(REPLACE "#include \"airlight.glsl\"" "
#include \"airlight/atmospheres.glsl\"
#include \"airlight/color.glsl\"
#include \"airlight/compose.glsl\"" parts "${whole}")

# The README's other lines: a flag, and a hook that is the renderer's own function.
string(REPLACE "#include" "
#define AIRLIGHT_OZONE AIRLIGHT_OZONE_NONE
#define AIRLIGHT_VISIBILITY(position) my_shadow(position)
float my_shadow(vec3 position);
#include" hooked "${whole}")
string(APPEND hooked "float my_shadow(vec3 position) { return position.z > 0.0 ? 1.0 : 0.5; }\n")

file(MAKE_DIRECTORY "${WORK}/glsl")
foreach(variant whole parts hooked)
    file(WRITE "${WORK}/glsl/${variant}.frag" "${${variant}}")
    execute_process(
        COMMAND "${GLSLANG}" -l "-I${PREFIX}/share/airlight/glsl" "${WORK}/glsl/${variant}.frag"
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output
    )
    if(NOT result EQUAL 0 OR output MATCHES "WARNING|ERROR")
        message(FATAL_ERROR "${variant}.frag does not compile cleanly:\n${output}")
    endif()
endforeach()
