#include "app/talk/talk_hint.h"

#include "app/widgets/follow_theme.h"

namespace app {
namespace {

constexpr int kHintMs = 6000, kKeysMs = 20000;

}  // namespace

TalkHint::TalkHint(bool hasCues, QWidget* parent)
    : QLabel(hasCues ? tr("PgDown next cue · F10 step · B black · H keys · Esc leaves")
                     : tr("F10 step · Ctrl+→ next stage · B black · H keys · Esc leaves"),
             parent) {
    setObjectName("cleanHint");
    setProperty("kind", "overlay");
    setProperty("tone", 2);
    m_time.setSingleShot(true);
    connect(&m_time, &QTimer::timeout, this, &QWidget::hide);
    m_time.setInterval(kHintMs);
    followTheme(this, [this] {
        setFont(Theme::current().text(12));
        setMargin(Theme::current().px(4));
    });
}

void TalkHint::paintEvent(QPaintEvent* event) {
    QLabel::paintEvent(event);
    if (!m_time.isActive()) m_time.start();
}

void TalkHint::showKeys() {
    setText(
        tr("PgDown, PgUp   next cue, the one before\n"
           "F10, Shift+F10   step, step back\n"
           "Ctrl+→, Ctrl+←   next stage, the one before\n"
           "B, W   black, white\n"
           "P, O   pen, spotlight\n"
           "A   algorithm\n"
           "A to D, digits   votes, while a question is on show\n"
           "1, 2   one view, all views\n"
           "F4   swap the screens\n"
           "Esc   leaves"));
    show();
    raise();
    emit changed();
    m_time.start(kKeysMs);
}

}  // namespace app
