#include "pipeline/core/quad.h"

#if LDBL_MANT_DIG != 113
// libquadmath's, which comes with GCC; its header does not come with other compilers.
extern "C" {
pipeline::Binary128 fabsq(pipeline::Binary128) noexcept;
pipeline::Binary128 sqrtq(pipeline::Binary128) noexcept;
pipeline::Binary128 acosq(pipeline::Binary128) noexcept;
pipeline::Binary128 exp2q(pipeline::Binary128) noexcept;
pipeline::Binary128 log2q(pipeline::Binary128) noexcept;
pipeline::Binary128 expq(pipeline::Binary128) noexcept;
pipeline::Binary128 log1pq(pipeline::Binary128) noexcept;
pipeline::Binary128 powq(pipeline::Binary128, pipeline::Binary128) noexcept;
pipeline::Binary128 atan2q(pipeline::Binary128, pipeline::Binary128) noexcept;
pipeline::Binary128 floorq(pipeline::Binary128) noexcept;
pipeline::Binary128 roundq(pipeline::Binary128) noexcept;
pipeline::Binary128 frexpq(pipeline::Binary128, int*) noexcept;
pipeline::Binary128 ldexpq(pipeline::Binary128, int) noexcept;
int finiteq(pipeline::Binary128) noexcept;
}
#endif

namespace pipeline {

#if LDBL_MANT_DIG == 113
Quad abs(Quad x) { return std::abs(x.value); }
Quad sqrt(Quad x) { return std::sqrt(x.value); }
Quad acos(Quad x) { return std::acos(x.value); }
Quad exp(Quad x) { return std::exp(x.value); }
Quad exp2(Quad x) { return std::exp2(x.value); }
Quad log2(Quad x) { return std::log2(x.value); }
Quad log1p(Quad x) { return std::log1p(x.value); }
Quad pow(Quad x, Quad y) { return std::pow(x.value, y.value); }
Quad atan2(Quad y, Quad x) { return std::atan2(y.value, x.value); }
Quad floor(Quad x) { return std::floor(x.value); }
Quad round(Quad x) { return std::round(x.value); }
Quad frexp(Quad x, int* exponent) { return std::frexp(x.value, exponent); }
Quad ldexp(Quad x, int exponent) { return std::ldexp(x.value, exponent); }
bool isfinite(Quad x) { return std::isfinite(x.value); }
#else
Quad abs(Quad x) { return Quad::of(fabsq(x.value)); }
Quad sqrt(Quad x) { return Quad::of(sqrtq(x.value)); }
Quad acos(Quad x) { return Quad::of(acosq(x.value)); }
Quad exp(Quad x) { return Quad::of(expq(x.value)); }
Quad exp2(Quad x) { return Quad::of(exp2q(x.value)); }
Quad log2(Quad x) { return Quad::of(log2q(x.value)); }
Quad log1p(Quad x) { return Quad::of(log1pq(x.value)); }
Quad pow(Quad x, Quad y) { return Quad::of(powq(x.value, y.value)); }
Quad atan2(Quad y, Quad x) { return Quad::of(atan2q(y.value, x.value)); }
Quad floor(Quad x) { return Quad::of(floorq(x.value)); }
Quad round(Quad x) { return Quad::of(roundq(x.value)); }
Quad frexp(Quad x, int* exponent) { return Quad::of(frexpq(x.value, exponent)); }
Quad ldexp(Quad x, int exponent) { return Quad::of(ldexpq(x.value, exponent)); }
bool isfinite(Quad x) { return finiteq(x.value) != 0; }
#endif

}  // namespace pipeline
