#include "app/lesson/lesson_page.h"

#include <QVBoxLayout>
#include <utility>

#include "app/lesson/prose_view.h"
#include "app/lesson/question_card.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

LessonPage::LessonPage(LessonRun& run, Document& document, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_column(new QVBoxLayout(this)),
      m_heading(new ProseView(this)),
      m_text(new ProseView(this)),
      m_card(new QuestionCard(run, document, this)) {
    setAutoFillBackground(false);  // the dock's surface shows through
    m_heading->setAccessibleName(tr("Heading"));
    m_heading->setObjectName("lessonHeading");
    m_heading->setFocusPolicy(Qt::NoFocus);
    m_text->setAccessibleName(tr("Lesson page"));
    m_text->setObjectName("lessonText");
    for (QWidget* part : std::initializer_list<QWidget*>{m_heading, m_text, m_card}) m_column->addWidget(part);
    m_column->addStretch(1);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_column->setContentsMargins(theme.px(14), theme.px(8), theme.px(14), theme.px(10));
        m_column->setSpacing(theme.px(8));
    });
}

void LessonPage::showPage() {
    delete std::exchange(m_then, nullptr);
    const lessons::Page& page = m_run.current();
    for (ProseView* view : findChildren<ProseView*>())
        view->setPictureFolder(folderOf(*m_run.lesson(), m_run.current()));
    m_heading->setProse(toQString(page.heading), ProseView::Tone::Heading);
    m_text->setProse(toQString(withGaps(page.first.text)));
    m_card->ask();
}

void LessonPage::fill() {
    m_text->setProse(toQString(m_run.texts()->text));
    m_card->fill();
    if (m_run.isSettled()) showThen();
}

void LessonPage::showThen() {
    if (m_then || !m_run.current().then || !m_run.texts() || !m_run.isSettled()) return;
    m_then = new ProseView(this);
    m_then->setAccessibleName(tr("Second half of the page"));
    m_then->setObjectName("lessonThen");
    m_then->setPictureFolder(folderOf(*m_run.lesson(), m_run.current()));
    m_then->setProse(toQString(m_run.texts()->then));
    m_column->insertWidget(m_column->indexOf(m_card) + 1, m_then);
}

}  // namespace app
