# Runs a program and compares what it does with what it should do.
#
#   cmake -DPROGRAM=... -DARGUMENTS="a;b" -DSTATUS=0|1 -DSAYS=<regular expression> -DFOLDER=<output folder>
#         [-DTRUNCATE=<file>] -P expect.cmake
#
# STATUS 1: the program must exit with 1, say SAYS in exactly one line of standard error, and leave nothing in
# FOLDER. STATUS 0: it must exit with 0, say SAYS on standard output and leave no temporary in FOLDER.
# TRUNCATE: the first half of that file is first copied to FOLDER.truncated, which ARGUMENTS may name.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
if(TRUNCATE)
    file(SIZE "${TRUNCATE}" size)
    math(EXPR half "${size} / 2")
    execute_process(
        COMMAND head -c ${half} "${TRUNCATE}" OUTPUT_FILE "${FOLDER}.truncated" COMMAND_ERROR_IS_FATAL ANY
    )
endif()
execute_process(
    COMMAND "${PROGRAM}" ${ARGUMENTS}
    RESULT_VARIABLE status
    OUTPUT_VARIABLE output
    ERROR_VARIABLE error
)
message("${output}${error}")
if(NOT status EQUAL STATUS)
    message(FATAL_ERROR "exit status ${status}, expected ${STATUS}")
endif()

file(GLOB_RECURSE left "${FOLDER}/*")
if(STATUS EQUAL 0)
    if(NOT output MATCHES "${SAYS}")
        message(FATAL_ERROR "standard output does not say: ${SAYS}")
    endif()
    list(FILTER left INCLUDE REGEX "\\.tmp-")
else()
    string(REGEX MATCHALL "\n" ends "${error}")
    list(LENGTH ends lines)
    if(NOT lines EQUAL 1 OR NOT error MATCHES "\n$")
        message(FATAL_ERROR "standard error has ${lines} lines, expected one")
    endif()
    if(NOT error MATCHES "${SAYS}")
        message(FATAL_ERROR "standard error does not say: ${SAYS}")
    endif()
endif()
if(left)
    message(FATAL_ERROR "files were left behind: ${left}")
endif()
