#pragma once
#include <cstddef>

namespace pipeline {

// What opening a file may build. A few words may ask for a fine shape, and name a mesh again and again: what is built is
// counted before it is, against what was read, so that 64 KiB take less than a second and 256 MiB.
class ReadBudget {
public:
    static constexpr std::size_t kPiece = std::size_t{64} << 10;  // bytes
    // Of 104 bytes each, with their normals, quadrilaterals and triangles: 234 MiB. The finest shape has 2 113 568.
    static constexpr std::size_t kVerticesPerPiece = std::size_t{9} << 18;

    static std::size_t mostVertices(std::size_t bytes) { return (bytes / kPiece + 1) * kVerticesPerPiece; }

    void addRead(std::size_t bytes) { m_read += bytes; }
    // Counts vertices that are about to be built; false where they are too many.
    bool mayBuild(std::size_t vertices) {
        m_built += vertices;
        return m_built <= most();
    }
    std::size_t built() const { return m_built; }
    std::size_t most() const { return mostVertices(m_read); }

private:
    std::size_t m_read = 0, m_built = 0;
};

}  // namespace pipeline
