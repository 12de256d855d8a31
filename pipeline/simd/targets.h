#pragma once
// Before Highway's headers: the instruction sets for which kernels are compiled. Below SSE4 the compiler's default is
// used; no kernel uses what AVX3_DL adds to AVX-512. Structs contain vectors, so vectors without a fixed width are
// excluded. Under the address sanitizer the widest shading kernels take a quarter of an hour to compile. So it checks
// vectors of one and of eight numbers, and the tests compare the bits of the others with these.
#if defined(__SANITIZE_ADDRESS__) && defined(__x86_64__)
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#endif
