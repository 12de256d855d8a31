#include "app/talk/ask_panel.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <numeric>

#include "app/look/text.h"
#include "app/look/theme.h"
#include "lessons/pages/talk_words.h"

namespace app {
namespace {

constexpr int kMostVotes = 9999;
constexpr double kLetter = 36, kWords = 24.5, kAnswerLetter = 30,
                 kAnswerWords = 19.5;  // 66, 45, 55, 36 px in 1080 lines

QString letterOf(int choice) { return QString(QChar('A' + choice)); }

}  // namespace

AskPanel::AskPanel(CueModel& cues, QWidget* parent) : QWidget(parent), m_cues(cues) {
    setObjectName("askPanel");
    connect(&cues, &CueModel::changed, this, [this] { show(true); });
    connect(&cues, &CueModel::votesChanged, this, [this] { show(false); });
    show(true);
}

void AskPanel::show(bool anew) {
    if (anew) {
        const auto asking =
            m_cues.current() < 0 ? std::nullopt : lessons::asking(m_cues.list(), std::size_t(m_cues.current()));
        m_cue = asking ? std::optional(int(*asking)) : std::nullopt;
        m_field = -1;
    }
    setVisible(asks());
    if (asks()) {
        QStringList read;
        for (int i = 0; i < int(question().choices.size()); ++i) {
            QString row = tr("%1: %2").arg(letterOf(i), toQString(question().choices[std::size_t(i)]));
            if (const int votes = m_cues.votes(*m_cue)[std::size_t(i)]; votes > 0) row += tr(", %1 votes").arg(votes);
            if (isAnswer() && std::size_t(i) == question().right) row += tr(", right");
            read << row;
        }
        setAccessibleName(title() + QStringLiteral(". ") + read.join(QStringLiteral("; ")));
    }
    update();
    emit changed();
}

QString AskPanel::title() const {
    if (!asks()) return {};
    const lessons::Cue& now = *m_cues.currentCue();
    return toQString(!isAnswer() ? question().text : now.caption.empty() ? now.name : now.caption);
}

QString AskPanel::remark() const {
    if (!asks()) return {};
    const std::vector<int> votes = m_cues.votes(*m_cue);
    const int total = std::accumulate(votes.begin(), votes.end(), 0);
    if (isAnswer()) {
        const int right = votes[question().right];
        return total == 0 ? QString() : tr("%1 of %2 votes were right.").arg(right).arg(total);
    }
    if (total > 0) return total == 1 ? tr("1 vote so far.") : tr("%1 votes so far.").arg(total);
    const lessons::Cue& now = *m_cues.currentCue();
    return now.caption.empty() ? tr(lessons::kVoteByHand) : toQString(now.caption);
}

// Letters are for the votes while a question is on show, digits while one of its fields is chosen.
bool AskPanel::wantsKey(int key) const {
    if (!asks() || isAnswer()) return false;
    if (key >= Qt::Key_A && key < Qt::Key_A + int(question().choices.size())) return true;
    return m_field >= 0 && ((key >= Qt::Key_0 && key <= Qt::Key_9) || key == Qt::Key_Tab || key == Qt::Key_Backspace);
}

bool AskPanel::takeKey(int key) {
    if (!wantsKey(key)) return false;
    const int count = int(question().choices.size());
    const auto choose = [this](int field) { m_field = field, m_isNew = true; };
    if (key == Qt::Key_Tab) {
        choose((m_field + 1) % count);
    } else if (key >= Qt::Key_A && key <= Qt::Key_Z) {
        choose(key - Qt::Key_A);
    } else {
        const int before = m_cues.votes(*m_cue)[std::size_t(m_field)];
        const bool isDigit = key != Qt::Key_Backspace;
        const int now = isDigit ? (m_isNew ? 0 : before * 10) + key - Qt::Key_0 : before / 10;
        m_isNew = false;
        m_cues.setVotes(*m_cue, m_field, std::min(now, kMostVotes));
    }
    update();
    return true;
}

bool AskPanel::leaveField() {
    if (m_field < 0) return false;
    m_field = -1;
    update();
    return true;
}

void AskPanel::paintEvent(QPaintEvent*) {
    if (!asks()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const std::vector<int> votes = m_cues.votes(*m_cue);
    const int count = int(question().choices.size()), total = std::accumulate(votes.begin(), votes.end(), 0);
    const double gap = Theme::current().px(8), high = (height() - gap * (count - 1)) / count;
    for (int i = 0; i < count; ++i)
        paintChoice(painter, QRectF(0, i * (high + gap), width(), high).adjusted(2, 2, -2, -2), i, total);
}

// Letter, words, votes, and along the lower edge the share of all votes.
void AskPanel::paintChoice(QPainter& painter, const QRectF& box, int choice, int total) const {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    const bool answers = isAnswer(), right = answers && std::size_t(choice) == question().right;
    const int votes = m_cues.votes(*m_cue)[std::size_t(choice)];
    const double round = theme.px(5), letterWidth = theme.px(answers ? 34 : 40), barHeight = theme.px(5);
    QPainterPath outline;
    outline.addRoundedRect(box, round, round);
    painter.save();
    painter.setClipPath(outline);
    painter.fillRect(box, colors.raised);
    const QRectF letter(box.left(), box.top(), letterWidth, box.height());
    painter.fillRect(letter, right ? colors.run : answers ? colors.hover : colors.tint);
    if (total > 0) {
        const QRectF all(letter.right(), box.bottom() - barHeight, box.right() - letter.right(), barHeight);
        painter.fillRect(all, colors.line);
        painter.fillRect(QRectF(all.left(), all.top(), all.width() * votes / total, all.height()),
                         right ? colors.run : colors.text3);
    }
    painter.restore();
    painter.setPen(QPen(right ? colors.run : colors.outline, right ? theme.px(2) : 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box, round, round);
    painter.setFont(theme.text(answers ? kAnswerLetter : kLetter, 700));
    painter.setPen(right ? colors.raised : answers ? colors.text2 : colors.accent);
    painter.drawText(letter, Qt::AlignCenter, letterOf(choice));

    const QFont numbers = theme.mono(answers ? kAnswerWords : kWords);
    const double gap = theme.px(10), number = QFontMetricsF(numbers).horizontalAdvance(QStringLiteral("000")) + gap;
    const bool hasField = !answers && choice == m_field;
    QRectF words(letter.right() + gap, box.top(), box.right() - letter.right() - 2 * gap, box.height() - barHeight);
    if (total > 0 || hasField || right) {
        QRectF place(words.right() - number, words.center().y() - theme.px(18), number, theme.px(36));
        words.setRight(place.left() - gap);
        if (hasField) {
            painter.setPen(QPen(colors.accent, theme.px(2)));
            painter.drawRoundedRect(place, round, round);
        }
        painter.setFont(numbers);
        painter.setPen(colors.text);
        QString text = total > 0 || hasField ? QString::number(votes) : QString();
        painter.drawText(place, Qt::AlignCenter, text);
        if (right) {
            const double dot = theme.px(11);
            const QPointF at(total > 0 ? words.right() : place.right() - dot, words.center().y());
            painter.setPen(Qt::NoPen);
            painter.setBrush(colors.run);
            painter.drawEllipse(at, dot / 2, dot / 2);
            words.setRight(at.x() - dot);
        }
    }
    painter.setPen(answers && !right ? colors.text2 : colors.text);
    // As large as fits: long words take a smaller size before they would be cut.
    for (double size = answers ? kAnswerWords : kWords; size >= 12; size -= 1) {
        const QFont font = theme.text(size);
        const QString text = toQString(question().choices[std::size_t(choice)]);
        const QRectF needed = QFontMetricsF(font).boundingRect(words, Qt::AlignVCenter | Qt::TextWordWrap, text);
        if (size > 13 && (needed.height() > words.height() || needed.width() > words.width())) continue;
        painter.setFont(font);
        painter.drawText(words, int(Qt::AlignVCenter | Qt::TextWordWrap), text);
        return;
    }
}

}  // namespace app
