# airlight_find_package(<name> DEBIAN <package> FOR <what needs it> [OPTION <AIRLIGHT_BUILD_...>]
#                       [VERSION <least>] [COMPONENTS <component>...])
#
# find_package that fails with the name of the Debian package to install. OPTION names the option whose OFF
# does without this dependency. A macro, so that the variables a package defines reach the caller.
macro(airlight_find_package name)
    cmake_parse_arguments(_airlight_find "" "DEBIAN;FOR;OPTION;VERSION" "COMPONENTS" ${ARGN})
    set(_airlight_find_components)
    if(_airlight_find_COMPONENTS)
        set(_airlight_find_components COMPONENTS ${_airlight_find_COMPONENTS})
    endif()
    find_package(${name} ${_airlight_find_VERSION} QUIET ${_airlight_find_components})
    if(NOT ${name}_FOUND)
        airlight_missing_dependency(
            "${name} ${_airlight_find_VERSION}" DEBIAN ${_airlight_find_DEBIAN} FOR "${_airlight_find_FOR}"
            OPTION "${_airlight_find_OPTION}"
        )
    endif()
endmacro()

# airlight_find_module(<prefix> <pkg-config module> DEBIAN <package> FOR <what needs it> [OPTION <option>])
#
# The same for a library that has a pkg-config file and no CMake package: defines PkgConfig::<prefix>.
function(airlight_find_module prefix module)
    cmake_parse_arguments(PARSE_ARGV 2 arg "" "DEBIAN;FOR;OPTION" "")
    airlight_find_package(PkgConfig DEBIAN pkg-config FOR "${arg_FOR}" OPTION "${arg_OPTION}")
    if(NOT TARGET PkgConfig::${prefix})
        pkg_check_modules(${prefix} QUIET IMPORTED_TARGET GLOBAL ${module})
        if(NOT ${prefix}_FOUND)
            airlight_missing_dependency(
                "${module}" DEBIAN ${arg_DEBIAN} FOR "${arg_FOR}" OPTION "${arg_OPTION}"
            )
        endif()
    endif()
endfunction()

# airlight_missing_dependency(<name> DEBIAN <package> FOR <what needs it> [OPTION <option>]): stops with the
# one message that both functions above give.
function(airlight_missing_dependency name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "DEBIAN;FOR;OPTION" "")
    string(STRIP "${name}" name)
    set(message "airlight: ${name} was not found, and it is needed for ${arg_FOR}.\n"
                "Install it (Debian: apt-get install ${arg_DEBIAN})"
    )
    if(arg_OPTION)
        list(APPEND message " or do without: -D${arg_OPTION}=OFF")
    endif()
    string(JOIN "" message ${message} ".")
    message(FATAL_ERROR "${message}")
endfunction()
