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
     "Leaves out the model transform of the only object if its matrix is the identity: vertices are read directly from "
     "the mesh, and so are normals of length 1."},
    {"rule.culling", "Culling", "Leaves out culling if it drops nothing and nobody reads its verdicts."},
    {"rule.polygon_normals", "Polygon normals",
     "Leaves out polygon normals, and their sums around vertices, if nobody reads them."},
    {"rule.vertex_normals", "Vertex normals", "Leaves out vertex normals if only polygon normals are read, or none."},
    {"rule.polygon_terms", "Polygon terms", "Evaluates polygons only in flat shading, or on request."},
    {"rule.vertex_terms", "Vertex terms", "Evaluates vertices only in Gouraud shading, or on request."},
    {"rule.hidden_polygons", "Hidden polygons",
     "Leaves out the evaluation of polygons that culling dropped. If more than one polygon for four pixels remains, "
     "also of those that no pixel shows."},
    {"rule.hidden_vertices", "Hidden vertices", "Leaves out the evaluation of vertices whose polygons are all hidden."},
    {"rule.dark_light", "Dark light", "Leaves out a light of intensity 0 or of black colour, with its shadow buffer."},
    {"rule.unreflected", "Unreflected light", "Leaves out a light that no material reflects."},
    {"rule.convex_shadow", "Convex object",
     "Leaves out the shadow buffers if the only object is convex, because it cannot shadow itself."},
    {"rule.distant_shadow", "Distant objects",
     "Leaves out the shadow buffer of a light at infinity if all objects are convex and, seen from the light, apart."},
    {"rule.shadow_lookup", "Shadow look-up", "Leaves out a look-up if the terms that it would multiply are 0."},
    {"rule.clipping", "Clipping", "Leaves out clipping for polygons that are wholly in the picture, as culling found."},
    {"rule.empty_tiles", "Empty tiles", "Leaves out tiles of the picture in which nothing was drawn."},
    {"rule.position", "Position", "Leaves out the position of a pixel's surface if no light and nobody else reads it."},
    {"rule.view_vector", "View vector", "Leaves out V of a pixel if no specular term reads it."},
    {"rule.directions", "R and H", "Leaves out R or H if the illumination model does not read it."},
    {"rule.specular", "Specular term", "Leaves out the specular term of a light if k_s is 0."},
    {"rule.vanishing_power", "Vanishing power",
     "Leaves out the power so far from the highlight that its result rounds to 0. In Phong shading also if it changes "
     "no bit of the intensity and the specular term is not requested."},
    {"rule.attenuation", "Attenuation", "Leaves out the attenuation of a light if it is 1 at every distance."},
    {"rule.ambient", "Ambient term", "Leaves out the ambient term if there is no ambient light to reflect."},
    {"rule.unread_buffers", "Unread buffers", "Leaves out buffers that nobody requests."},
    {"rule.translucent_pass", "Translucent pass", "Leaves out the pass over translucent polygons if there are none."},
    {"rule.layer_sort", "Sort of layers", "Leaves out the sorting of layers if only one triangle is translucent."},
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
