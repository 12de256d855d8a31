# SHADESCOPE_INSTRUCTION_SET: the best one that this machine and the kernels have, by Highway's name. It is asked anew in each
# configuration, because a build folder may be seen by several machines.
unset(ran CACHE)
unset(compiled CACHE)
try_run(ran compiled
  SOURCE_FROM_CONTENT instruction_set.cpp "#include \"pipeline/simd/targets.h\"
#include <hwy/highway.h>
#include <cstdio>
int main() { std::fputs(hwy::TargetName(hwy::SupportedAndGeneratedTargets().front()), stdout); }
"
  CMAKE_FLAGS -DINCLUDE_DIRECTORIES=${PROJECT_SOURCE_DIR} LINK_LIBRARIES hwy::hwy
  COMPILE_OUTPUT_VARIABLE why RUN_OUTPUT_VARIABLE instruction_set)
if(NOT compiled OR NOT ran STREQUAL 0)
  message(FATAL_ERROR "This machine's instruction set is not found: ${why} ${instruction_set}")
endif()
set(SHADESCOPE_INSTRUCTION_SET ${instruction_set} CACHE INTERNAL "")
message(STATUS "SIMD kernels for ${instruction_set} alone")
