#pragma once
// Before Highway's headers: for which processors kernels are compiled. Structs hold vectors in them, which those of no
// fixed width forbid.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
