#pragma once
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "pipeline/buffers/buffer2d.h"
#include "pipeline/core/real.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// The shadow factor of a frame, pixel by pixel, against exact rays to the light: where a shadow buffer is right, and
// the two ways in which it is wrong. A light of which half or more is seen counts as lit.
enum class ShadowVerdict : std::int8_t {
    Lit,       // both say so
    Shadowed,  // both say so
    Acne,      // false shadow: rays reach the light, the frame has a shadow
    Leak,      // false light: rays are blocked, the frame has light
};
inline constexpr std::size_t kShadowVerdictCount = 4;
struct ShadowVerdictInfo {
    std::string_view name;     // "acne"
    std::string_view meaning;  // "false shadow: …"
};
std::span<const ShadowVerdictInfo, kShadowVerdictCount> shadowVerdictTable();  // in the order of the enumerators

// Why a light has no such map in a scene, one sentence; empty where it has one.
std::string whyNoShadowVerdicts(const Scene& scene, std::size_t light);

// What the rays say, for every pixel: through its centre to the first polygon, from there to the light. It holds as
// long as no surface, camera or light changes, whatever the shadow buffers' settings are.
struct ExactShadows {
    std::size_t light = 0;
    Buffer2D<std::int32_t> object;  // seen at the pixel's centre, index into Scene::objects; -1: none
    Buffer2D<float> seen;           // what part of the light is seen from there, 0 to 1
};
// share: of what is done, 0 to 1; called on any thread.
using RayProgress = std::function<void(double share)>;
// whyNoShadowVerdicts is empty. threads 0: as many as the machine has. Nothing when it was stopped.
std::optional<ExactShadows> exactShadows(const Scene& scene, std::size_t light, int threads, Stop stop = {},
                                         const RayProgress& progress = {});
// Whether the rays of one scene are those of the other: they differ in settings of the shadow buffers at most.
bool haveSameRays(const Scene& a, const Scene& b);

struct ShadowVerdicts {
    std::size_t light = 0;
    Buffer2D<std::int32_t> verdicts;  // -1 where nothing is drawn, or elsewhere
    std::array<std::size_t, kShadowVerdictCount> counts{};
    std::size_t elsewhere = 0;  // drawn pixels at whose centre a ray meets another object: at outlines

    std::size_t judged() const;             // pixels with a verdict
    double percent(ShadowVerdict v) const;  // of those; 0 where there are none
};
// exact: of the frame's scene, or of one with the same rays. The frame holds shadow.k of that light; nothing where it
// does not.
std::optional<ShadowVerdicts> judgeShadows(const Frame& frame, const ExactShadows& exact);

// The buffer shadow_verdict.k: {H, W} int32, -1 where there is no verdict.
AnyBuffer bufferOf(const ShadowVerdicts& verdicts);

}  // namespace pipeline
