#include "pipeline/compare/handed_in/values.h"
#include "pipeline/core/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "pipeline/core/angles.h"

namespace pipeline::foreign {

namespace {

using B = BufferId;
using M = Measure;
using Of = Tolerance::Of;

constexpr std::array kTolerances{
    Tolerance{B::VerticesWorld, M::Distance, 1e-4, Of::Scene, "world units"},
    Tolerance{B::VerticesView, M::Distance, 1e-4, Of::Scene, "world units"},
    Tolerance{B::VerticesScreen, M::Distance, 0.01, Of::Unit, "px"},
    Tolerance{B::PolygonsVerdict, M::Same, 0, Of::Unit, ""},
    Tolerance{B::PolygonsNormal, M::Angle, 0.5, Of::Unit, "\u00b0"},
    Tolerance{B::VerticesNormal, M::Angle, 0.5, Of::Unit, "\u00b0"},
    Tolerance{B::ShadowBuffer, M::Largest, 2e-3, Of::Scene, "world units"},
    Tolerance{B::ZView, M::Largest, 1e-3, Of::DepthRange, "world units"},
    Tolerance{B::ObjectId, M::Same, 0, Of::Unit, ""},
    Tolerance{B::PolygonId, M::Same, 0, Of::Unit, ""},
    Tolerance{B::Overdraw, M::Largest, 0, Of::Unit, "fragments"},
    Tolerance{B::Position, M::Distance, 1e-3, Of::Scene, "world units"},
    Tolerance{B::Normal, M::Angle, 0.5, Of::Unit, "\u00b0"},
    Tolerance{B::ViewVector, M::Angle, 0.5, Of::Unit, "\u00b0"},
    Tolerance{B::LightVector, M::Angle, 0.5, Of::Unit, "\u00b0"},
    Tolerance{B::ReflectionVector, M::Angle, 0.5, Of::Unit, "\u00b0"},
    Tolerance{B::HalfwayVector, M::Angle, 0.5, Of::Unit, "\u00b0"},
    Tolerance{B::NDotL, M::Largest, 0.005, Of::Unit, ""},
    Tolerance{B::RDotV, M::Largest, 0.005, Of::Unit, ""},
    Tolerance{B::NDotH, M::Largest, 0.005, Of::Unit, ""},
    Tolerance{B::Shadow, M::Largest, 0.05, Of::Unit, ""},
    Tolerance{B::Ambient, M::Largest, 0.005, Of::IMax, "intensity"},
    Tolerance{B::Diffuse, M::Largest, 0.005, Of::IMax, "intensity"},
    Tolerance{B::Specular, M::Largest, 0.005, Of::IMax, "intensity"},
    Tolerance{B::Emission, M::Largest, 0.005, Of::IMax, "intensity"},
    Tolerance{B::Intensity, M::Largest, 0.005, Of::IMax, "intensity"},
    Tolerance{B::Color, M::Largest, 2, Of::Unit, "of 255"},
};

double angle(const double* a, const double* b) {
    const Vec3d u(a[0], a[1], a[2]), v(b[0], b[1], b[2]);
    const double lengthU = glm::length(u), lengthV = glm::length(v);
    const double between = pipeline::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)) * 180 / std::acos(-1.0);
    const double longer = 100 * std::abs(lengthU - lengthV) / std::max(1.0, std::max(lengthU, lengthV));
    return std::max(between, longer);
}

}  // namespace

std::span<const Tolerance> toleranceTable() { return kTolerances; }

const Tolerance* toleranceOf(BufferId buffer) {
    const auto found = std::ranges::find(kTolerances, buffer, &Tolerance::buffer);
    return found == kTolerances.end() ? nullptr : &*found;
}

Values valuesOf(const AnyBuffer& buffer, const std::vector<std::uint8_t>& covered) {
    Values out{buffer.info->domain, buffer.rows(), buffer.columns(), buffer.channels(), {}, {}};
    std::visit([&](const auto& numbers) { out.numbers.assign(numbers.begin(), numbers.end()); }, buffer.data);
    out.there.assign(out.count(), 1);
    if (out.domain == Domain::Pixel && covered.size() == out.count()) out.there = covered;
    const std::vector<bool> placed = rowsWithValue(buffer);
    for (std::size_t i = 0; i < placed.size(); ++i) out.there[i] = placed[i];
    for (std::size_t i = 0; i < out.count(); ++i)
        for (int c = 0; c < out.channels; ++c)
            if (!std::isfinite(out.at(i)[c])) out.there[i] = 0;
    return out;
}

double differenceAt(Measure measure, const Values& mine, const Values& reference, std::size_t element) {
    return differenceBetween(measure, mine, element, reference, element);
}

double differenceBetween(Measure measure, const Values& mine, std::size_t element, const Values& reference,
                         std::size_t other) {
    if (!mine.there[element] || !reference.there[other]) return std::numeric_limits<double>::quiet_NaN();
    const double *a = mine.at(element), *b = reference.at(other);
    const int channels = std::min(mine.channels, reference.channels);
    switch (measure) {
        case Measure::Same: return a[0] == b[0] ? 0 : 1;
        case Measure::Angle: return angle(a, b);
        case Measure::Distance:
        case Measure::Largest: break;
    }
    double sum = 0, largest = 0;
    for (int c = 0; c < channels; ++c) {
        const double d = std::abs(a[c] - b[c]);
        sum += d * d, largest = std::max(largest, d);
    }
    return measure == Measure::Distance ? std::sqrt(sum) : largest;
}

}  // namespace pipeline::foreign
