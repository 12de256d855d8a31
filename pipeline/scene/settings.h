#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include "pipeline/core/forms.h"
#include "pipeline/defects/defect.h"
#include "pipeline/scene/rules.h"

namespace pipeline {

// What the stages compute in: 24, 53, 64 (113 where long double has as many) and 113 bits of significand. Extended and
// quad are references for the rounding errors of the others, many times slower.
enum class Precision : std::uint8_t { Float, Double, Extended, Quad };
constexpr int bytesOf(Precision precision) {
    return precision == Precision::Float ? 4 : precision == Precision::Double ? 8 : 16;
}
// In which operations. Exact: those of IEEE 754 alone, in float and double the same bits on every machine; extended and
// quad take elementary functions of a library. Fast: multiplying and adding at
// once, and roots estimated, where pixels are shaded in vectors (pipeline/simd); within 1/255 of the picture in exact
// arithmetic, its bits those of the machine.
enum class Arithmetic : std::uint8_t { Exact, Fast };
enum class CullMode : std::uint8_t { None, Back };
enum class Shading : std::uint8_t { Flat, Gouraud, Phong };
// What intensities and normals are interpolated with; pipeline/stages/vertex_weights.h.
enum class Interpolation : std::uint8_t { Perspective, Affine, Scanline };
// The illumination models; pipeline/scene/model_facts.h says what is known of each.
enum class Model : std::uint8_t { Phong, BlinnPhong, OpenGl, CookTorrance };
inline constexpr std::size_t kModelCount = 4;
// Given: the mesh's own normals where it has them, else Mean.
enum class NormalWeight : std::uint8_t { Mean, Area, Angle, Given };
// How z_view becomes the number that the z-buffer stores and compares.
//   Linear    z_view itself, world units, infinity where nothing was drawn
//   Float     0 at the near plane, 1 at the far plane, as OpenGL's perspective matrix maps it
//   Reversed  1 at the near plane, 0 at the far plane
//   Fixed16, Fixed24, Fixed32   as Float, rounded to a multiple of 1 / (2^bits - 1)
//   Half, ReversedHalf          as Float and Reversed, in 16-bit floats
//   Infinite  reversed with the far plane at infinity: near / z_view; what lies behind the scene's own far plane is
//             clipped all the same
// Float, Reversed and Infinite are 32-bit floats in every precision.
enum class DepthFormat : std::uint8_t {
    Linear,
    Float,
    Reversed,
    Fixed16,
    Fixed24,
    Fixed32,
    Half,
    ReversedHalf,
    Infinite
};
constexpr bool isReversed(DepthFormat format) {
    return format == DepthFormat::Reversed || format == DepthFormat::ReversedHalf || format == DepthFormat::Infinite;
}
// Where the samples of a pixel stand; pipeline/stages/sample_pattern.h.
enum class SamplePattern : std::uint8_t { Grid, Jittered, Random, Hammersley };
// How it is decided what is seen.
//   ZBuffer   the nearest fragment of every pixel
//   Painter   polygons are painted from the farthest to the nearest
//   None      nothing is decided: every polygon's outline
enum class Visibility : std::uint8_t { ZBuffer, Painter, None };
// In which order translucent surfaces are laid over what is behind them.
//   Exact     by depth, at every pixel
//   Polygons  by the mean depth of the polygons, the farthest first
enum class Translucency : std::uint8_t { Exact, Polygons };
// Which triangles shadow buffers leave out, by the way they face the light.
//   None   none of them
//   Back   those that face away: of a closed object the others hide them
//   Front  those that face it: what is lit is compared with the far side of its object
// Y. Wang and S. Molnar, "Second-depth shadow mapping", University of North Carolina, TR94-019, 1994.
enum class ShadowCull : std::uint8_t { None, Back, Front };
enum class ShadowBias : std::uint8_t { Automatic, Constant, Slope };

// How a scene is rendered. Every member has a row in settings_table.cpp.
struct Settings {
    int width = 640, height = 480;  // pixels
    Precision precision = Precision::Float;
    Arithmetic arithmetic = Arithmetic::Exact;
    int antialiasing = 1;  // samples along a side of a pixel
    SamplePattern antialiasingPattern = SamplePattern::Grid;
    CullMode cull = CullMode::Back;
    Shading shading = Shading::Flat;
    Interpolation interpolation = Interpolation::Perspective;
    Model model = Model::Phong;
    double exponentFactor = 1;  // Blinn-Phong: multiplies n; about 4 gives a highlight as wide as Phong's
    bool localViewer = false;   // OpenGL: V points to the eye; off: along the viewing axis
    bool twoSided = false;      // back faces are lit with their normal turned round
    NormalWeight normalWeight = NormalWeight::Mean;
    Visibility visibility = Visibility::ZBuffer;
    bool split = true;  // Painter: polygons that intersect or overlap in a cycle are split
    DepthFormat depthFormat = DepthFormat::Linear;
    Translucency translucency = Translucency::Exact;
    int shadowSize = 1024;  // texels along a side of a shadow buffer
    ShadowCull shadowCull = ShadowCull::None;
    ShadowBias shadowBias = ShadowBias::Automatic;
    double shadowBiasValue = 0;  // Constant: world units; Slope: factor of the closed-form bias
    int shadowFilter = 0;        // percentage-closer filtering over (2r+1)^2 texels
    Forms forms{};               // of formulas that can be written in several ways
    int subPixelBits = 8;        // polygons' corners are snapped to 2^-bits pixels
    bool leaveOut = true;        // false switches every rule off: everything runs, the picture is the same
    RuleSet rules = RuleSet().set();
    Defect defect = Defect::None;  // planted on purpose: the picture is wrong
    int defectWay = 0;             // which of the ways of making it, from 0
    // A student's function in the place of one of the pipeline's; planted for one frame, see FrameRequest. No text has it.
    std::shared_ptr<const Own> own{};
    bool isPlanted() const { return defect != Defect::None || own; }
    bool operator==(const Settings&) const = default;
};

// The rules that are in force. With a defect, or a student's function, none: that they change no bit is proved of the right pipeline alone.
inline RuleSet rulesOf(const Settings& settings) {
    return settings.leaveOut && !settings.isPlanted() ? settings.rules : RuleSet();
}

}  // namespace pipeline
