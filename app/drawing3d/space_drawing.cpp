#include "app/drawing3d/space_drawing.h"

#include <utility>

#include "app/drawing3d/aids_drawing.h"

namespace app {

namespace {

Label words(Vec3d at, Vec3d foot, std::string text, Ink ink) {
    return {.kind = Label::Kind::Plane, .at = at, .foot = foot, .text = std::move(text), .distance = {}, .ink = ink};
}

void addRectangle(const std::array<Vec3d, 4>& corners, Ink ink, std::vector<InkedLine>& lines) {
    for (std::size_t i = 0; i < 4; ++i) lines.push_back({corners[i], corners[(i + 1) % 4], ink, 1, 1});
}

}  // namespace

void addSpaceBox(const SpaceMap& map, Drawing& drawing) {
    const SpaceBox box = visibleBox(map);
    addBox({box.min, box.max}, Ink::V, drawing.lines);
    const Vec3d middle = (box.min + box.max) / 2.0;
    const Vec3d nearCorner = box.min, farCorner{box.min.x, box.max.y, box.min.z};
    const bool clip = map.space == ViewSpace::Clip;
    drawing.labels.push_back(words(nearCorner, middle, clip ? "near, z = −1" : "near, z = 0", Ink::V));
    drawing.labels.push_back(words(farCorner, middle, "far, z = 1", Ink::V));
}

void addWorldBox(const ViewContent& content, const pipeline::BoundingBox& box, Ink ink, std::vector<InkedLine>& lines) {
    std::vector<InkedLine> world;
    addBox(box, ink, world);
    const SpaceMap& map = content.map;
    for (InkedLine line : world) {
        if (!map.keepsLengths()) {
            double a = depthOf(map.view, line.a) - map.view.near, b = depthOf(map.view, line.b) - map.view.near;
            if (a < 0 && b < 0) continue;
            if (a < 0) line.a = glm::mix(line.a, line.b, a / (a - b));
            if (b < 0) line.b = glm::mix(line.b, line.a, b / (b - a));
        }
        line.a = map.toSpace(line.a);
        line.b = map.toSpace(line.b);
        lines.push_back(line);
    }
}

std::vector<Segment> markedOutline(const ViewContent& content) {
    std::vector<Segment> outline;
    const auto& loop = content.outlinedLoop();
    for (std::size_t i = 0; i < loop.size(); ++i)
        outline.push_back({content.mesh->positions[loop[i]], content.mesh->positions[loop[(i + 1) % loop.size()]]});
    if (!content.markedBox) return outline;
    std::vector<InkedLine> edges;
    addWorldBox(content, *content.markedBox, Ink::Outline, edges);
    for (const InkedLine& edge : edges) outline.push_back({edge.a, edge.b});
    return outline;
}

bool isShown(const LightFrustum& frustum, const ViewContent& content, const ViewOptions& options) {
    const bool asked = options.lightFrusta && frustum.texels > 0;
    if (content.map.space != ViewSpace::Light) return asked;
    return frustum.light == content.map.light && (asked || frustum.face == content.map.face);
}

void addLightFrustum(const LightFrustum& frustum, Drawing& drawing) {
    const pipeline::View& view = frustum.view;
    const auto plane = pictureCorners(view, frustum.plane), end = pictureCorners(view, frustum.end);
    const auto start = pictureCorners(view, view.perspective ? 0 : frustum.plane);
    addRectangle(plane, Ink::L, drawing.lines);
    addRectangle(end, Ink::L, drawing.lines);
    for (std::size_t i = 0; i < 4; ++i) drawing.lines.push_back({start[i], end[i], Ink::L, 1, 1});
    const auto middle = [](const std::array<Vec3d, 4>& corners) { return (corners[0] + corners[2]) / 2.0; };
    std::string name = "Z′, shadow buffer of light " + std::to_string(frustum.light);
    if (frustum.faces > 1) name += ", face " + nameOfFace(frustum.face);
    drawing.labels.push_back(words(plane[1], middle(plane), std::move(name), Ink::L));
    if (frustum.texels == 0) return;
    drawing.labels.push_back(words(end[2], middle(end), "farthest Z′ " + threeDigits(frustum.end), Ink::L));
}

}  // namespace app
