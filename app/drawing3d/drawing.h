#pragma once
#include <QColor>
#include <QPointF>
#include <optional>
#include <string>
#include <vector>

#include "app/drawing3d/arrow_shape.h"
#include "app/drawing3d/orbit_camera.h"
#include "app/look/theme.h"

namespace app {

// What a mark is drawn in; the theme gives the colour.
enum class Ink : unsigned char { N, L, V, R, H, Grid, Edge, Outline, Text, Hint };
Ink inkOf(VectorCode code);
QColor colorOf(Ink ink, const ThemeColors& colors);
QColor mixed(const QColor& a, const QColor& b, double shareOfA);
inline QPointF toPoint(glm::dvec2 p) { return {p.x, p.y}; }

// Decimals that leave a number three digits, as lengths are read; more before the point stay.
int decimalsOf(double value);
std::string threeDigits(double value);  // "719", "0.0719"

struct InkedSolid {
    Ink ink;
    Solid solid;
    double unit = 1;      // world units per pixel of the design where it stands
    double strength = 1;  // 1 full, 0 gone into the background
};

struct Segment {
    Vec3d a, b;
};

// A line, a little over 1 pixel of the design wide. Its ends may fade into the background: 1 full, 0 gone.
struct InkedLine {
    Vec3d a, b;
    Ink ink = Ink::Edge;
    float strengthA = 1, strengthB = 1;
};

// Words that stand beside a point.
struct Label {
    enum class Kind : unsigned char {
        Letter,   // of a vector, beside its tip, away from `foot`
        Axis,     // x, y, z
        Note,     // words on a point
        Angle,    // beside the middle of its arc
        Plane,    // words beside a corner, away from `foot`
        Caption,  // of a mark; at the border with its distance where the mark lies outside the view
    };
    Kind kind = Kind::Letter;
    Vec3d at, foot;
    std::string text;
    std::string distance;  // ", 719 units away"; for a caption at the border
    Ink ink = Ink::Text;
    double strength = 1;
};

// What words had better not lie on: points of something convex, or the two ends of a line.
using Obstacle = std::vector<Vec3d>;

// The light parts of a 3D view: what keeps its size in pixels and so depends on the camera.
struct Drawing {
    std::vector<InkedLine> lines;
    std::vector<InkedSolid> solids;   // hidden by what stands before them
    std::vector<InkedSolid> vectors;  // shine through faintly where they are hidden
    std::vector<Label> labels;
    std::vector<Obstacle> obstacles;  // beside lines and labels
    struct Marker {
        Vec3d at;
        bool hidden = false;  // something stands before it
    };
    std::optional<Marker> point;  // what the picked pixel shows
    std::optional<Marker> foot;   // where the vectors start
    std::optional<Vec3d> vertex;  // what is selected
};

// While another view points at some of the vectors: the other ones faint, at 35 %. None: as it is.
void dimAllBut(const std::vector<VectorCode>& codes, Drawing& drawing);

// The view that a drawing is made for.
struct ViewFrame {
    OrbitCamera camera;
    glm::dvec2 size{640, 480};  // logical pixels
    double scale = 1;           // of all marks, as of the letters beside them: logical pixels a pixel of the design

    // World units that a pixel of the design spans at the camera's target.
    double unitsPerMarkPixel() const { return scale * camera.unitsPerPixel(size.y); }
};

}  // namespace app
