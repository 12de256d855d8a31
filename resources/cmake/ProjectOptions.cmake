# project_options: what every target of the project is compiled with.
add_library(project_options INTERFACE)
target_compile_features(project_options INTERFACE cxx_std_20)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

target_compile_options(project_options INTERFACE
  -ffp-contract=off   # a fused multiply-add where the compiler likes one changes bits between machines
  -Wall -Wextra -Wpedantic
  -Wshadow            # a local name that hides another
  -Wconversion        # a number that silently changes its type
  $<$<BOOL:${SHADESCOPE_WERROR}>:-Werror>)

set(SHADESCOPE_SANITIZE "" CACHE STRING "Sanitizers: address,undefined or thread")
if(SHADESCOPE_SANITIZE)
  set(sanitize -fsanitize=${SHADESCOPE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(SHADESCOPE_SANITIZE MATCHES undefined)
    list(APPEND sanitize -fsanitize=float-cast-overflow)
  endif()
  target_compile_options(project_options INTERFACE ${sanitize})
  target_link_options(project_options INTERFACE ${sanitize})
endif()

# Qt's headers take half of a first build; precompiled once, they do not.
option(SHADESCOPE_PRECOMPILE "Precompile Qt's headers" OFF)

find_program(CCACHE ccache)
if(CCACHE)
  # Without the first ccache keeps nothing that was compiled with a precompiled header; with the others one clone
  # takes what another one compiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
endif()
