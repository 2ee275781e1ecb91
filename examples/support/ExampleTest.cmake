# example_test(<name> PROGRAM <target> STATUS <0|1> SAYS <regular expression> [ARGUMENTS <argument>...]
#              [ENVIRONMENT <name=value>...] [TRUNCATE <file>])
#
# A test that runs an example and expects an exit status and a text; see expect.cmake. @FOLDER@ in ARGUMENTS
# is a folder of the test's own.
set(EXAMPLE_TEST_SCRIPT "${CMAKE_CURRENT_LIST_DIR}/expect.cmake")

function(example_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "PROGRAM;STATUS;SAYS;TRUNCATE" "ARGUMENTS;ENVIRONMENT")
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/output/${name}")
    string(REPLACE "@FOLDER@" "${folder}" arguments "${arg_ARGUMENTS}")
    add_test(
        NAME ${name}
        COMMAND
            "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:${arg_PROGRAM}>" "-DARGUMENTS=${arguments}"
            "-DSTATUS=${arg_STATUS}" "-DSAYS=${arg_SAYS}" "-DFOLDER=${folder}" "-DTRUNCATE=${arg_TRUNCATE}" -P
            "${EXAMPLE_TEST_SCRIPT}"
    )
    set_tests_properties(${name} PROPERTIES LABELS examples ENVIRONMENT "${arg_ENVIRONMENT}")
endfunction()
