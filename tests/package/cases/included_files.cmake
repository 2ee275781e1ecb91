# The umbrella header pulls in GLM's basic parts and nothing that <glm/glm.hpp> does not: what keeps its
# compile time near that of GLM alone (bench/compile_time measures the time itself).
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")

# files_of(<result> <code>): every file that compiling the code opens, with the preprocessed line count.
function(files_of result code)
    set(source "${WORK}/included_files.cpp")
    file(WRITE "${source}" "${code}\n")
    execute_process(
        COMMAND "${CXX}" -std=c++17 "-I${SOURCE}/include" -M "${source}" OUTPUT_VARIABLE rule RESULT_VARIABLE status
    )
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "does not compile: ${code}")
    endif()
    string(REGEX REPLACE "^[^:]*:" "" rule "${rule}")
    string(REPLACE "\\\n" " " rule "${rule}")
    separate_arguments(files UNIX_COMMAND "${rule}")
    list(REMOVE_ITEM files "${source}")
    set(${result} "${files}" PARENT_SCOPE)
endfunction()

files_of(ours "#include <airlight/airlight.hpp>")
files_of(glm "#include <glm/glm.hpp>\n#include <limits>")
list(FILTER ours EXCLUDE REGEX "/airlight/")
list(LENGTH ours ours_count)
list(LENGTH glm glm_count)
list(REMOVE_ITEM ours ${glm})
message("outside its own headers <airlight/airlight.hpp> opens ${ours_count} files, <glm/glm.hpp> ${glm_count}")
if(ours)
    message(FATAL_ERROR "opened by airlight and not by GLM: ${ours}")
endif()
