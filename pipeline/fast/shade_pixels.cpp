#include "pipeline/fast/shade_pixels.h"

#include <algorithm>
#include <array>

#include "pipeline/fast/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fast/shade_pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/fast/power.h"
#include "pipeline/fast/surfaces.h"
#include "pipeline/stages/shading_terms.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

// What the pixels of a tile have in common.
struct Common {
    const ShadingInputs& inputs;
    const ShadingSources<float>& in;
    const ShadingOutput<float>& out;  // of its polygons or vertices, which have been shaded
    // Of a pixel by its triangle's corners, as depths are compared with; else on the ray through the pixel.
    bool position = false;
    float toByte = 0;  // 255 / I_max
};

// What a light makes of a material.
struct Reflected {
    Vec3<float> diffuse, specular;
};
// Of the object that pixels belong to; mostly the one of the pixels before.
struct Look {
    std::size_t object = ~std::size_t(0);
    const Material* material = nullptr;
    Vec3<float> base{0};
    std::vector<Reflected> lights;
    bool halfway = false;
    float exponent = 0;

    void become(const ShadingInputs& inputs, std::size_t next) {
        if (object == next) return;
        object = next;
        material = &inputs.materials[next];
        base = sumOf(baseTerms<float>(inputs, *material));
        halfway = usesHalfway(inputs.illumination.model, *material);
        exponent = float((halfway ? inputs.illumination.exponentFactor : 1.0) * material->exponent);
        lights.clear();
        for (const Light& light : inputs.lights) {
            const Vec3<float> shining(light.intensity * light.color);
            lights.push_back({shining * Vec3<float>(material->diffuse), shining * Vec3<float>(material->specular)});
        }
    }
};

struct Surfaces {
    Floats3 position, N, V;
    Floats3 weights;  // over the corners of the triangle
    Ints polygon, vertices[3];
};

// How many of the texels that filtering looks at see the points lit: litTexels, of a light at infinity.
HWY_INLINE Floats litShare(const LightView<float>& light, const ShadowSettings& settings, Floats3 position,
                           Floats3 normal, Mask wanted) {
    const View& face = light.faces[0];
    const Buffer2D<float>& depth = light.depth[0];
    const Floats3 right = all(Vec3<float>(face.right)), up = all(Vec3<float>(face.up)),
                  forward = all(Vec3<float>(face.forward));
    const Floats3 p = position - all(Vec3<float>(face.eye));
    const Floats x = hn::Floor(hn::MulAdd(all(float(face.scale.x)), dot(right, p), all(float(face.centre.x))));
    const Floats y = hn::Floor(hn::NegMulAdd(all(float(face.scale.y)), dot(up, p), all(float(face.centre.y))));
    const Floats z = dot(forward, p);
    Floats bias = all(float(settings.biasValue));
    if (settings.bias != ShadowBias::Constant) {
        const float texels = float(settings.filter) + 0.5F + 1.0F / 128;
        const Floats across = hn::MulAdd(hn::Abs(dot(right, normal)), all(float(1 / face.scale.x)),
                                         hn::Mul(hn::Abs(dot(up, normal)), all(float(1 / face.scale.y))));
        const Floats slope = hn::Div(hn::Mul(all(texels), across), hn::Abs(dot(forward, normal)));
        bias = settings.bias == ShadowBias::Slope ? hn::Mul(bias, slope) : hn::Add(slope, all(light.rounding));
    }
    const int r = settings.filter;
    const Floats zero = all(0), last = all(float(depth.size.x - 1));
    Floats lit = zero;
    for (int dy = -r; dy <= r; ++dy) {
        for (int dx = -r; dx <= r; ++dx) {
            const Floats u = hn::Add(x, all(float(dx))), v = hn::Add(y, all(float(dy)));
            const Mask inside = hn::And(hn::And(hn::Ge(u, zero), hn::Le(u, last)),
                                        hn::And(hn::And(hn::Ge(v, zero), hn::Le(v, last)), wanted));
            const Ints column = hn::ConvertTo(I(), hn::IfThenElseZero(inside, u));
            const Ints row = hn::ConvertTo(I(), hn::IfThenElseZero(inside, v));
            const Ints at = hn::Add(hn::Mul(row, hn::Set(I(), depth.size.x)), column);
            const Floats stored = hn::GatherIndex(F(), depth.pixels.data(), at);
            const Mask shadowed = hn::And(inside, hn::Gt(z, hn::Add(stored, bias)));
            lit = hn::Add(lit, hn::IfThenZeroElse(shadowed, all(1)));
        }
    }
    return lit;
}

// S of light k; 1 where it is not asked for. shadowAt says what it is.
HWY_INLINE Floats shadows(const Common& scene, std::size_t k, const Surfaces& at, Floats3 L, Mask wanted) {
    const Light& light = scene.inputs.lights[k];
    const bool none = !light.castsShadow || scene.inputs.illumination.model == Model::OpenGl;
    if (none || hn::AllFalse(F(), wanted)) return all(1);
    if (light.kind == LightKind::AtInfinity) {
        const Floats3 normal = gather(scene.in.normals.polygon, at.polygon);
        const Mask faces = hn::Gt(dot(normal, L), all(0));
        const bool looksUp = scene.in.shadow && !scene.in.shadow->lights[k].empty();
        Floats share = all(1);
        if (looksUp)
            share = hn::Mul(litShare(scene.in.shadow->lights[k][0], scene.inputs.shadow, at.position, normal,
                                     hn::And(wanted, faces)),
                            all(1 / float(filteredTexels(scene.inputs.shadow))));
        return hn::IfThenElse(wanted, hn::IfThenElseZero(faces, share), all(1));
    }
    // Six buffers, of an area light for each sample: one pixel after the other.
    HWY_ALIGN float factor[16], x[16], y[16], z[16];
    HWY_ALIGN std::int32_t polygon[16];
    hn::Store(hn::IfThenElseZero(wanted, all(1)), F(), factor);
    hn::Store(at.position.x, F(), x), hn::Store(at.position.y, F(), y), hn::Store(at.position.z, F(), z);
    hn::Store(at.polygon, I(), polygon);
    for (std::size_t i = 0; i < hn::Lanes(F()); ++i)
        factor[i] = factor[i] == 0
                        ? 1
                        : shadowAt(scene.inputs, scene.in, k, std::uint32_t(polygon[i]), Vec3<float>(x[i], y[i], z[i]));
    return hn::Load(F(), factor);
}

HWY_INLINE long long countOf(Mask mask) { return static_cast<long long>(hn::CountTrue(F(), mask)); }

// The intensity of the pixels in `mask`, all of one object.
HWY_INLINE Floats3 illuminate(const Common& scene, const Look& look, const Surfaces& at, Mask mask,
                              ShadingCounts& counts) {
    const ShadingInputs& inputs = scene.inputs;
    const LightDetail& detail = inputs.illumination.detail;
    const bool shines = look.material->specular != Vec3d(0);
    Floats3 intensity = all(look.base);
    for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
        if (!inputs.parts.lights[k]) continue;
        const Light& light = inputs.lights[k];
        const Floats3 L = light.kind == LightKind::AtInfinity ? all(normalized(Vec3<float>(light.position)))
                                                              : unit(all(Vec3<float>(light.position)) - at.position);
        const Floats nDotL = dot(at.N, L);
        const Mask lit = hn::And(mask, hn::Gt(nDotL, all(0)));
        counts.evaluations += countOf(mask);
        Floats power = all(0);
        if (shines || detail.dull) {
            const Floats3 a = look.halfway ? at.N : scaled(at.N, hn::Add(nDotL, nDotL)) - L;
            const Floats3 b = look.halfway ? unit(L + at.V) : at.V;
            const Mask towards = hn::And(lit, hn::Gt(dot(a, b), all(0)));
            const Floats q = halfSquare(a, b), exponent = all(look.exponent);
            power = powerOfCosines(q, exponent, towards);
            const Mask vanished = hn::And(towards, hn::Gt(hn::Mul(exponent, q), all(105)));  // powerVanishes
            const long long vanishing = detail.vanishing ? 0 : countOf(vanished);
            counts.vanished += vanishing, counts.powers += countOf(towards) - vanishing;
        }
        const Reflected& reflected = look.lights[k];
        const Mask idle = hn::Not(lit);  // nothing to shadow there
        const Mask wanted = inputs.parts.idleLookups ? mask : hn::AndNot(idle, mask);
        const Floats S = shadows(scene, k, at, L, wanted);
        if (scene.in.shadow && !scene.in.shadow->lights[k].empty())
            counts.lookups += countOf(wanted), counts.idleLookups += countOf(mask) - countOf(wanted);
        const Floats diffuse = hn::IfThenElseZero(lit, hn::Mul(S, nDotL)),
                     specular = hn::IfThenElseZero(lit, hn::Mul(S, power));
        intensity = scaledPlus(all(reflected.diffuse), diffuse, intensity);
        intensity = scaledPlus(all(reflected.specular), specular, intensity);
    }
    return intensity;
}

// Two vectors of three numbers each, side by side in an array: the first of them, or the second.
template <class Pair>
HWY_INLINE Floats3 gatherOf(const std::vector<Pair>& values, Ints index, int which) {
    static_assert(sizeof(Pair) == 6 * sizeof(float));
    const auto* base = reinterpret_cast<const float*>(values.data()) + 3 * which;
    const Ints at = hn::Mul(index, hn::Set(I(), 6));
    const Ints one = hn::Set(I(), 1);
    return {hn::GatherIndex(F(), base, at), hn::GatherIndex(F(), base, hn::Add(at, one)),
            hn::GatherIndex(F(), base, hn::Add(at, hn::Add(one, one)))};
}

// Values of polygons, or those of vertices interpolated: the i-th of `each` values of every element.
template <class Pair>
HWY_INLINE Floats3 shadedBefore(const Common& scene, const std::vector<Pair>& values, const Surfaces& at,
                                std::size_t each, std::size_t i, int which) {
    const auto indexOf = [&](Ints element) HWY_ATTR {
        return hn::Add(hn::Mul(element, hn::Set(I(), std::int32_t(each))), hn::Set(I(), std::int32_t(i)));
    };
    if (scene.inputs.shading == Shading::Flat) return gatherOf(values, indexOf(at.polygon), which);
    const Floats3 sum = scaledPlus(gatherOf(values, indexOf(at.vertices[1]), which), at.weights.y,
                                   scaled(gatherOf(values, indexOf(at.vertices[0]), which), at.weights.x));
    return scaledPlus(gatherOf(values, indexOf(at.vertices[2]), which), at.weights.z, sum);
}

// The intensity in flat or Gouraud shading: what polygons or vertices have, and the shadows of the pixels.
HWY_INLINE Floats3 gathered(const Common& scene, const Surfaces& at, Mask mask, ShadingCounts& counts) {
    const ShadingInputs& inputs = scene.inputs;
    const auto& elements = inputs.shading == Shading::Flat ? scene.out.polygons : scene.out.vertices;
    const std::size_t lights = inputs.lights.size();
    Floats3 intensity =
        shadedBefore(scene, elements.base, at, 1, 0, 0) + shadedBefore(scene, elements.base, at, 1, 0, 1);
    for (std::size_t k = 0; k < lights; ++k) {
        if (!inputs.parts.lights[k]) continue;
        const Light& light = inputs.lights[k];
        const Floats3 diffuse = shadedBefore(scene, elements.terms, at, lights, k, 0);
        const Floats3 specular = shadedBefore(scene, elements.terms, at, lights, k, 1);
        const auto isZero = [&](Floats3 v) HWY_ATTR {
            return hn::And(hn::Eq(v.x, all(0)), hn::And(hn::Eq(v.y, all(0)), hn::Eq(v.z, all(0))));
        };
        const Mask idle = hn::And(isZero(diffuse), isZero(specular));
        const Mask wanted = inputs.parts.idleLookups ? mask : hn::AndNot(idle, mask);
        const Floats3 L =
            light.kind == LightKind::AtInfinity ? all(normalized(Vec3<float>(light.position))) : all(Vec3<float>(0));
        const Floats S = shadows(scene, k, at, L, wanted);
        if (scene.in.shadow && !scene.in.shadow->lights[k].empty())
            counts.lookups += countOf(wanted), counts.idleLookups += countOf(mask) - countOf(wanted);
        intensity = scaledPlus(specular, S, scaledPlus(diffuse, S, intensity));
    }
    return intensity;
}

// round(255 · clamp(I / I_max, 0, 1)); 0 where I is no number.
HWY_INLINE hn::Vec<hn::Rebind<std::uint8_t, F>> bytes(Floats intensity, float toByte) {
    const Floats value = hn::Mul(intensity, all(toByte));
    const Floats clamped = hn::IfThenElseZero(hn::Gt(value, all(0)), hn::Min(value, all(255)));
    return hn::DemoteTo(hn::Rebind<std::uint8_t, F>(), hn::ConvertTo(I(), hn::Add(clamped, all(0.5F))));
}

// Of the vector at `at` of a block, the block's first pixel being `first`.
HWY_INLINE Surfaces surfacesOf(const Common& scene, const SurfaceBlock& block, std::size_t at, glm::ivec2 first) {
    const ShadingSources<float>& in = scene.in;
    Surfaces out;
    out.polygon = hn::Load(I(), &block.polygon[at]);
    out.position = scene.position ? load(block.position, at) : all(Vec3<float>(0));
    if (scene.inputs.shading != Shading::Phong) {
        out.weights = load(block.weights, at);
        const auto ids = hn::Load(U(), &block.triangle[at]);
        const auto none = hn::Eq(ids, hn::Set(U(), kNoTriangle));
        const Ints triangle = hn::BitCast(I(), hn::IfThenZeroElse(none, ids));
        static_assert(sizeof(Triangle) == 16);
        const auto* words = reinterpret_cast<const std::int32_t*>(in.transform.topology->triangles.data());
        for (int i = 0; i < 3; ++i)
            out.vertices[i] = hn::GatherIndex(I(), words, hn::Add(hn::ShiftLeft<2>(triangle), hn::Set(I(), i)));
        return out;
    }
    out.N = unit(load(block.normal, at));
    const View& view = in.transform.view;
    if (!scene.position) {  // worldPoint, at the pixels' centres
        const Floats zView = hn::Load(F(), &block.zView[at]);
        const Floats spread = view.perspective ? zView : all(1);
        const Floats column = hn::ConvertTo(F(), columnOf(int(at))), row = hn::ConvertTo(F(), rowOf(int(at)));
        const float left = float(first.x + 0.5 - view.centre.x), top = float(view.centre.y - first.y - 0.5);
        const Floats x = hn::Mul(hn::Mul(hn::Add(column, all(left)), all(float(1 / view.scale.x))), spread);
        const Floats y = hn::Mul(hn::Mul(hn::Sub(all(top), row), all(float(1 / view.scale.y))), spread);
        out.position = scaledPlus(all(Vec3<float>(view.forward)), zView,
                                  scaledPlus(all(Vec3<float>(view.right)), x,
                                             scaledPlus(all(Vec3<float>(view.up)), y, all(Vec3<float>(view.eye)))));
    }
    out.V = view.perspective ? unit(all(Vec3<float>(view.eye)) - out.position) : all(-Vec3<float>(view.forward));
    return out;
}

HWY_INLINE void shadeVector(const Common& scene, const TileSurfaces& tile, std::size_t at, glm::ivec2 first, Look& look,
                            TileColors& out, ShadingCounts& counts) {
    const SurfaceBlock& block = tile[at / kBlockPixels];
    const std::size_t inBlock = at % kBlockPixels;
    const auto none = hn::Eq(hn::Load(U(), &block.triangle[inBlock]), hn::Set(U(), kNoTriangle));
    if (hn::AllTrue(U(), none)) return;
    const Mask hit = hn::RebindMask(F(), hn::Not(none));
    const Surfaces surfaces = surfacesOf(scene, block, inBlock, first);

    const Topology& topology = *scene.in.transform.topology;
    Floats3 intensity = all(Vec3<float>(0));
    Mask left = hit;
    if (scene.inputs.shading != Shading::Phong) {
        const Floats3 some = gathered(scene, surfaces, hit, counts);
        intensity = {hn::IfThenElseZero(hit, some.x), hn::IfThenElseZero(hit, some.y), hn::IfThenElseZero(hit, some.z)};
        left = hn::AndNot(hit, hit);
    }
    Ints objects = hn::Zero(I());
    if (topology.meshes.size() > 1)
        objects = hn::GatherIndex(I(), reinterpret_cast<const std::int32_t*>(topology.polygonObject.data()),
                                  surfaces.polygon);
    HWY_ALIGN std::int32_t object[16];
    hn::Store(objects, I(), object);
    while (!hn::AllFalse(F(), left)) {
        const std::int32_t next = object[hn::FindKnownFirstTrue(F(), left)];
        const Mask same = hn::And(left, hn::RebindMask(F(), hn::Eq(objects, hn::Set(I(), next))));
        look.become(scene.inputs, std::size_t(next));
        const Floats3 some = illuminate(scene, look, surfaces, same, counts);
        intensity = {hn::IfThenElse(same, some.x, intensity.x), hn::IfThenElse(same, some.y, intensity.y),
                     hn::IfThenElse(same, some.z, intensity.z)};
        left = hn::AndNot(same, left);
    }
    HWY_ALIGN float numbers[16];
    HWY_ALIGN std::uint8_t bytesOfColor[16];
    const Floats channels[3]{intensity.x, intensity.y, intensity.z};
    for (int c = 0; c < 3; ++c) {
        hn::Store(channels[c], F(), numbers);
        putInRows(numbers, at, out.intensity[c]);
        hn::Store(bytes(channels[c], scene.toByte), hn::Rebind<std::uint8_t, F>(), bytesOfColor);
        putInRows(bytesOfColor, at, out.color[c]);
    }
}

}  // namespace

ShadingCounts shadeTileInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                                 ShadingOutput<float>& out) {
    Common scene{inputs, in, out, false, 0};
    const auto usesPosition = [](const Light& light) {
        return light.castsShadow || light.kind != LightKind::AtInfinity;
    };
    scene.position = std::ranges::any_of(inputs.lights, usesPosition);
    scene.toByte = out.iMax > 0 ? float(255 / out.iMax) : 0;
    Look look;
    ShadingCounts counts;
    TileSurfaces surfaces;
    TileColors colors;
    findSurfaces(inputs, in, scene.position, tile, surfaces);
    for (std::size_t at = 0; at < kTilePixels; at += hn::Lanes(F()))
        shadeVector(scene, surfaces, at, tile.min + pixelOf(at / kBlockPixels * kBlockPixels), look, colors, counts);
    writePixels(colors.intensity, tile, out.vectors[index(BufferId::Intensity)][0]);
    writePixels(colors.color, tile, out.color);
    return counts;
}

int lanesHere() { return int(hn::Lanes(F())); }

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pipeline {

HWY_EXPORT(shadeTileInVectors);
HWY_EXPORT(lanesHere);

void leaveTileDark(Tile tile, ShadingOutput<float>& out) {
    for (int y = tile.min.y; y < tile.max.y; ++y) {
        const std::size_t at = out.color.offset({tile.min.x, y});
        std::fill_n(&out.color.pixels[at], tile.max.x - tile.min.x, Color8(0));
        std::fill_n(&out.vectors[index(BufferId::Intensity)][0].pixels[at], tile.max.x - tile.min.x, Vec3<float>(0));
    }
}

ShadingCounts shadePixelsFast(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                              ShadingOutput<float>& out) {
    return HWY_DYNAMIC_DISPATCH(shadeTileInVectors)(inputs, in, tile, out);
}

int fastLanes() { return HWY_DYNAMIC_DISPATCH(lanesHere)(); }

}  // namespace pipeline
#endif
