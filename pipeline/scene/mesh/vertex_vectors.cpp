#include "pipeline/scene/mesh/vertex_vectors.h"

#include <algorithm>

namespace pipeline {
namespace {

bool isInFloat(const Vec3d& v) { return Vec3d(Vec3<float>(v)) == v; }

}  // namespace

void VertexVectors::set(std::size_t i, const Vec3d& v) {
    if (!isInFloat(v)) widen();
    std::visit([&](auto& of) { of[i] = v; }, m_of);
}

void VertexVectors::push_back(const Vec3d& v) {
    if (!isInFloat(v)) widen();
    std::visit([&](auto& of) { of.emplace_back(v); }, m_of);
}

void VertexVectors::widen() {
    const auto* narrow = std::get_if<Narrow>(&m_of);
    if (!narrow) return;
    Wide wide;
    wide.reserve(narrow->capacity());
    wide.assign(narrow->begin(), narrow->end());
    m_of = std::move(wide);
}

void VertexVectors::shrink_to_fit() {
    if (const auto* wide = std::get_if<Wide>(&m_of); wide && std::ranges::all_of(*wide, isInFloat))
        m_of = Narrow(wide->begin(), wide->end());
    std::visit([](auto& of) { of.shrink_to_fit(); }, m_of);
}

void VertexVectors::dropSignsOfZero() {
    std::visit(
        [](auto& of) {
            for (auto& v : of) v += typename std::remove_reference_t<decltype(v)>::value_type(0);
        },
        m_of);
}

bool VertexVectors::operator==(const VertexVectors& other) const {
    if (m_of.index() == other.m_of.index()) return m_of == other.m_of;
    return std::ranges::equal(*this, other);
}

}  // namespace pipeline
