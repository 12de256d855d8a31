#pragma once
// Before Highway's headers: for which processors kernels are compiled. What lies below SSE4 takes the compiler's own
// way, and what AVX3_DL adds to AVX-512 no kernel uses. Structs hold vectors in them, which those of no
// fixed width forbid. Under the address sanitizer a compiler takes a quarter of an hour for the widest of the shading
// kernels: there vectors of one number and of eight are watched, and the tests hold the others to their bits.
#if defined(__SANITIZE_ADDRESS__) && defined(__x86_64__)
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#endif
