#pragma once
#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/plan/stage.h"

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
};
inline constexpr std::size_t kBufferCount = std::size_t(BufferId::Color) + 1;
constexpr std::size_t index(BufferId id) { return static_cast<std::size_t>(id); }

// What one row of a buffer stands for.
enum class Domain : std::uint8_t { Vertex, Polygon, Pixel, Texel };
// Real is float32, or float64 when the run is in double.
enum class Element : std::uint8_t { Real, Int32, UInt8 };
// How a value becomes a colour on the screen.
enum class Palette : std::uint8_t { Sequential, Diverging, Categorical, Verdict, Direction, Color };

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
};

std::span<const BufferInfo, kBufferCount> bufferTable();
const BufferInfo& bufferInfo(BufferId id);

// A buffer by name: "depth", "n_dot_l.0".
struct BufferName {
    BufferId id;
    int light = -1;  // only for buffers per light
    std::string text() const;
    bool operator==(const BufferName&) const = default;
};
// Nothing where there is no such buffer, or a light's index is missing or too many.
std::optional<BufferName> findBuffer(std::string_view text);
// The nearest existing name, for messages.
std::string nearestBuffer(std::string_view text);
// Every buffer a scene with this many lights can have, in the order of the stages.
std::vector<BufferName> allBuffers(std::size_t lights);

// Per light where it applies: wanting n_dot_l wants it of every light.
using BufferSet = std::bitset<kBufferCount>;
BufferSet setOf(std::initializer_list<BufferId> ids);

}  // namespace pipeline
