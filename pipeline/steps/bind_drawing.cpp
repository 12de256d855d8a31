// The values of a step of the z-buffer stage.
#include <algorithm>

#include "pipeline/core/text.h"
#include "pipeline/steps/bindings.h"

namespace pipeline {

template <class Real>
void bindDrawing(const FrameData<Real>& data, const Drawing<Real>& drawing, const BoundStep& step, Bindings& out) {
    const Topology& topology = *data.transform->topology;
    const Visibility visibility = data.keys.zBuffer.visibility;
    const bool painted = visibility == Visibility::Painter;
    bindElement(step, painted ? "piece" : "polygon", out);
    if (visibility == Visibility::None) {
        const auto& range = drawing.ranges[step.element];
        out.word("edges", plural(range[1] - range[0], "edge"));
        return;
    }
    const glm::ivec2 pixel = bindPixel(spansOf(drawing, step.element), step.within, out);
    const PixelFragments fragments = fragmentsAt(data, drawing, step.element, pixel);
    // Two triangles of a polygon that is not planar may cover the pixel: the fragment that stays counts.
    const auto stays = std::ranges::find_if(fragments.own.rbegin(), fragments.own.rend(), &FragmentRecord::won);
    const FragmentRecord& own = stays == fragments.own.rend() ? fragments.own.front() : *stays;
    const auto below = std::ranges::find_if(fragments.before.rbegin(), fragments.before.rend(), &FragmentRecord::won);
    const bool isFirst = below == fragments.before.rend();
    const std::string before = isFirst ? "nothing" : fmt::format("polygon {}", topology.polygonOf(below->triangle));
    if (painted) {
        out.whole("polygon", topology.polygonOf(own.triangle));
        out.word("what is there", before);
        out.word("polygons", plural(std::int64_t(topology.polygonCount()), "polygon"));
        out.word("pieces", plural(std::int64_t(drawing.order.pieces.size()), "piece"));
        return;
    }
    const double stored = fragments.own.front().stored;
    out.depth("z", own.depth, fmt::format("of polygon {}", step.number()));
    out.depth("zbuffer(x, y)", stored, isFirst ? "cleared" : "written by " + before).shown =
        fmt::format("zbuffer({}, {})", pixel.x, pixel.y);
    out.tests["nearer"] = own.won;
}

#define SHADESCOPE_INSTANTIATE(Real) \
    template void bindDrawing(const FrameData<Real>&, const Drawing<Real>&, const BoundStep&, Bindings&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
