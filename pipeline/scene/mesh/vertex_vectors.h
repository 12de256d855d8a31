#pragma once
#include <compare>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "pipeline/core/real.h"

namespace pipeline {

// A vector a vertex: places or normals of a mesh. They are those that were put in, to the last bit: kept in float, 12
// bytes each, while every number of them is one, as in binary files of most formats; else all of them in double, 24 bytes.
class VertexVectors {
public:
    VertexVectors() = default;
    VertexVectors(std::initializer_list<Vec3d> of) : VertexVectors(std::span<const Vec3d>(of.begin(), of.size())) {}
    VertexVectors(const std::vector<Vec3d>& of) : VertexVectors(std::span<const Vec3d>(of)) {}
    explicit VertexVectors(std::span<const Vec3d> of) {
        reserve(of.size());
        for (const Vec3d& v : of) push_back(v);
    }

    std::size_t size() const {
        return std::visit([](const auto& of) { return of.size(); }, m_of);
    }
    bool empty() const { return size() == 0; }
    // Const, so that nobody takes what it gives for a place of the list and writes to it.
    const Vec3d operator[](std::size_t i) const {  // NOLINT(readability-const-return-type)
        if (const auto* narrow = std::get_if<Narrow>(&m_of)) return Vec3d((*narrow)[i]);
        return (*std::get_if<Wide>(&m_of))[i];
    }
    std::vector<Vec3d> copy() const { return {begin(), end()}; }
    void set(std::size_t i, const Vec3d& v);
    void push_back(const Vec3d& v);
    void reserve(std::size_t count) {
        std::visit([&](auto& of) { of.reserve(count); }, m_of);
    }
    // What is added is 0.
    void resize(std::size_t count) {
        std::visit([&](auto& of) { of.resize(count); }, m_of);
    }
    void clear() { m_of = Narrow(); }
    // Also in float, where by now all of them are.
    void shrink_to_fit();
    // -0 becomes 0.
    void dropSignsOfZero();

    std::size_t bytes() const {  // that it has room for
        return std::visit([](const auto& of) { return of.capacity() * sizeof(of[0]); }, m_of);
    }

    // All of them, in the form that they are kept in; the other is empty.
    std::span<const Vec3<float>> floats() const {
        const auto* of = std::get_if<Narrow>(&m_of);
        return of ? std::span<const Vec3<float>>(*of) : std::span<const Vec3<float>>();
    }
    std::span<const Vec3d> doubles() const {
        const auto* of = std::get_if<Wide>(&m_of);
        return of ? std::span<const Vec3d>(*of) : std::span<const Vec3d>();
    }
    // All of them where they are kept in Real, else none.
    template <class Real>
    std::span<const Vec3<Real>> in() const {
        if constexpr (std::is_same_v<Real, float>) return floats();
        if constexpr (std::is_same_v<Real, double>) return doubles();
        return {};
    }

    class Iterator {
    public:
        using value_type = Vec3d;
        using reference = Vec3d;
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::random_access_iterator_tag;
        using iterator_category = std::input_iterator_tag;  // what it points at is no place of the list's

        Iterator() = default;
        Iterator(const VertexVectors* of, std::size_t at) : m_of(of), m_at(difference_type(at)) {}
        Vec3d operator*() const { return (*m_of)[std::size_t(m_at)]; }
        Vec3d operator[](difference_type n) const { return *(*this + n); }
        Iterator& operator++() { return *this += 1; }
        Iterator operator++(int) { return std::exchange(*this, *this + 1); }
        Iterator& operator--() { return *this -= 1; }
        Iterator operator--(int) { return std::exchange(*this, *this - 1); }
        Iterator& operator+=(difference_type n) { return m_at += n, *this; }
        Iterator& operator-=(difference_type n) { return m_at -= n, *this; }
        friend Iterator operator+(Iterator i, difference_type n) { return i += n; }
        friend Iterator operator+(difference_type n, Iterator i) { return i += n; }
        friend Iterator operator-(Iterator i, difference_type n) { return i -= n; }
        friend difference_type operator-(const Iterator& a, const Iterator& b) { return a.m_at - b.m_at; }
        friend bool operator==(const Iterator& a, const Iterator& b) { return a.m_at == b.m_at; }
        friend auto operator<=>(const Iterator& a, const Iterator& b) { return a.m_at <=> b.m_at; }

    private:
        const VertexVectors* m_of = nullptr;
        difference_type m_at = 0;
    };
    Iterator begin() const { return {this, 0}; }
    Iterator end() const { return {this, size()}; }

    bool operator==(const VertexVectors& other) const;

private:
    using Narrow = std::vector<Vec3<float>>;
    using Wide = std::vector<Vec3d>;
    void widen();

    std::variant<Narrow, Wide> m_of;
};

}  // namespace pipeline
