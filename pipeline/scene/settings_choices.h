#pragma once
#include <array>
#include <string_view>

#include "pipeline/scene/settings_rows.h"

// The words that choices among settings go by, and ranges that several settings share; settings_table.cpp alone reads
// it.
namespace pipeline::settings_choices {

inline constexpr std::array<std::string_view, 2> kSwitch{"off", "on"};
// In the order of the enumerators.
inline constexpr std::array<std::string_view, 4> kPrecision{"float", "double", "extended", "quad"};
inline constexpr std::array<std::string_view, 2> kArithmetic{"exact", "fast"};
inline constexpr std::array<std::string_view, 2> kCull{"none", "back"};
inline constexpr std::array<std::string_view, 3> kShading{"flat", "gouraud", "phong"};
inline constexpr std::array<std::string_view, 3> kInterpolation{"perspective", "affine", "scanline"};
inline constexpr std::array<std::string_view, 4> kNormalWeight{"mean", "area", "angle", "given"};
inline constexpr std::array<std::string_view, 3> kHighlight{"model", "phong", "blinn-phong"};
inline constexpr std::array<std::string_view, 2> kLightSpace{"world", "eye"};
inline constexpr std::array<std::string_view, 9> kDepthFormat{"linear",  "float", "reversed",      "fixed16", "fixed24",
                                                              "fixed32", "half",  "reversed-half", "infinite"};
inline constexpr std::array<std::string_view, 4> kPattern{"grid", "jittered", "random", "hammersley"};
inline constexpr std::array<std::string_view, 6> kPowerForm{"log1p", "pow", "squaring", "exp2", "schlick", "gaussian"};
inline constexpr std::array<std::string_view, 5> kUnitForm{"scaled", "direct", "estimate", "newton", "newton2"};
inline constexpr std::array<std::string_view, 3> kPolygonNormalForm{"newell", "from-origin", "three-corners"};
inline constexpr std::array<std::string_view, 2> kNormalMatrixForm{"cofactors", "inverse-transpose"};
inline constexpr std::array<std::string_view, 2> kCameraBasisForm{"angles", "cross-product"};
inline constexpr std::array<std::string_view, 2> kCornerAngleForm{"atan2", "acos"};
inline constexpr std::array<std::string_view, 3> kVisibility{"z-buffer", "painter", "none"};
inline constexpr std::array<std::string_view, 2> kTranslucency{"exact", "polygons"};
inline constexpr std::array<std::string_view, 3> kShadowCull{"none", "back", "front"};
inline constexpr std::array<std::string_view, 3> kShadowBias{"automatic", "constant", "slope"};
inline constexpr std::array<std::string_view, 2> kCameraKind{"spherical", "look-at"};
inline constexpr std::array<std::string_view, 2> kProjection{"perspective", "orthographic"};
inline constexpr std::array<std::string_view, 2> kUpAxis{"z", "y"};
inline constexpr std::array<std::string_view, 3> kLightKind{"at-infinity", "point", "area"};

// World units. With coordinates up to here a normal's squared length (an edge to the fourth
// power) is still a float; likewise for the smallest distances.
inline constexpr double kFar = 1e9, kNearest = 1e-9;
inline constexpr double kTurns = 1e6;  // degrees

using settings_rows::Range;
inline constexpr Range kPlace{-kFar, kFar, -1000, 1000};
inline constexpr Range kToward{-kFar, kFar, -1, 1};
inline constexpr Range kFading{0, kFar, 0, 2};
// Fractions, and above 0, in nature; a scene may have more or less. The largest products of an
// intensity, two colours and OpenGL's attenuation are still floats.
inline constexpr Range kFraction{-1000, 1000, 0, 1};
inline constexpr Range kIntensity{-kFar, kFar, 0, 200};
inline constexpr Range kAngle{-kTurns, kTurns, -180, 180};
inline constexpr Range kScale{-kFar, kFar, 0.1, 5};
inline constexpr Range kPlane{-kFar, kFar, 0, 2000};
inline constexpr Range kSide{1, 16384, 16, 4096};

}  // namespace pipeline::settings_choices
