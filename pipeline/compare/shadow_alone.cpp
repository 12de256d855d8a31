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

// Per pixel what the lights that cast shadows add, all of it and in the reference.
struct LightAndShadow {
    Values lit, dark;  // colours
};
std::optional<LightAndShadow> colorsOf(const Reference& reference) {
    if (!reference.unshadowed || !reference.values.contains("intensity")) return {};
    const Scene& scene = reference.frame->scene();
    Values lit = reference.values.at("intensity"), dark = lit;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        if (!scene.lights[k].castsShadow) continue;
        for (const std::string term : {"diffuse.", "specular."}) {
            const std::string name = term + std::to_string(k);
            const auto whole = valuesIn(*reference.unshadowed, *findBuffer(name), reference.context.covered);
            const Values* const here = reference.values.find(name);
            if (!whole || !here) return {};
            for (std::size_t i = 0; i < lit.numbers.size(); ++i) {
                lit.numbers[i] += whole->numbers[i] - here->numbers[i];
                dark.numbers[i] -= here->numbers[i];
            }
        }
    }
    for (Values* const values : {&lit, &dark})
        for (std::size_t i = 0; i < values->count(); ++i) {
            double* const v = values->at(i);
            const Color8 color = frameBufferValue({v[0], v[1], v[2]}, reference.context.iMax);
            for (int c = 0; c < 3; ++c) v[c] = color[c];
        }
    return LightAndShadow{std::move(lit), std::move(dark)};
}

bool isClose(const Values& a, const Values& b, std::size_t i, double tolerance) {
    return differenceAt(Measure::Largest, a, b, i) <= tolerance;
}

}  // namespace

ShadowAlone shadowAlone(const Finding& color, const Values& theirs, const Reference& reference) {
    ShadowAlone out;
    const auto colors = colorsOf(reference);
    if (!colors || reference.shadowed.empty()) return out;
    const double tolerance = color.tolerance + 0.5;
    enum State : std::uint8_t { Neither, Lit, Dark };
    std::vector<State> state(theirs.count(), Neither);
    std::size_t wrong = 0, telling = 0, exact = 0, shouldBeLit = 0, darkThere = 0, litWhereDark = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
        const Class of = color.classes[i];
        const bool isWrong = of == Class::Wrong || of == Class::Missing || of == Class::Extra;
        wrong += isWrong;
        if (!reference.context.covered[i] || reference.shadowContrast[i] < kContrast) continue;
        state[i] = isClose(theirs, colors->lit, i, tolerance)    ? Lit
                   : isClose(theirs, colors->dark, i, tolerance) ? Dark
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
