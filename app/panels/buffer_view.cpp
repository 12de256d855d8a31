#include "app/panels/buffer_view.h"

#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <QStyle>
#include <utility>

#include "app/core/luminance.h"
#include "app/core/number_format.h"
#include "app/core/put_away.h"
#include "app/core/shadow_texel.h"
#include "app/core/text.h"
#include "app/core/working_bar.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_compare.h"
#include "app/panels/buffer_header.h"
#include "app/panels/loupe.h"
#include "app/panels/range_foot.h"
#include "app/panels/stage_differences.h"
#include "pipeline/plan/needs.h"

namespace app {

using pipeline::BufferName;
using pipeline::Domain;

namespace {

std::optional<QPoint> toPoint(std::optional<glm::ivec2> p) {
    if (!p) return {};
    return QPoint(p->x, p->y);
}

std::optional<glm::ivec2> toVector(std::optional<QPoint> p) {
    if (!p) return {};
    return glm::ivec2(p->x(), p->y());
}

}  // namespace

BufferView::BufferView(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    build();
    observe();
    setBuffer(m_name);
}

void BufferView::observe() {
    connect(m_header->chooser(), &BufferChooser::chosen, this, &BufferView::setBuffer);
    connect(m_header, &BufferHeader::channelChosen, this, &BufferView::setChannel);
    connect(m_header, &BufferHeader::fitChosen, m_canvas, &BufferCanvas::toggleFit);
    connect(m_header, &BufferHeader::originalChosen, m_canvas, [this] { m_canvas->setZoom(1); });
    observeOverlays();
    observeDerived();
    observeMarks();
    connect(m_header, &BufferHeader::loupeToggled, this, &BufferView::setShowLoupe);
    observeCopies();
    connect(m_foot, &RangeFoot::rangeChosen, this, &BufferView::setRange);
    connect(m_foot, &RangeFoot::autofit, this, &BufferView::autofit);
    connect(m_foot, &RangeFoot::logarithmicChosen, this, &BufferView::setLogCounts);
    connect(m_header, &BufferHeader::compareMenuOpens, this,
            [this](QMenu* menu) { m_compare->fillMenu(*menu, m_name); });
    connect(m_compare, &BufferCompare::changed, this, &BufferView::refresh);
    connect(m_compare, &BufferCompare::stagesChosen, this,
            [this] { m_stages->open(m_compare->bar()->mapToGlobal(m_compare->bar()->rect().bottomRight())); });
    connect(m_stages, &StageDifferences::chosen, this, [this](const pipeline::StageDifference& difference) {
        setBuffer(difference.buffer);
        m_compare->goToWorst();
    });
    connect(m_compute, &QPushButton::clicked, this, &BufferView::takeOffer);

    connect(m_canvas, &BufferCanvas::zoomChanged, m_header, &BufferHeader::setZoom);
    connect(m_canvas, &BufferCanvas::picked, this, [this](QPoint pixel) {
        if (standsOnPicture()) m_document.pick(toVector(pixel));
    });
    connect(m_canvas, &BufferCanvas::nudged, this, &BufferView::nudge);
    connect(m_canvas, &BufferCanvas::hovered, this, [this](std::optional<QPoint> pixel) {
        m_localHover = pixel;
        if (standsOnPicture()) m_document.hover(toVector(pixel));
        showPixels();
    });

    connect(&m_document, &Document::frameReady, this, &BufferView::refresh);
    connect(&m_document, &Document::busyChanged, this, [this] {
        if (!m_document.frame()) refresh();
    });
    connect(&NumberStyle::current(), &NumberStyle::changed, this, &BufferView::refresh);
    connect(&m_document, &Document::sceneOpened, this, [this] {
        m_kept.clear();
        m_shown.reset();
        m_frame.reset();
        m_showing.forget();
        m_canvas->setContent({});
        if (m_name.light >= int(m_document.scene().lights.size())) m_name = {pipeline::BufferId::Color};
        setBuffer(m_name);
    });
    connect(&m_document, &Document::sceneChanged, this, &BufferView::want);
    connect(&m_document, &Document::pixelChanged, this, &BufferView::showPixels);
    connect(&m_document, &Document::hoverChanged, this, &BufferView::showPixels);
    connect(&m_document, &Document::selectionChanged, this, &BufferView::markSelection);
    observeWork();
    connect(&m_showing, &ShowJob::ready, this, &BufferView::refresh);
    // The frame that a view stands in shows which view the keys go to.
    m_focus.begin([this](QWidget* now) {
        QWidget* frame = parentWidget();
        const bool active = now && isAncestorOf(now);
        if (!frame || frame->property("active").toBool() == active) return;
        if (!active) m_compare->holdOther(false), m_compare->holdPrevious(false);
        frame->setProperty("active", active);
        frame->style()->polish(frame);
    });
}

void BufferView::setBuffer(const BufferName& name) {
    const bool isOther = !(name == m_name);
    m_name = name;
    m_header->show(name, kept().channel);
    m_title->setText(toQString(name.text()));
    setAccessibleName(tr("Buffer view: %1").arg(toQString(name.text())));
    m_canvas->setAccessibleName(toQString(name.text()));
    want();
    refresh();
    if (isOther) emit bufferChanged(name);
}

lessons::ShownChannel BufferView::channel() const {
    const auto found = m_kept.find(m_name.text());
    return found == m_kept.end() ? lessons::ShownChannel::All : found->second.channel;
}

void BufferView::setChannel(lessons::ShownChannel channel) {
    const pipeline::BufferInfo& info = bufferInfo(m_name.id);
    if (info.channels == 1 || (channel == lessons::ShownChannel::Luminance && !hasLuminance(info))) return;
    kept().channel = channel;
    kept().range.reset();  // that of another channel means nothing
    m_header->show(m_name, channel);
    refresh();
}

// A buffer that the scene has no use for is computed only when the user insists.
void BufferView::want() {
    wantDerived();
    if (isPutAway(*this)) return m_document.want(this, {});
    const bool isOwn = !pipeline::isDerived(m_name.id);
    const bool useful = isOwn && m_document.hasScene() && whyUseless(m_document.scene(), m_name.id).empty();
    const bool hasOverlays = whyNoOverlays(bufferInfo(m_name.id)).isEmpty();
    m_document.want(this, (useful || kept().forced ? pipeline::setOf({m_name.id}) : pipeline::BufferSet()) |
                              (hasOverlays ? buffersOf(m_overlays, m_name.id) : pipeline::BufferSet()));
}

bool BufferView::standsOnPicture() const { return bufferInfo(m_name.id).domain != Domain::Texel; }

void BufferView::refresh() {
    m_missed = isPutAway(*this);
    if (m_missed) {
        m_frame.reset();
        return m_showing.forget();
    }
    if (!m_document.hasScene())
        return showMessage(tr("No scene yet. Open a file, or begin with the pyramid."), Offer::Nothing);
    const pipeline::FramePtr& frame = m_document.frame();
    if (!frame) {
        if (!m_shown)
            showMessage(m_document.busy() ? tr("The first picture is being computed.") : tr("There is no picture yet."),
                        Offer::Nothing);
        return;
    }
    const auto asked = request(frame);
    if (!asked) return;
    const auto answer = m_showing.answer(*asked);
    if (!answer || answer->request.buffer.name != m_name) return;  // the first one is on its way
    // All that stands in the view is of one frame, which may lag behind.
    m_frame = answer->request.frame;
    m_shown = m_compare->show(*answer);
    if (!isDifference(*m_shown->buffer.info)) m_shown->notice = withNotices(m_shown->notice);
    const bool hadKeys = m_page->hasFocus();
    m_stack->setCurrentWidget(m_canvas);
    if (hadKeys) m_canvas->setFocus();
    if (std::exchange(m_keysWait, false) && m_header->chooser()->hasFocus()) takeKeys();
    showContent();
    m_foot->show(*m_shown, !keptRange(), kept().logCounts);
    m_notice->setText(m_shown->empty.isEmpty() ? m_shown->notice : m_shown->empty);
    m_notice->setVisible(!m_notice->text().isEmpty());
    m_notice->setAttribute(Qt::WA_TransparentForMouseEvents, !m_notice->text().contains("href"));
    setAccessibleDescription(m_shown->description);
    markSelection();
    showPixels();
    showPins();
    showRegion();
    if (!m_showing.busy() && !m_compare->busy() && std::exchange(m_fitsOnce, false)) setRange(m_shown->look.range);
}

QString BufferView::message() const { return m_stack->currentWidget() == m_page ? m_message->text() : QString(); }

void BufferView::showMessage(const QString& text, Offer offer) {
    m_shown.reset();
    m_showing.forget();
    m_message->setText(text);
    m_offer = offer;
    m_compute->setText(offer == Offer::Cancel           ? tr("Cancel")
                       : pipeline::isDerived(m_name.id) ? tr("Compute")
                                                        : tr("Compute anyway"));
    m_compute->setVisible(offer != Offer::Nothing);
    m_foot->hide();
    setAccessibleDescription(text);
    if (m_canvas->hasFocus()) m_page->setFocus();  // else the button would have it, and Space press it
    m_stack->setCurrentWidget(m_page);
    m_header->setZoom(0);  // of no picture
}

void BufferView::showPixels() {
    const bool isPicture = standsOnPicture();
    m_canvas->setPicked(isPicture ? toPoint(m_document.pixel()) : texelOf(m_document.pixel()));
    m_canvas->setHovered(isPicture      ? toPoint(m_document.hovered())
                         : m_localHover ? m_localHover
                                        : texelOf(m_document.hovered()));
    showEdgeFunctions();
    const std::optional<QPoint> at =
        m_canvas->content().hovered ? m_canvas->content().hovered : m_canvas->content().picked;
    m_readout->setText(at && m_shown ? readout(*at) : QString());
    m_readout->setVisible(!m_readout->text().isEmpty());
    // The canvas has the focus: what is picked is told first, and again with every nudge.
    if (m_shown)
        m_canvas->setAccessibleDescription(m_readout->text().isEmpty()
                                               ? m_shown->description
                                               : m_readout->text() + QStringLiteral(". ") + m_shown->description);
    placeOverlays();
}

std::optional<QPoint> BufferView::texelOf(std::optional<glm::ivec2> pixel) const {
    if (!pixel || !m_frame) return {};
    return toPoint(shadowTexel(*m_frame, std::size_t(m_name.light), *pixel));
}

QString BufferView::readout(QPoint pixel) const {
    const QString place = QString("x %1 y %2").arg(pixel.x()).arg(pixel.y());
    if (!QRect(QPoint(0, 0), m_shown->content.size).contains(pixel)) return {};
    if (!m_shown->content.shapes) {
        const QString value =
            elementText(m_shown->buffer, std::size_t(pixel.x()), std::size_t(pixel.y()), m_shown->look.channel)
                .join(' ');
        return place + " → " + (m_shown->hasValue(pixel) ? value : tr("no value, %1 is stored").arg(value)) +
               m_compare->readout(pixel);
    }
    const int polygon = nearestPolygonAt(*m_shown->content.shapes, QPointF(pixel) + QPointF(0.5, 0.5));
    return polygon < 0 ? place : place + QString(" → polygon %1").arg(polygon);
}

}  // namespace app
