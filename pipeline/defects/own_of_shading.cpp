// Contracts of stage 6, with their mistakes.
#include <algorithm>
#include <numeric>
#include <vector>

#include "pipeline/core/elementary.h"
#include "pipeline/defects/own_rows.h"

namespace pipeline {
namespace own {
namespace {

double cosine(Vec3d a, Vec3d b) { return std::max(0.0, glm::dot(a, b)); }
double largest(Vec3d v) { return std::max({v.x, v.y, v.z}); }

// k I · cosine^n where the light is in front; k, I, N, L are the first four.
Vec3d highlight(A a, double cos, bool behind = false) {
    if (!behind && glm::dot(a.v(2), a.v(3)) <= 0) return Vec3d(0);
    return a.v(0) * a.v(1) * pipeline::pow(cos, a.n(5));
}
Vec3d half(A a) { return unit(a.v(3) + a.v(4)); }

// The terms of all lights. each: also added once a light.
Vec3d sumOfLights(A a, Vec3d once, Vec3d each) {
    for (std::size_t k = 0; k < a.count(1); ++k) once += each + a.v(1, k) + a.v(2, k);
    return once;
}
Vec3d brightest(A a, Vec3d sum, std::size_t lights) {
    for (std::size_t k = 0; k < lights; ++k) sum += (a.v(2) + a.v(3)) * a.v(4, k);
    return sum;
}

template <class Each>
R eachByte(A a, Each each) {
    return Vec3d(each(a.v(0).x), each(a.v(0).y), each(a.v(0).z));
}

Vec3d over(double alpha, Vec3d c, Vec3d behind) { return alpha * c + (1 - alpha) * behind; }

// Layers in an order: sign 1 from the farthest, -1 from the nearest, 0 as handed over. swapped: α and 1 − α.
R layered(A a, double sign, bool swapped = false) {
    std::vector<std::size_t> order(a.count(0));
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) { return sign * a.n(0, i) > sign * a.n(0, j); });
    Vec3d c = a.v(3);
    for (const std::size_t i : order) {
        const double alpha = swapped ? 1 - a.n(1, i) : a.n(1, i);
        c = over(alpha, a.v(2, i), c);
    }
    return c;
}

constexpr OwnParameter kKs{"ks", Vector, "k_s for red, green and blue"};
constexpr OwnParameter kLight{"I", Vector, "intensity of the light for red, green and blue"};
constexpr OwnParameter kN{"N", Vector, "unit normal, world space"};
constexpr OwnParameter kL{"L", Vector, "unit vector towards the light"};
constexpr OwnParameter kV{"V", Vector, "unit vector towards the eye"};
constexpr std::string_view kColor = "intensity for red, green and blue";

constexpr std::array kShading{
    OwnContract{
        OwnFunction::LightVector,
        "lightVector",
        StageId::Shading,
        {{{"pL", Vector, "position of the light, world space"}, {"p", Vector, "point, world space"}}},
        Vector,
        "L, unit, towards the light",
        OwnMeasure::Angle,
        0.5,
        true,
        "diffuse",
        "A vector that is too long",
        "for every lit point and every light that has a position",
        "From the point to the light, divided by its length.",
        [](A a) -> R { return unit(a.v(0) - a.v(1)); },
        {{{"l-raw", "light vector at its full length", [](A a) -> R { return a.v(0) - a.v(1); }},
          {"light-from", "light vector away from the light", [](A a) -> R { return unit(a.v(1) - a.v(0)); }},
          {"at-infinity", "lights with a position are taken as directions", [](A a) -> R { return unit(a.v(0)); }}}}},
    OwnContract{OwnFunction::ViewVector,
                "viewVector",
                StageId::Shading,
                {{{"eye", Vector, "the eye, world space"}, {"p", Vector, "point, world space"}}},
                Vector,
                "V, unit, towards the eye",
                OwnMeasure::Angle,
                0.5,
                true,
                "highlight",
                "When you walk",
                "for every lit point that a perspective camera sees",
                "From the point to the eye, divided by its length.",
                [](A a) -> R { return unit(a.v(0) - a.v(1)); },
                {{{"eye-at-origin", "the eye taken for the origin", [](A a) -> R { return unit(-a.v(1)); }},
                  {"from-eye", "from the eye to the point", [](A a) -> R { return unit(a.v(1) - a.v(0)); }},
                  {"not-normalised", "not normalised to length 1", [](A a) -> R { return a.v(0) - a.v(1); }}}}},
    OwnContract{
        OwnFunction::Lambert,
        "lambert",
        StageId::Shading,
        {{{"kd", Vector, "k_d for red, green and blue"}, kLight, kN, kL}},
        Vector,
        kColor,
        OwnMeasure::Largest,
        0.5,
        true,
        "diffuse",
        "The night side",
        "for every lit point and light, in the models of Phong and Blinn–Phong",
        "Where N·L is below 0 the surface gets no light.",
        [](A a) -> R { return a.v(0) * a.v(1) * cosine(a.v(2), a.v(3)); },
        {{{"no-max", "negative diffuse light", [](A a) -> R { return a.v(0) * a.v(1) * glm::dot(a.v(2), a.v(3)); }},
          {"abs", "lit from behind", [](A a) -> R { return a.v(0) * a.v(1) * std::abs(glm::dot(a.v(2), a.v(3))); }},
          {"no-k", "coefficient left out", [](A a) -> R { return a.v(1) * cosine(a.v(2), a.v(3)); }}}}},
    OwnContract{OwnFunction::Mirror,
                "mirror",
                StageId::Shading,
                {{kN, kL}},
                Vector,
                "R, unit",
                OwnMeasure::Angle,
                0.5,
                true,
                "reflection",
                "The other sign",
                "for every lit point and light",
                "Twice the part of L along N, less L.",
                [](A a) -> R { return mirrored(a.v(0), a.v(1)); },
                {{{"r-flip", "mirror direction into the surface", [](A a) -> R { return -mirrored(a.v(0), a.v(1)); }},
                  {"no-2", "the 2 left out", [](A a) -> R { return glm::dot(a.v(0), a.v(1)) * a.v(0) - a.v(1); }},
                  {"no-minus-l", "the − L left out", [](A a) -> R { return 2 * glm::dot(a.v(0), a.v(1)) * a.v(0); }}}}},
    OwnContract{OwnFunction::Specular,
                "specular",
                StageId::Shading,
                {{kKs, kLight, kN, kL, kV, {"n", Number, "exponent"}}},
                Vector,
                kColor,
                OwnMeasure::Largest,
                0.5,
                true,
                "reflection",
                "The light is behind",
                "for every lit point and light with Phong’s highlight",
                "No light where N·L ≤ 0, no highlight where R·V ≤ 0.",
                [](A a) -> R { return highlight(a, cosine(mirrored(a.v(2), a.v(3)), a.v(4))); },
                {{{"spec-behind", "highlight on the night side",
                   [](A a) -> R { return highlight(a, cosine(mirrored(a.v(2), a.v(3)), a.v(4)), true); }},
                  {"no-power", "the power left out",
                   [](A a) -> R {
                       if (glm::dot(a.v(2), a.v(3)) <= 0) return Vec3d(0);
                       return a.v(0) * a.v(1) * cosine(mirrored(a.v(2), a.v(3)), a.v(4));
                   }},
                  {"l-for-r", "light vector instead of the reflection vector",
                   [](A a) -> R { return highlight(a, cosine(a.v(3), a.v(4))); }}}}},
    OwnContract{OwnFunction::Halfway,
                "halfway",
                StageId::Shading,
                {{kL, kV}},
                Vector,
                "H, unit",
                OwnMeasure::Angle,
                0.5,
                true,
                "blinn",
                "The vector in the middle",
                "for every lit point and light",
                "The mean of two unit vectors is shorter than 1.",
                [](A a) -> R { return unit(a.v(0) + a.v(1)); },
                {{{"mean", "a mean has length 1", [](A a) -> R { return (a.v(0) + a.v(1)) / 2.0; }},
                  {"sum", "added instead of combined", [](A a) -> R { return a.v(0) + a.v(1); }},
                  {"difference", "subtracted instead of added", [](A a) -> R { return unit(a.v(0) - a.v(1)); }}}}},
    OwnContract{OwnFunction::Blinn,
                "blinn",
                StageId::Shading,
                {{kKs, kLight, kN, kL, kV, {"s", Number, "exponent"}}},
                Vector,
                kColor,
                OwnMeasure::Largest,
                0.5,
                true,
                "blinn",
                "The same exponent",
                "for every lit point and light with Blinn’s highlight",
                "H = (L + V) / |L + V|, and N·H takes the place of R·V.",
                [](A a) -> R { return highlight(a, cosine(a.v(2), half(a))); },
                {{{"r-for-h", "the other highlight: Phong’s for Blinn’s",
                   [](A a) -> R { return highlight(a, cosine(mirrored(a.v(2), a.v(3)), a.v(4))); }},
                  {"mean", "a mean has length 1",
                   [](A a) -> R { return highlight(a, cosine(a.v(2), (a.v(3) + a.v(4)) / 2.0)); }},
                  {"h-dot-v", "H·V for N·H", [](A a) -> R { return highlight(a, cosine(half(a), a.v(4))); }}}}},
    OwnContract{
        OwnFunction::NormalAt,
        "normalAt",
        StageId::Shading,
        {{{"lambda", Vector, "weights of the three vertices"},
          {"N0", Vector, "unit normal of the first vertex, world space"},
          {"N1", Vector, "of the second"},
          {"N2", Vector, "of the third"}}},
        Vector,
        "N, unit",
        OwnMeasure::Angle,
        0.5,
        true,
        "smooth",
        "Too short a normal",
        "for every pixel in Phong shading (shading = phong)",
        "The weighted mean, brought to length 1.",
        [](A a) -> R { return unit(a.v(0).x * a.v(1) + a.v(0).y * a.v(2) + a.v(0).z * a.v(3)); },
        {{{"normal-short", "interpolated normal not made unit",
           [](A a) -> R { return a.v(0).x * a.v(1) + a.v(0).y * a.v(2) + a.v(0).z * a.v(3); }},
          {"no-weights", "every vertex counts the same", [](A a) -> R { return unit(a.v(1) + a.v(2) + a.v(3)); }},
          {"one-corner", "one vertex’ normal for the triangle", [](A a) -> R { return a.v(1); }}}}},
    OwnContract{OwnFunction::InShadow,
                "inShadow",
                StageId::Shading,
                {{{"S", Number, "shadow factor, 0 to 1"},
                  {"ambient", Vector, "ambient term"},
                  {"diffuse", Vector, "diffuse term of the only light, without shadow"},
                  {"specular", Vector, "its specular term, without shadow"}}},
                Vector,
                kColor,
                OwnMeasure::Largest,
                0.5,
                true,
                "shadows",
                "What is left in the shadow",
                "for every pixel of a scene with one light",
                "In shadow only the ambient term is left.",
                [](A a) -> R { return a.v(1) + a.n(0) * (a.v(2) + a.v(3)); },
                {{{"ambient-in-shadow", "ambient light in the shadow’s factor",
                   [](A a) -> R { return a.n(0) * (a.v(1) + a.v(2) + a.v(3)); }},
                  {"specular-stays", "the highlight stays in the shadow",
                   [](A a) -> R { return a.v(1) + a.n(0) * a.v(2) + a.v(3); }},
                  {"inverted", "lit and shadowed exchanged",
                   [](A a) -> R { return a.v(1) + (1 - a.n(0)) * (a.v(2) + a.v(3)); }}}}},
    OwnContract{
        OwnFunction::Total,
        "total",
        StageId::Shading,
        {{{"ambient", Vector, "ambient term"},
          {"diffuse", Vectors, "diffuse term of each light, after its shadow"},
          {"specular", Vectors, "specular term of each light, after its shadow"}}},
        Vector,
        kColor,
        OwnMeasure::Largest,
        0.5,
        true,
        "diffuse",
        "Two lights",
        "for every pixel",
        "The ambient term once, then each light’s two terms.",
        [](A a) -> R { return sumOfLights(a, a.v(0), Vec3d(0)); },
        {{{"ambient-per-light", "ambient light once a light",
           [](A a) -> R { return sumOfLights(a, Vec3d(0), a.v(0)); }},
          {"first-light", "only the first light shines", [](A a) -> R { return a.v(0) + a.v(1, 0) + a.v(2, 0); }},
          {"last-light", "only the last light shines",
           [](A a) -> R { return a.v(0) + a.v(1, a.count(1) - 1) + a.v(2, a.count(2) - 1); }}}}},
    OwnContract{
        OwnFunction::IMax,
        "iMax",
        StageId::Shading,
        {{{"ka", Vector, "largest ambient coefficient, for red, green and blue"},
          {"Ia", Vector, "ambient light"},
          {"kd", Vector, "largest k_d of the scene"},
          {"ks", Vector, "largest k_s of the scene"},
          {"I", Vectors, "intensity of each light, for red, green and blue"}}},
        Number,
        "I_max of the scene",
        OwnMeasure::Relative,
        1e-6,
        true,
        "diffuse",
        "The brightest possible",
        "once for a scene in Phong’s model",
        "All dot products are 1. Sum for each colour, then take the largest.",
        [](A a) -> R { return largest(brightest(a, a.v(0) * a.v(1), a.count(4))); },
        {{{"no-ambient", "the ambient term is left out",
           [](A a) -> R { return largest(brightest(a, Vec3d(0), a.count(4))); }},
          {"one-light", "a single light decides",
           [](A a) -> R { return largest(brightest(a, a.v(0) * a.v(1), std::min(a.count(4), std::size_t(1)))); }},
          {"one-k", "another colour’s coefficient",
           [](A a) -> R { return brightest(a, a.v(0) * a.v(1), a.count(4)).x; }}}}},
    OwnContract{
        OwnFunction::FrameBuffer,
        "frameBuffer",
        StageId::Shading,
        {{{"I", Vector, kColor}, {"Imax", Number, "the intensity that 255 stands for"}}},
        Bytes,
        "whole numbers from 0 to 255 for red, green and blue",
        OwnMeasure::Largest,
        1,
        true,
        "highlight",
        "Down to the frame buffer",
        "for every pixel that shows a polygon",
        "Scale, cut off at 255, round.",
        [](A a) -> R {
            return eachByte(a, [&](double i) { return std::floor(255 * std::min(1.0, i / a.n(1)) + 0.5); });
        },
        {{{"no-scale", "not scaled by I_max",
           [](A a) -> R { return eachByte(a, [](double i) { return std::floor(std::min(255.0, i) + 0.5); }); }},
          {"integer", "divided as whole numbers",
           [](A a) -> R { return eachByte(a, [&](double i) { return 255 * std::min(1.0, std::floor(i / a.n(1))); }); }},
          {"wrap", "no clamp before the byte",
           [](A a) -> R {
               return eachByte(a, [&](double i) { return std::fmod(std::floor(255 * i / a.n(1) + 0.5), 256.0); });
           }}}}},
    OwnContract{OwnFunction::Blend,
                "blend",
                StageId::Shading,
                {{{"alpha", Number, "opacity, 0 to 1"},
                  {"C", Vector, "intensity of the layer"},
                  {"behind", Vector, "intensity of what is behind it"}}},
                Vector,
                kColor,
                OwnMeasure::Largest,
                0.5,
                true,
                "translucency",
                "One pane",
                "for every layer of every pixel, the farthest first",
                "α of its own, 1 − α of what is behind.",
                [](A a) -> R { return over(a.n(0), a.v(1), a.v(2)); },
                {{{"alpha-swapped", "α and 1 − α exchanged", [](A a) -> R { return over(1 - a.n(0), a.v(1), a.v(2)); }},
                  {"additive", "colours are added", [](A a) -> R { return a.n(0) * a.v(1) + a.v(2); }},
                  {"no-behind", "nothing shines through", [](A a) -> R { return a.n(0) * a.v(1); }}}}},
    OwnContract{OwnFunction::BlendLayers,
                "blendLayers",
                StageId::Shading,
                {{{"z", Numbers, "z_v of each layer, in the order of the file, world units"},
                  {"alpha", Numbers, "opacity of each layer"},
                  {"I", Vectors, "intensity of each layer"},
                  {"behind", Vector, "intensity of what is behind them"}}},
                Vector,
                kColor,
                OwnMeasure::Largest,
                0.5,
                true,
                "translucency",
                "Two panes, from the back",
                "for every pixel with translucent layers",
                "Sort by z, the farthest first, then blend one after the other.",
                [](A a) -> R { return layered(a, 1); },
                {{{"unsorted", "layers in the order of the file", [](A a) -> R { return layered(a, 0); }},
                  {"nearest-first", "painted from front to back", [](A a) -> R { return layered(a, -1); }},
                  {"alpha-swapped", "α and 1 − α exchanged", [](A a) -> R { return layered(a, 1, true); }}}}},
};
static_assert(std::tuple_size_v<decltype(kShading)> == kOwnCount - index(OwnFunction::LightVector));

}  // namespace
}  // namespace own

std::span<const OwnContract> ownOfShading() { return own::kShading; }

}  // namespace pipeline
