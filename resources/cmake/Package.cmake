# The Debian packages, by `cpack` in a build folder: shadescope, and from the preset headless
# shadescope-cli, the commands alone. resources/packaging/deb builds both.
set(CPACK_GENERATOR DEB)
if(SHADESCOPE_WINDOW)
  set(CPACK_PACKAGE_NAME shadescope)
  set(other shadescope-cli)
  # Fonts and OpenGL in software are found at run time, so that no library says that they are needed.
  # Style sheets draw arrows and marks with Qt's plugin for SVG, which Debian 12 has in libqt6svg6.
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "fonts-inter, fonts-jetbrains-mono, fonts-stix, fonts-dejavu-core, qt6-svg-plugins | libqt6svg6 (<< 6.7)")
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, qt6-wayland")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "step-by-step visualizer of a rendering pipeline")
  set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Shadescope renders a scene of polygons through six stages, from the transform
to the shading, and keeps what every stage leaves. Step through the stages,
look at any buffer, and click a pixel to read the illumination equation that
made its colour, with its numbers.

It is made for teaching computer graphics: it has lessons, a view for the
projector, and commands that write buffers as files.")
else()
  set(CPACK_PACKAGE_NAME shadescope-cli)
  set(other shadescope)
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "step-by-step rendering pipeline (commands alone)")
  set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Shadescope renders a scene of polygons through six stages, from the transform
to the shading, and keeps what every stage leaves.

This package has the commands alone, without the window: they write any
buffer as a file, explain a pixel, and measure error against run time.")
endif()
# Both have the program shadescope.
set(CPACK_DEBIAN_PACKAGE_CONFLICTS ${other})
set(CPACK_DEBIAN_PACKAGE_REPLACES ${other})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
# Debian 12's package is older than Debian 13's, so that an upgrade of the system takes the new one.
cmake_host_system_information(RESULT release QUERY DISTRIB_VERSION_ID)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1~deb${release})
set(SHADESCOPE_MAINTAINER "The Shadescope authors <shadescope@example.org>" CACHE STRING
  "Who answers for a package: a name and an address")
set(CPACK_PACKAGE_CONTACT ${SHADESCOPE_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/package)

# What Debian asks of every package: who may copy it, what changed, and the man page.
set(doc ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_PACKAGE_NAME})
install(FILES ${PROJECT_SOURCE_DIR}/resources/packaging/copyright DESTINATION ${doc})
file(STRINGS ${PROJECT_SOURCE_DIR}/resources/desktop/shadescope.metainfo.xml date REGEX "<release version=\"${PROJECT_VERSION}\"")
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+" date "${date}")
execute_process(COMMAND date --utc --rfc-email --date=${date} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE)
configure_file(${PROJECT_SOURCE_DIR}/resources/packaging/changelog.in ${PROJECT_BINARY_DIR}/changelog @ONLY)
set(packed ${PROJECT_BINARY_DIR}/packed)
function(pack from to folder)
  add_custom_command(OUTPUT ${packed}/${to}.gz COMMAND ${CMAKE_COMMAND} -E make_directory ${packed}
    COMMAND gzip -9nc ${from} > ${packed}/${to}.gz DEPENDS ${from} VERBATIM)
  target_sources(package_files PRIVATE ${packed}/${to}.gz)
  install(FILES ${packed}/${to}.gz DESTINATION ${folder})
endfunction()
add_custom_target(package_files ALL)
pack(${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog ${doc})
pack(${PROJECT_BINARY_DIR}/changelog changelog.Debian ${doc})
pack(${PROJECT_BINARY_DIR}/resources/manual/shadescope.1 shadescope.1 ${CMAKE_INSTALL_MANDIR}/man1)
add_dependencies(package_files command_files)
include(CPack)
