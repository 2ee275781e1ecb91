# .ci/levels passes this tree, and names the line of each kind of include that it exists to refuse.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
find_program(BASH bash REQUIRED)
run("${BASH}" "${SOURCE}/.ci/levels")

set(folder "${WORK}/levels/airlight")
# refuses(<message> <header> <its text>): a tree of this header and a sound one.
function(refuses message header text)
    file(REMOVE_RECURSE "${folder}")
    file(WRITE "${folder}/types.hpp" "#include <glm/vec3.hpp>\n")
    file(WRITE "${folder}/airlight.hpp" "#include <airlight/types.hpp>\n#include <airlight/${header}>\n")
    file(WRITE "${folder}/${header}" "${text}\n")
    expect_failure("${message}" "${BASH}" "${SOURCE}/.ci/levels" "${folder}")
endfunction()

refuses("phase.hpp:2: airlight/column.hpp does not lie below phase" phase.hpp "\n#include <airlight/column.hpp>")
refuses("phase.hpp:1: airlight/density.hpp does not lie below phase" phase.hpp "# include <airlight/density.hpp>")
refuses("phase.hpp:1: write <airlight/...>" phase.hpp "#include \"types.hpp\"")
refuses("phase.hpp:1: <vector> is not allowed" phase.hpp "#include <vector>")
refuses("phase.hpp:1: glm/gtc/constants.hpp is not among" phase.hpp "#include <glm/gtc/constants.hpp>")
refuses("clouds.hpp: has no level" clouds.hpp "#include <airlight/types.hpp>")

file(REMOVE_RECURSE "${folder}")
file(WRITE "${folder}/types.hpp" "#include <glm/vec3.hpp>\n")
file(WRITE "${folder}/airlight.hpp" "// includes nothing\n")
expect_failure("does not include <airlight/types.hpp>" "${BASH}" "${SOURCE}/.ci/levels" "${folder}")
