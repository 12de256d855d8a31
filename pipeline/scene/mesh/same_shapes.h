#pragma once
#include <memory>
#include <vector>

#include "pipeline/scene/mesh/shape.h"

namespace pipeline {

// While one lives, makeShape gives meshes that it has made before in this thread again: for work that goes over the same
// scene many times. They are freed with it.
class SameShapes {
public:
    SameShapes();
    ~SameShapes();
    SameShapes(const SameShapes&) = delete;
    SameShapes& operator=(const SameShapes&) = delete;

    // Null where this thread has none, or none that is known.
    static std::shared_ptr<const Mesh> find(const Shape& shape);
    static void keep(const Shape& shape, const std::shared_ptr<const Mesh>& mesh);

private:
    struct Made {
        Shape shape;
        std::shared_ptr<const Mesh> mesh;
    };
    SameShapes* m_outer;
    std::vector<Made> m_made;
};

}  // namespace pipeline
