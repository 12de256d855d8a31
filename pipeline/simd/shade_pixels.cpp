#include "pipeline/simd/shade_pixels.h"

#include <algorithm>
#include <array>

#include "pipeline/simd/targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/shade_pixels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
//
#include "pipeline/simd/power.h"
#include "pipeline/simd/shadows.h"
#include "pipeline/simd/surfaces.h"
#include "pipeline/stages/shading_terms.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {
namespace {

// What the pixels of a tile have in common.
struct Common {
    const ShadingInputs& inputs;
    const ShadingSources<float>& in;
    ShadingOutput<float>& out;  // its polygons or vertices have been shaded
    glm::ivec2 origin;          // of the tile
    bool everyShadow = false;   // S also where nothing depends on it: somebody looks

    bool has(BufferId id) const { return !out.vectors[index(id)].empty() || !out.scalars[index(id)].empty(); }
};

// What a light makes of a material.
struct Reflected {
    Vec3<float> diffuse, specular;
};
// Of the object that pixels belong to; mostly the one of the pixels before.
struct Look {
    std::size_t object = ~std::size_t(0);
    const Material* material = nullptr;
    BaseTerms<float> base;
    std::vector<Reflected> lights;
    bool halfway = false;
    float exponent = 0;

    void become(const ShadingInputs& inputs, std::size_t next) {
        if (object == next) return;
        object = next;
        material = &inputs.materials[next];
        base = baseTerms<float>(inputs, *material);
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

// Pixels of one vector, and what of them goes into buffers that are there.
struct Pixels {
    const Common& scene;
    std::size_t at;  // the vector's place in the tile
    Mask mask;

    HWY_INLINE void put(BufferId id, Floats3 v, std::size_t k = 0) const {
        auto& buffers = scene.out.vectors[index(id)];
        if (!buffers.empty()) putPixels(v.x, v.y, v.z, F(), mask, at, scene.origin, buffers[k]);
    }
    HWY_INLINE void put(BufferId id, Floats v, std::size_t k = 0) const {
        auto& buffers = scene.out.scalars[index(id)];
        if (!buffers.empty()) putPixels(v, mask, at, scene.origin, buffers[k]);
    }
};

HWY_INLINE long long countOf(Mask mask) { return static_cast<long long>(hn::CountTrue(F(), mask)); }

HWY_INLINE Mask isZero(Floats3 v) {
    return hn::And(hn::Eq(v.x, all(0)), hn::And(hn::Eq(v.y, all(0)), hn::Eq(v.z, all(0))));
}
HWY_INLINE Floats3 where(Mask mask, Floats3 v) {
    return {hn::IfThenElseZero(mask, v.x), hn::IfThenElseZero(mask, v.y), hn::IfThenElseZero(mask, v.z)};
}

// The terms of light k in its shadow, added to the intensity.
template <class A>
HWY_INLINE void addLight(const Pixels& pixels, std::size_t k, const Surfaces& at, Floats3 diffuse, Floats3 specular,
                         Floats3& intensity, ShadingCounts& counts) {
    const Common& scene = pixels.scene;
    const Mask idle = hn::And(isZero(diffuse), isZero(specular));
    const bool everywhere = scene.inputs.parts.idleLookups || scene.everyShadow;
    const Mask wanted = everywhere ? pixels.mask : hn::AndNot(idle, pixels.mask);
    const Floats S = shadowFactors<A>(scene.inputs, scene.in, k, at.position, at.polygon, wanted);
    if (scene.in.shadow && !scene.in.shadow->lights[k].empty()) {
        const long long lookups = countOf(wanted);
        counts.lookups += lookups, counts.idleLookups += countOf(pixels.mask) - lookups;
    }
    diffuse = scaled(diffuse, S), specular = scaled(specular, S);
    intensity = intensity + diffuse + specular;
    pixels.put(BufferId::Shadow, S, k);
    pixels.put(BufferId::Diffuse, diffuse, k);
    pixels.put(BufferId::Specular, specular, k);
}

// The intensity in Phong shading, of pixels that are all of one object.
template <class A>
HWY_INLINE Floats3 illuminate(const Pixels& pixels, const Look& look, const Surfaces& at, ShadingCounts& counts) {
    const ShadingInputs& inputs = pixels.scene.inputs;
    const LightDetail& detail = inputs.illumination.detail;
    const bool powers = look.material->specular != Vec3d(0) || detail.dull;
    pixels.put(BufferId::Emission, all(look.base.emission));
    pixels.put(BufferId::Ambient, all(look.base.ambient));
    Floats3 intensity = all(sumOf(look.base));
    for (std::size_t k = 0; k < inputs.lights.size(); ++k) {
        if (!inputs.parts.lights[k]) continue;
        const Light& light = inputs.lights[k];
        const Vec3<float> place(light.position);
        const Floats3 L = light.kind == LightKind::AtInfinity ? all(normalized(place))
                                                              : A::unit(all(place) - at.position, pixels.mask);
        const Floats nDotL = A::dot(at.N, L);
        const Mask lit = hn::And(pixels.mask, hn::Gt(nDotL, all(0)));
        counts.evaluations += countOf(pixels.mask);
        pixels.put(BufferId::LightVector, L, k);
        pixels.put(BufferId::NDotL, nDotL, k);
        Floats3 R = all(Vec3<float>(0)), H = R;
        Floats rDotV = all(0), nDotH = rDotV;
        if (detail.reflection || (!look.halfway && powers)) {
            R = scaled(at.N, hn::Add(nDotL, nDotL)) - L;
            rDotV = A::dot(R, at.V);
            pixels.put(BufferId::ReflectionVector, R, k);
            pixels.put(BufferId::RDotV, rDotV, k);
        }
        if (detail.halfway || (look.halfway && powers)) {
            H = A::unit(L + at.V, pixels.mask);
            nDotH = A::dot(at.N, H);
            pixels.put(BufferId::HalfwayVector, H, k);
            pixels.put(BufferId::NDotH, nDotH, k);
        }
        Floats power = all(0);
        Mask towards = lit;
        if (powers) {
            towards = hn::And(lit, hn::Gt(look.halfway ? nDotH : rDotV, all(0)));
            const Floats q = look.halfway ? halfSquare<A>(at.N, H) : halfSquare<A>(R, at.V);
            const Floats exponent = all(look.exponent);
            power = powerOfCosines<A>(q, exponent, towards);
            const Mask vanished = hn::And(towards, hn::Gt(hn::Mul(exponent, q), all(kVanishing<float>)));
            const long long vanishing = detail.vanishing ? 0 : countOf(vanished);
            counts.vanished += vanishing, counts.powers += countOf(towards) - vanishing;
        }
        const Reflected& reflected = look.lights[k];
        // Never -0: what is left out is +0.
        const Floats3 specular = scaled(all(reflected.specular), power) + all(Vec3<float>(0));
        addLight<A>(pixels, k, at, where(lit, scaled(all(reflected.diffuse), nDotL)), where(towards, specular),
                    intensity, counts);
    }
    return intensity;
}

// Two vectors of three numbers each, side by side in an array: the first of them, or the second.
template <class Pair>
HWY_INLINE Floats3 gatherOf(const std::vector<Pair>& values, Ints index, int which) {
    static_assert(sizeof(Pair) == 6 * sizeof(float));
    const auto* base = reinterpret_cast<const float*>(values.data()) + std::ptrdiff_t(3) * which;
    const Ints at = hn::Mul(index, hn::Set(I(), 6));
    const Ints one = hn::Set(I(), 1);
    return {hn::GatherIndex(F(), base, at), hn::GatherIndex(F(), base, hn::Add(at, one)),
            hn::GatherIndex(F(), base, hn::Add(at, hn::Add(one, one)))};
}

// The intensity in flat or Gouraud shading: what polygons or vertices have, and the shadows of the pixels.
template <class A>
HWY_INLINE Floats3 gathered(const Pixels& pixels, const Surfaces& at, ShadingCounts& counts) {
    const ShadingInputs& inputs = pixels.scene.inputs;
    const bool flat = inputs.shading == Shading::Flat;
    const auto& elements = flat ? pixels.scene.out.polygons : pixels.scene.out.vertices;
    const std::size_t lights = inputs.lights.size();
    // Interpolated by differences, so that equal values stay what they are.
    const auto base = [&](int which) HWY_ATTR {
        if (flat) return gatherOf(elements.base, at.polygon, which);
        const Floats3 first = gatherOf(elements.base, at.vertices[0], which);
        const Floats3 second = gatherOf(elements.base, at.vertices[1], which) - first;
        const Floats3 third = gatherOf(elements.base, at.vertices[2], which) - first;
        return scaledPlus<A>(third, at.weights.z, scaledPlus<A>(second, at.weights.y, first));
    };
    const auto term = [&](std::size_t k, int which) HWY_ATTR {
        const auto of = [&](Ints element) HWY_ATTR {
            const Ints first = hn::Mul(element, hn::Set(I(), std::int32_t(lights)));
            return gatherOf(elements.terms, hn::Add(first, hn::Set(I(), std::int32_t(k))), which);
        };
        if (flat) return of(at.polygon);
        const Floats3 first = scaledPlus<A>(of(at.vertices[0]), at.weights.x, all(Vec3<float>(0)));
        return scaledPlus<A>(of(at.vertices[2]), at.weights.z, scaledPlus<A>(of(at.vertices[1]), at.weights.y, first));
    };
    const Floats3 emission = base(0), ambient = base(1);
    pixels.put(BufferId::Emission, emission);
    pixels.put(BufferId::Ambient, ambient);
    Floats3 intensity = all(Vec3<float>(0)) + emission + ambient;
    for (std::size_t k = 0; k < lights; ++k)
        if (inputs.parts.lights[k]) addLight<A>(pixels, k, at, term(k, 0), term(k, 1), intensity, counts);
    return intensity;
}

using Bytes = hn::Rebind<std::uint8_t, F>;

// frameBufferValue of one channel; its bits in exact arithmetic.
template <class A>
HWY_INLINE hn::Vec<Bytes> bytesOf(Floats intensity, double iMax) {
    if constexpr (!A::kExact) {
        const Floats value = hn::Mul(intensity, all(iMax > 0 ? float(255 / iMax) : 0));
        const Floats clamped = hn::IfThenElseZero(hn::Gt(value, all(0)), hn::Min(value, all(255)));
        return hn::DemoteTo(Bytes(), hn::ConvertTo(I(), hn::Add(clamped, all(0.5F))));
    }
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(Bytes(), frameBufferValue(Vec3d(double(hn::GetLane(intensity))), iMax).x);
#else
    const hn::Half<F> half;
    const hn::Rebind<double, hn::Half<F>> d;
    const auto rounded = [&](auto some) HWY_ATTR {
        const auto share = hn::Div(hn::PromoteTo(d, some), hn::Set(d, iMax));
        const auto value = hn::Add(hn::Mul(share, hn::Set(d, 255)), hn::Set(d, 0.5));
        const auto clamped = hn::IfThenElseZero(hn::Gt(share, hn::Zero(d)), hn::Min(value, hn::Set(d, 255.5)));
        return hn::DemoteTo(hn::Rebind<std::int32_t, decltype(d)>(), clamped);
    };
    if (!(iMax > 0)) return hn::Zero(Bytes());
    const auto low = rounded(hn::LowerHalf(half, intensity)), high = rounded(hn::UpperHalf(half, intensity));
    return hn::DemoteTo(Bytes(), hn::Combine(I(), high, low));
#endif
}

// Of the vector at `at` of a block.
template <class A>
HWY_INLINE Surfaces surfacesOf(const Common& scene, const SurfaceBlock& block, std::size_t at, Mask hit) {
    const ShadingInputs& inputs = scene.inputs;
    const ShadingSources<float>& in = scene.in;
    Surfaces out;
    out.polygon = hn::Load(I(), &block.polygon[at]);
    out.position = inputs.parts.position ? load(block.position, at) : all(Vec3<float>(0));
    if (inputs.shading != Shading::Phong) {
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
    out.N = A::unit(load(block.normal, at), hit);
    const View& view = in.transform.view;
    if (!inputs.parts.viewVector)
        out.V = all(Vec3<float>(0));
    else if (view.perspective)
        out.V = A::unit(all(Vec3<float>(view.eye)) - out.position, hit);
    else
        out.V = all(-Vec3<float>(view.forward));
    return out;
}

// A vector in Phong shading: object by object.
template <class A>
HWY_INLINE Floats3 shadeObjects(const Pixels& pixels, const Surfaces& surfaces, Look& look, ShadingCounts& counts) {
    const Topology& topology = *pixels.scene.in.transform.topology;
    Ints objects = hn::Zero(I());
    if (topology.meshes.size() > 1)
        objects = hn::GatherIndex(I(), reinterpret_cast<const std::int32_t*>(topology.polygonObject.data()),
                                  surfaces.polygon);
    HWY_ALIGN std::int32_t object[16];
    hn::Store(objects, I(), object);
    Floats3 intensity = all(Vec3<float>(0));
    Mask left = pixels.mask;
    while (!hn::AllFalse(F(), left)) {
        const std::int32_t next = object[hn::FindKnownFirstTrue(F(), left)];
        const Mask same = hn::And(left, hn::RebindMask(F(), hn::Eq(objects, hn::Set(I(), next))));
        look.become(pixels.scene.inputs, std::size_t(next));
        const Floats3 some = illuminate<A>({pixels.scene, pixels.at, same}, look, surfaces, counts);
        intensity = {hn::IfThenElse(same, some.x, intensity.x), hn::IfThenElse(same, some.y, intensity.y),
                     hn::IfThenElse(same, some.z, intensity.z)};
        left = hn::AndNot(same, left);
    }
    return intensity;
}

// In which pixels of a vector something is seen.
HWY_INLINE Mask seenIn(const TileSurfaces& tile, std::size_t at) {
    const auto ids = hn::Load(U(), &tile[at / kBlockPixels].triangle[at % kBlockPixels]);
    return hn::RebindMask(F(), hn::Ne(ids, hn::Set(U(), kNoTriangle)));
}

template <class A>
HWY_INLINE void shadeVector(const Common& scene, const TileSurfaces& tile, std::size_t at, Mask inTile, Look& look,
                            ShadingCounts& counts) {
    const SurfaceBlock& block = tile[at / kBlockPixels];
    const std::size_t inBlock = at % kBlockPixels;
    const Pixels pixels{scene, at, seenIn(tile, at)};
    Floats3 intensity = all(Vec3<float>(0));
    if (!hn::AllFalse(F(), pixels.mask)) {
        const Surfaces surfaces = surfacesOf<A>(scene, block, inBlock, pixels.mask);
        pixels.put(BufferId::Position, surfaces.position);
        if (scene.inputs.shading == Shading::Phong) {
            pixels.put(BufferId::Normal, surfaces.N);
            pixels.put(BufferId::ViewVector, surfaces.V);
            intensity = shadeObjects<A>(pixels, surfaces, look, counts);
        } else
            intensity = gathered<A>(pixels, surfaces, counts);
        intensity = where(pixels.mask, intensity);
    }
    const Pixels whole{scene, at, inTile};
    whole.put(BufferId::Intensity, intensity);
    const double iMax = scene.out.iMax;
    putPixels(bytesOf<A>(intensity.x, iMax), bytesOf<A>(intensity.y, iMax), bytesOf<A>(intensity.z, iMax), Bytes(),
              inTile, at, scene.origin, scene.out.color);
}

template <class A>
ShadingCounts shadeTile(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                        ShadingOutput<float>& out) {
    Common scene{inputs, in, out, tile.min};
    scene.everyShadow = scene.has(BufferId::Shadow);
    Look look;
    ShadingCounts counts;
    TileSurfaces surfaces;
    findSurfaces<A>(inputs, in, tile, surfaces);
    const glm::ivec2 size = tile.max - tile.min;
    for (std::size_t at = 0; at < kTilePixels; at += hn::Lanes(F())) {
        const glm::ivec2 block = pixelOf(at / kBlockPixels * kBlockPixels);
        const int inBlock = int(at % kBlockPixels);
        const auto inColumns = hn::Lt(columnOf(inBlock), hn::Set(I(), size.x - block.x));
        const auto inRows = hn::Lt(rowOf(inBlock), hn::Set(I(), size.y - block.y));
        const Mask inTile = asFloats(hn::And(inColumns, inRows));
        if (const std::size_t next = at + hn::Lanes(F()); next < kTilePixels && inputs.parts.position) {
            const Mask seen = seenIn(surfaces, next);
            const Floats3 position = load(surfaces[next / kBlockPixels].position, next % kBlockPixels);
            if (!hn::AllFalse(F(), seen)) fetchTexels<A>(inputs, in, position, seen);
        }
        if (!hn::AllFalse(F(), inTile)) shadeVector<A>(scene, surfaces, at, inTile, look, counts);
    }
    return counts;
}

}  // namespace

ShadingCounts shadeTileInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                                 ShadingOutput<float>& out) {
    return inputs.parts.fast ? shadeTile<Fast>(inputs, in, tile, out) : shadeTile<Exact>(inputs, in, tile, out);
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
        for (auto& intensity : out.vectors[index(BufferId::Intensity)])
            std::fill_n(&intensity.pixels[at], tile.max.x - tile.min.x, Vec3<float>(0));
    }
}

ShadingCounts shadePixelsInVectors(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
                                   ShadingOutput<float>& out) {
    return HWY_DYNAMIC_DISPATCH(shadeTileInVectors)(inputs, in, tile, out);
}

int vectorLanes() { return HWY_DYNAMIC_DISPATCH(lanesHere)(); }

}  // namespace pipeline
#endif
