#include "app/buffer_view/buffer_page.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/widgets/follow_theme.h"

namespace app {

BufferPage::BufferPage(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::ClickFocus);  // the keys go on to the window
    m_title = new QLabel(this);
    m_title->hide();
    m_message = new QLabel(this);
    m_message->setAlignment(Qt::AlignCenter);
    m_message->setWordWrap(true);
    m_offer = new QPushButton(tr("Compute anyway"), this);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_title);
    column->addStretch();
    column->addWidget(m_message);
    column->addWidget(m_offer, 0, Qt::AlignHCenter);
    column->addStretch();
    connect(m_offer, &QPushButton::clicked, this, &BufferPage::offerTaken);
    followTheme(this, [this] { setFonts(); });
}

// Those of hidden labels do not outlive a style sheet, so that they are set again with the words.
void BufferPage::setFonts() {
    const Theme& theme = Theme::current();
    m_title->setFont(theme.text(13, 600));
    m_message->setFont(theme.text(m_bare ? 18 : 13));
    m_offer->setFont(theme.text(13, 500));
}

void BufferPage::setBare(bool bare) {
    m_bare = bare;
    m_title->setVisible(bare);
    setFonts();
}

void BufferPage::setTitle(const QString& name) { m_title->setText(name); }

void BufferPage::show(const Absence& absence) {
    using Offer = Absence::Offer;
    setFonts();
    m_message->setText(absence.why);
    m_offer->setText(absence.offer == Offer::Cancel    ? tr("Cancel")
                     : absence.offer == Offer::Compute ? tr("Compute")
                                                       : tr("Compute anyway"));
    m_offer->setVisible(!m_bare && absence.offer != Offer::Nothing);
}

QString BufferPage::text() const { return m_message->text(); }

}  // namespace app
