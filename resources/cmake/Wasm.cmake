# The toolchain of the preset web: clang 19 for WebAssembly, with Debian's C and C++ libraries. It makes a library for a
# page, a "reactor": no main, no files, no threads, no exceptions.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-19)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)   # there is no main to link
# Debian's C++ library there has no exceptions: where memory is out, the core ends.
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fno-exceptions -fno-rtti")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-mexec-model=reactor -Wl,--gc-sections -Wl,--strip-all -Wl,-z,stack-size=1048576")
set(SHADESCOPE_COMPILER_ROUNDS_PAIRS ON CACHE BOOL "Nothing runs here that would tell; GCC alone does not")
