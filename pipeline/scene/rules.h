#pragma once
#include <array>
#include <bitset>
#include <concepts>
#include <cstdint>
#include <string_view>

namespace pipeline {

// What the pipeline may leave out of a frame. A rule is allowed only where it cannot change a bit
// of what is asked for: it removes work whose result nobody reads, or terms that are exactly 0.
// Whatever is only nearly right is an approximation, and a setting of its own instead.
enum class Rule : std::uint8_t {
    ModelTransform,
    Culling,
    PolygonNormals,
    VertexNormals,
    PolygonTerms,
    VertexTerms,
    HiddenPolygons,
    HiddenVertices,
    DarkLight,
    Unreflected,
    ConvexShadow,
    DistantShadow,
    ShadowLookup,
    Clipping,
    EmptyTiles,
    Position,
    ViewVector,
    Directions,
    Specular,
    VanishingPower,
    Attenuation,
    Ambient,
    UnreadBuffers,
    TranslucentPass,
    LayerSort,
};
constexpr std::size_t index(Rule rule) { return static_cast<std::size_t>(rule); }

struct RuleInfo {
    std::string_view key;    // of its switch among the settings: "rule.specular"
    std::string_view label;  // for a control
    std::string_view when;   // what is left out and exactly when, one sentence
};

// In the order of the enumerators.
inline constexpr auto kRules = std::to_array<RuleInfo>({
    {"rule.model_transform", "Model transform",
     "Leaves the model transform of the only object out where its matrix is the identity: its vertices are read where "
     "the mesh has them, and so are normals that have length 1."},
    {"rule.culling", "Culling", "Leaves culling out where it drops nothing and nobody reads its verdicts."},
    {"rule.polygon_normals", "Polygon normals",
     "Leaves polygon normals, and their sums around vertices, out where nobody reads them."},
    {"rule.vertex_normals", "Vertex normals",
     "Leaves vertex normals out where only polygon normals are read, or none."},
    {"rule.polygon_terms", "Polygon terms", "Evaluates polygons only in flat shading, or where they are asked for."},
    {"rule.vertex_terms", "Vertex terms", "Evaluates vertices only in Gouraud shading, or where they are asked for."},
    {"rule.hidden_polygons", "Hidden polygons",
     "Leaves the evaluation of polygons out that culling dropped and, where more than one for four pixels is left, of "
     "those that no pixel shows."},
    {"rule.hidden_vertices", "Hidden vertices",
     "Leaves the evaluation of vertices out all of whose polygons are hidden."},
    {"rule.dark_light", "Dark light", "Leaves a light of intensity 0 or of colour black out, with its shadow buffer."},
    {"rule.unreflected", "Unreflected light", "Leaves a light out of which no material reflects any part."},
    {"rule.convex_shadow", "Convex object",
     "Leaves the shadow buffers out where the only object is convex, which cannot shadow itself."},
    {"rule.distant_shadow", "Distant objects",
     "Leaves the shadow buffer of a light at infinity out where all objects are convex and, seen from the light, "
     "apart."},
    {"rule.shadow_lookup", "Shadow look-up", "Leaves a look-up out where the terms that it would multiply are 0."},
    {"rule.clipping", "Clipping", "Leaves clipping out for polygons that culling found whole in the picture."},
    {"rule.empty_tiles", "Empty tiles", "Leaves the tiles of the picture out in which nothing was drawn."},
    {"rule.position", "Position", "Leaves the position of a pixel's surface out where no light and nobody reads it."},
    {"rule.view_vector", "View vector", "Leaves V of a pixel out where there is no specular term to read it."},
    {"rule.directions", "R and H", "Leaves of R and H out what the illumination model does not read."},
    {"rule.specular", "Specular term", "Leaves the specular term of a light out where k_s is 0."},
    {"rule.vanishing_power", "Vanishing power",
     "Leaves the power out so far from the highlight that its result is rounded to 0, or, with Phong shading, changes "
     "no bit of an intensity whose specular term is not asked for."},
    {"rule.attenuation", "Attenuation", "Leaves the attenuation of a light out that is 1 at every distance."},
    {"rule.ambient", "Ambient term", "Leaves the ambient term out where there is no ambient light to reflect."},
    {"rule.unread_buffers", "Unread buffers", "Leaves buffers out that nobody asks for."},
    {"rule.translucent_pass", "Translucent pass", "Leaves the pass over translucent polygons out where there is none."},
    {"rule.layer_sort", "Sort of layers", "Leaves the sort of layers out where one triangle alone is translucent."},
});
inline constexpr std::size_t kRuleCount = kRules.size();
static_assert(kRuleCount == index(Rule::LayerSort) + 1);
using RuleSet = std::bitset<kRuleCount>;

constexpr const RuleInfo& ruleInfo(Rule rule) { return kRules[index(rule)]; }
// "specular": the key without its group.
constexpr std::string_view name(Rule rule) { return ruleInfo(rule).key.substr(5); }

// What stages do that may be left out by itself: stage by stage, in the order in which a plan lists it. The row of each in
// pipeline/plan/part_table.cpp says when; stages and buffers name what they read.
enum class Part : std::uint8_t {
    ModelTransform,
    Culling,
    PolygonNormals,
    NormalSums,  // around vertices
    VertexNormals,
    Normalisation,  // of the vertex normals
    ShadowBuffer,   // per light
    Clipping,
    SeenPolygons,  // what stage 5 leaves beside distances
    FragmentCounts,
    Weights,
    DepthTest,
    Sort,
    Split,
    DrawnInVectors,
    PolygonTerms,
    VertexTerms,
    HiddenPolygons,
    HiddenVertices,
    Ambient,
    Light,        // per light
    Specular,     // per light
    Attenuation,  // per light
    Reflection,   // R
    Halfway,      // H
    Powers,
    NegligiblePowers,  // which change no bit of a sum
    ViewVector,        // at a pixel
    Position,          // at a pixel
    ShadowLookup,
    Antialiasing,
    ShadedInVectors,
    FastVectors,
    Tiles,
    Layers,
    LayerSort,
    Emission,
    Intensity,       // beside the frame buffer
    SurfaceVectors,  // N and V of every pixel, for who looks
    LightVectors,    // and L, R, H and their products
};
inline constexpr std::size_t kPartCount = 40;
constexpr std::size_t index(Part part) { return static_cast<std::size_t>(part); }

// A bit for each part.
class PartSet {
public:
    static constexpr PartSet all() {
        PartSet set;
        set.m_bits = ~std::uint64_t(0);
        return set;
    }
    constexpr bool operator[](Part part) const { return (m_bits >> index(part) & 1) != 0; }
    constexpr PartSet& set(Part part, bool on = true) {
        const std::uint64_t bit = std::uint64_t(1) << index(part);
        m_bits = on ? m_bits | bit : m_bits & ~bit;
        return *this;
    }
    constexpr PartSet& operator|=(PartSet more) {
        m_bits |= more.m_bits;
        return *this;
    }
    constexpr bool hasAnyOf(PartSet other) const { return (m_bits & other.m_bits) != 0; }
    constexpr bool operator==(const PartSet&) const = default;

private:
    static_assert(kPartCount <= 64);
    std::uint64_t m_bits = 0;
};
template <std::same_as<Part>... Parts>
constexpr PartSet partsOf(Parts... parts) {
    PartSet set;
    (set.set(parts), ...);
    return set;
}

}  // namespace pipeline
