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
  USED_BY pipeline pipeline_io pipeline_check lessons app_state app_derived)
precompiled(precompiled_cli
  HEADERS [["pipeline/run/frame.h"]] <filesystem> <CLI/CLI.hpp>
  OPTIONS app_options CLI11::CLI11
  USED_BY app_cli)
# A file that includes CLI11 compiles for 3.5 s before its own first line, and readers and writers include nlohmann's JSON
# and toml++: ten of them together pay that once. The command line took 134 s of a processor and takes 42 s.
set_target_properties(app_cli pipeline_io PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 10)
if(SHADESCOPE_WINDOW)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets)
  precompiled(precompiled_window
    HEADERS <condition_variable> <filesystem> <set> <thread> ${qt_headers} [["pipeline/run/frame.h"]]
    OPTIONS app_options Qt6::Widgets
    USED_BY app_core app_view3d app_panels app_desktop)
  # Nor is a file of the window small: Qt's and VTK's headers behind those above. Eight of them together.
  set_target_properties(app_core app_view3d app_panels app_desktop PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
endif()

if(SHADESCOPE_TESTS)
  find_package(GTest REQUIRED)
  target_precompile_headers(test_support REUSE_FROM precompiled_library)
  precompiled(precompiled_tests
    HEADERS <filesystem> <random> <gtest/gtest.h> [["pipeline/run/frame.h"]]
    OPTIONS test_options GTest::gtest
    USED_BY unit_tests property_tests reference_tests lessons_tests cli_tests
      architecture_tests worker_tests)
  if(TARGET twin_tests)
    target_precompile_headers(twin_tests REUSE_FROM precompiled_tests)
  endif()
  if(SHADESCOPE_WINDOW)
    # Not <QTest>: its flags name the folder.
    precompiled(precompiled_window_tests
      HEADERS <condition_variable> <filesystem> <set> <thread> ${qt_headers} <gtest/gtest.h> [["app/core/document.h"]]
      OPTIONS test_options Qt6::Widgets GTest::gtest
      USED_BY widget_tests view3d_tests lesson_panel_tests window_tests)
  endif()
endif()
