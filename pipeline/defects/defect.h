#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pipeline {

// The classic errors of renderers, planted on purpose: what each is stands in pipeline/defects/defect_table.h.
enum class Defect : std::uint8_t {
    None,
    TrsOrder,
    Radians,
    YDown,
    Winding,
    CullSign,
    CullAxis,
    NearDrop,
    NormalFlip,
    NormalMatrix,
    NormalShort,
    ShadowSpace,
    ShadowFlip,
    NoBias,
    BigBias,
    ZClear,
    ZFlip,
    ZNoWrite,
    ZAffine,
    Affine,
    NearSmall,
    LRaw,
    LightFrom,
    LightInEye,
    NoMax,
    SpecBehind,
    RFlip,
    HRaw,
    EyeAtOrigin,
    AmbientInShadow,
    AmbientPerLight,
    KsKd,
    FadeTwice,
    Integer,
    BlocksOfFour,
    Wrap,
    Gamma,
    Unsorted,
    NormalSpace,
    ClipNormals,
    HalfAngle,
    OneBased,
    Degrees,
    NoScale,
    Bgr,
    HalfPixel,
    Exponent,
    NoAmbient,
    NoSpecular,
    Aspect,
};
constexpr std::size_t index(Defect defect) { return static_cast<std::size_t>(defect); }

// What the setting `defect` calls them, in the order of the enumerators.
inline constexpr auto kDefectIds = std::to_array<std::string_view>({
    "none",
    "trs-order",
    "radians",
    "y-down",
    "winding",
    "cull-sign",
    "cull-axis",
    "near-drop",
    "normal-flip",
    "normal-matrix",
    "normal-short",
    "shadow-space",
    "shadow-flip",
    "no-bias",
    "big-bias",
    "z-clear",
    "z-flip",
    "z-no-write",
    "z-affine",
    "affine",
    "near-small",
    "l-raw",
    "light-from",
    "light-in-eye",
    "no-max",
    "spec-behind",
    "r-flip",
    "h-raw",
    "eye-at-origin",
    "ambient-in-shadow",
    "ambient-per-light",
    "ks-kd",
    "fade-twice",
    "integer",
    "blocks-of-four",
    "wrap",
    "gamma",
    "unsorted",
    "normal-space",
    "clip-normals",
    "half-angle",
    "one-based",
    "degrees",
    "no-scale",
    "bgr",
    "half-pixel",
    "exponent",
    "no-ambient",
    "no-specular",
    "aspect",
});
inline constexpr std::size_t kDefectCount = kDefectIds.size();
static_assert(kDefectCount == index(Defect::Aspect) + 1);
// Why no rule acts and no kernel draws.
inline constexpr const char* kDefectIsPlanted = "A defect is planted.";
constexpr std::string_view idOf(Defect defect) { return kDefectIds[index(defect)]; }

struct Own;  // pipeline/defects/own.h

// A defect as the inputs of a stage hold it: none, but in the stage whose text it changes.
struct Planted {
    Defect defect = Defect::None;
    std::uint8_t way = 0;  // which of the row's ways of making it
    double value = 0;      // what the error takes from the scene: of z-clear a depth, world units
    double second = 0;
    const Own* own = nullptr;  // a function in the place of one of the stage's, which the scene's settings keep
    constexpr explicit operator bool() const { return defect != Defect::None || own; }
    bool operator==(const Planted&) const = default;
};

}  // namespace pipeline
