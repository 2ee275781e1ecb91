# Runs deferred --window on a display of its own (Xvfb) and the same picture without a window, then the check
# that compares them.
#
#   cmake -DPROGRAM=... -DCHECK=... -DFOLDER=<output folder> -P window.cmake
#
# Without Xvfb it is skipped, which the environment variable CI makes a failure.
find_program(XVFB_RUN xvfb-run)
find_program(XAUTH xauth)
if(NOT XVFB_RUN OR NOT XAUTH)
    set(missing "no xvfb-run or no xauth (Debian: apt-get install xvfb xauth)")
    if(DEFINED ENV{CI})
        message(FATAL_ERROR "${missing}")
    endif()
    message("skipped: ${missing}")
    return()
endif()

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
# Exposed alike: automatic exposure samples the picture in a window, and reads all of it for a file.
set(same --size 480x270 --camera ground --sun-elevation 20 --exposure 15 --shadow-size 512)
set(in_window "${XVFB_RUN}" -a -s "-screen 0 1024x768x24" "${PROGRAM}" --window)
set(small --tables none --shadow-size 64)

execute_process(
    COMMAND "${PROGRAM}" --headless ${same} --difference off --output "${FOLDER}"
    COMMAND_ERROR_IS_FATAL ANY
)
execute_process(
    COMMAND ${in_window} ${same} --frames 3 --screenshot "${FOLDER}/window.png" COMMAND_ERROR_IS_FATAL ANY
)
# Down to one pixel and up again; the last frames are drawn at the last size.
execute_process(
    COMMAND ${in_window} ${small} --size 64x36 --window-sizes 1x1 1x1 300x2 2x300 64x36 --frames 8 --screenshot
            "${FOLDER}/resized.png"
    COMMAND_ERROR_IS_FATAL ANY
)
execute_process(
    COMMAND ${in_window} ${small} --size 1x1 --frames 2 --screenshot "${FOLDER}/one.png"
    COMMAND_ERROR_IS_FATAL ANY
)
execute_process(COMMAND "${CHECK}" COMMAND_ERROR_IS_FATAL ANY)
