# Headers that most files of a layer include are parsed once for the layer. A file still includes what it
# uses: without SHADESCOPE_PRECOMPILE the same sources compile, only more slowly.
# More headers are not better: each file pays for the inline functions of all of them, used or not.
# With <QtWidgets> that was 0.7 s a file, with the headers of Qt that stand here 0.3 s to 0.5 s.
set(standard_headers
  <algorithm> <array> <bitset> <chrono> <cmath> <compare> <concepts> <cstddef> <cstdint> <functional> <limits>
  <map> <memory> <mutex> <optional> <span> <stop_token> <string> <string_view> <type_traits> <utility> <variant>
  <vector>)
set(qt_headers
  <QApplication> <QColor> <QFont> <QHBoxLayout> <QImage> <QLabel> <QMenu> <QObject> <QPainter> <QPalette>
  <QPolygonF> <QPushButton> <QString> <QStringList> <QTimer> <QToolButton> <QUndoStack> <QVBoxLayout> <QWidget>)

# precompiled(NAME HEADERS ... OPTIONS libraries whose flags it is compiled with ... USED_BY targets with these flags ...)
function(precompiled name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;OPTIONS;USED_BY")
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "")   # a target has a source
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
  set_target_properties(${name} PROPERTIES AUTOMOC OFF)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${arg_OPTIONS} glm::glm)
  target_precompile_headers(${name} PRIVATE ${standard_headers} <glm/glm.hpp> <fmt/format.h> ${arg_HEADERS})
  foreach(target ${arg_USED_BY})
    target_precompile_headers(${target} REUSE_FROM ${name})
  endforeach()
endfunction()

find_package(glm REQUIRED)
find_package(CLI11 REQUIRED)
precompiled(precompiled_library
  HEADERS [["pipeline/scene/scene.h"]]
  OPTIONS project_options
  USED_BY pipeline pipeline_io pipeline_check pipeline_compare lessons lessons_state)
position_independent(precompiled_library)
precompiled(precompiled_cli
  HEADERS [["pipeline/run/frame.h"]] <filesystem> <CLI/CLI.hpp>
  OPTIONS app_options CLI11::CLI11
  USED_BY app_cli)

# Beyond that most files compile for longer before their own first line than behind it: CLI11 alone takes 3.5 s,
# toml++, Qt and VTK no less. So many files together pay that once; what is a file's own has to have a name of its own
# among them.
function(compiled_together files)
  set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${files})
endfunction()
compiled_together(8 pipeline pipeline_check pipeline_compare lessons_state)
compiled_together(10 pipeline_io app_cli)
compiled_together(11 lessons)
# But not what a frame's time goes into: how much of a function is put into another depends on what stands beside it.
# Nor tables, whose columns have names of a letter, and rays.
get_target_property(alone pipeline SOURCES)
list(FILTER alone INCLUDE REGEX "^(buffers|core|illumination|run|scene|simd|stages)/|/ray_")
if(SHADESCOPE_FUZZ)  # no frame is timed
  list(FILTER alone INCLUDE REGEX "^(simd|run)/|_table|model_facts|scene_check|settings_|buffers/|/ray_")
endif()
list(TRANSFORM alone PREPEND ${PROJECT_SOURCE_DIR}/pipeline/)
set_source_files_properties(${alone} TARGET_DIRECTORY pipeline PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
if(SHADESCOPE_THIS_MACHINE)  # what is inspected, replayed and planned: as app_options
  target_compile_options(pipeline PRIVATE $<$<CONFIG:Release>:-O1>)
  set_property(SOURCE ${alone} TARGET_DIRECTORY pipeline APPEND PROPERTY COMPILE_OPTIONS $<$<CONFIG:Release>:-O3>)
endif()
if(SHADESCOPE_WINDOW)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets)
  precompiled(precompiled_window
    HEADERS <condition_variable> <filesystem> <set> <thread> ${qt_headers} [["pipeline/run/frame.h"]]
    OPTIONS app_options Qt6::Widgets
    USED_BY app_core app_view3d app_panels app_desktop)
  compiled_together(16 app_core app_view3d app_panels app_desktop)
endif()

if(SHADESCOPE_TESTS)
  # GCC takes a test file among others for a header, whose tests had better not have a fixture that is each file's own.
  # Where a file is compiled alone, the warning stays.
  function(tests_compiled_together)
    compiled_together(8 ${ARGN})
    foreach(target ${ARGN})
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    endforeach()
  endfunction()
  find_package(GTest REQUIRED)
  target_precompile_headers(test_support REUSE_FROM precompiled_library)
  position_independent(test_support)
  precompiled(precompiled_tests
    HEADERS <filesystem> <random> <gtest/gtest.h> [["pipeline/run/frame.h"]]
    OPTIONS test_options GTest::gtest
    USED_BY unit_tests property_tests reference_tests lessons_tests cli_tests
      architecture_tests worker_tests)
  tests_compiled_together(unit_tests property_tests lessons_tests cli_tests architecture_tests)
  if(TARGET twin_tests)
    target_precompile_headers(twin_tests REUSE_FROM precompiled_tests)
  endif()
  if(SHADESCOPE_WINDOW)
    # Not <QTest>: its flags name the folder.
    precompiled(precompiled_window_tests
      HEADERS <condition_variable> <filesystem> <set> <thread> ${qt_headers} <gtest/gtest.h> [["app/document/document.h"]]
      OPTIONS test_options Qt6::Widgets GTest::gtest
      USED_BY widget_tests view3d_tests lesson_panel_tests window_tests)
    tests_compiled_together(widget_tests view3d_tests window_tests)
  endif()
endif()
