// Included once for each instruction set, like lanes.h.
#if defined(SHADESCOPE_SURFACES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHADESCOPE_SURFACES_H
#undef SHADESCOPE_SURFACES_H
#else
#define SHADESCOPE_SURFACES_H
#endif

#include <hwy/cache_control.h>

#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "pipeline/simd/area_vectors.h"
#include "pipeline/simd/arithmetic.h"
#include "pipeline/simd/drawn_row.h"
#include "pipeline/simd/rows.h"
#include "pipeline/simd/seen.h"
#include "pipeline/simd/seen_blocks.h"
#include "pipeline/simd/shadow_bias.h"
#include "pipeline/stages/shading.h"
#include "pipeline/stages/vertex_weights.h"

HWY_BEFORE_NAMESPACE();
namespace pipeline::HWY_NAMESPACE {

// The visible surfaces of a row of blocks. Lanes that show nothing have arbitrary numbers.
struct SurfaceRow {
    std::uint32_t seen[kRowVectors];                // for each vector, the bit mask of the lanes that show something
    alignas(64) std::int32_t triangle[kRowPixels];  // in Gouraud shading
    alignas(64) std::int32_t polygon[kRowPixels];   // in flat shading
    alignas(64) std::int32_t object[kRowPixels];    // in Phong shading, if objects are told apart
    Row3 N;                                         // unit length, in Phong shading
    Row3 position;                                  // if it is needed
    Row3 weights;                                   // in Gouraud shading
    Row3 facing;                                    // the normal of the triangle's plane, if it is needed
    std::vector<Row> bias;                          // for each light whose bias is constant over triangles

    HWY_INLINE Mask seenAt(std::size_t i) const { return maskOf(seen[i / hn::Lanes(F())]); }
};

// An attribute of a triangle: its value at one vertex, and its differences to the other two.
struct Corners {
    Vec3<float> origin, toSecond, toThird;
    void become(Vec3<float> first, Vec3<float> second, Vec3<float> third) {
        origin = first, toSecond = second - first, toThird = third - first;
    }
    void become(std::span<const Vec3<float>> values, const std::uint32_t (&v)[3]) {
        become(values[v[0]], values[v[1]], values[v[2]]);
    }
    template <class A>
    HWY_INLINE Floats3 at(Floats second, Floats third) const {
        return scaledPlus<A>(all(toThird), third, scaledPlus<A>(all(toSecond), second, all(origin)));
    }
};

// A visible triangle of a tile, prepared for any vector of the tile.
struct SeenSurface {
    SeenTriangle triangle;
    std::uint32_t id;  // index into Topology::triangles
    std::int32_t polygon, object;
    Corners normals, positions;
    Vec3<float> facing;  // normal of its plane
    // Whether `normals` is linear in the picture: its value at firstPixel, and the steps to the right and down.
    bool isPlane;
    Vec2<float> firstPixel;
};

// Finds the visible surfaces of a tile, one row of blocks at a time. Fast arithmetic interpolates n/z of the vertices
// linearly in the picture, which has the direction of the normal. It does not do so if positions are needed.
template <class A>
class Surfaces {
public:
    // biases: of the lights whose bias is constant over triangles. facing: whether others need the planes' normals.
    // drawn: shows these triangles instead of the visible ones; null: the visible ones.
    Surfaces(const ShadingInputs& inputs, const ShadingSources<float>& in, Tile tile,
             std::span<const PolygonBias> biases, bool facing, const DrawnTile* drawn)
        : m_inputs(inputs),
          m_in(in),
          m_tile(tile),
          m_biases(biases),
          m_facing(facing),
          m_perPixel(inputs.shading == Shading::Phong),
          m_positioned(inputs.parts[Part::Position]),
          m_tellsObjects(m_perPixel && inputs.materials.size() > 1),
          m_mirrors(in.transform.anyMirrored()) {
        if (const SeenBlocks* seen = in.zBuffer.seen.get(); seen && !drawn) {
            m_index = tileAt(in.transform.view.size, tile);
            m_isDrawn = in.zBuffer.tileIsDrawn[m_index] != 0;
            m_drawnNames = numbersOf(seen->name.tile(m_index));
            const TransformOutput<float>& from = in.transform;
            m_seenIn.emplace(
                SeenIn{from.view, *from.topology, from.snapped, seen->pieces, tile, seen->z.tile(m_index)->of});
            m_isFine = in.zBuffer.seenPixels < 4 * static_cast<long long>(seen->triangles);
            m_findsPlanes = !A::kExact && !m_positioned;  // else the weights, which give the normals too
        }
        m_drawn.from = drawn;
        m_names.fill(kNoTriangle), m_bias.resize(kSlots * biases.size());
    }
    bool tellsObjects() const { return m_tellsObjects; }

    void find(int row, SurfaceRow& out) {
        out.bias.resize(m_biases.size());
        if (!m_isDrawn) {  // its blocks were not written
            std::ranges::fill(out.seen, 0);
            return;
        }
        const std::size_t begin = std::size_t(row) * kRowPixels;
        if (m_perPixel)
            m_positioned ? findRow<true, true>(begin, out) : findRow<true, false>(begin, out);
        else
            m_positioned ? findRow<false, true>(begin, out) : findRow<false, false>(begin, out);
        const bool isAffine = m_inputs.shading == Shading::Gouraud && m_inputs.interpolation == Interpolation::Affine;
        if (isAffine && m_in.transform.view.perspective) makeAffine(begin, out);
    }

private:
    // The first triangle that a vector shows, and the bit mask of the lanes that show other ones.
    struct FirstSeen {
        std::uint32_t name, others;
        static HWY_INLINE FirstSeen of(const std::uint32_t* names, std::uint32_t seen) {
            const std::uint32_t name = names[std::min(std::countr_zero(seen), int(hn::Lanes(F())) - 1)];
            return {name, seen & ~bitsOf(seesIn(names, name))};
        }
    };

    // The vectors of the row of blocks that begins with pixel `begin` of the tile. Rare needs have a loop of their own:
    // in the common loop, checking for them would cost as much time as the arithmetic.
    template <bool kPerPixel, bool kPositions>
    void findRow(std::size_t begin, SurfaceRow& out) {
        if constexpr (kPerPixel)
            if (m_drawnNames && !m_facing && !m_tellsObjects) return findVectors<true, kPositions, false>(begin, out);
        findVectors<kPerPixel, kPositions, true>(begin, out);
    }
    // kMore: handles the rare needs too.
    template <bool kPerPixel, bool kPositions, bool kMore>
    void findVectors(std::size_t begin, SurfaceRow& out) {
        const bool areNamed = !kMore || m_drawnNames != nullptr;
        if (!areNamed) m_drawn.read(m_in.zBuffer, m_tile, begin);
        const std::uint32_t* const rowNames = areNamed ? m_drawnNames + begin : m_drawn.triangle;
        // First of all and without a branch, because all interpolation waits for it.
        FirstSeen firsts[kRowVectors];
        for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F())) {
            const std::uint32_t seen = bitsOf(areNamed ? seenIn(m_seenIn->z + begin + i) : m_drawn.seenAt(i));
            out.seen[i / hn::Lanes(F())] = seen, firsts[i / hn::Lanes(F())] = FirstSeen::of(rowNames + i, seen);
        }
        for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F())) {
            const VectorPlace place(begin + i);
            if (m_isFine) fetchAhead(place.at);
            const Mask seen = out.seenAt(i);
            if (out.seen[i / hn::Lanes(F())] == 0) continue;
            const std::uint32_t* const names = rowNames + i;
            if constexpr (kPerPixel) {
                if (m_isFine && areSmall(names, seen)) {
                    findByPixel<kPositions>(place, seen, i, out);
                    continue;
                }
            }
            const Floats z = areNamed ? m_seenIn->zAt(place) : all(1);
            struct Interpolated {
                Floats3 normal, weights, position;
            };
            const auto interpolate = [&](const SeenSurface& surface) HWY_ATTR {
                Interpolated of;
                if constexpr (!A::kExact && kPerPixel && !kPositions) {
                    if (surface.isPlane) {
                        const Floats x = hn::Sub(hn::ConvertTo(F(), place.column()), all(surface.firstPixel.x));
                        const Floats y = hn::Sub(hn::ConvertTo(F(), place.row()), all(surface.firstPixel.y));
                        of.normal = surface.normals.template at<A>(x, y);
                        return of;
                    }
                }
                const Shares b = areNamed ? surface.triangle.weights(*m_seenIn, place, z)
                                          : Shares{load(m_drawn.weights[0], i), load(m_drawn.weights[1], i)};
                if constexpr (kPerPixel)
                    of.normal = surface.normals.template at<A>(b.one, b.two);
                else
                    of.weights = {hn::Sub(hn::Sub(all(1), b.one), b.two), b.one, b.two};
                if constexpr (kPositions) of.position = surface.positions.template at<A>(b.one, b.two);
                return of;
            };
            const FirstSeen first = firsts[i / hn::Lanes(F())];
            const SeenSurface* surface = &surfaceOf(first.name);
            Interpolated found = interpolate(*surface);
            const auto whole = [](std::int32_t value) HWY_ATTR { return hn::Set(I(), value); };
            Ints triangle = whole(std::int32_t(surface->id)), polygon = whole(surface->polygon);
            Ints object = whole(surface->object);
            Floats3 facing = all(surface->facing);
            for (std::size_t k = 0; k < m_biases.size(); ++k) store(all(biasOf(*surface, k)), out.bias[k], i);
            for (std::uint32_t left = first.others; left != 0;) {
                const std::uint32_t name = names[std::countr_zero(left)];
                const Mask mine = seesIn(names, name);
                left &= ~bitsOf(mine);
                surface = &surfaceOf(name);
                const Interpolated other = interpolate(*surface);
                const auto blended = [&](std::int32_t value, Ints before) HWY_ATTR {
                    return hn::IfThenElse(hn::RebindMask(I(), mine), whole(value), before);
                };
                if constexpr (kPerPixel) {
                    found.normal = choose(mine, other.normal, found.normal);
                    if (kMore && m_tellsObjects) object = blended(surface->object, object);
                } else {
                    found.weights = choose(mine, other.weights, found.weights);
                    triangle = blended(std::int32_t(surface->id), triangle);
                    polygon = blended(surface->polygon, polygon);
                }
                if constexpr (kPositions) found.position = choose(mine, other.position, found.position);
                if (kMore && m_facing) facing = choose(mine, all(surface->facing), facing);
                for (std::size_t k = 0; k < m_biases.size(); ++k)
                    hn::BlendedStore(all(biasOf(*surface, k)), mine, F(), out.bias[k].of + i);
            }
            if constexpr (kPerPixel) {
                store(A::unit(found.normal, seen), out.N, i);
                if (kMore && m_tellsObjects) hn::Store(object, I(), out.object + i);
            } else {
                hn::Store(triangle, I(), out.triangle + i), hn::Store(polygon, I(), out.polygon + i);
                store(found.weights, out.weights, i);
            }
            if (kMore && m_facing) store(facing, out.facing, i);
            if constexpr (kPositions) store(found.position, out.position, i);
        }
    }
    // For vector i of a row if each lane shows a different triangle: going through the triangles would compute a whole
    // vector for each pixel.
    template <bool kPositions>
    HWY_NOINLINE void findByPixel(const VectorPlace& place, Mask seen, std::size_t i, SurfaceRow& out) const {
        const SeenInPixels in(*m_seenIn, place, m_drawnNames + place.at, seen);
        const Topology& topology = *m_in.transform.topology;
        struct Quantity {
            Floats3 origin, toSecond, toThird;
        };
        const auto cornersOf = [&](std::span<const Vec3<float>> values) HWY_ATTR {
            const auto at = [&](int corner) HWY_ATTR {
                return loadThrees(values, [&](std::size_t l) { return in.vertices[corner][l]; });
            };
            const Floats3 origin = at(0);
            return Quantity{origin, at(1) - origin, at(2) - origin};
        };
        const auto interpolate = [&](const Quantity& q) HWY_ATTR {
            return scaledPlus<A>(q.toThird, in.weights.two, scaledPlus<A>(q.toSecond, in.weights.one, q.origin));
        };
        store(A::unit(interpolate(cornersOf(m_in.normals.vertex)), seen), out.N, i);
        const auto polygonOf = [&](std::size_t l) { return std::size_t(in.polygon[l]); };
        const bool asksFacing = m_facing || !m_biases.empty();
        const bool findsFacing = asksFacing && (m_in.normals.polygon.empty() || !topology.polygons.empty());
        Floats3 facing = all(Vec3<float>(0));
        if (asksFacing && !findsFacing) facing = loadThrees(m_in.normals.polygon, polygonOf);
        if (kPositions || findsFacing) {
            const Quantity world = cornersOf(m_in.transform.world);
            if constexpr (kPositions) store(interpolate(world), out.position, i);
            if (findsFacing) {
                const Floats3 sum = areaVectors(m_in.transform, m_mirrors, world.toSecond, world.toThird, polygonOf);
                facing = Exact::unit(sum, seen);
                replaceSmall(seen, sum, facing, [&](std::size_t l) { return m_in.planeNormal(in.id[l]); });
            }
        }
        if (m_facing) store(facing, out.facing, i);
        for (std::size_t k = 0; k < m_biases.size(); ++k) store(m_biases[k].template of<A>(facing), out.bias[k], i);
        for (std::size_t l = 0; m_tellsObjects && l < hn::Lanes(F()); ++l)
            out.object[i + l] = std::int32_t(topology.objectOfPolygon(in.polygon[l]));
    }
    // In a fine mesh each pixel shows another triangle, which is not in the inner caches. So the triangles of later
    // vectors are prefetched while this one is computed.
    HWY_INLINE void fetchAhead(std::size_t at) const {
        constexpr std::size_t kTriangles = 48, kVertices = 16;  // pixels
        const std::size_t lanes = hn::Lanes(F());
        if (at + kTriangles + lanes > kTilePixels) return;
        const auto triangleAt = [&](std::size_t pixel) -> const Triangle* {
            if (!(m_seenIn->z[pixel] < SeenBlocks::kNowhere)) return nullptr;
            const std::uint32_t name = m_drawnNames[pixel];
            return TrianglePieces::isOther(name) ? nullptr : &m_in.transform.topology->triangles[name];
        };
        for (std::size_t l = 0; l < lanes; ++l) {
            if (const Triangle* t = triangleAt(at + kTriangles + l)) hwy::Prefetch(t);
            const Triangle* const t = triangleAt(at + kVertices + l);
            for (int corner = 0; t && corner < 3; corner += 2) {  // two: the third is mostly beside one of them
                const std::uint32_t vertex = t->vertices[corner];
                hwy::Prefetch(&m_in.transform.snapped.at(vertex));
                if (m_perPixel) hwy::Prefetch(&m_in.normals.vertex[vertex]);
                if (m_positioned) hwy::Prefetch(&m_in.transform.world[vertex]);
            }
        }
    }
    // The bias of a cached surface for light k.
    HWY_INLINE float& biasOf(const SeenSurface& surface, std::size_t k) {
        return m_bias[std::size_t(&surface - m_surfaces.get()) * m_biases.size() + k];
    }
    // name: the triangle's name in the blocks if there are blocks, else its index.
    HWY_INLINE const SeenSurface& surfaceOf(std::uint32_t name) {
        const std::size_t slot = name % kSlots;
        if (m_names[slot] != name) m_names[slot] = name, become(m_surfaces[slot], name);
        return m_surfaces[slot];
    }
    HWY_NOINLINE void become(SeenSurface& seen, std::uint32_t name) {
        seen.id = name, seen.isPlane = false;
        if (m_drawnNames) seen.triangle.become(*m_seenIn, name, m_others[name % kSlots]), seen.id = seen.triangle.id();
        const Triangle& triangle = m_in.transform.topology->triangles[seen.id];
        const std::uint32_t polygon = m_in.transform.topology->polygonOf(seen.id);
        seen.polygon = std::int32_t(polygon);
        if (m_tellsObjects) seen.object = std::int32_t(m_in.transform.topology->objectOfPolygon(polygon));
        if (m_positioned) seen.positions.become(m_in.transform.world, triangle.vertices);
        if (m_facing || !m_biases.empty()) seen.facing = m_in.planeNormal(seen.id);
        for (std::size_t k = 0; k < m_biases.size(); ++k)
            biasOf(seen, k) = hn::GetLane(m_biases[k].template of<A>(all(seen.facing)));
        if (!m_perPixel) return;
        if (m_findsPlanes && seen.triangle.isLinear()) becomePlane(seen, triangle);
        if (!seen.isPlane) seen.normals.become(m_in.normals.vertex, triangle.vertices);
    }
    // The normal over z_view is linear in the picture and has the normal's direction. In a triangle thinner than a few
    // pixels the sums of its steps are not accurate enough.
    void becomePlane(SeenSurface& seen, const Triangle& triangle) const {
        constexpr float kSteepest = 64;
        const auto divided = [&](std::size_t corner) {
            const Vec3<float> n = seen.triangle.atCorner(m_in.normals.vertex, triangle.vertices, corner);
            return seen.triangle.w(corner) * n;
        };
        const glm::ivec2 first = seen.triangle.firstPixel(m_tile);
        const Slope one = seen.triangle.slope(1, first), two = seen.triangle.slope(2, first);
        for (const Slope& l : {one, two})
            if (!(std::abs(l.value) + std::abs(l.column) + std::abs(l.row) < kSteepest)) return;
        Corners n;
        n.become(divided(0), divided(1), divided(2));
        seen.isPlane = true, seen.firstPixel = first;
        seen.normals = {n.origin + one.value * n.toSecond + two.value * n.toThird,
                        one.column * n.toSecond + two.column * n.toThird, one.row * n.toSecond + two.row * n.toThird};
    }
    // Replaces the weights by ones that are linear in the picture, for the row of blocks that begins with pixel `begin`
    // of the tile: vertexWeights.
    void makeAffine(std::size_t begin, SurfaceRow& out) const {
        const TransformOutput<float>& in = m_in.transform;
        const auto* words = reinterpret_cast<const std::int32_t*>(in.topology->triangles.data());
        auto nearest = float(in.view.near);  // the smallest z in front of the near plane
        const Floats3 pivot = all(Vec3<float>(in.view.pivot)), forward = all(Vec3<float>(in.view.forward));
        const Floats depth = all(float(in.view.pivotDepth));
        if (double(nearest) < in.view.near) nearest = std::nextafter(nearest, std::numeric_limits<float>::infinity());
        for (std::size_t i = 0; i < kRowPixels; i += hn::Lanes(F())) {
            const Mask seen = out.seenAt(i);
            if (hn::AllFalse(F(), seen)) continue;
            const Ints id = hn::Load(I(), out.triangle + i), first = hn::Add(id, hn::Add(id, id));
            static_assert(sizeof(Triangle) == 12);
            const Floats3 b = load(out.weights, i);
            Mask isInFront = seen;
            const auto scaledByZ = [&](Floats weight, int corner) HWY_ATTR {
                const Ints vertex = hn::GatherIndex(I(), words, hn::Add(first, hn::Set(I(), corner)));
                const Ints at = hn::Add(vertex, hn::Add(vertex, vertex));
                const auto world = [&](int part) HWY_ATTR { return hn::GatherIndex(F(), &in.world[0].x + part, at); };
                const Floats along = Exact::dot(forward, Floats3{world(0), world(1), world(2)} - pivot);
                const Floats z = hn::Add(along, depth);
                isInFront = hn::And(isInFront, hn::Ge(z, all(nearest)));
                return hn::Mul(weight, z);
            };
            const Floats3 l{scaledByZ(b.x, 0), scaledByZ(b.y, 1), scaledByZ(b.z, 2)};
            const Floats sum = hn::Add(hn::Add(l.x, l.y), l.z);
            store(choose(isInFront, {hn::Div(l.x, sum), hn::Div(l.y, sum), hn::Div(l.z, sum)}, b), out.weights, i);
            // For a clipped polygon the scalar code finds the piece that covers the pixel.
            for (std::uint32_t rest = bitsOf(hn::AndNot(isInFront, seen)); rest != 0; rest &= rest - 1) {
                const std::size_t at = i + std::size_t(std::countr_zero(rest));
                Row3& weights = out.weights;
                RowCrossings none;
                const VertexWeights<float> affine = vertexWeights<float>(
                    Interpolation::Affine, in, std::uint32_t(out.triangle[at]),
                    {weights.x.of[at], weights.y.of[at], weights.z.of[at]}, m_tile.min + pixelOf(begin + at), none);
                weights.x.of[at] = affine.weights[0], weights.y.of[at] = affine.weights[1];
                weights.z.of[at] = affine.weights[2];
            }
        }
    }
    const ShadingInputs& m_inputs;
    const ShadingSources<float>& m_in;
    Tile m_tile;
    bool m_isFine = false;       // for meshes with few pixels per triangle
    bool m_findsPlanes = false;  // whether SeenSurface::isPlane is used
    std::span<const PolygonBias> m_biases;
    bool m_facing, m_perPixel, m_positioned, m_tellsObjects, m_mirrors, m_isDrawn = true;
    std::size_t m_index = 0;                      // of the tile
    const std::uint32_t* m_drawnNames = nullptr;  // in the tile; null if no kernel drew it
    std::optional<SeenIn> m_seenIn;               // null if no kernel drew it
    DrawnRow m_drawn;                             // the row, if no kernel drew it
    // The surfaces that were used last: pixels beside each other mostly show the same few.
    static constexpr std::size_t kSlots = 128;
    std::array<std::uint32_t, kSlots> m_names;
    std::vector<float> m_bias;  // of each of these surfaces, all lights side by side
    std::unique_ptr<SeenSurface[]> m_surfaces = std::make_unique_for_overwrite<SeenSurface[]>(kSlots);
    std::array<std::unique_ptr<SeenTriangle::Other>, kSlots> m_others;  // for those of them that need it
};

}  // namespace pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
