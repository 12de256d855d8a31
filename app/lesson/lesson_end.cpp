#include "app/lesson/lesson_end.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <map>

#include "app/lesson/prose_view.h"
#include "app/lesson/question_card.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "lessons/questions/misconceptions.h"

namespace app {

namespace {

bool hasKnownMistake(const lessons::Progress& progress) {
    return std::ranges::any_of(progress.tries, [](const lessons::Try& one) { return !one.mistake.empty(); });
}

// "● 1 Which is which, 1 of 1"
QString pageText(const LessonRun& run, int page) {
    const lessons::Page& one = run.lesson()->pages[std::size_t(page)];
    const lessons::Progress progress = run.progress(page);
    const bool right = progress.outcome == lessons::Progress::Outcome::Right;
    const QString mark = !one.question || progress.outcome == lessons::Progress::Outcome::Shown ? QStringLiteral("–")
                         : !right                                                               ? QStringLiteral("○")
                         : hasKnownMistake(progress)                                            ? QStringLiteral("△")
                                                                                                : QStringLiteral("●");
    const QString points =
        !one.question                                           ? LessonEnd::tr("no question")
        : progress.outcome == lessons::Progress::Outcome::Shown ? LessonEnd::tr("shown")
        : !right                                                ? LessonEnd::tr("not answered")
                 : LessonEnd::tr("%1 of %2").arg(pointsText(run.points(page)), pointsText(fullPoints(one)));
    return QStringLiteral("%1 **%2** %3, %4")
        .arg(mark, toQString(pageName(*run.lesson(), std::size_t(page))), toQString(one.heading), points);
}

}  // namespace

LessonEnd::LessonEnd(LessonRun& run, const LessonShelf& shelf, QWidget* parent)
    : QWidget(parent), m_run(run), m_shelf(shelf) {
    setObjectName("lessonEnd");
    auto* all = new QVBoxLayout(this);
    m_column = all;
    followTheme(this, [all] {
        const Theme& theme = Theme::current();
        all->setContentsMargins(theme.px(14), theme.px(8), theme.px(14), theme.px(10));  // those of a page
    });
}

void LessonEnd::showRun() {
    delete m_content;
    m_content = new QWidget(this);
    layout()->addWidget(m_content);
    m_column = new QVBoxLayout(m_content);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(Theme::current().px(10));
    addPages();
    addMistakes();
    addNext();
    addResults();
    m_column->addStretch(1);
}

void LessonEnd::addPages() {
    const auto add = [this](const QString& markdown, const char* name, ProseView::Tone tone = ProseView::Tone::Plain) {
        auto* view = new ProseView(m_content);
        view->setObjectName(name);
        view->setFocusPolicy(Qt::NoFocus);
        view->setProse(markdown, tone);
        m_column->addWidget(view);
    };
    add(tr("The lesson is done"), "endHeading", ProseView::Tone::Heading);
    QString pages;
    for (int i = 0; i < m_run.pageCount(); ++i) pages += pageText(m_run, i) + QStringLiteral("\n\n");
    add(pages + tr("● right, △ right after a known mistake, – shown"), "endPages");
    if (m_run.lesson()->can.empty()) return;
    QString can = tr("**You can now**\n\n");
    for (const std::string& ability : m_run.lesson()->can) can += QStringLiteral("- ") + toQString(ability) + '\n';
    add(can, "endCan");
}

void LessonEnd::addMistakes() {
    std::map<std::string, int> pages;  // of each mistake, the first page
    for (int i = m_run.pageCount() - 1; i >= 0; --i)
        for (const lessons::Try& one : m_run.progress(i).tries)
            if (lessons::findMisconception(one.mistake)) pages[one.mistake] = i;
    const auto name = [this](int page) { return toQString(pageName(*m_run.lesson(), std::size_t(page))); };
    auto* view = new ProseView(m_content);
    view->setObjectName("endMistakes");
    view->setFocusPolicy(Qt::NoFocus);
    QString text = tr("**Mistakes that were yours**\n\n");
    for (const auto& [id, page] : pages)
        text += tr("- %1 (page %2)\n").arg(toQString(lessons::findMisconception(id)->name), name(page));
    view->setProse(pages.empty() ? text + tr("None that the program knows.") : text);
    m_column->addWidget(view);
    for (const auto& [id, page] : pages) {
        auto* back = new QPushButton(tr("Back to page %1").arg(name(page)), m_content);
        back->setProperty("kind", "link");
        connect(back, &QPushButton::clicked, this, [this, page = page] { m_run.goTo(page); });
        m_column->addWidget(back, 0, Qt::AlignLeft);
    }
}

void LessonEnd::addNext() {
    const lessons::Lesson* next = m_shelf.findListed(toQString(m_run.lesson()->next));
    auto* row = new QHBoxLayout;
    if (next) {
        auto* view = new ProseView(m_content);
        view->setObjectName("endNext");
        view->setFocusPolicy(Qt::NoFocus);
        const QString minutes = next->minutes > 0 ? tr(", about %1 minutes").arg(next->minutes) : QString();
        view->setProse(
            tr("**Next lesson: %1**%2\n\n%3").arg(toQString(next->title), minutes, toQString(next->summary)));
        m_column->addWidget(view);
        auto* begin = new QPushButton(tr("Begin"), m_content);
        begin->setObjectName("beginNext");
        begin->setProperty("kind", "primary");
        begin->setAutoDefault(true);
        connect(begin, &QPushButton::clicked, this, [this, name = toQString(next->name)] { emit beginAsked(name); });
        row->addWidget(begin);
    }
    auto* all = new QPushButton(tr("All lessons"), m_content);
    all->setObjectName("endAll");
    all->setAutoDefault(true);
    connect(all, &QPushButton::clicked, this, &LessonEnd::allAsked);
    row->addWidget(all);
    row->addStretch(1);
    m_column->addLayout(row);
}

void LessonEnd::addResults() {
    auto* words = styled(new QLabel(tr("Your results stay on this machine."), m_content), {.tone = 2, .wraps = true});
    words->setFont(Theme::current().text(12));
    m_column->addWidget(words);
    auto* row = new QHBoxLayout;
    const auto link = [&](const QString& text, const char* name, auto asked) {
        auto* made = new QPushButton(text, m_content);
        made->setObjectName(name);
        made->setProperty("kind", "link");
        made->setAutoDefault(true);
        connect(made, &QPushButton::clicked, this, asked);
        row->addWidget(made);
    };
    link(tr("My results…"), "myResults", &LessonEnd::resultsAsked);
    link(tr("Forget my results"), "forgetResults", &LessonEnd::forgetAsked);
    row->addStretch(1);
    m_column->addLayout(row);
}

void LessonEnd::takeFocus() {
    auto* first = findChild<QPushButton*>("beginNext");
    if (!first) first = findChild<QPushButton*>("endAll");
    if (first) first->setFocus();
}

}  // namespace app
