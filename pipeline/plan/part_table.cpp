#include "pipeline/plan/part_table.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "pipeline/plan/own_normals.h"
#include "pipeline/plan/part_rows.h"

namespace pipeline {

const PartInfo& partInfo(Part part) {
    const std::size_t shading = index(Part::PolygonTerms);
    return index(part) < shading ? partsBeforeShading()[index(part)] : partsOfShading()[index(part) - shading];
}

Decision::Decision(const Scene& whole, const Scene& lit, StageId last, Needs& out)
    : scene(whole), drawn(lit), until(last), m_needs(out) {
    for (const BufferInfo& info : bufferTable())
        if (out.buffers[index(info.id)]) m_reads |= info.reads;
}

const Need& Decision::operator[](Part part) const {
    decide(part);
    return m_needs[part];
}
const Need& Decision::of(Part part, std::size_t light) const {
    decide(part);
    return m_needs.of(part, light);
}

const std::vector<bool>& Decision::ownNormals() const {
    if ((*this)[Part::VertexNormals] && isInForce(Rule::PolygonNormals) && m_needs.ownNormals.empty())
        m_needs.ownNormals = objectsOfOwnNormals(scene);
    return m_needs.ownNormals;
}

Need Decision::unless(Rule rule, std::string reason) const {
    if (reason.empty()) return {};
    if (isInForce(rule)) return {std::move(reason), rule};
    if (scene.settings.isPlanted()) return {{}, {}, kDefectIsPlanted};
    reason.pop_back();  // the full stop
    const std::string_view off = scene.settings.leaveOut ? ruleInfo(rule).key : "leave_out";
    return {{}, {}, fmt::format("{}, but {} is off.", reason, off)};
}

void Decision::decide(Part part) const {
    if (m_isDecided[index(part)]) return;
    m_isDecided.set(index(part));
    const PartInfo& row = partInfo(part);
    Need& whole = m_needs.whole[index(part)];
    if (!row.forAll) {
        whole = row.need(*this, 0);
        return;
    }
    std::vector<Need>& lights = m_needs.lights[index(part)];
    for (std::size_t k = 0; k < scene.lights.size(); ++k) lights.push_back(row.need(*this, k));
    whole = row.forAll(scene, lights);
}

}  // namespace pipeline
