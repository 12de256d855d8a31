// Which buffers a ThumbnailStrip shows, and their pictures.
#include "app/core/derived_buffers.h"
#include "app/core/text.h"
#include "app/core/theme.h"
#include "app/panels/thumbnail.h"
#include "app/panels/thumbnail_strip.h"
#include "pipeline/plan/needs.h"

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;

namespace {

struct Wanted {
    BufferName name;
    std::optional<pipeline::AnyBuffer> buffer;
    QSize size;
};

}  // namespace

std::vector<BufferName> thumbnailBuffers(pipeline::StageId stage, const pipeline::Scene& scene) {
    static const pipeline::BufferSet landmarks =
        pipeline::setOf({BufferId::VerticesScreen, BufferId::PolygonsVerdict, BufferId::ZView, BufferId::PolygonId,
                         BufferId::Normal, BufferId::ShadowBuffer, BufferId::Color});
    std::vector<BufferName> names;
    for (const BufferName& name : pipeline::allBuffers(scene.lights.size())) {
        const pipeline::BufferInfo& info = bufferInfo(name.id);
        const bool isOthers = info.stage != stage && !(landmarks[index(name.id)] && name.light <= 0);
        // H is of another model, and a buffer of zeros teaches nothing.
        const bool isNever =
            name.id == BufferId::Emission || name.id == BufferId::NDotH || name.id == BufferId::HalfwayVector;
        if (!isOthers && !isNever) names.push_back(name);
    }
    return names;
}

// Those that somebody looks at, and that are there.
std::vector<BufferName> ThumbnailStrip::derivedOnShow() const {
    std::vector<BufferName> names;
    if (!m_document.hasScene()) return names;
    for (const BufferName& name : pipeline::allDerived(m_document.scene().lights.size()))
        if (m_document.derived().made(name)) names.push_back(name);
    return names;
}

void ThumbnailStrip::takeDerived() {
    if (!m_document.hasScene()) return;
    if (derivedOnShow() == m_derived) return m_later.start();
    const int offset = m_offset;
    rebuild();
    scrollTo(offset);
}

void ThumbnailStrip::rebuild() {
    m_items.clear();
    if (m_document.hasScene())
        for (const BufferName& name : thumbnailBuffers(m_document.stage(), m_document.scene()))
            m_items.push_back({name, {}, {}, false});
    m_derived = derivedOnShow();
    for (const BufferName& name : m_derived) m_items.push_back({name, {}, {}, false});
    m_offset = 0;
    setCurrent(m_current);
    want();
    refresh();
}

// Left-out buffers are not computed for a thumbnail.
void ThumbnailStrip::want() {
    pipeline::BufferSet wanted;
    if (m_document.hasScene() && isVisible())
        for (int i = 0; i < int(m_items.size()); ++i) {
            const BufferId id = m_items[std::size_t(i)].name.id;
            const bool isOwn = !pipeline::isDerived(id);  // the others are made for who looks at them
            if (isOwn && itemRect(i).intersects(rect()) && whyUseless(m_document.scene(), id).empty())
                wanted.set(index(id));
        }
    m_document.frames().want(this, wanted, FrameFeed::When::AtRest);
}

// Drawn away from the window: a million polygons take their time.
void ThumbnailStrip::refresh() {
    const pipeline::FramePtr& frame = m_document.frames().shown();
    if (!frame || !isVisible()) return update();
    std::vector<Wanted> wanted;
    for (int i = 0; i < int(m_items.size()); ++i) {
        Item& item = m_items[std::size_t(i)];
        const bool isDerived = pipeline::isDerived(item.name.id);
        item.why = isDerived ? QString() : toQString(whyUseless(frame->scene(), item.name.id));
        const QRect rect = itemRect(i);
        item.isInSight = rect.intersects(this->rect());
        if (!item.isInSight) continue;
        if (m_document.hidden().hides(item.name)) {
            item.picture = {};
            item.why = tr("after your answer");
            continue;
        }
        if (frame->until() < bufferInfo(item.name.id).stage) {  // while stepping inside an earlier stage
            item.picture = {};
            item.why = toQString(frame->whyAbsent(item.name));
            continue;
        }
        const lessons::DerivedBuffer* made = isDerived ? m_document.derived().made(item.name) : nullptr;
        wanted.push_back({item.name,
                          made        ? std::optional(made->buffer)
                          : isDerived ? std::nullopt
                                      : frame->buffer(item.name),
                          QSize(rect.width() - 6, rect.height() - Theme::current().px(24))});
    }
    m_drawing.ask(
        [frame, wanted, ratio = devicePixelRatioF()](const BackgroundJob::Control& control) {
            std::vector<Picture> pictures;
            const auto polygons = frame->buffer({BufferId::PolygonId});
            for (const auto& [name, buffer, size] : wanted)
                if (!control.stop.stop_requested())
                    pictures.push_back({name, buffer ? thumbnail(*frame, *buffer, size, polygons, ratio) : QImage()});
            return pictures;
        },
        [this](const std::vector<Picture>& pictures) { take(pictures); });
    update();
}

void ThumbnailStrip::take(const std::vector<Picture>& pictures) {
    for (const Picture& drawn : pictures)
        for (Item& item : m_items) {
            if (item.name != drawn.name || m_document.hidden().hides(item.name)) continue;
            // One that is on its way leaves the picture before it.
            if (!drawn.image.isNull() || !item.why.isEmpty()) item.picture = drawn.image;
            if (!item.picture.isNull()) item.why.clear();
        }
    describe();
    update();
}

// The one that the arrows have come to, then what is left out of those in sight.
void ThumbnailStrip::describe() {
    QStringList texts;
    if (m_marked >= 0 && m_marked < int(m_items.size())) {
        const Item& item = m_items[std::size_t(m_marked)];
        const QString name = toQString(item.name.text());
        texts << (item.name == m_current ? tr("%1, on show.") : tr("%1, Enter shows it.")).arg(name);
    }
    for (const Item& item : m_items)
        if (item.isInSight && !item.why.isEmpty()) texts << toQString(item.name.text()) + ": " + item.why;
    setAccessibleDescription(texts.join(' '));
}

}  // namespace app
