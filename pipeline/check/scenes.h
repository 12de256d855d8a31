#pragma once
#include <array>
#include <cmath>
#include <initializer_list>
#include <random>
#include <span>
#include <vector>

#include "pipeline/run/runner.h"
#include "pipeline/scene/scene.h"

// What the cases build their inputs from, and read their answers with.
namespace pipeline::check {

// References are computed in it: 64 bits of significand where double has 53, or more.
using Long = long double;
using Long3 = glm::vec<3, Long>;

inline constexpr auto kModels = [] {
    std::array<Model, kModelCount> all{};
    for (std::size_t i = 0; i < kModelCount; ++i) all[i] = Model(i);
    return all;
}();

using Polygons = std::vector<std::vector<std::uint32_t>>;
using Corners = std::array<Vec3d, 3>;
std::shared_ptr<const Mesh> meshOf(VertexVectors positions, const Polygons& polygons);
// Each with three vertices of its own.
std::shared_ptr<const Mesh> trianglesOf(std::span<const Corners> triangles);
// The cube low..high in all three directions, its faces outward.
std::shared_ptr<const Mesh> boxMesh(double low, double high);
// The regular grid of cells × cells quadrilaterals over [x0, x1] × [y0, y1] in the plane z.
std::shared_ptr<const Mesh> gridMesh(int cells, Vec3d low, Vec3d high);

Object objectOf(std::shared_ptr<const Mesh> mesh, Material material = {});
// One light at infinity towards which +z looks, grey material, double precision, every polygon kept.
Scene litScene(std::vector<std::shared_ptr<const Mesh>> meshes);
// Orthographic, a pixel a world unit: (0, 0) is the lower left corner of the picture, seen from +z. World positions
// that are multiples of 1/256 fall on the sub-pixel grid exactly.
Scene pixelScene(int width, int height, std::vector<std::shared_ptr<const Mesh>> meshes);
// Perspective from (0, 0, distance) towards the origin, y up, 64 × 64.
Scene frontScene(double distance, std::vector<std::shared_ptr<const Mesh>> meshes);

double numberOf(const FramePtr& frame, BufferName name, std::size_t i);
Vec3d vectorOf(const FramePtr& frame, BufferName name, std::size_t i);
// Pixels in which something was drawn.
std::size_t drawnPixels(const FramePtr& frame);
// Numbers of these buffers whose bits differ; all of a buffer that one frame lacks.
std::size_t differences(const FramePtr& a, const FramePtr& b, std::initializer_list<BufferId> compared);

// Between vectors of any length but 0; keeps its digits at every angle.
Long degreesBetween(Long3 a, Long3 b);
inline Long radians(Long degrees) { return degrees * 3.14159265358979323846264338327950288L / 180; }

// The same numbers with every library.
class Random {
public:
    explicit Random(unsigned seed) : m_bits(seed) {}
    double between(double low, double high) { return low + (high - low) * (double(m_bits()) / double(m_bits.max())); }
    int below(int limit) { return int(m_bits() % unsigned(limit)); }
    Vec3d inCube(double half) {
        const double x = between(-half, half), y = between(-half, half);
        return {x, y, between(-half, half)};
    }
    Vec3d direction();  // unit length within rounding

private:
    std::mt19937 m_bits;
};

// A wall without thickness at x = 16, 16 high, lit at 45 degrees: its shadow lies at 16 < x < 32.
Scene wallScene();

}  // namespace pipeline::check
