#include "app/lesson/pick_watch.h"

#include "pipeline/scene/mesh/topology.h"

namespace app {

using lessons::ThingKind;

PickWatch::PickWatch(Document& document, QObject* parent, Took took)
    : QObject(parent), m_document(document), m_took(std::move(took)) {
    connect(&document.pointing(), &Pointing::pixelChanged, this, &PickWatch::takePixel);
    connect(&document.pointing(), &Pointing::selectionChanged, this, &PickWatch::takeSelection);
    document.frames().want(this, pipeline::setOf({pipeline::BufferId::PolygonId}));
}

void PickWatch::takePixel() {
    const auto pixel = m_document.pointing().pixel();
    const pipeline::FramePtr& frame = m_document.frames().whole();
    const auto polygon = pixel && frame ? lessons::polygonAt(*frame, *pixel) : std::nullopt;
    if (!polygon) return;
    m_took({ThingKind::Polygon, *polygon});
    m_took({ThingKind::Object, std::size_t(frame->topology().objectOfPolygon(std::uint32_t(*polygon)))});
}

void PickWatch::takeSelection() {
    const auto& selected = m_document.pointing().selection();
    if (!selected) return;
    using Kind = lessons::Selection::Kind;
    switch (selected->kind) {
        case Kind::Object: return m_took({ThingKind::Object, selected->index});
        case Kind::Polygon: return m_took({ThingKind::Polygon, selected->index});
        case Kind::Vertex: return m_took({ThingKind::Vertex, selected->index});
        case Kind::Light: return m_took({ThingKind::Light, selected->index});
    }
}

}  // namespace app
