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
target_link_libraries(project_options INTERFACE fmt::fmt)
# What the loader has filled in cannot be overwritten later: all functions of libraries are looked up at the start.
target_link_options(project_options INTERFACE LINKER:-z,relro,-z,now)

if(SHADESCOPE_THIS_MACHINE)
  include(CheckLinkerFlag)
  foreach(linker mold lld gold)
    check_linker_flag(CXX -fuse-ld=${linker} SHADESCOPE_LINKS_WITH_${linker})
    if(SHADESCOPE_LINKS_WITH_${linker})
      target_link_options(project_options INTERFACE -fuse-ld=${linker})
      break()
    endif()
  endforeach()
endif()

# GCC 12 puts two numbers that go from double to float and back side by side into a vector, and forgets to round them.
include(CheckCXXSourceRuns)
set(CMAKE_REQUIRED_FLAGS -O2)
check_cxx_source_runs("
__attribute__((noinline)) void roundBoth(const double* from, double* to) {
    const float x = float(from[0]), y = float(from[1]);
    to[0] = x, to[1] = y;
}
int main() {
    const double from[]{0.1, 0.2};
    double to[2];
    roundBoth(from, to);
    return to[0] == from[0] || to[1] == from[1];
}" SHADESCOPE_COMPILER_ROUNDS_PAIRS)
unset(CMAKE_REQUIRED_FLAGS)
if(NOT SHADESCOPE_COMPILER_ROUNDS_PAIRS)
  target_compile_options(project_options INTERFACE -fno-tree-slp-vectorize)
endif()

set(SHADESCOPE_SANITIZE "" CACHE STRING "Sanitizers: address,undefined or thread")
if(SHADESCOPE_SANITIZE)
  set(sanitize -fsanitize=${SHADESCOPE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(SHADESCOPE_SANITIZE MATCHES undefined)
    list(APPEND sanitize -fsanitize=float-cast-overflow)
  endif()
  target_compile_options(project_options INTERFACE ${sanitize})
  target_link_options(project_options INTERFACE ${sanitize})
endif()

# For what a shared library has in it as well, the Python module's. Its functions are called without a detour, as before,
# because nothing of it is seen from outside.
function(position_independent)
  set_target_properties(${ARGN} PROPERTIES
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# The same for what stands around the pipeline. Two thirds of a compilation go into optimising there, and nobody waits for
# what that gains: a build for this machine alone has -O1, as tests have anywhere, and takes a third less time.
add_library(app_options INTERFACE)
add_library(test_options INTERFACE)
target_link_libraries(app_options INTERFACE project_options)
target_link_libraries(test_options INTERFACE project_options)
target_compile_options(app_options INTERFACE $<$<CONFIG:Release>:-O$<IF:$<BOOL:${SHADESCOPE_THIS_MACHINE}>,1,2>>)
target_compile_options(test_options INTERFACE $<$<CONFIG:Release>:-O1>)

# Headers take six tenths of a first build.
option(SHADESCOPE_PRECOMPILE "Precompile headers, see Precompile.cmake" OFF)

find_program(CCACHE ccache)
if(CCACHE)
  # Without the first ccache keeps nothing that was compiled with a precompiled header; with the second it does not
  # preprocess every file before it compiles it. A clone at another path finds little of what this one has compiled:
  # a precompiled header holds its own path.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_DEPEND=1 CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
endif()
