#include "pipeline/plan/plan_parts.h"

#include <fmt/format.h>

#include "pipeline/plan/part_rows.h"

namespace pipeline {
namespace {

struct Listing {
    const Scene& scene;
    const Needs& needs;
    Action action;  // of the stage

    PlanPart part(const PartInfo& row, const Need& need, std::size_t light) const {
        std::string name = fmt::format(fmt::runtime(row.name), light);
        if (!need)
            return {std::move(name), Action::LeaveOut, need.notBecause, need.rule ? row.saves(scene, needs, light) : "",
                    need.rule};
        // Where the stage leaves some of it out, the run counts it.
        if (std::string within = need.rule ? row.within(scene, needs, light) : ""; !within.empty())
            return {std::move(name), action, std::move(within), "", need.rule};
        return {std::move(name), action, need.despite.empty() ? row.runs(scene, needs, light) : need.despite, "", {}};
    }
    bool lists(const PartInfo& row, StageId stage) const {
        if (row.stage != stage || row.name.empty() || (outlines(scene) && !row.ofOutlines)) return false;
        return !row.isListed || row.isListed(scene, needs);
    }
};

// The buffers of shading that nobody reads, and their size.
PlanPart buffersPart(const Scene& scene, const Needs& needs, Action action) {
    if (!needs.rules[index(Rule::UnreadBuffers)]) return {"buffers", action, "All of them.", "", {}};
    int unread = 0;
    double numbers = 0;
    for (const BufferInfo& info : bufferTable()) {
        if (info.stage != StageId::Shading || info.domain != Domain::Pixel || info.element != Element::Real ||
            info.id == BufferId::Antialiased || needs.buffers[index(info.id)])
            continue;
        const int count = info.perLight ? int(scene.lights.size()) : 1;
        unread += count;
        numbers += double(count) * info.channels * scene.settings.width * scene.settings.height;
    }
    if (unread == 0) return {"buffers", action, "All of them are asked for.", "", {}};
    return {fmt::format("{} {}", unread, unread == 1 ? "buffer" : "buffers"), Action::LeaveOut, "Nobody asks for them.",
            fmt::format("{:.1f} MB", numbers * bytesOf(scene.settings.precision) / 1e6), Rule::UnreadBuffers};
}

}  // namespace

std::vector<PlanPart> planParts(StageId stage, const Scene& scene, const Needs& needs, Action action) {
    const Listing listing{scene, needs, action};
    std::vector<PlanPart> parts;
    for (std::size_t i = 0; i < kPartCount; ++i) {
        const PartInfo& row = partInfo(Part(i));
        if (!row.forAll) {
            if (listing.lists(row, stage)) parts.push_back(listing.part(row, needs[row.id], 0));
            continue;
        }
        // What is per light stands light by light.
        std::size_t end = i;
        while (end < kPartCount && partInfo(Part(end)).forAll) ++end;
        for (std::size_t k = 0; k < scene.lights.size(); ++k)
            for (std::size_t one = i; one < end; ++one)
                if (const PartInfo& of = partInfo(Part(one)); listing.lists(of, stage))
                    parts.push_back(listing.part(of, needs.of(of.id, k), k));
        i = end - 1;
    }
    if (stage == StageId::Shading) parts.push_back(buffersPart(scene, needs, action));
    return parts;
}

}  // namespace pipeline
