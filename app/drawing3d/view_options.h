#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

#include "pipeline/inspect/formula.h"

namespace app {

enum class NormalsShown { Off, Polygons, Vertices };
// What the faces are coloured by: as the frame buffer has them, or (N + 1) / 2 as red, green and blue.
enum class FacesShown { Shaded, Normals };
// What the normals' arrows are coloured by: all as N, or each by its own direction, (N + 1) / 2.
enum class NormalColors { OfN, Direction };

// What the handle of an object changes.
enum class HandleTool { Move, Turn, Scale };

constexpr int kSparsestNormals = 100000;
// Arrows that are drawn at most: more cover what they stand on, and take longer to draw than all else.
constexpr std::size_t kMostNormals = 10000;

// What of a ViewContent is drawn, and how large. Lengths are in pixels of the design, which grow with the letters.
struct ViewOptions {
    NormalsShown normals = NormalsShown::Polygons;
    double normalLength = 40;   // 4 to 400
    int everyNormal = 1;        // every k-th, k from 1 to kSparsestNormals
    double vectorLength = 130;  // 4 to 400
    bool vectors = true, lights = true, eye = true;
    FacesShown faces = FacesShown::Shaded;
    bool boxes = false, spheres = false;          // around every object
    bool frustum = false;                         // of the scene's camera, between near and far plane
    bool projection = false, reflection = false;  // at the point: (N·L)N, and how it makes R
    NormalColors normalColors = NormalColors::OfN;
    bool handles = true;  // of lights, camera and objects
    HandleTool objectTool = HandleTool::Move;
    bool lobe = false;                                              // of the specular term, at the point
    bool lightFrusta = false;                                       // what the lights see, with their shadow buffers
    std::array<bool, 6> shown{true, true, true, true, true, true};  // by VectorCode

    bool shows(pipeline::VectorCode code) const { return vectors && shown[static_cast<std::size_t>(code)]; }
    // Of so many arrows every k-th is drawn.
    std::size_t everyOf(std::size_t arrows) const {
        return std::max(std::size_t(everyNormal), (arrows + kMostNormals - 1) / kMostNormals);
    }
    bool operator==(const ViewOptions&) const = default;
};

}  // namespace app
