#include "app/widgets/progress_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "app/widgets/follow_theme.h"

namespace app {

ProgressLine::ProgressLine(QWidget* parent)
    : QWidget(parent), m_what(new QLabel(this)), m_bar(new QProgressBar(this)), m_link(new QPushButton(this)) {
    m_bar->setTextVisible(false);
    m_link->setProperty("kind", "link");
    m_link->setFocusPolicy(Qt::TabFocus);
    auto* row = spaced(new QHBoxLayout(this), {}, 8);
    row->addWidget(m_what);
    row->addWidget(m_bar);
    row->addWidget(m_link);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_what->setFont(theme.text(12));
        m_what->setIndent(theme.px(12));
        m_link->setFont(theme.text(12));
        m_bar->setFixedSize(theme.px(160), theme.px(6));
    });
    hide();
}

void ProgressLine::tell(const QString& what) { m_what->setText(what); }

void ProgressLine::setShare(std::optional<double> share) {
    m_bar->setRange(0, share ? 100 : 0);
    if (share) m_bar->setValue(int(100 * *share));
}

void ProgressLine::setBar(bool shown) { m_bar->setVisible(shown); }

}  // namespace app
