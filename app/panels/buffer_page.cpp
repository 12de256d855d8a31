#include "app/panels/buffer_page.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/panels/follow_theme.h"

namespace app {

BufferPage::BufferPage(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::ClickFocus);  // the keys go on to the window
    m_message = new QLabel(this);
    m_message->setAlignment(Qt::AlignCenter);
    m_message->setWordWrap(true);
    m_offer = new QPushButton(tr("Compute anyway"), this);
    auto* column = new QVBoxLayout(this);
    column->addStretch();
    column->addWidget(m_message);
    column->addWidget(m_offer, 0, Qt::AlignHCenter);
    column->addStretch();
    connect(m_offer, &QPushButton::clicked, this, &BufferPage::offerTaken);
    followTheme(this, [this] {
        m_message->setFont(Theme::current().text(13));
        m_offer->setFont(Theme::current().text(13, 500));
    });
}

void BufferPage::show(const Absence& absence) {
    using Offer = Absence::Offer;
    m_message->setText(absence.why);
    m_offer->setText(absence.offer == Offer::Cancel    ? tr("Cancel")
                     : absence.offer == Offer::Compute ? tr("Compute")
                                                       : tr("Compute anyway"));
    m_offer->setVisible(absence.offer != Offer::Nothing);
}

QString BufferPage::text() const { return m_message->text(); }

}  // namespace app
