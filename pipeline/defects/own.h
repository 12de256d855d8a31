#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/core/real.h"
#include "pipeline/core/stage.h"

namespace pipeline {

// The functions of the pipeline that a student may write, as the lectures print them. Each has a contract: what it is
// handed, what it returns, and which wrong answers have a name.
enum class OwnFunction : std::uint8_t {
    Place,
    Camera,
    Project,
    Cut,
    SignedArea,
    IsVisible,
    FacesEye,
    CalcNormal,
    PolygonNormal,
    VertexNormal,
    ScaledNormal,
    NormalColor,
    ToLight,
    ShadowFactor,
    Setpixel,
    IsInside,
    Weights,
    DepthAt,
    PerspectiveWeights,
    Intensity,
    IsPaintedFirst,
    DepthCode,
    LightVector,
    ViewVector,
    Lambert,
    Mirror,
    Specular,
    Halfway,
    Blinn,
    NormalAt,
    InShadow,
    Total,
    IMax,
    FrameBuffer,
    Blend,
    BlendLayers,
};
inline constexpr std::size_t kOwnCount = 36;
constexpr std::size_t index(OwnFunction function) { return static_cast<std::size_t>(function); }

// What a value is. A list is handed over with its count first, then its elements one after the other.
enum class OwnKind : std::uint8_t { None, Truth, Number, Point, Vector, Bytes, Numbers, Points, Vectors };
constexpr bool isList(OwnKind kind) { return kind >= OwnKind::Numbers; }
// How many numbers a value, or an element of a list, has: 1, 2 or 3.
std::size_t sizeOf(OwnKind kind);

struct OwnParameter {
    std::string_view name;
    OwnKind kind = OwnKind::None;
    std::string_view meaning;  // with unit or space
};

// The arguments of one call, found in its numbers.
class OwnArguments {
public:
    // Nothing unless `in` has exactly the numbers that the parameters ask for.
    static std::optional<OwnArguments> read(std::span<const OwnParameter> parameters, std::span<const double> in);

    std::size_t count(std::size_t list) const { return std::size_t(m_in[m_first[list] - 1]); }
    double n(std::size_t i, std::size_t k = 0) const { return m_in[m_first[i] + k]; }
    glm::dvec2 p(std::size_t i, std::size_t k = 0) const { return {n(i, 2 * k), n(i, 2 * k + 1)}; }
    Vec3d v(std::size_t i, std::size_t k = 0) const { return {n(i, 3 * k), n(i, 3 * k + 1), n(i, 3 * k + 2)}; }

private:
    std::span<const double> m_in;
    std::array<std::size_t, 10> m_first{};  // of each argument; of a list its first element
};

// A result of up to three numbers; a truth is 1 or 0.
struct OwnValue {
    std::array<double, 3> at{};
    OwnValue() = default;
    OwnValue(bool truth) : at{truth ? 1.0 : 0.0} {}
    OwnValue(double x) : at{x} {}
    OwnValue(glm::dvec2 p) : at{p.x, p.y} {}
    OwnValue(Vec3d v) : at{v.x, v.y, v.z} {}
};
using OwnFormula = OwnValue (*)(const OwnArguments& a);

struct OwnMistake {
    std::string_view id, name;  // "normal-flip", "cross product in the wrong order"
    OwnFormula formula = nullptr;
};

// How far two results are apart. Distance and Largest: in the result's unit. Relative: as a share of the right one.
// Angle: degrees, or 100 times the difference of the lengths over the larger length or 1, whichever is more.
// Same: 0 or 1.
enum class OwnMeasure : std::uint8_t { Same, Distance, Relative, Largest, Angle };

struct OwnContract {
    OwnFunction id;
    std::string_view name;  // "CalcNormal"
    StageId stage;
    std::array<OwnParameter, 10> parameters;  // the first with a name
    OwnKind returns;
    std::string_view result;  // "unit vector"
    OwnMeasure measure;
    double tolerance;
    bool picture;  // the rest of the pipeline goes on with its results
    std::string_view lesson, heading;
    std::string_view asked;  // which scenes call it, after "It is called"
    std::string_view hint;
    OwnFormula right;
    std::array<OwnMistake, 3> mistakes;

    std::span<const OwnParameter> taken() const;
    std::size_t size() const { return sizeOf(returns); }
};
const OwnContract& ownContract(OwnFunction function);
std::optional<OwnFunction> findOwn(std::string_view name);  // "CalcNormal"
// Of the calls of one row; zeros for numbers that are no call.
OwnValue valueOf(const OwnContract& contract, OwnFormula formula, std::span<const double> in);
// CalcNormal(v0, v1, v2)
std::string signatureOf(const OwnContract& contract);

// Where in the scene a call belongs: a vertex, a polygon, a pixel (x + y · width), or nothing that is known there.
enum class OwnPlace : std::uint8_t { Unknown, Vertex, Polygon, Pixel };

// A function in the place of one of the pipeline's. call: may come from several threads; writes as many numbers as the
// contract's result has. What is not finite counts as 0, as with planted defects.
struct Own {
    OwnFunction function;
    std::function<void(OwnPlace kind, std::size_t place, std::span<const double> in, std::span<double> out)> call;
};

}  // namespace pipeline
