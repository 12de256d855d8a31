#include "app/study/study_bar.h"

#include <QHBoxLayout>
#include <QLabel>

#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"

namespace app {

StudyBar::StudyBar(QWidget* parent)
    : QWidget(parent),
      m_words(new ElidedLabel(this)),
      m_load(styled(new QLabel(this), {.name = "studyLoad", .tone = 2, .size = 12})) {
    m_words->setObjectName("studyAnswers");
    m_words->setTextFormat(Qt::PlainText);
    m_load->setToolTip(
        tr("Programs that ran, on average over the minute before the times were measured. "
           "More than one a core disturbs them."));
    auto* row = spaced(new QHBoxLayout(this), {4, 0, 4, 0}, 12);
    row->addWidget(m_words, 1);
    row->addWidget(m_load);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_words->setFont(theme.text(13));
        fit();
    });
    setLoad({});
}

void StudyBar::setAnswers(const QStringList& sentences) {
    m_answers = sentences;
    fit();
}

void StudyBar::tell(const QString& doing) {
    m_doing = doing;
    fit();
}

void StudyBar::setLoad(std::optional<double> load) {
    m_load->setVisible(load.has_value());
    if (load) m_load->setText(tr("machine load %1").arg(*load, 0, 'f', 1));
    fit();
}

// Whole sentences: the tab of the answers has all of them.
void StudyBar::fit() {
    QString words = m_doing;
    if (m_doing.isEmpty())
        for (const QString& answer : m_answers) {
            const QString longer = words.isEmpty() ? answer : words + QStringLiteral("  ") + answer;
            const int room = width() - (m_load->isHidden() ? 0 : m_load->sizeHint().width() + layout()->spacing()) -
                             layout()->contentsMargins().left() - layout()->contentsMargins().right();
            if (words.isEmpty() || m_words->fontMetrics().horizontalAdvance(longer) <= room) words = longer;
        }
    m_words->setText(words);
}

void StudyBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

}  // namespace app
