#include "app/panels/lesson_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QToolButton>

#include "app/core/icons.h"
#include "app/core/text.h"
#include "app/panels/error_list.h"
#include "app/panels/follow_theme.h"
#include "app/panels/handout_button.h"
#include "app/panels/prose_view.h"
#include "app/panels/question_card.h"

namespace app {

LessonPanel::LessonPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_shelf(new LessonShelf(this)),
      m_stack(new QStackedWidget(this)),
      m_errors(new ErrorList(this)) {
    setObjectName("lesson");
    m_errors->setObjectName("lessonErrors");  // the window has a list of its own
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_errors);
    column->addWidget(m_stack, 1);
    m_stack->addWidget(makeList());
    m_stack->addWidget(makePage());
    if (!m_shelf->errors().empty()) m_errors->report(tr("A lesson cannot be read."), m_shelf->errors());
    connect(&document, &Document::frameReady, this, &LessonPanel::takeFrame);
    // A frame that has all this page wants is not computed again: then only this tells.
    connect(&document, &Document::busyChanged, this, &LessonPanel::takeFrame);
}

QWidget* LessonPanel::makeList() {
    m_list = new QListView(this);
    m_list->setModel(m_shelf);
    m_list->setWordWrap(true);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setAccessibleName(tr("Lessons"));
    const auto openRow = [this](const QModelIndex& row) { open(row.data(LessonShelf::NameRole).toString()); };
    connect(m_list, &QListView::clicked, this, openRow);
    connect(m_list, &QListView::activated, this, openRow);
    followTheme(m_list, [this] {
        m_list->setFont(Theme::current().text());
        m_list->setSpacing(Theme::current().px(4));
    });
    return m_list;
}

QWidget* LessonPanel::makePage() {
    auto* page = new QWidget(this);
    auto* all = new QPushButton(tr("All lessons"), page);
    all->setProperty("kind", "link");
    m_place = new QLabel(page);
    m_place->setProperty("tone", 2);
    m_previous = new QToolButton(page);
    m_next = new QToolButton(page);
    m_previous->setIcon(icon("chevron-left"));
    m_next->setIcon(icon("chevron-right"));
    m_previous->setAccessibleName(tr("Previous page"));
    m_next->setAccessibleName(tr("Next page"));
    m_previous->setObjectName("previousPage");
    m_next->setObjectName("nextPage");
    auto* top = new QHBoxLayout;
    top->addWidget(all);
    top->addStretch(1);
    top->addWidget(m_place);
    top->addWidget(m_previous);
    top->addWidget(m_next);

    m_heading = new ProseView(page);
    m_heading->setAccessibleName(tr("Heading"));
    m_heading->setFocusPolicy(Qt::NoFocus);
    m_text = new ProseView(page);
    m_text->setAccessibleName(tr("Lesson page"));
    m_text->setObjectName("lessonText");
    m_question = new QuestionCard(page);
    auto* again = new QPushButton(tr("Set the window to this page again"), page);
    again->setProperty("kind", "link");
    again->setObjectName("setWindow");
    auto* handout = new HandoutButton([this] { return m_lesson; }, page);

    auto* content = new QWidget(page);
    auto* column = new QVBoxLayout(content);
    column->addWidget(m_heading);
    column->addWidget(m_text);
    column->addWidget(m_question);
    column->addWidget(again, 0, Qt::AlignLeft);
    column->addWidget(handout, 0, Qt::AlignLeft);
    column->addStretch(1);
    m_scroll = new QScrollArea(page);
    m_scroll->setWidget(content);
    content->setAutoFillBackground(false);  // the dock's surface shows through
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addLayout(top);
    rows->addWidget(m_scroll, 1);

    connect(all, &QPushButton::clicked, this, &LessonPanel::close);
    connect(m_previous, &QToolButton::clicked, this, [this] { goTo(m_page - 1); });
    connect(m_next, &QToolButton::clicked, this, [this] { goTo(m_page + 1); });
    connect(again, &QPushButton::clicked, this, [this] {
        if (mayShow(current())) setWindow();
    });
    connect(handout, &HandoutButton::written, &m_document, &Document::said);
    connect(handout, &HandoutButton::failed, m_errors, &ErrorList::report);
    connect(m_question, &QuestionCard::answered, this, &LessonPanel::check);
    connect(m_question, &QuestionCard::hintAsked, this, [this] {
        const auto hint = m_attempt->hintsSeen() < m_attempt->hintCount()
                              ? m_attempt->nextHint({.frame = *m_pageFrame})
                              : m_attempt->hint(m_attempt->hintCount() - 1, {.frame = *m_pageFrame});
        m_question->say(hint ? toQString(*hint) : toQString(format(hint.errors())), QuestionCard::Comment::Hint);
    });
    followTheme(page, [this, all, top, column] {
        const Theme& theme = Theme::current();
        all->setMinimumWidth(all->fontMetrics().horizontalAdvance(all->text()) + theme.px(12));
        m_place->setFont(theme.text(12));
        top->setContentsMargins(theme.px(10), theme.px(4), theme.px(8), theme.px(4));
        top->setSpacing(theme.px(4));
        column->setContentsMargins(theme.px(12), theme.px(4), theme.px(12), theme.px(12));
        column->setSpacing(theme.px(8));
    });
    return page;
}

bool LessonPanel::open(const QString& name) {
    const lessons::Lesson* const found = m_shelf->find(name);
    if (!found) return false;
    const int reached = m_shelf->page(*found);
    const int page = reached == 0 || reached == int(found->pages.size()) ? 0 : reached - 1;
    if (!mayShow(found->pages[std::size_t(page)])) return false;
    m_lesson = found;
    m_stack->setCurrentIndex(1);
    showPage(page);
    m_next->setFocus();
    return true;
}

bool LessonPanel::openOwn(lessons::Lesson lesson) {
    const QString name = toQString(lesson.name);
    if (m_lesson && toQString(m_lesson->name) == name) close();  // its pages may be others now
    m_shelf->put(std::move(lesson));
    return open(name);
}

void LessonPanel::close() {
    m_lesson = nullptr;
    m_pageFrame.reset();
    m_document.want(this, {});
    m_stack->setCurrentIndex(0);
    m_list->setFocus();
}

void LessonPanel::goTo(int page) {
    if (!m_lesson || page < 0 || page >= int(m_lesson->pages.size())) return;
    if (mayShow(m_lesson->pages[std::size_t(page)])) showPage(page);
}

void LessonPanel::showPage(int page) {
    m_page = page;
    m_pageFrame.reset();
    for (ProseView* view : findChildren<ProseView*>()) view->setPictureFolder(m_lesson->folder);
    m_shelf->setPage(*m_lesson, page + 1);
    const int pages = int(m_lesson->pages.size());
    m_place->setText(tr("page %1 of %2").arg(page + 1).arg(pages));
    m_previous->setEnabled(page > 0);
    m_next->setEnabled(page + 1 < pages);
    m_previous->setToolTip(page > 0 ? tr("Previous page") : tr("Already at the first page."));
    m_next->setToolTip(page + 1 < pages ? tr("Next page") : tr("Already at the last page."));
    m_heading->setProse(toQString(current().heading), ProseView::Tone::Heading);
    m_text->setProse(toQString(withGaps(current().first.text)));
    m_question->setVisible(current().question.has_value());
    m_attempt.reset();
    if (const auto& question = current().question) {
        m_attempt.emplace(*question);
        m_question->ask(toQString(withGaps(question->text)), !question->hints.empty());
        m_question->setReady(false);
    }
    m_scroll->verticalScrollBar()->setValue(0);
    setWindow();
}

// Within one scene a page is a step of undo.
static bool isOpen(const Document& document, const lessons::Page& page) {
    return document.hasScene() && document.scene().file == page.first.state.scene.file;
}

bool LessonPanel::mayShow(const lessons::Page& page) const { return isOpen(m_document, page) || m_mayLeave(); }

void LessonPanel::setWindow() {
    const lessons::PageState& state = current().first.state;
    if (!isOpen(m_document, current()))
        m_document.setScene(state.scene);
    else
        m_document.replace(state.scene, tr("Lesson page %1").arg(m_page + 1));
    m_document.setStage(state.window.stage);
    m_document.pick(lessons::pickedPixel(state));
    m_document.setChannel(state.window.channel);
    m_document.want(this, lessons::requestFor(current()).wanted);
    QStringList names;
    for (const pipeline::BufferName& buffer : lessons::shownBuffers(state)) names << toQString(buffer.text());
    emit showBuffers(names);
}

void LessonPanel::takeFrame() {
    const pipeline::FramePtr& frame = m_document.wholeFrame();
    if (!m_lesson || m_pageFrame || !frame || frame->scene() != current().first.state.scene) return;
    const auto text = lessons::filled(current().first.text, *frame);
    const auto question = current().question ? lessons::filled(current().question->text, *frame) : std::string();
    if (!text || !question) {
        // While a frame is under way, this one may only lack the buffers that the page has asked for.
        if (!m_document.busy())
            m_errors->report(tr("This page cannot be filled in."), text ? question.errors() : text.errors());
        return;
    }
    m_pageFrame = frame;
    m_text->setProse(toQString(*text));
    if (!current().question) return;
    m_question->setQuestion(toQString(*question));
    m_question->setReady(true);
}

void LessonPanel::check(const QString& typed) {
    if (m_attempt->isSettled()) m_attempt.emplace(*current().question);
    const auto verdict = m_attempt->check(lessons::Typed{typed.toStdString()}, {.frame = *m_pageFrame});
    if (!verdict) {
        m_errors->report(tr("This question has no answer here."), verdict.errors());
        return;
    }
    m_question->say(toQString(verdict->said), verdict->mark == lessons::Mark::Right ? QuestionCard::Comment::Right
                                                                                    : QuestionCard::Comment::NotYet);
}

}  // namespace app
