#include "app/lesson/note_box.h"

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include "app/lesson/prose_view.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace {

QColor barColor(NoteBox::Kind kind) {
    const ThemeColors& c = Theme::current().colors();
    switch (kind) {
        case NoteBox::Kind::Known: return c.warn;
        case NoteBox::Kind::Unknown: return c.reused;
        case NoteBox::Kind::Right: return c.run;
        case NoteBox::Kind::Again: break;
    }
    return c.outline;
}

}  // namespace

NoteBox::NoteBox(QWidget* parent)
    : QFrame(parent),
      m_heading(styled(new QLabel(this), {.size = 13, .weight = 600, .wraps = true})),
      m_text(new ProseView(this)) {
    setObjectName("note");
    setFocusPolicy(Qt::StrongFocus);
    m_text->setObjectName("comment");
    m_text->setAccessibleName(tr("Comment"));
    m_text->setFocusPolicy(Qt::NoFocus);
    auto* column = spaced(new QVBoxLayout(this), {14, 8, 10, 8}, 4);
    column->addWidget(m_heading);
    column->addWidget(m_text);
}

void NoteBox::say(Kind kind, const QString& heading, const QString& markdown) {
    constexpr const char* kMarks[]{"△ ", "○ ", "", "● "};
    m_kind = kind;
    const QString mark = QString::fromUtf8(kMarks[int(kind)]),
                  marked = mark + (heading.isEmpty() ? tr("Comment") : heading);
    m_heading->setText(mark + heading);
    m_heading->setVisible(!heading.isEmpty());
    m_text->setProse(heading.isEmpty() ? mark + markdown : markdown);
    m_text->setVisible(!markdown.isEmpty());
    setAccessibleName(marked);
    setAccessibleDescription(plainText(markdown));
    update();
}

void NoteBox::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    QColor ground = barColor(m_kind);
    ground.setAlphaF(0.1F);
    painter.fillRect(rect(), ground);
    painter.fillRect(0, 0, theme.px(4), height(), barColor(m_kind));
    if (!hasFocus()) return;
    painter.setPen(QPen(theme.colors().focus, 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

}  // namespace app
