#pragma once
#include <memory>
#include <vector>

#include "pipeline/run/frame.h"

namespace bench {

// How the triangles lie in OpenGL's memory: a vertex once with indices to it, or once for each triangle that has it.
enum class Geometry : std::uint8_t { Indexed, Unshared };

// A frame of ours drawn with OpenGL: the same triangles, camera, light, material, normals and shadow buffer's view, lit
// per fragment in a shader (without a colour where the frame has none). Needs a current context; compiles and uploads
// when made.
class GlScene {
public:
    static std::unique_ptr<GlScene> make(const pipeline::Frame& frame, Geometry geometry, std::string& whyNot);
    virtual ~GlScene() = default;
    // Clears, draws (the shadow buffer first where there is one), and waits until it is done.
    virtual void draw() = 0;
    // What was drawn, row 0 on top; depth in [0, 1].
    virtual std::vector<pipeline::Color8> color() = 0;
    virtual std::vector<float> depth() = 0;
};

}  // namespace bench
