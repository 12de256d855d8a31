#pragma once
#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/stage.h"
#include "pipeline/scene/rules.h"

namespace pipeline {

enum class BufferId : std::uint8_t {
    VerticesWorld,
    VerticesView,
    VerticesScreen,
    PolygonsVerdict,
    PolygonsNormal,
    VerticesNormal,
    ShadowBuffer,
    Depth,
    ZView,
    ObjectId,
    PolygonId,
    Barycentric,
    Overdraw,
    DepthWrites,
    Position,
    Normal,
    ViewVector,
    LightVector,
    ReflectionVector,
    HalfwayVector,
    NDotL,
    RDotV,
    NDotH,
    Shadow,
    DiffuseCoefficient,
    Ambient,
    Diffuse,
    Specular,
    Emission,
    Translucent,
    Transmittance,
    Layers,
    Intensity,
    Antialiased,
    PolygonsIntensity,
    VerticesIntensity,
    Color,
    // Derived: made of a finished frame by no stage. A frame does not hold them.
    Mix,
    ShadowVerdict,
    Condition,
    Expression,
    ZNdc,
};
constexpr std::size_t index(BufferId id) { return static_cast<std::size_t>(id); }
inline constexpr std::size_t kBufferCount = index(BufferId::Color) + 1;  // that frames hold
inline constexpr std::size_t kDerivedCount = index(BufferId::ZNdc) + 1 - kBufferCount;
constexpr bool isDerived(BufferId id) { return index(id) >= kBufferCount; }

// What one row of a buffer stands for.
enum class Domain : std::uint8_t { Vertex, Polygon, Pixel, Texel };
// Real is float32, or float64 when the run is in double.
enum class Element : std::uint8_t { Real, Int32, UInt8 };
// How a value becomes a colour on the screen.
enum class Palette : std::uint8_t {
    Sequential,
    Diverging,
    Categorical,
    Verdict,
    ShadowVerdict,
    Truth,
    Direction,
    Color
};

struct BufferInfo {
    BufferId id;
    std::string_view name;  // without a light's index: "n_dot_l"
    StageId stage;          // that leaves it
    Domain domain;
    Element element;
    int channels;
    bool perLight;             // its name ends in ".k", k the light's index
    std::string_view unit;     // "world units", "pixels"; empty for a pure number
    std::string_view space;    // "world", "view", "screen"; empty where none applies
    std::string_view meaning;  // one sentence
    Palette palette;
    double neutral;  // where nothing was drawn, and what readers see when it is left out
    PartSet
        reads{};  // what a frame does for whoever asks for it; by these the plan knows when a scene has no use for it
    // What the rows without a value are, for messages: "vertices without a position in the picture". Empty if every row has
    // a value.
    std::string_view withoutValue{};
};

// Its values are names: equal or not, and nothing between them.
constexpr bool isOfNames(const BufferInfo& info) {
    return info.palette == Palette::Categorical || info.palette == Palette::Verdict ||
           info.palette == Palette::ShadowVerdict || info.palette == Palette::Truth;
}

std::span<const BufferInfo, kBufferCount> bufferTable();
std::span<const BufferInfo, kDerivedCount> derivedTable();
const BufferInfo& bufferInfo(BufferId id);

// A buffer by name: "depth", "n_dot_l.0".
struct BufferName {
    BufferId id;
    int light = -1;  // only for buffers per light
    std::string text() const;
    bool operator==(const BufferName&) const = default;
};
// Nothing where there is no such buffer, or a light's index is missing or too many. Buffers of a frame.
std::optional<BufferName> findBuffer(std::string_view text);
std::optional<BufferName> findDerived(std::string_view text);
// Of a frame or derived: what a view can show and an export can write.
std::optional<BufferName> findAnyBuffer(std::string_view text);
// The nearest existing name, or all of them, for messages: as insteadOf() in pipeline/core/text.h.
std::string insteadOfBuffer(std::string_view text);
std::string insteadOfAnyBuffer(std::string_view text);  // derived ones too
// Every buffer a scene with this many lights can have, in the order of the stages.
std::vector<BufferName> allBuffers(std::size_t lights);
std::vector<BufferName> allDerived(std::size_t lights);

// Per light where it applies: wanting n_dot_l wants it of every light. Of a frame's buffers alone.
using BufferSet = std::bitset<kBufferCount>;
BufferSet setOf(std::initializer_list<BufferId> ids);

}  // namespace pipeline
