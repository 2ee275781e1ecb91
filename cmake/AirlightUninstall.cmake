cmake_minimum_required(VERSION 3.21)
# Removes what the last `cmake --install` of this build folder wrote, and the folders that this empties.
# Run by the target `uninstall`; MANIFEST is that build folder's install_manifest.txt.
if(NOT EXISTS "${MANIFEST}")
    message(FATAL_ERROR "nothing to uninstall: ${MANIFEST} does not exist; run cmake --install first")
endif()

file(STRINGS "${MANIFEST}" files)
set(folders)
foreach(file IN LISTS files)
    set(path "$ENV{DESTDIR}${file}")
    if(EXISTS "${path}" OR IS_SYMLINK "${path}")
        message(STATUS "Removing ${path}")
        file(REMOVE "${path}")
    endif()
    cmake_path(GET path PARENT_PATH folder)
    list(APPEND folders "${folder}")
endforeach()

# Upwards from each file: a folder goes only while it is empty and belongs to airlight by name; include/ or
# share/ of a prefix may be somebody else's.
list(REMOVE_DUPLICATES folders)
foreach(folder IN LISTS folders)
    while(folder MATCHES "/airlight(/|$)")
        file(GLOB left LIST_DIRECTORIES true "${folder}/*" "${folder}/.*")
        if(left OR NOT IS_DIRECTORY "${folder}")
            break()
        endif()
        message(STATUS "Removing ${folder}")
        file(REMOVE_RECURSE "${folder}")
        cmake_path(GET folder PARENT_PATH folder)
    endwhile()
endforeach()
file(REMOVE "${MANIFEST}")
