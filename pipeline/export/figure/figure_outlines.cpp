// The polygons' edges in a figure.
#include <algorithm>
#include <limits>

#include "pipeline/buffers/verdict.h"
#include "pipeline/export/figure/figure.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/scene/mesh/topology.h"

namespace pipeline {
namespace {

// z_view; in front of it nothing has a place in the picture. A parallel projection has no such plane.
double nearestDepth(const Frame& frame) {
    return readStages(frame, [](const auto& data) {
        const bool cuts = data.transform && data.transform->view.perspective;
        return cuts ? double(data.transform->view.near) : -std::numeric_limits<double>::infinity();
    });
}

}  // namespace

BufferSet outlineBuffers() {
    return setOf({BufferId::VerticesScreen, BufferId::VerticesView, BufferId::PolygonsVerdict});
}

std::vector<Figure::Outline> polygonOutlines(const Frame& frame, const std::optional<Figure::Part>& part) {
    const auto screen = frame.buffer({BufferId::VerticesScreen}), view = frame.buffer({BufferId::VerticesView});
    const auto verdicts = frame.buffer({BufferId::PolygonsVerdict});
    if (!screen || !view) return {};
    const Settings& settings = frame.scene().settings;
    const glm::dvec2 low = part ? glm::dvec2(part->first) : glm::dvec2(0);
    const glm::dvec2 high = part ? glm::dvec2(part->last) + 1.0 : glm::dvec2(settings.width, settings.height);
    const std::vector<bool> hasPlace = rowsWithValue(*screen);
    const double nearest = nearestDepth(frame);
    const Topology& topology = frame.topology();
    std::vector<Figure::Outline> outlines;
    for (std::size_t p = 0; p < topology.polygonCount(); ++p) {
        if (verdicts && p < verdicts->count() && !goesOn(Verdict(int(verdicts->flat(p))))) continue;
        const auto corners = topology.corners(p);
        Figure::Outline outline;
        glm::dvec2 least(std::numeric_limits<double>::infinity()), most = -least;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::size_t v = corners[i];
            if (!hasPlace[v] || view->value(0, v, 2) < nearest) break;
            outline.emplace_back(screen->value(0, v, 0), screen->value(0, v, 1));
            least = glm::min(least, outline.back()), most = glm::max(most, outline.back());
        }
        const bool isSeen = most.x >= low.x && most.y >= low.y && least.x <= high.x && least.y <= high.y;
        if (outline.size() == corners.size() && isSeen) outlines.push_back(std::move(outline));
    }
    return outlines;
}

}  // namespace pipeline
