# Install, export, pkg-config and uninstall. Everything is independent of the architecture, so the package
# files go to share/; every path in them is relative to the file itself, so an installed tree may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(airlight_install_cmakedir "${CMAKE_INSTALL_DATADIR}/cmake/airlight")
set(airlight_install_pkgconfigdir "${CMAKE_INSTALL_DATADIR}/pkgconfig")
set(airlight_install_glsldir "${CMAKE_INSTALL_DATADIR}/airlight/glsl")

install(TARGETS airlight EXPORT airlight-targets INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(DIRECTORY include/airlight DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY glsl/ DESTINATION "${airlight_install_glsldir}" FILES_MATCHING PATTERN "*.glsl"
        PATTERN "manifest.json"
)
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(EXPORT airlight-targets NAMESPACE airlight:: DESTINATION "${airlight_install_cmakedir}")

configure_package_config_file(
    cmake/airlight-config.cmake.in airlight-config.cmake INSTALL_DESTINATION "${airlight_install_cmakedir}"
    PATH_VARS airlight_install_glsldir
)
write_basic_package_version_file(
    airlight-config-version.cmake COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT
)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/airlight-config.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/airlight-config-version.cmake"
        DESTINATION "${airlight_install_cmakedir}"
)

# pkg-config knows its own file's folder as ${pcfiledir}; the way from there to the prefix makes it movable.
file(RELATIVE_PATH airlight_pkgconfig_to_prefix "/${airlight_install_pkgconfigdir}" "/")
string(REGEX REPLACE "/$" "" airlight_pkgconfig_to_prefix "${airlight_pkgconfig_to_prefix}")
foreach(directory CMAKE_INSTALL_INCLUDEDIR airlight_install_glsldir)
    if(IS_ABSOLUTE "${${directory}}")
        set(airlight_pkgconfig_${directory} "${${directory}}")
    else()
        set(airlight_pkgconfig_${directory} "\${prefix}/${${directory}}")
    endif()
endforeach()
configure_file(cmake/airlight.pc.in airlight.pc @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/airlight.pc" DESTINATION "${airlight_install_pkgconfigdir}")

# `uninstall` belongs to the project being built; as a subdirectory airlight leaves the name alone.
if(PROJECT_IS_TOP_LEVEL)
    add_custom_target(
        uninstall
        COMMAND "${CMAKE_COMMAND}" "-DMANIFEST=${CMAKE_CURRENT_BINARY_DIR}/install_manifest.txt" -P
                "${CMAKE_CURRENT_SOURCE_DIR}/cmake/AirlightUninstall.cmake"
        COMMENT "Removing the files of the last install"
        VERBATIM
    )
endif()
