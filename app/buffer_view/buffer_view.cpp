#include "app/buffer_view/buffer_view.h"

#include <QKeyEvent>
#include <QLabel>
#include <QStackedLayout>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/buffer_view/buffer_captions.h"
#include "app/buffer_view/buffer_channels.h"
#include "app/buffer_view/buffer_compare_choice.h"
#include "app/buffer_view/buffer_condition.h"
#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_holds.h"
#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_page.h"
#include "app/buffer_view/buffer_range.h"
#include "app/buffer_view/buffer_source.h"
#include "app/buffer_view/buffer_zoom.h"
#include "app/buffer_view/held_band.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/condition_bar.h"
#include "app/canvas/range_bar.h"
#include "app/canvas/shadow_overlay.h"
#include "app/compare/buffer_compare.h"
#include "app/compare/compare_bar.h"
#include "app/holds/held_files.h"
#include "app/look/hidden_in_window.h"
#include "app/look/number_format.h"
#include "app/look/press_watch.h"
#include "app/look/text.h"
#include "app/look/working_bar.h"
#include "app/widgets/follow_theme.h"

namespace app {

BufferView::BufferView(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    build();
    observe();
    observeWork();
    setBuffer(m_name);
}

void BufferView::build() {
    setMinimumSize(280, 220);
    m_header = new BufferHeader(m_document, this);
    new PressWatch(*m_header, [this] { takeKeys(); });  // a click there gives the keys to the view
    auto* middle = new QWidget(this);
    m_stack = new QStackedLayout(middle);
    m_canvas = new BufferCanvas(middle);
    m_page = new BufferPage(middle);
    m_stack->addWidget(m_canvas);
    m_stack->addWidget(m_page);
    m_features = makeFeatures(*this);
    m_working = new WorkingBar(m_canvas);
    auto* all = spaced(new QVBoxLayout(this), {}, 0);
    all->addWidget(m_header);
    auto* row = spaced(new QHBoxLayout, {}, 0);
    row->addWidget(middle, 1);
    row->addWidget(&m_features.holds->files());
    all->addLayout(row, 1);
    all->addWidget(&m_features.holds->band());
    all->addWidget(&condition());
    all->addWidget(compare().bar());
    all->addWidget(&m_features.range->foot());
    followTheme(this, [this] { place(); });
}

void BufferView::observe() {
    connect(m_header->chooser(), &BufferChooser::chosen, this, &BufferView::setBuffer);
    connect(&m_canvas->input(), &CanvasInput::menuAsked, m_header, &BufferHeader::openMoreMenu);
    // Where views change places the canvas may get its size long after the view.
    connect(m_canvas, &BufferCanvas::sizeChanged, this, &BufferView::place);
    connect(m_page, &BufferPage::offerTaken, m_features.source, &BufferSource::takeOffer);
    connect(&m_features.captions->notices(), &QLabel::linkActivated, &m_features.overlays->shadows(),
            &ShadowOverlay::cancel);

    connect(&m_document.frames(), &FrameFeed::frameReady, this, &BufferView::refresh);
    connect(&m_document.frames(), &FrameFeed::busyChanged, this, [this] {
        if (!m_document.frames().shown()) refresh();
    });
    connect(&NumberStyle::current(), &NumberStyle::changed, this, &BufferView::refresh);
    connect(&m_document, &Document::sceneOpened, this, [this] {
        m_shown.reset();
        m_frame.reset();
        m_showing.forget();
        m_canvas->setContent({});
        if (m_name.light >= int(m_document.scene().lights.size())) m_name = {pipeline::BufferId::Color};
        setBuffer(m_name);
    });
    connect(&m_document, &Document::sceneChanged, this, &BufferView::want);
    connect(&m_showing, &ShowJob::ready, this, &BufferView::refresh);
    // The frame around a view shows which view the keys go to.
    m_focus.begin([this](QWidget* now) {
        QWidget* frame = parentWidget();
        const bool active = now && isAncestorOf(now);
        if (!frame || frame->property("active").toBool() == active) return;
        if (!active) m_features.compare->letGo();
        frame->setProperty("active", active);
        frame->style()->polish(frame);
    });
}

// The work that the view waits for. It can be stopped.
void BufferView::observeWork() {
    WorkList& work = m_document.work();
    const auto tell = [this, &work] {
        const bool busy = m_showing.busy() || m_canvas->isPainting() ||
                          std::ranges::any_of(m_features.all, [](const BufferFeature* f) { return f->busy(); });
        work.setBusy(this, busy);
        m_working->setWorking(m_document.frames().busy() || busy || compare().other().busy());
        m_working->setStopped(work.isStopped(this) || work.isStopped(&compare()) ||
                              work.isStopped(&m_document.frames()));
    };
    work.add(
        this, tr("a buffer's picture"),
        [this] {
            m_showing.cancel(), m_canvas->cancelPainting();
            for (BufferFeature* feature : m_features.all) feature->cancel();
        },
        [this] {
            m_showing.retry(), m_canvas->retryPainting();
            for (BufferFeature* feature : m_features.all) feature->retry();
            refresh();
        });
    connect(&m_document.frames(), &FrameFeed::busyChanged, &m_watch, tell);
    connect(&work, &WorkList::changed, &m_watch, tell);
    connect(&m_showing, &ShowJob::busyChanged, &m_watch, tell);
    for (BufferFeature* feature : m_features.all) connect(feature, &BufferFeature::busyChanged, &m_watch, tell);
    connect(m_canvas, &BufferCanvas::paintingChanged, &m_watch, tell);
}

BufferCompare& BufferView::compare() const { return m_features.compare->compare(); }
ConditionBar& BufferView::condition() const { return m_features.condition->bar(); }
bool BufferView::isOfPixels() const { return bufferInfo(m_name.id).domain != pipeline::Domain::Texel; }
QString BufferView::message() const { return m_stack->currentWidget() == m_page ? m_page->text() : QString(); }

void BufferView::setBuffer(const pipeline::BufferName& name) {
    const bool isOther = !(name == m_name);
    m_name = name;
    m_header->show(name, m_features.channel->channel());
    m_features.captions->setTitle(toQString(name.text()));
    m_page->setTitle(toQString(name.text()));
    setAccessibleName(tr("Buffer view: %1").arg(toQString(name.text())));
    m_canvas->setAccessibleName(toQString(name.text()));
    want();
    refresh();
    if (isOther) emit bufferChanged(name);
}

void BufferView::setBare(bool bare) {
    m_header->setVisible(!bare);
    m_features.captions->setBare(bare);
    m_page->setBare(bare);
    condition().setBare(bare);
    compare().bar()->setBare(bare);
    m_features.range->foot().setBare(bare);
    place();
}

lessons::BufferShown BufferView::state() const {
    lessons::BufferShown state{m_name.text()};
    for (const BufferFeature* feature : m_features.all) feature->write(state);
    return state;
}

pipeline::Errors BufferView::lookAt(const lessons::BufferShown& state) {
    const auto name = pipeline::findAnyBuffer(state.buffer);
    if (!name) return {{{}, "there is no buffer \"" + state.buffer + '"'}};
    setBuffer(*name);
    pipeline::Errors errors;
    for (BufferFeature* feature : m_features.all) {
        const pipeline::Errors found = feature->read(state);
        errors.insert(errors.end(), found.begin(), found.end());
    }
    want();
    m_features.zoom->showPart(state.zoom);
    return errors;
}

void BufferView::want() {
    pipeline::BufferSet wanted;
    for (BufferFeature* feature : m_features.all) wanted |= feature->want();
    m_document.frames().want(this, isHiddenInWindow(*this) ? pipeline::BufferSet() : wanted);
}

void BufferView::refresh() {
    m_missed = isHiddenInWindow(*this);
    if (m_missed) {
        m_frame.reset();
        return m_showing.forget();
    }
    if (!m_document.hasScene()) return showMessage({tr("No scene yet. Open a file, or begin with the pyramid.")});
    const pipeline::FramePtr& frame = m_document.frames().shown();
    if (!frame) {
        if (!m_shown)
            showMessage({m_document.frames().busy() ? tr("The first picture is being computed.")
                                                    : tr("There is no picture yet.")});
        return;
    }
    const auto asked = request(frame);
    if (!asked) return;
    const auto answer = m_showing.answer(*asked);
    if (answer && answer->request.buffer.name == m_name) take(*answer);  // else the first one is on its way
}

std::optional<ShowRequest> BufferView::request(const pipeline::FramePtr& frame) {
    const BufferSource& source = *m_features.source;
    if (source.isHidden()) {
        m_frame.reset();
        m_canvas->setContent({});
        m_canvas->setAccessibleDescription({});
        showMessage({tr("%1\nafter your answer").arg(toQString(m_name.text()))});
        return {};
    }
    auto buffer = source.find(*frame);
    if (!buffer) {
        if (const auto absence = source.whyNot(*frame)) showMessage(*absence);
        return {};
    }
    ShowRequest request{.frame = frame, .buffer = *std::move(buffer)};
    for (BufferFeature* feature : m_features.all) feature->addTo(request);
    return request;
}

// The whole view is of one frame, which may lag behind.
void BufferView::take(const ShowAnswer& answer) {
    m_frame = answer.request.frame;
    m_shown = compare().show(answer);
    if (!isDifference(*m_shown->buffer.info)) {
        QStringList lines;
        for (const BufferFeature* feature : m_features.all) lines << feature->notice();
        if (!m_features.captions->isBare()) lines << m_shown->notice;  // for one who measures, not for a hall
        lines.removeAll(QString());
        m_shown->notice = lines.join("<br>");
    }
    const bool hadKeys = m_page->hasFocus();
    m_stack->setCurrentWidget(m_canvas);
    if (hadKeys) m_canvas->setFocus();
    if (std::exchange(m_keysWait, false) && m_header->chooser()->hasFocus()) takeKeys();
    m_canvas->setContent(m_shown->content);
    setAccessibleDescription(m_shown->counts->description);
    for (BufferFeature* feature : m_features.all) feature->show();
    place();
}

void BufferView::showMessage(const Absence& absence) {
    m_shown.reset();
    m_showing.forget();
    m_page->show(absence);
    m_features.range->foot().hide();
    setAccessibleDescription(absence.why);
    if (m_canvas->hasFocus()) m_page->setFocus();  // else the button would have it, and Space press it
    m_stack->setCurrentWidget(m_page);
    m_header->setZoom(0);  // of no picture
}

void BufferView::place() {
    CanvasRoom room;
    room.size = m_canvas->size();
    room.bottom = m_canvas->height();
    for (BufferFeature* feature : m_features.all) feature->place(room);
}

void BufferView::takeKeys() {
    m_keysWait = !message().isEmpty();
    if (m_keysWait)
        m_header->chooser()->setFocus(Qt::ShortcutFocusReason);
    else
        m_canvas->setFocus(Qt::ShortcutFocusReason);
}

void BufferView::keyPressEvent(QKeyEvent* event) {
    if (!(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)))
        for (BufferFeature* feature : m_features.all)
            if (feature->press(*event)) return;
    QWidget::keyPressEvent(event);
}

void BufferView::keyReleaseEvent(QKeyEvent* event) {
    if (event->isAutoRepeat()) return;
    for (BufferFeature* feature : m_features.all) feature->release(*event);
    QWidget::keyReleaseEvent(event);
}

void BufferView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    compare().bar()->fit(height());
}

void BufferView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    want();
    if (m_missed) refresh();
}

void BufferView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    want();
}

}  // namespace app
