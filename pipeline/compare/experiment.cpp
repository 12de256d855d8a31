#include "pipeline/compare/hypotheses.h"
#include "pipeline/run/runner.h"

namespace pipeline::foreign {

std::optional<Experiment> experimentBetween(const std::vector<Candidate>& candidates, const Scene& scene,
                                            const Reference& reference, const Stop& stop) {
    std::vector<FramePtr> frames;
    BufferSet wanted;
    for (const Tolerance& row : toleranceTable()) wanted.set(index(row.buffer));
    for (std::size_t i = 0; i < 2; ++i) {
        frames.push_back(runFrame(referenceScene(candidates[i].error.plant(scene), reference.corner),
                                  {wanted, StageId::Shading, 0, stop}, nullptr));
        if (!frames.back()) return {};
    }
    for (const BufferName& name : allBuffers(scene.lights.size())) {
        const Tolerance* const row = toleranceOf(name.id);
        if (!row || name.id == BufferId::ShadowBuffer || !reference.tolerances.contains(name.text())) continue;
        const auto a = valuesIn(*frames[0], name), b = valuesIn(*frames[1], name);
        if (!a || !b || !a->isSameSize(*b)) continue;
        const double tolerance = reference.tolerances.at(name.text());
        double largest = 0;
        std::size_t at = 0;
        for (std::size_t i = 0; i < a->count(); ++i) {
            const double d = differenceAt(row->measure, *a, *b, i);
            if (d > largest) largest = d, at = i;
        }
        if (!(largest > 10 * tolerance)) continue;
        Finding shown;
        shown.name.buffer = name, shown.columns = a->columns;
        return Experiment{name.text(), placeText(shown, at), {valueText(shown, *a, at), valueText(shown, *b, at)}};
    }
    return {};
}

}  // namespace pipeline::foreign
