#include "app/widgets/section.h"

#include <QHBoxLayout>
#include <QPainter>

#include "app/look/icons.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"

namespace app {

Section::Section(const QString& title, QWidget* body, QWidget* extra, QWidget* parent)
    : QWidget(parent), m_title(new QToolButton(this)), m_sentence(new ElidedLabel(this)), m_body(body), m_extra(extra) {
    m_title->setText(title);
    m_title->setCheckable(true);
    m_title->setChecked(true);
    m_title->setProperty("kind", "fold");
    m_title->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_title->setToolTip(tr("Fold or unfold"));
    m_sentence->setProperty("tone", "2");
    auto* head = spaced(new QHBoxLayout, {}, 6);
    head->addWidget(m_title);
    head->addWidget(m_sentence, 1);
    if (extra) head->addWidget(extra);
    auto* column = spaced(new QVBoxLayout(this), {8, 6, 12, 8}, 4);
    column->addLayout(head);
    column->addWidget(body);
    connect(m_title, &QToolButton::toggled, this, [this](bool open) { setFolded(!open); });
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_title->setFont(theme.text(13, 600));
        m_title->setIconSize(QSize(1, 1) * theme.px(12));
        m_sentence->setFont(theme.text(12));
    });
    setFolded(false);
}

void Section::setSentence(const QString& sentence) {
    m_text = sentence;
    m_title->setAccessibleDescription(sentence);
    setFolded(isFolded());
}

void Section::setKeepsSentence() {
    m_keepsSentence = true;
    setFolded(isFolded());
}

void Section::setFolded(bool folded) {
    m_title->setChecked(!folded);
    m_title->setIcon(icon(folded ? "chevron-right" : "chevron-down"));
    m_body->setVisible(!folded);
    if (m_extra) m_extra->setVisible(!folded);
    m_sentence->setAlignment(Qt::AlignVCenter | (folded ? Qt::AlignLeft : Qt::AlignRight));
    m_sentence->setText(folded || m_keepsSentence ? m_text : QString());
}

void Section::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(Theme::current().colors().line);
    painter.drawLine(0, 0, width(), 0);
}

}  // namespace app
