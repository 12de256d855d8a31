#include "app/buffer_view/buffer_stale.h"

#include <QLabel>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/compare/buffer_compare.h"
#include "app/widgets/follow_theme.h"

namespace app {

LateVeil::LateVeil(BufferView& view)
    : BufferFeature(view), m_veil(styled(new QLabel(view.canvas()), {.name = "lateVeil", .wraps = true})) {
    m_veil->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_veil->setAlignment(Qt::AlignCenter);
    m_veil->hide();
    Document& document = view.document();
    connect(&document.frames(), &FrameFeed::busyChanged, this, &LateVeil::show);
    connect(&document.stepper(), &Stepper::changed, this, &LateVeil::show);
    connect(&document.stepper(), &Stepper::busyChanged, this, &LateVeil::show);
    connect(&document, &Document::sceneChanged, this, &LateVeil::show);
    connect(&view, &BufferView::bufferChanged, this, &LateVeil::show);
    followTheme(m_veil, [veil = m_veil] {
        const Theme& theme = Theme::current();
        QColor ground = theme.colors().view;
        ground.setAlphaF(0.82F);
        veil->setFont(theme.text(14, 500));
        veil->setStyleSheet(QStringLiteral("background: %1; color: %2;")
                                .arg(ground.name(QColor::HexArgb), theme.colors().text2.name()));
    });
}

bool LateVeil::isThere() const {
    const Document& document = view().document();
    const FrameFeed& frames = document.frames();
    const Stepper& stepper = document.stepper();
    return view().shown() && view().isCurrent() && showsScene() && view().frame() == frames.shown() && !frames.busy() &&
           (!stepper.isInside() || stepper.isSettled());
}

QString LateVeil::words() const {
    const BufferCompare& compare = view().compare();
    // B alone is asked for, and the canvas has none.
    if (view().shown() && compare.source() && compare.mode() == CompareMode::B && !view().canvas()->pictures().b)
        return view().canvas()->wipe().nameB;
    if (!m_isAsked) return {};
    return view().document().work().isStopped(&view().document().frames()) ? tr("stopped") : tr("computing");
}

void LateVeil::show() {
    if (isThere()) m_isAsked = false;
    const QString said = words();
    m_veil->setText(said);
    m_veil->setVisible(!said.isEmpty());
    if (said.isEmpty()) return;
    m_veil->setGeometry(view().canvas()->rect());
    m_veil->raise();
}

void LateVeil::place(CanvasRoom& room) { m_veil->setGeometry(QRect(QPoint(), room.size)); }

pipeline::Errors LateVeil::read(const lessons::BufferShown&) {
    m_isAsked = true;
    show();
    return {};
}

}  // namespace app
