# What `cmake --install build/release --prefix PREFIX` lays out: the program in bin, the scenes,
# lessons and manual in share/shadescope where the program looks for them, and what a desktop reads.
include(GNUInstallDirs)
install(TARGETS shadescope RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY resources/scenes resources/starter resources/assignments resources/sheets DESTINATION ${CMAKE_INSTALL_DATADIR}/shadescope)
# Talks by name: present lecture1, export --cue lecture2:3.
install(DIRECTORY resources/manual DESTINATION ${CMAKE_INSTALL_DATADIR}/shadescope FILES_MATCHING PATTERN "*.cues")
install(DIRECTORY lessons/ DESTINATION ${CMAKE_INSTALL_DATADIR}/shadescope/lessons
  FILES_MATCHING PATTERN "*.md" PATTERN "*.scene" PATTERN "*.toml" PATTERN "*.des" PATTERN "*.png"
  PATTERN expression EXCLUDE PATTERN state EXCLUDE PATTERN questions EXCLUDE PATTERN grading EXCLUDE
  PATTERN games EXCLUDE PATTERN pages EXCLUDE)
# What live pages are made of; the core where the preset web has built it.
install(DIRECTORY app/web/page/ DESTINATION ${CMAKE_INSTALL_DATADIR}/shadescope/web
  FILES_MATCHING PATTERN "*.html" PATTERN "*.css" PATTERN "*.js" PATTERN "*.txt")
set(core ${PROJECT_SOURCE_DIR}/build/web/shadescope_core.wasm.gz)
install(FILES ${core} ${PROJECT_SOURCE_DIR}/build/web/shadescope_core_write.wasm.gz
  ${PROJECT_SOURCE_DIR}/build/web/shadescope_core_all.wasm.gz ${PROJECT_SOURCE_DIR}/build/web/acorn.js
  DESTINATION ${CMAKE_INSTALL_DATADIR}/shadescope/web OPTIONAL)
install(CODE "if(NOT EXISTS ${core})
  message(WARNING \"Installed without live pages: the preset web has not built their core\")
endif()")
# The Python package, by itself: resources/packaging makes a wheel and a Debian package of it. It has its own scenes and
# parts of a live page, because neither program need be there.
if(TARGET shadescope_python)
  install(TARGETS shadescope_python LIBRARY DESTINATION shadescope COMPONENT python EXCLUDE_FROM_ALL)
  install(DIRECTORY app/python/shadescope DESTINATION . COMPONENT python EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN "*.py" PATTERN py.typed)
  install(DIRECTORY resources/scenes DESTINATION shadescope/share COMPONENT python EXCLUDE_FROM_ALL)
  install(DIRECTORY app/web/page/ DESTINATION shadescope/share/web COMPONENT python EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN "*.html" PATTERN "*.css" PATTERN "*.js")
  install(FILES ${core} DESTINATION shadescope/share/web
    COMPONENT python EXCLUDE_FROM_ALL OPTIONAL)
endif()
set(commands ${PROJECT_BINARY_DIR}/resources/manual)
install(FILES ${commands}/shadescope.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME shadescope)
install(FILES ${commands}/_shadescope DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${commands}/shadescope.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
if(SHADESCOPE_WINDOW)
  install(DIRECTORY resources/manual resources/pictures DESTINATION ${CMAKE_INSTALL_DATADIR}/shadescope
    FILES_MATCHING PATTERN "*.md" PATTERN "*.png")
  set(desktop ${PROJECT_SOURCE_DIR}/resources/desktop)
  install(FILES ${desktop}/shadescope.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${desktop}/shadescope.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
  install(FILES ${desktop}/shadescope-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
    RENAME shadescope.xml)
  install(FILES ${desktop}/shadescope.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()
