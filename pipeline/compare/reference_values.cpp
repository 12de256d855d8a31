#include "pipeline/compare/reference_values.h"

#include <algorithm>

#include "pipeline/buffers/verdict.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/run/frame_data.h"

namespace pipeline::foreign {

std::vector<std::uint8_t> coveredIn(const Frame& frame) {
    std::vector<std::uint8_t> covered;
    const auto polygons = frame.buffer({BufferId::PolygonId});
    if (!polygons) return covered;
    covered.resize(polygons->count());
    for (std::size_t i = 0; i < covered.size(); ++i) covered[i] = polygons->flat(i) >= 0;
    return covered;
}

std::optional<Values> valuesIn(const Frame& frame, const BufferName& name) {
    return valuesIn(frame, name, coveredIn(frame));
}
std::optional<Values> valuesIn(const Frame& frame, const BufferName& name, const std::vector<std::uint8_t>& covered) {
    const auto buffer = frame.buffer(name);
    if (!buffer) return {};
    const bool ofSurface = name.id != BufferId::Color && name.id != BufferId::ZView;
    Values out = valuesOf(*buffer, ofSurface ? covered : std::vector<std::uint8_t>());
    if (name.id == BufferId::ZView) {  // cleared, as files of others are read
        const View view = readStages(frame, [](const auto& data) { return data.transform->view; });
        for (std::size_t i = 0; i < out.count(); ++i) {
            const double z = out.at(i)[0];
            if (z == 0 || z >= view.far * (1 - 1e-12) || (view.perspective && z < 0)) out.there[i] = 0;
            if (!out.there[i]) out.at(i)[0] = 0;
        }
    }
    if (name.id == BufferId::PolygonsVerdict)  // what is told of others: whether it goes on
        for (double& code : out.numbers) code = goesOn(Verdict(int(code))) ? 1 : 0;
    if (name.id == BufferId::VerticesScreen) {
        // Before the near plane vertices have no agreed place; the depth is the z-buffer's affair.
        const auto view = frame.buffer({BufferId::VerticesView});
        const double near = readStages(frame, [](const auto& data) { return data.transform->view.near; });
        const glm::dvec2 shift = sampleShiftOf(frame.scene());
        for (std::size_t i = 0; i < out.count(); ++i) {
            if (view && view->value(0, i, 2) < near) out.there[i] = 0;
            out.at(i)[0] -= shift.x, out.at(i)[1] -= shift.y, out.at(i)[2] = 0;
        }
    }
    return out;
}

ReferenceValues::ReferenceValues(FramePtr frame, std::vector<std::uint8_t> covered, const BufferSet& wanted)
    : m_frame(std::move(frame)), m_covered(std::move(covered)) {
    for (const BufferName& name : allBuffers(m_frame->scene().lights.size()))
        if (toleranceOf(name.id) && wanted[index(name.id)] && m_frame->buffer(name)) m_names.emplace(name.text(), name);
}

bool ReferenceValues::contains(const std::string& name) const { return m_names.contains(name); }

const Values* ReferenceValues::find(const std::string& name) const {
    const auto found = m_names.find(name);
    if (found == m_names.end()) return nullptr;
    const std::lock_guard lock(m_read->mutex);
    const auto read = m_read->values.find(name);
    if (read != m_read->values.end()) return &read->second;
    return &m_read->values.emplace(name, *valuesIn(*m_frame, found->second, m_covered)).first->second;
}

const Values& ReferenceValues::at(const std::string& name) const { return *find(name); }

void ReferenceValues::forget(const std::string& name) const {
    const std::lock_guard lock(m_read->mutex);
    m_read->values.erase(name);
}

}  // namespace pipeline::foreign
