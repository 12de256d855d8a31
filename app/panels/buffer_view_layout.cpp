// How a BufferView is put together; what it does stands in buffer_view.cpp.
#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>

#include "app/core/press_watch.h"
#include "app/core/working_bar.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_compare.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_view.h"
#include "app/panels/compare_bar.h"
#include "app/panels/condition_bar.h"
#include "app/panels/follow_theme.h"
#include "app/panels/loupe.h"
#include "app/panels/range_foot.h"
#include "app/panels/region_panel.h"
#include "app/panels/stage_differences.h"

namespace app {

namespace {

QLabel* overlay(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    label->setProperty("kind", "overlay");
    label->setMargin(5);
    label->hide();
    return label;
}

}  // namespace

void BufferView::build() {
    setMinimumSize(280, 220);
    m_header = new BufferHeader(m_document, this);
    new PressWatch(*m_header, [this] { takeKeys(); });  // whoever clicks there goes on with the view's keys
    auto* middle = new QWidget(this);
    m_stack = new QStackedLayout(middle);
    m_canvas = new BufferCanvas(middle);
    m_compare = new BufferCompare(m_document, m_canvas, this);
    m_stages = new StageDifferences(m_document, *m_compare, this);
    m_condition = new ConditionBar(m_document, this);
    m_loupe = new Loupe(m_canvas);
    m_readout = overlay(m_canvas);
    m_notice = overlay(m_canvas);
    m_pins = overlay(m_canvas);
    m_title = overlay(m_canvas);
    m_region = new RegionPanel(m_canvas);
    m_working = new WorkingBar(m_canvas);

    m_page = new QWidget(middle);
    m_page->setFocusPolicy(Qt::ClickFocus);  // the keys go on to the window
    m_message = new QLabel(m_page);
    m_message->setAlignment(Qt::AlignCenter);
    m_message->setWordWrap(true);
    m_compute = new QPushButton(tr("Compute anyway"), m_page);
    auto* column = new QVBoxLayout(m_page);
    column->addStretch();
    column->addWidget(m_message);
    column->addWidget(m_compute, 0, Qt::AlignHCenter);
    column->addStretch();
    m_stack->addWidget(m_canvas);
    m_stack->addWidget(m_page);

    m_foot = new RangeFoot(this);
    m_foot->hide();
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addWidget(m_header);
    all->addWidget(middle, 1);
    all->addWidget(m_condition);
    all->addWidget(m_compare->bar());
    all->addWidget(m_foot);
    // Where views change places the canvas may get its size long after the view.
    connect(m_canvas, &BufferCanvas::sizeChanged, this, &BufferView::placeOverlays);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_notice->setTextFormat(Qt::RichText);
        m_message->setFont(theme.text(13));
        m_compute->setFont(theme.text(13, 500));
        placeOverlays();
    });
}

void BufferView::setBare(bool bare) {
    m_bare = bare;
    m_header->setVisible(!bare);
    m_compare->bar()->setBare(bare);
    m_foot->setBare(bare);
    placeOverlays();
}

void BufferView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_compare->bar()->fit(height());
}

// What the view waits for, and may be told to give up.
void BufferView::observeWork() {
    WorkList& work = m_document.work();
    const auto tell = [this, &work] {
        const bool busy = m_showing.busy() || m_compare->busy() || m_canvas->isPainting() || m_marking.busy();
        work.setBusy(this, busy);
        m_working->setWorking(m_document.busy() || busy || m_compare->waitsForB());
        m_working->setStopped(work.isStopped(this) || work.isStopped(m_compare) || work.isStopped(&m_document));
    };
    work.add(
        this, tr("a buffer's picture"),
        [this] { m_showing.cancel(), m_compare->cancel(), m_canvas->cancelPainting(), m_marking.forget(); },
        [this] {
            m_showing.retry(), m_compare->retry(), m_canvas->retryPainting();
            refresh();
        });
    connect(&m_document, &Document::busyChanged, this, tell);
    connect(&work, &WorkList::changed, this, tell);
    connect(&m_showing, &ShowJob::busyChanged, this, tell);
    connect(m_compare, &BufferCompare::chosen, this, &BufferView::takeKeys);
    connect(m_compare, &BufferCompare::busyChanged, this, tell);
    connect(&m_marking, &BackgroundJob::busyChanged, this, tell);
    connect(m_canvas, &BufferCanvas::paintingChanged, this, tell);
}

void BufferView::placeOverlays() {
    constexpr int kMargin = 8;
    // Set while they are hidden, fonts do not outlive a view that moves in the window.
    const Theme& theme = Theme::current();
    for (QLabel* numbers : {m_readout, m_pins}) numbers->setFont(theme.mono(12));
    m_notice->setFont(theme.text(12));
    m_title->setFont(theme.text(13, 600));
    if (m_readout->sizeHint().width() > m_canvas->width() - 2 * kMargin)  // A, B and their difference
        m_readout->setText(m_readout->text().replace("   ", "\n"));
    m_readout->adjustSize();
    // Over "0, 0", where the canvas marks it.
    const int origin = m_canvas->isFlipped() ? QFontMetrics(theme.mono(12)).height() + 4 : 0;
    m_readout->move(kMargin, m_canvas->height() - m_readout->height() - kMargin - origin);
    m_title->setVisible(m_bare && !m_compare->isOn());
    m_title->adjustSize();
    m_title->move(kMargin, kMargin);
    m_notice->adjustSize();
    const int right = m_loupe->isVisibleTo(m_canvas) ? m_loupe->width() + kMargin : 0;
    m_notice->move(m_canvas->width() - m_notice->width() - kMargin - right, kMargin);
    // Above the readout, and the region beside it or above.
    m_pins->adjustSize();
    const int top = m_readout->isVisibleTo(m_canvas) ? m_readout->y() : m_canvas->height();
    m_pins->move(kMargin, top - m_pins->height() - kMargin);
    // Where it covers neither the pins' values nor, if there is a choice, the region.
    const int beside = m_canvas->width() - m_region->width() - 2 * kMargin;
    const bool isTight = m_pins->isVisibleTo(m_canvas) && m_pins->geometry().right() > beside;
    const auto& region = m_canvas->content().region;
    const bool isLow = region && m_canvas->visiblePart().center().y() < region->center().y();
    const bool onTop = isTight || isLow != m_canvas->isFlipped();
    m_region->move(m_canvas->width() - m_region->width() - kMargin,
                   onTop ? kMargin : m_canvas->height() - m_region->height() - kMargin);
    m_loupe->follow();
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
