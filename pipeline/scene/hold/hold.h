#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/scene/scene.h"
#include "pipeline/scene/settings_table.h"

// What a hand can move in a picture: a lamp, the eye, an object, a number. A hold has no value of its own: its values are
// settings, and its place follows from the scene, so that it never waits for a frame.

namespace pipeline {

struct Hold {
    enum class Kind : std::uint8_t {
        LampAtInfinity,  // around `point`; its distance from it in the picture is the angle between L and the line of sight
        LampFoot,        // of a light at a place: below it, in the plane z = 0
        LampTop,         // the same light, up and down
        Eye,             // around what the camera looks at, at an equal distance
        Turn,            // an object about `axis` through `point`, by its surface
        Along,           // an object along `axis`
        Vertex,  // of an object, in a plane through it: the picture's, or where `axis` is not 0 one of the object's own
        Rim,     // of the highlight of a ball, where the cosine to the power of n has fallen to a half
        Number   // any number, on a track
    };
    Kind kind = Kind::Number;
    std::size_t index = 0;          // of the light or the object
    std::vector<std::string> keys;  // of the settings that it sets, one to three
    Vec3d point{0.0};     // world space; of Along the translation at 0, of Vertex its object's middle, object space
    Vec3d axis{0, 0, 1};  // world space, unit; of Vertex object space
    double low = 0, high = 0;  // of Along, world units along `axis`; of Vertex the most off `point`; else inclusive
    std::string name;          // "Lamp"
    std::string symbol;        // "n", for "n = 0.05"; may be empty
    std::size_t vertex = 0;    // of Vertex, its number in its mesh
    bool turnsOver = false;    // of Vertex: its polygons may turn over in the picture
    bool operator==(const Hold&) const = default;
};
std::string_view name(Hold::Kind kind);  // "lamp", "foot", "top", "eye", "turn", "along", "vertex", "rim", "number"
bool movesObject(const Hold& hold);      // by dragging its surface
bool hasEnds(const Hold& hold);          // it goes from `low` to `high`
// A number that spans a factor of 50 and more has a track of equal factors.
bool isLogarithmic(const Hold& hold);

// Pixels of the picture, row 0 on top; of Number x and y are the share of its track, 0 to 1, and of Eye nothing.
struct HoldPlace {
    glm::dvec2 at{0.0};
    bool isBehind = false;  // a lamp behind what it goes around
};
// Nothing where it is behind the eye.
std::optional<HoldPlace> placeOf(const Scene& scene, const Hold& hold);

using Assignments = std::vector<std::pair<std::string, double>>;        // key and value
std::string toText(const Assignments& assignments);                     // "light.0.x=1; light.0.y=0"
Result<Scene> withSettings(Scene scene, std::string_view assignments);  // the same back into settings; not yet checked
Assignments valuesOf(const Scene& scene, const Hold& hold);             // as they are now

// Values that a drag gives which began at `from` in `start` and is at `to` now, pixels of the picture (shares of the track
// of a number): what was under the pointer stays under it. Always finite and within the hold's limits; coarse: in large steps.
Assignments valuesAt(const Scene& start, const Hold& hold, glm::dvec2 from, glm::dvec2 to, bool coarse = false);
// By arrow keys: by.x to the right, by.y downwards.
Assignments nudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse);
// Its value, as it stands beside the pointer: "θ 20° φ 60°", "n = 0.05", "2 pieces".
std::string wordsOf(const Scene& scene, const Hold& hold);

// Where a point of world space is in the picture, pixels; nothing where it is not in front of the eye.
struct View;
std::optional<glm::dvec2> projected(const View& view, Vec3d world);

}  // namespace pipeline
