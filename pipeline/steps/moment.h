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

// The size of a step. A stage without such parts uses its next larger ones: the cull stage has no pixels, so a step by
// pixel is a polygon there. A line is one of the stage's algorithm (pipeline/steps/algorithm.h).
enum class StepLevel : std::uint8_t { Stage, Object, Polygon, Scanline, Pixel, Line };
inline constexpr std::size_t kStepLevelCount = 6;
std::string_view name(StepLevel level);  // "stage", "object", "polygon", "scanline", "pixel", "line"
std::optional<StepLevel> findStepLevel(std::string_view name);

// A moment of a frame: all stages before `stage` have run, and this one has done `done` of its smallest steps, as
// pipeline/steps/steps.h counts them. At done = 0 the stage's buffers are cleared. Moments are ordered in time. The
// number of a moment means nothing in another frame, whose polygons cover other pixels; use a Place for that.
struct Moment {
    StageId stage = StageId::Transform;
    std::int64_t done = 0;
    // Inside the next smallest step: the line that is about to write, counted from 1 among the lines that the step
    // passes. The buffers are those after `done` steps. 0: between two steps.
    int line = 0;
    // The smallest step that the moment is in, or the last one that was done; -1 before the first.
    std::int64_t step() const { return line > 0 ? done : done - 1; }
    auto operator<=>(const Moment&) const = default;
};

// The kinds of elements that a stage works through in sequence.
enum class ElementKind : std::uint8_t {
    Vertex,
    Polygon,
    Piece,         // in the painter's order; a polygon may have several
    PolygonTerms,  // evaluated by flat shading before the first pixel
    VertexTerms,   // evaluated by Gouraud shading before the first pixel
    Layers,        // of all translucent surfaces
    Samples,       // of all pixels, for antialiasing
};
std::string_view name(ElementKind kind);  // as a place names it: "vertex", "polygon-terms"

// A moment by name: right after something. It is valid in any frame. If the frame has no such thing (the polygon is
// culled, or does not cover the row), it is the moment at which that would have been over.
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
    int light = -1;                           // of a shadow buffer; -1: the first light that casts shadows
    ElementKind kind = ElementKind::Polygon;  // What::Element
    std::int64_t number = 0;                  // of the object or element
    std::optional<int> row = {}, x = {};      // x only with a row
    std::optional<int> line = {};             // What::Element; of the algorithm, from 1
    int time = 1;                             // the number of the visit of that line
    bool operator==(const Place&) const = default;
};
std::string text(const Place& place);
// Errors say what was found and what is known.
Result<Place> parsePlace(std::string_view text);
// The same for text that somebody types: the scene must have the named light, object, polygon, vertex or pixel. Pieces
// are known only after the painter has ordered them.
Result<Place> parsePlace(std::string_view text, const Scene& scene);

}  // namespace pipeline
