#include "pipeline/buffers/buffer_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "pipeline/core/text.h"

namespace pipeline {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using B = BufferId;
using S = StageId;
using D = Domain;
using E = Element;
using P = Palette;
using R = Part;

// In the order of BufferId, which is that of the stages. `depth` has the neutral value of the
// linear and the [0, 1] formats; in a reversed one, where larger is nearer, a run fills in 0.
constexpr std::array<BufferInfo, kBufferCount> kTable{{
    {B::VerticesWorld, "vertices.world", S::Transform, D::Vertex, E::Real, 3, false, "world units", "world",
     "Vertices after their object's transform.", P::Direction, 0},
    {B::VerticesView, "vertices.view", S::Transform, D::Vertex, E::Real, 3, false, "world units", "view",
     "Vertices in view space: x right, y up, z away from the viewer.", P::Direction, 0},
    {B::VerticesScreen, "vertices.screen", S::Transform, D::Vertex, E::Real, 3, false, "pixels, pixels, depth",
     "screen",
     "Vertices in the picture: x right, y down, and the depth as stored; -1e30 three times for a vertex without a "
     "position: not in front of the eye, or too far off the picture.",
     P::Direction, 0, PartSet{}, "vertices without a position in the picture"},

    {B::PolygonsVerdict, "polygons.verdict", S::Cull, D::Polygon, E::UInt8, 1, false, "", "",
     "Why each polygon is kept or dropped.", P::Verdict, 0, partsOf(R::Culling)},

    {B::PolygonsNormal, "polygons.normal", S::Normals, D::Polygon, E::Real, 3, false, "", "world",
     "Unit normals of the polygons.", P::Direction, 0, partsOf(R::PolygonNormals)},
    {B::VerticesNormal, "vertices.normal", S::Normals, D::Vertex, E::Real, 3, false, "", "world",
     "Unit normals of the vertices.", P::Direction, 0, partsOf(R::VertexNormals)},

    {B::ShadowBuffer, "shadow_buffer", S::ShadowBuffer, D::Texel, E::Real, 1, true, "world units", "light",
     "Z': the distance from the light to the nearest polygon; six faces for a point light and for each sample of an "
     "area light, in sequence.",
     P::Sequential, kInfinity, partsOf(R::ShadowBuffer)},

    {B::Depth, "depth", S::ZBuffer, D::Pixel, E::Real, 1, false, "as stored", "screen",
     "The contents of the z-buffer, in the chosen format.", P::Sequential, kInfinity, partsOf(R::DepthTest)},
    {B::ZView, "z_view", S::ZBuffer, D::Pixel, E::Real, 1, false, "world units", "view",
     "Distance along the viewing direction.", P::Sequential, kInfinity},
    {B::ObjectId, "object_id", S::ZBuffer, D::Pixel, E::Int32, 1, false, "", "", "The visible object.", P::Categorical,
     -1, partsOf(R::SeenPolygons)},
    {B::PolygonId, "polygon_id", S::ZBuffer, D::Pixel, E::Int32, 1, false, "", "",
     "The visible polygon, counted over all objects.", P::Categorical, -1, partsOf(R::SeenPolygons)},
    {B::Barycentric, "barycentric", S::ZBuffer, D::Pixel, E::Real, 3, false, "", "",
     "Weights of the triangle's three vertices, perspective-correct.", P::Color, 0,
     partsOf(R::SeenPolygons, R::Weights)},
    {B::Overdraw, "overdraw", S::ZBuffer, D::Pixel, E::Int32, 1, false, "fragments", "", "The number of fragments.",
     P::Sequential, 0, partsOf(R::FragmentCounts)},
    {B::DepthWrites, "depth_writes", S::ZBuffer, D::Pixel, E::Int32, 1, false, "fragments", "",
     "The number of fragments that passed the depth test.", P::Sequential, 0, partsOf(R::FragmentCounts)},

    {B::Position, "position", S::Shading, D::Pixel, E::Real, 3, false, "world units", "world", "The visible point.",
     P::Direction, 0, partsOf(R::Position)},
    {B::Normal, "normal", S::Shading, D::Pixel, E::Real, 3, false, "", "world", "N, unit.", P::Direction, 0,
     partsOf(R::SurfaceVectors)},
    {B::ViewVector, "view_vector", S::Shading, D::Pixel, E::Real, 3, false, "", "world", "V, towards the eye, unit.",
     P::Direction, 0, partsOf(R::SurfaceVectors, R::ViewVector)},
    {B::LightVector, "light_vector", S::Shading, D::Pixel, E::Real, 3, true, "", "world", "L, towards the light, unit.",
     P::Direction, 0, partsOf(R::LightVectors, R::Light)},
    {B::ReflectionVector, "reflection_vector", S::Shading, D::Pixel, E::Real, 3, true, "", "world",
     "R, L mirrored at N, unit.", P::Direction, 0, partsOf(R::LightVectors, R::Light, R::Reflection)},
    {B::HalfwayVector, "halfway_vector", S::Shading, D::Pixel, E::Real, 3, true, "", "world",
     "H, halfway between L and V, unit.", P::Direction, 0,
     partsOf(R::LightVectors, R::Light, R::ViewVector, R::Halfway)},
    {B::NDotL, "n_dot_l", S::Shading, D::Pixel, E::Real, 1, true, "", "", "N·L before clamping.", P::Diverging, 0,
     partsOf(R::LightVectors, R::Light)},
    {B::RDotV, "r_dot_v", S::Shading, D::Pixel, E::Real, 1, true, "", "", "R·V before clamping.", P::Diverging, 0,
     partsOf(R::LightVectors, R::Light, R::ViewVector, R::Reflection)},
    {B::NDotH, "n_dot_h", S::Shading, D::Pixel, E::Real, 1, true, "", "", "N·H before clamping.", P::Diverging, 0,
     partsOf(R::LightVectors, R::Light, R::ViewVector, R::Halfway)},
    {B::Shadow, "shadow", S::Shading, D::Pixel, E::Real, 1, true, "", "",
     "S: 1 lit, 0 in shadow or if the polygon faces away from the light; always 1 for a light without shadows.",
     P::Sequential, 1, partsOf(R::Light, R::ShadowLookup)},
    {B::DiffuseCoefficient, "k_d", S::Shading, D::Pixel, E::Real, 3, false, "", "",
     "k_d of the visible point, with the colours of its polygon's vertices.", P::Color, 0},
    {B::Ambient, "ambient", S::Shading, D::Pixel, E::Real, 3, false, "intensity", "", "The ambient term.", P::Color, 0},
    {B::Diffuse, "diffuse", S::Shading, D::Pixel, E::Real, 3, true, "intensity", "", "The diffuse term of a light.",
     P::Color, 0, partsOf(R::Light)},
    {B::Specular, "specular", S::Shading, D::Pixel, E::Real, 3, true, "intensity", "", "The specular term of a light.",
     P::Color, 0, partsOf(R::Light, R::NegligiblePowers)},
    {B::Emission, "emission", S::Shading, D::Pixel, E::Real, 3, false, "intensity", "",
     "The light that the material emits.", P::Color, 0, partsOf(R::Emission)},
    {B::Translucent, "translucent", S::Shading, D::Pixel, E::Real, 3, false, "intensity", "",
     "The intensity that translucent surfaces add; the terms are those of the opaque surface.", P::Color, 0,
     partsOf(R::Layers)},
    {B::Transmittance, "transmittance", S::Shading, D::Pixel, E::Real, 1, false, "", "",
     "The fraction of the opaque surface's intensity that passes the translucent surfaces.", P::Sequential, 1,
     partsOf(R::Layers)},
    {B::Layers, "layers", S::Shading, D::Pixel, E::Int32, 1, false, "layers", "",
     "The number of translucent surfaces in front of the opaque one; depth, object and polygon are those of the opaque "
     "one.",
     P::Sequential, 0, partsOf(R::Layers)},
    {B::Intensity, "intensity", S::Shading, D::Pixel, E::Real, 3, false, "intensity", "",
     "transmittance · (the sum of all terms) + translucent, before scaling by I_max.", P::Color, 0,
     partsOf(R::Intensity)},
    {B::Antialiased, "antialiased", S::Shading, D::Pixel, E::Real, 3, false, "intensity", "",
     "The mean intensity over the samples of a pixel; intensity itself is the value at its centre.", P::Color, 0,
     partsOf(R::Antialiasing, R::Intensity)},
    {B::PolygonsIntensity, "polygons.intensity", S::Shading, D::Polygon, E::Real, 3, false, "intensity", "",
     "Flat shading's intensity of each polygon that is kept; 0 for the others.", P::Color, 0,
     partsOf(R::PolygonTerms, R::Culling), "polygons that are not lit: culled, or seen in no pixel"},
    {B::VerticesIntensity, "vertices.intensity", S::Shading, D::Vertex, E::Real, 3, false, "intensity", "",
     "Gouraud shading's intensity of each vertex of a polygon that is kept; 0 for the others.", P::Color, 0,
     partsOf(R::VertexTerms, R::Culling), "vertices that are not lit: their polygons are culled, or seen in no pixel"},
    {B::Color, "color", S::Shading, D::Pixel, E::UInt8, 3, false, "", "sRGB", "The frame buffer.", P::Color, 0},
}};

// In the order of BufferId. Their stage is the last that they may read.
constexpr std::array<BufferInfo, kDerivedCount> kDerived{{
    {B::Mix, "mix", S::Shading, D::Pixel, E::UInt8, 3, false, "", "sRGB", "The frame buffer of the mixed terms.",
     P::Color, 0},
    {B::ShadowVerdict, "shadow_verdict", S::Shading, D::Pixel, E::Int32, 1, true, "", "",
     "The shadow factor against exact rays: 0 lit, 1 shadowed, 2 acne, 3 leak.", P::ShadowVerdict, -1},
    {B::Condition, "condition", S::Shading, D::Pixel, E::UInt8, 1, false, "", "", "1 where the condition is true.",
     P::Truth, 0},
    {B::Expression, "expression", S::Shading, D::Pixel, E::Real, 1, false, "", "", "The value of the expression.",
     P::Sequential, 0},
    {B::ZNdc, "z_ndc", S::ZBuffer, D::Pixel, E::Real, 1, false, "", "clip",
     "z in normalised device coordinates: -1 at the near plane, 1 at the far one.", P::Sequential, kInfinity},
}};

// findBuffer and bufferInfo index by BufferId.
static_assert([] {
    for (std::size_t i = 0; i < kTable.size(); ++i)
        if (index(kTable[i].id) != i || (i > 0 && kTable[i].stage < kTable[i - 1].stage)) return false;
    for (std::size_t i = 0; i < kDerived.size(); ++i)
        if (index(kDerived[i].id) != kBufferCount + i) return false;
    return true;
}());

std::optional<BufferName> find(std::span<const BufferInfo> table, std::string_view text) {
    for (const BufferInfo& info : table) {
        if (!info.perLight) {
            if (text == info.name) return BufferName{info.id};
            continue;
        }
        if (!text.starts_with(info.name) || text.size() < info.name.size() + 2 || text[info.name.size()] != '.')
            continue;
        const std::string_view digits = text.substr(info.name.size() + 1);
        int light = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), light);
        const bool canonical = light >= 0 && (digits == "0" || (digits[0] != '0' && digits[0] != '-'));
        if (error == std::errc() && end == digits.data() + digits.size() && canonical)
            return BufferName{info.id, light};
    }
    return std::nullopt;
}

std::vector<BufferName> namesOf(std::span<const BufferInfo> table, std::size_t lights) {
    std::vector<BufferName> names;
    for (const BufferInfo& info : table) {
        if (!info.perLight)
            names.push_back({info.id});
        else
            for (std::size_t k = 0; k < lights; ++k) names.push_back({info.id, static_cast<int>(k)});
    }
    return names;
}

std::vector<std::string> textsOf(const std::vector<BufferName>& names) {
    std::vector<std::string> texts;
    for (const BufferName& name : names) texts.push_back(name.text());
    return texts;
}

}  // namespace

std::span<const BufferInfo, kBufferCount> bufferTable() { return kTable; }

std::span<const BufferInfo, kDerivedCount> derivedTable() { return kDerived; }

const BufferInfo& bufferInfo(BufferId id) {
    return isDerived(id) ? kDerived[index(id) - kBufferCount] : kTable[index(id)];
}

std::string BufferName::text() const {
    std::string text(bufferInfo(id).name);
    if (bufferInfo(id).perLight) text += '.' + std::to_string(light);
    return text;
}

std::optional<BufferName> findBuffer(std::string_view text) { return find(kTable, text); }
std::optional<BufferName> findDerived(std::string_view text) { return find(kDerived, text); }

std::optional<BufferName> findAnyBuffer(std::string_view text) {
    const auto name = findBuffer(text);
    return name ? name : findDerived(text);
}

std::string insteadOfBuffer(std::string_view text) { return insteadOf(text, textsOf(allBuffers(1)), kListingCommand); }

std::string insteadOfAnyBuffer(std::string_view text) {
    std::vector<std::string> names = textsOf(allBuffers(1)), derived = textsOf(allDerived(1));
    names.insert(names.end(), derived.begin(), derived.end());
    return insteadOf(text, names, kListingCommand);
}

std::vector<BufferName> allBuffers(std::size_t lights) { return namesOf(kTable, lights); }
std::vector<BufferName> allDerived(std::size_t lights) { return namesOf(kDerived, lights); }

BufferSet setOf(std::initializer_list<BufferId> ids) {
    BufferSet set;
    for (const BufferId id : ids) set.set(index(id));
    return set;
}

}  // namespace pipeline
