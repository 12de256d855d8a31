#include <algorithm>
#include <cmath>

#include "pipeline/compare/hypotheses.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/stages/shading.h"

namespace pipeline::foreign {

namespace {

constexpr double kExact = 0.97;     // of the wrong pixels with contrast: in the colour of light or of shadow
constexpr double kOfAll = 0.8;      // of all wrong pixels: with contrast
constexpr double kContrast = 8;     // of 255, between light and shadow
constexpr double kDark = 0.98;      // of what is lit: dark, where no light arrives
constexpr double kStripes = 0.05;   // of neighbours within what is lit: one of them dark
constexpr double kMostlyLit = 0.9;  // of the wrong pixels: lit where it is dark

// The colours of a pixel where all light arrives, and where none of the lights that cast shadows does.
class LitAndDark {
public:
    explicit LitAndDark(const Reference& reference)
        : m_reference(reference), m_intensity(*reference.frame, "intensity") {
        const std::vector<Light>& lights = reference.frame->scene().lights;
        for (std::size_t k = 0; k < lights.size(); ++k)
            for (const std::string term : {"diffuse.", "specular."})
                if (lights[k].castsShadow) m_terms.emplace_back(*reference.frame, term + std::to_string(k));
    }
    bool areKnown() const {
        return !m_reference.unshadowedTerms.empty() && !m_intensity.empty() &&
               std::ranges::none_of(m_terms, &NumbersInPlace::empty);
    }
    Color8 dark(std::size_t pixel) const { return color(rest(pixel)); }
    Color8 lit(std::size_t pixel) const { return color(rest(pixel) + Vec3d(m_reference.unshadowedTerms[pixel])); }

private:
    Color8 color(const Vec3d& intensity) const { return frameBufferValue(intensity, m_reference.context.iMax); }
    Vec3d rest(std::size_t pixel) const {
        Vec3d sum = m_intensity.vector(pixel);
        for (const NumbersInPlace& term : m_terms) sum -= term.vector(pixel);
        return sum;
    }

    const Reference& m_reference;
    NumbersInPlace m_intensity;
    std::vector<NumbersInPlace> m_terms;
};

bool isClose(const Values& theirs, std::size_t pixel, Color8 color, double tolerance) {
    if (!theirs.there[pixel]) return false;
    for (int c = 0; c < 3; ++c)
        if (!(std::abs(theirs.at(pixel)[c] - color[c]) <= tolerance)) return false;
    return true;
}

}  // namespace

ShadowAlone shadowAlone(const Finding& color, const Values& theirs, const Reference& reference) {
    ShadowAlone out;
    const LitAndDark colors(reference);
    if (!colors.areKnown()) return out;
    const double tolerance = color.tolerance + 0.5;
    enum State : std::uint8_t { Neither, Lit, Dark };
    std::vector<State> state(theirs.count(), Neither);
    std::size_t wrong = 0, telling = 0, exact = 0, shouldBeLit = 0, darkThere = 0, litWhereDark = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
        const Class of = color.classes[i];
        const bool isWrong = of == Class::Wrong || of == Class::Missing || of == Class::Extra;
        wrong += isWrong;
        if (!reference.context.covered[i] || reference.shadowContrast[i] < kContrast) continue;
        state[i] = isClose(theirs, i, colors.lit(i), tolerance)    ? Lit
                   : isClose(theirs, i, colors.dark(i), tolerance) ? Dark
                                                                   : Neither;
        const bool isDark = reference.shadowed[i] != 0;
        shouldBeLit += !isDark, darkThere += !isDark && state[i] == Dark;
        if (!isWrong) continue;
        ++telling, exact += state[i] != Neither, litWhereDark += isDark && state[i] == Lit;
    }
    if (telling == 0 || double(exact) < kExact * double(telling) || double(telling) < kOfAll * double(wrong))
        return out;
    // Within what is lit: how often S changes from a pixel to the next.
    std::size_t pairs = 0, changes = 0;
    const std::size_t width = theirs.columns;
    for (std::size_t i = 0; i + 1 < state.size(); ++i) {
        if (i % width + 1 == width || state[i] == Neither || state[i + 1] == Neither) continue;
        if (reference.shadowed[i] || reference.shadowed[i + 1]) continue;
        ++pairs, changes += state[i] != state[i + 1];
    }
    out.explained = double(exact) / double(wrong);
    if (double(darkThere) >= kDark * double(shouldBeLit)) {
        out.kind = "no light arrives", out.ids = {"light-from", "normal-flip", "bias-sign"};
    } else if (double(changes) >= kStripes * double(pairs)) {
        out.kind = "stripes of shadow on what is lit", out.ids = {"no-bias"};
    } else if (double(litWhereDark) >= kMostlyLit * double(exact)) {
        out.kind = "light where there is shadow", out.ids = {"no-shadow", "big-bias"};
    } else {
        out.kind = "the shadow is elsewhere", out.ids = {"shadow-flip", "shadow-space", "affine"};
    }
    return out;
}

}  // namespace pipeline::foreign
