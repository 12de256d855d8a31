#include "app/study/study_pictures.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/look/numbers.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"

namespace app {

PictureFrame::PictureFrame(QWidget* parent) : QWidget(parent) {
    followTheme(this, [this] {
        setMinimumSize(Theme::current().px(80), Theme::current().px(70));
        update();
    });
}

void PictureFrame::show(QImage picture, const QString& caption, const QString& instead) {
    m_picture = std::move(picture);
    m_caption = caption;
    m_instead = instead;
    setToolTip(caption);
    setAccessibleName(m_picture.isNull() ? caption + ": " + instead : caption);
    update();
}

// As large as fits above one line of words.
QRect PictureFrame::pictureRect() const {
    const QRect place = rect().adjusted(0, 0, 0, -Theme::current().px(24));
    return m_picture.isNull() ? place
                              : QRect(place.topLeft(), m_picture.size().scaled(place.size(), Qt::KeepAspectRatio));
}

// Right below the picture, folded where there is room.
void PictureFrame::paintEvent(QPaintEvent*) {
    if (m_caption.isEmpty()) return;  // nothing is chosen
    const Theme& theme = Theme::current();
    QPainter painter(this);
    const QRect place = pictureRect(), words(0, place.bottom() + 1, width(), height() - place.height());
    painter.setFont(theme.text(12));
    painter.setPen(theme.colors().text2);
    constexpr int kCaptionFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
    const QFontMetrics metrics(painter.font());
    if (metrics.boundingRect(words, kCaptionFlags, m_caption).height() <= words.height())
        painter.drawText(words, kCaptionFlags, m_caption);
    else
        painter.drawText(words, Qt::AlignLeft | Qt::AlignTop, metrics.elidedText(m_caption, Qt::ElideRight, width()));
    if (m_picture.isNull()) {
        painter.fillRect(place, theme.colors().view);
        painter.drawText(place.adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, m_instead);
        return;
    }
    // Device pixels by nearest neighbour where the picture is enlarged; averaged where it is made smaller.
    painter.setRenderHint(QPainter::SmoothPixmapTransform, place.width() < m_picture.width());
    painter.drawImage(place, m_picture);
}

StudyPicturesView::StudyPicturesView(QWidget* parent) : QWidget(parent) {
    m_title = new ElidedLabel(this);
    m_numbers = new ElidedLabel(this);
    m_numbers->setProperty("tone", 2);
    m_use = new QPushButton(tr("Use these settings"), this);
    m_use->setObjectName("useSettings");
    connect(m_use, &QPushButton::clicked, this, &StudyPicturesView::useAsked);
    auto* head = new QHBoxLayout;
    auto* words = spaced(new QVBoxLayout, {}, 0);
    words->addWidget(m_title);
    words->addWidget(m_numbers);
    head->addLayout(words, 1);
    head->addWidget(m_use);
    auto* row = spaced(new QHBoxLayout, {}, 12);
    for (PictureFrame*& frame : m_frames) {
        frame = new PictureFrame(this);
        row->addWidget(frame, 1);
    }
    auto* column = spaced(new QVBoxLayout(this), {12, 8, 12, 8});
    column->addLayout(head);
    column->addLayout(row, 1);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_title->setFont(theme.text(13, 600));
        m_numbers->setFont(theme.text(12));
    });
    setPoint({}, {}, {});
}

void StudyPicturesView::setPoint(const QString& title, const QString& numbers, const QString& whyNotUsable) {
    const bool any = !title.isEmpty();
    m_title->setText(any ? tr("Selected: %1").arg(title) : tr("No point is selected"));
    m_numbers->setText(numbers);
    m_use->setEnabled(any && whyNotUsable.isEmpty());
    m_use->setToolTip(any ? whyNotUsable : tr("Choose a point first."));
    if (!any)
        for (PictureFrame* frame : m_frames) frame->show({}, {}, {});
}

void StudyPicturesView::setWaiting() {
    const QString wait = tr("computing");
    m_frames[0]->show({}, tr("Image"), wait);
    m_frames[1]->show({}, tr("Reference"), wait);
    m_frames[2]->show({}, tr("Error, signed"), wait);
}

void StudyPicturesView::setPictures(const SettingPictures& pictures) {
    m_frames[0]->show(pictures.image, tr("Image"), tr("nothing was drawn"));
    m_frames[1]->show(pictures.reference,
                      pictures.reference.isNull() ? tr("Reference") : tr("Reference, %1").arg(pictures.referenceName),
                      pictures.referenceName);
    const QString range = number(pictures.range, 4);
    m_frames[2]->show(pictures.error, tr("Error, signed, −%1 to %1 of I_max").arg(range), tr("no reference"));
}

}  // namespace app
