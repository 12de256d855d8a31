#include "app/panels/lesson_page.h"

#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "app/core/text.h"
#include "app/panels/follow_theme.h"
#include "app/panels/prose_view.h"
#include "app/panels/question_card.h"

namespace app {

QString partName(lessons::Part part) {
    const QString names[]{LessonPage::tr("the inspector"), LessonPage::tr("the equation"),
                          LessonPage::tr("all counts"),    LessonPage::tr("the plan"),
                          LessonPage::tr("the algorithm"), LessonPage::tr("the timeline"),
                          LessonPage::tr("the scene"),     LessonPage::tr("the settings")};
    return names[std::size_t(part)];
}

QString hiddenText(const lessons::Hidden& hidden) {
    QStringList things;
    for (const pipeline::BufferName& buffer : hidden.buffers) things << toQString(buffer.text());
    for (const lessons::Part part : hidden.parts) things << partName(part);
    if (things.size() < 2) return things.join(QString());
    const QString last = things.takeLast();
    return LessonPage::tr("%1 and %2").arg(things.join(QStringLiteral(", ")), last);
}

LessonPage::LessonPage(LessonRun& run, Document& document, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_document(document),
      m_column(new QVBoxLayout(this)),
      m_heading(new ProseView(this)),
      m_text(new ProseView(this)),
      m_card(new QuestionCard(run, document, this)),
      m_hides(new QLabel(this)) {
    setAutoFillBackground(false);  // the dock's surface shows through
    m_heading->setAccessibleName(tr("Heading"));
    m_heading->setObjectName("lessonHeading");
    m_heading->setFocusPolicy(Qt::NoFocus);
    m_text->setAccessibleName(tr("Lesson page"));
    m_text->setObjectName("lessonText");
    m_hides->setObjectName("lessonHides");
    m_hides->setProperty("tone", 2);
    m_hides->setWordWrap(true);
    for (QWidget* part : std::initializer_list<QWidget*>{m_heading, m_text, m_card, m_hides}) m_column->addWidget(part);
    m_column->addStretch(1);
    connect(&document, &Document::hiddenChanged, this, &LessonPage::showHidden);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_hides->setFont(theme.text(12));
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
    showHidden();
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
    m_column->insertWidget(m_column->indexOf(m_hides), m_then);
}

void LessonPage::showHidden() {
    const lessons::Hidden& hidden = m_document.hidden();
    m_hides->setVisible(hidden.count() > 0);
    m_hides->setText(hidden.count() > 0 ? tr("This page hides %1 until you have answered.").arg(hiddenText(hidden))
                                        : QString());
}

}  // namespace app
