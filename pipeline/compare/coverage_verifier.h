#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

// What any correct rasterizer may do with a sample of a triangle. Shares no code with the stages: it judges them.
namespace pipeline::foreign {

// Of a sample: every correct rasterizer covers it; none does; either is right.
enum class Coverage : std::uint8_t { Forced, Forbidden, Free };

// Where a rasterizer may put a vertex before it decides coverage, for a grid with steps of 2^-bits pixels.
//   Nearest  the nearest point of the grid; of two equally near ones either, in each coordinate by itself
//   Within   anywhere between the grid's points around it: any rounding, any finer grid, or no grid at all
enum class Snapping : std::uint8_t { Nearest, Within };

// One triangle, given by its vertices in the picture: pixels, x right, y down, row 0 on top.
//
// What is exact: every finite float and double is a whole number of steps of 2^-16 pixel and a rest, and both are found
// without rounding, because scaling by 2^16, floor and the difference to it are exact in double. From there on everything
// is an integer. A coordinate is at most 2^40 pixels, so that an edge function stays below 2^117 and fits 128 bits. The
// vertices themselves are taken as exact: who computes them in float passes its own floats, not the ones it should have.
//
// The fill rule is free: a sample on an edge of a snapped triangle is Free, unless another choice decides it. A snapped
// triangle without area covers nothing. Winding does not matter; culling is not decided here.
class CoverageVerifier {
public:
    static constexpr double kReach = 0x1p40;  // pixels

    // Nothing where a coordinate is not finite or beyond kReach. 1 <= bits <= 16.
    static std::optional<CoverageVerifier> make(const std::array<glm::dvec2, 3>& vertices, int bits,
                                                Snapping snapping = Snapping::Nearest);

    // Of a pixel's sample; `at`: where it is in the pixel, in pixels from its upper left, a multiple of 2^-16.
    Coverage at(glm::ivec2 pixel, glm::dvec2 at = {0.5, 0.5}) const;

    // The pixels outside of which every sample is Forbidden: first, and one past the last, in x and y. Beyond the range of
    // int the nearest that is in it.
    glm::ivec2 first() const { return m_first; }
    glm::ivec2 end() const { return m_end; }

private:
    struct Point {
        std::int64_t x, y;  // steps of 2^-16 pixel
    };
    // Where a vertex may be: 1, 2 or 4 points.
    struct Choices {
        std::array<Point, 4> points{};
        std::size_t count = 0;
        const Point* begin() const { return points.data(); }
        const Point* end() const { return points.data() + count; }
    };
    std::array<Choices, 3> m_choices;
    Snapping m_snapping = Snapping::Nearest;
    glm::ivec2 m_first{0}, m_end{0};
};

}  // namespace pipeline::foreign
