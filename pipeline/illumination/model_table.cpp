#include "pipeline/illumination/model_table.h"

#include "pipeline/illumination/blinn_phong.h"
#include "pipeline/illumination/cook_torrance.h"
#include "pipeline/illumination/opengl.h"
#include "pipeline/illumination/phong.h"

namespace pipeline {
namespace {

// Phong's terms or Blinn's, as the material says.
template <class Real>
void addEither(const LitSurface<Real>& in, LightSample<Real>& s) {
    in.halfway ? addBlinnPhong(in, s) : addPhong(in, s);
}

constexpr LightTermsOf kEither{addEither<float>, addEither<double>, addEither<long double>, addEither<Quad>};

// In the order of the enumerators.
constexpr std::array<LightTermsOf, kModelCount> kTerms{{
    kEither,
    kEither,
    {addOpenGl<float>, addOpenGl<double>, addOpenGl<long double>, addOpenGl<Quad>},
    {addCookTorrance<float>, addCookTorrance<double>, addCookTorrance<long double>, addCookTorrance<Quad>},
}};

}  // namespace

const LightTermsOf* triedTerms = nullptr;

const LightTermsOf& lightTermsOf(Model model) {
    const auto i = static_cast<std::size_t>(model);
    return i < kModelCount ? kTerms[i] : *triedTerms;
}

}  // namespace pipeline
