#pragma once
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/core/stage.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// How far one step goes. A stage that has no such parts takes its own next larger ones: the cull stage knows no
// pixels, and a step by pixel is a polygon there. A line is one of the stage's algorithm (pipeline/steps/algorithm.h).
enum class StepLevel : std::uint8_t { Stage, Object, Polygon, Scanline, Pixel, Line };
inline constexpr std::size_t kStepLevelCount = 6;
std::string_view name(StepLevel level);  // "stage", "object", "polygon", "scanline", "pixel", "line"
std::optional<StepLevel> findStepLevel(std::string_view name);

// A moment of a frame: all stages before `stage` have run, and this one has made `done` of its smallest steps, which
// pipeline/steps/steps.h counts. At done = 0 the stage's buffers are cleared. Ordered in time; numbers of one frame
// mean nothing in another, whose polygons cover other pixels: a Place does.
struct Moment {
    StageId stage = StageId::Transform;
    std::int64_t done = 0;
    // Inside the next smallest step: at which of the lines that it passes, from 1. The line is about to write: buffers
    // are those after `done` steps. 0: between two steps.
    int line = 0;
    // The smallest step that the moment is in or that was made last; -1 before the first.
    std::int64_t step() const { return line > 0 ? done : done - 1; }
    auto operator<=>(const Moment&) const = default;
};

// What a stage works through, one after the other.
enum class ElementKind : std::uint8_t {
    Vertex,
    Polygon,
    Piece,         // of the painter's order, which may come back to a polygon
    PolygonTerms,  // what flat shading evaluates before the first pixel
    VertexTerms,   // what Gouraud shading does
    Layers,        // of all translucent surfaces
    Samples,       // of all pixels, for antialiasing
};
std::string_view name(ElementKind kind);  // as a place has it: "vertex", "polygon-terms"

// A moment by name: right after something. It holds in any frame that has such a thing; where a frame has none (the
// polygon is culled, the row is not the polygon's), it is the moment at which that would have been over.
//   z-buffer                            the stage's end
//   z-buffer/start                      before its first step
//   z-buffer/object=0                   numbers as in the buffers, over all objects in the order of the scene
//   z-buffer/polygon=2/row=270/x=258    pixels, row 0 on top
//   z-buffer/piece=7                    painter: the place in the order of painting
//   transform/vertex=4, cull/polygon=1, normals/vertex=3, shadow-buffer/light=0/polygon=5
//   shading/polygon-terms=3, shading/vertex-terms=3, shading/polygon=2, shading/layers, shading/samples
//   z-buffer/polygon=2/row=270/x=258/line=5    in the last step of that, before line 5 of its algorithm writes; with several
//                                              lights the second time that it comes to the line: line=5/time=2
struct Place {
    enum class What : std::uint8_t { End, Start, Object, Element };
    StageId stage = StageId::Shading;
    What what = What::End;
    int light = -1;                           // of the shadow buffer; -1: of the first that casts shadows
    ElementKind kind = ElementKind::Polygon;  // What::Element
    std::int64_t number = 0;                  // of the object or element
    std::optional<int> row = {}, x = {};      // x only with a row
    std::optional<int> line = {};             // What::Element; of the algorithm, from 1
    int time = 1;                             // which of the step's passes of the line
    bool operator==(const Place&) const = default;
};
std::string text(const Place& place);
// Errors say what was found and what is known.
Result<Place> parsePlace(std::string_view text);
// The same, where the scene must have the light, the object, the polygon, the vertex or the pixel that is named: for
// what somebody types. Pieces are known when the painter has ordered them.
Result<Place> parsePlace(std::string_view text, const Scene& scene);

}  // namespace pipeline
