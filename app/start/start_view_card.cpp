#include "app/start/start_view_card.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <algorithm>

#include "app/widgets/follow_theme.h"

namespace app {

// One of the pictures, its name on it.
class StartViewCard::Picture : public StartButton {
public:
    Picture(const StartView::Part& part, QWidget* parent) : StartButton(part.label, {}, Frame::Flat, parent) {}

    ScenePicture shown;
    QRectF kept;

protected:
    void paintInside(QPainter& painter, const QRectF& box) const override {
        const Theme& theme = Theme::current();
        paintScenePicture(painter, box, shown.image, kept);
        painter.setFont(theme.text(12, 500));
        const QFontMetrics metrics = painter.fontMetrics();
        const double side = theme.px(4), pad = theme.px(5);
        const QRectF chip(box.left() + side, box.bottom() - side - metrics.height() - 1,
                          std::min(box.width() - 2 * side, metrics.horizontalAdvance(text()) + 2 * pad),
                          metrics.height() + 1);
        QColor plate = theme.colors().surface;
        plate.setAlphaF(0.94F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(plate);
        painter.drawRoundedRect(chip, theme.px(4), theme.px(4));
        painter.setPen(theme.colors().text);
        painter.drawText(chip.adjusted(pad, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(text(), Qt::ElideRight, int(chip.width() - pad)));
    }
};

StartViewCard::StartViewCard(const StartLecture& lecture, QWidget* parent)
    : QFrame(parent),
      m_view(lecture.first),
      m_title(styled(new QLabel(m_view.title, this), {.size = 13, .weight = 600, .wraps = true})),
      m_talkTitle(
          styled(new QLabel(tr("%1 as a talk").arg(lecture.title), this), {.size = 13, .weight = 600, .wraps = true})),
      m_talkPlace(styled(new QLabel(this), {.tone = 2, .size = 12})),
      m_open(new QPushButton(this)),
      m_talk(new QPushButton(this)) {
    setObjectName(QStringLiteral("view:") + m_view.name);
    for (const StartView::Part& part : m_view.parts) {
        auto* picture = new Picture(part, this);
        picture->setObjectName(QStringLiteral("part:") + QString::fromStdString(part.scene) + ':' + part.label);
        connect(picture, &Picture::clicked, this, [this, scene = part.scene] { emit sceneChosen(scene); });
        m_pictures.push_back(picture);
    }
    m_open->setObjectName(QStringLiteral("open:") + m_view.name);
    m_open->setAccessibleName(tr("Open %1").arg(m_view.title));
    m_open->setProperty("kind", "primary");
    m_talk->setObjectName(QStringLiteral("talk:") + m_view.name);
    for (QPushButton* button : {m_open, m_talk}) button->setAutoDefault(true);  // Enter presses it
    for (QWidget* part : findChildren<QWidget*>())
        if (part->focusPolicy() != Qt::NoFocus) part->installEventFilter(this);
    connect(m_open, &QPushButton::clicked, this, &StartViewCard::opened);
    connect(m_talk, &QPushButton::clicked, this, &StartViewCard::talkAsked);
    setFocusProxy(m_open);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        for (QPushButton* button : {m_open, m_talk}) button->setFont(theme.text(13, 500));
        place();
    });
}

QString StartViewCard::words() const {
    QStringList words{m_title->text(), m_talkTitle->text()};
    for (const StartView::Part& part : m_view.parts) words << part.label << QString::fromStdString(part.scene);
    return words.join(' ');
}

void StartViewCard::setPicture(std::size_t part, const ScenePicture& picture) {
    m_pictures[part]->shown = picture;
    QRectF kept;
    for (const Picture* one : m_pictures) kept |= one->shown.drawn;
    for (Picture* one : m_pictures) one->kept = kept, one->update();
}

void StartViewCard::setTalk(const StartTalk& talk) {
    const bool isBegun = talk.cue > 0 && talk.cue < talk.cues;
    m_talkPlace->setText(isBegun ? tr("cue %1 of %2").arg(talk.cue).arg(talk.cues)
                                 : tr("%1 cues, %2 min").arg(talk.cues).arg(talk.minutes));
    m_talk->setText(isBegun ? tr("Go on") : tr("Begin"));
    m_talk->setAccessibleName(m_talkTitle->text() + QStringLiteral(": ") + m_talk->text());
    m_talk->setEnabled(talk.cues > 0);
    place();
}

void StartViewCard::setPictureHeight(int height) {
    m_pictureHeight = height;
    place();
}

int StartViewCard::wantedHeight() const {
    return m_pictureHeight > 0 ? m_pictureHeight + 2 : m_open->sizeHint().height() + Theme::current().px(12);
}

void StartViewCard::press() const { m_open->click(); }

void StartViewCard::resizeEvent(QResizeEvent*) { place(); }

void StartViewCard::place() {
    const Theme& theme = Theme::current();
    const bool isLow = m_pictureHeight == 0;
    m_open->setText(isLow ? tr("Open") : tr("Open  Enter"));
    for (Picture* picture : m_pictures) picture->setVisible(!isLow);
    m_talkPlace->setVisible(!isLow);
    m_title->setWordWrap(!isLow), m_talkTitle->setWordWrap(!isLow);
    const int pad = theme.px(width() < theme.px(850) ? 9 : 14);
    if (isLow) {
        const auto centred = [&](QWidget& part, int x, int wide) {
            const int high = part.sizeHint().height();
            part.setGeometry(x, (height() - high) / 2, wide, high);
        };
        const int open = m_open->sizeHint().width(), talk = m_talk->sizeHint().width();
        const int words = QFontMetrics(m_talkTitle->font()).horizontalAdvance(m_talkTitle->text()) + 2;
        const int left = QFontMetrics(m_title->font()).horizontalAdvance(m_title->text()) + 2;
        const int titleWide = std::min(left, width() - open - talk - 5 * pad);
        centred(*m_title, pad, titleWide);
        centred(*m_open, 2 * pad + titleWide, open);
        centred(*m_talk, width() - pad - talk, talk);
        const int free = width() - 5 * pad - titleWide - open - talk;
        m_talkTitle->setVisible(words <= free);
        centred(*m_talkTitle, width() - 2 * pad - talk - words, words);
        return;
    }
    m_talkTitle->show();
    // The talk's name on one line where that does not take much from the pictures.
    const int talkName = QFontMetrics(m_talkTitle->font()).horizontalAdvance(m_talkTitle->text()) + 2 * pad + 2;
    const int text = std::max({int(width() * 0.157), theme.px(132), m_open->sizeHint().width() + 2 * pad,
                               std::min(talkName, int(width() * 0.18))});
    const int pictures = width() - 2 * text, count = int(m_pictures.size());
    for (int i = 0; i < count; ++i) {
        const int from = 1 + i * pictures / count, to = (i + 1) * pictures / count - 1;
        m_pictures[std::size_t(i)]->setGeometry(from, 1, to - from, height() - 2);
    }
    const auto stack = [&](int left, std::initializer_list<QWidget*> parts) {
        const int gap = theme.px(4), wide = text - 2 * pad;
        const auto heightOf = [&](const QWidget* part) {
            return part->hasHeightForWidth() ? part->heightForWidth(wide) : part->sizeHint().height();
        };
        int high = -gap;
        for (const QWidget* part : parts) high += heightOf(part) + gap;
        int y = std::max(1, (height() - high) / 2);
        for (QWidget* part : parts) {
            const bool isButton = qobject_cast<QPushButton*>(part);
            part->setGeometry(left + pad, y, isButton ? std::min(wide, part->sizeHint().width()) : wide,
                              heightOf(part));
            y += heightOf(part) + gap;
        }
    };
    stack(pictures, {m_title, m_open});
    stack(pictures + text, {m_talkTitle, m_talkPlace, m_talk});
}

void StartViewCard::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setBrush(c.surface);
    painter.setPen(hasFocus() ? QPen(c.focus, 2) : QPen(c.line, 1));
    painter.drawRoundedRect(hasFocus() ? box.adjusted(0.5, 0.5, -0.5, -0.5) : box, theme.px(6), theme.px(6));
    if (m_pictureHeight == 0) return;
    painter.setPen(c.line);
    const int between = m_talkTitle->x() - (m_title->x() - m_pictures.back()->geometry().right());
    painter.drawLine(between, 2, between, height() - 2);
}

bool StartViewCard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) update();
    if (event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Left: focusPreviousChild(); return true;
        case Qt::Key_Right: focusNextChild(); return true;
        case Qt::Key_Down: emit leftDown(); return true;
        default: return QFrame::eventFilter(watched, event);
    }
}

}  // namespace app
