#include "app/lesson/lesson_panel.h"

#include <QListView>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/document/hand.h"
#include "app/lesson/handout_button.h"
#include "app/lesson/lesson_end.h"
#include "app/lesson/lesson_head.h"
#include "app/lesson/lesson_keys.h"
#include "app/lesson/lesson_page.h"
#include "app/lesson/lesson_results_dialog.h"
#include "app/lesson/question_card.h"
#include "app/look/text.h"
#include "app/widgets/error_list.h"
#include "app/widgets/fitting_stack.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/kept_in_sight.h"
#include "app/widgets/surface.h"

namespace app {

static constexpr const char* kOnlyThis = "lesson/onlyThis";
static constexpr double kScaleOfFoot = 1.3;  // of the text: from here on Check stays in sight while the page scrolls

LessonPanel::LessonPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_shelf(new LessonShelf(this)),
      m_run(document),
      m_stack(new FittingStack(this)),
      m_errors(new ErrorList(this)) {
    setObjectName("lesson");
    m_errors->setObjectName("lessonErrors");  // the window has a list of its own
    auto* column = spaced(new QVBoxLayout(this), {}, 0);
    column->addWidget(m_errors);
    column->addWidget(m_stack, 1);
    m_stack->addWidget(makeList());
    m_stack->addWidget(makeLesson());
    for (auto* button : findChildren<QPushButton*>()) button->setAutoDefault(true);  // Enter presses them
    if (!m_shelf->errors().empty()) m_errors->report(tr("A lesson cannot be read."), m_shelf->errors());
    connect(&m_run, &LessonRun::pageChanged, this, &LessonPanel::showPage);
    connect(&m_run, &LessonRun::filled, this, [this] {
        m_page->fill();
        m_keys->pageFilled();
        emit bannerChanged();
    });
    connect(&m_run, &LessonRun::changed, this, &LessonPanel::showChange);
    connect(&m_run, &LessonRun::showViews, this, &LessonPanel::showViews);
    connect(&m_run, &LessonRun::failed, this,
            [this](const pipeline::Errors& errors) { m_errors->report(tr("This page cannot be filled in."), errors); });
    connect(&document, &Document::sceneChanged, this, [this] {
        if (lesson() && !m_run.isAtEnd()) m_page->card().showWindow();
    });
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

QWidget* LessonPanel::makeLesson() {
    auto* all = new QWidget(this);
    m_head = new LessonHead(m_run, all);
    auto* content = new QWidget(all);
    auto* column = spaced(new QVBoxLayout(content), {});
    m_page = new LessonPage(m_run, m_document, content);
    m_end = new LessonEnd(m_run, *m_shelf, content);
    HandoutButton* const handout = m_handout = new HandoutButton([this] { return lesson(); }, content);
    column->addWidget(m_page, 1);
    column->addWidget(m_end, 1);
    auto* below = spaced(new QHBoxLayout, {12, 0, 12, 8});
    below->addWidget(handout);
    below->addStretch(1);
    column->addLayout(below);
    m_scroll = scrolling(content, all);
    m_scroll->setFrameShape(QFrame::NoFrame);
    content->setAutoFillBackground(false);  // the dock's surface shows through
    m_foot = new LessonFoot(m_run, all);
    auto* rows = spaced(new QVBoxLayout(all), {}, 0);
    rows->addWidget(m_head);
    rows->addWidget(m_scroll, 1);
    rows->addWidget(m_foot);

    m_head->onlyThis().setChecked(isOnlyThis());
    connect(&m_head->onlyThis(), &QToolButton::toggled, this, &LessonPanel::setOnlyThis);
    connect(m_head, &LessonHead::leaveAsked, this, &LessonPanel::close);
    connect(m_head, &LessonHead::handoutAsked, this, &LessonPanel::writeHandout);
    // Beside a picture that is held what can wait is left out.
    const auto fit = [this] {
        if (!lesson()) return;
        const bool isQuiet = isHeld();
        m_head->setQuiet(isQuiet);
        m_foot->setQuiet(isQuiet);
        m_handout->setVisible(!isQuiet);
    };
    connect(&m_document.hand(), &Hand::taken, this, fit);
    connect(this, &LessonPanel::pageChanged, this, fit);
    connect(this, &LessonPanel::onlyThisChanged, this, fit);
    connect(handout, &HandoutButton::written, &m_document, &Document::said);
    connect(handout, &HandoutButton::failed, m_errors, &ErrorList::report);
    QuestionCard& card = m_page->card();
    m_keys = new LessonKeys(*this, m_run, card, *m_foot);
    connect(&card, &QuestionCard::settled, this, &LessonPanel::settle);
    connect(&card, &QuestionCard::said, &m_document, &Document::said);
    m_sight = new KeptInSight(*m_scroll);  // what is said to an answer stands below it
    connect(&card, &QuestionCard::said, m_sight, [this, &card] { m_sight->keep(&card.note()); });
    connect(&card, &QuestionCard::failed, m_errors, &ErrorList::report);
    connect(&card, &QuestionCard::adviceChanged, this, [this, &card] {
        if (!card.advice().isEmpty()) emit m_document.said(card.advice());
    });
    connect(m_end, &LessonEnd::beginAsked, this, &LessonPanel::open);
    connect(m_end, &LessonEnd::allAsked, this, &LessonPanel::close);
    connect(m_end, &LessonEnd::forgetAsked, this, &LessonPanel::askToForget);
    connect(m_end, &LessonEnd::resultsAsked, this,
            [this] { LessonResultsDialog::showResults(*m_shelf, m_run.results(), this); });
    followTheme(handout, [rows, &card] { card.standIn(Theme::current().scale() > kScaleOfFoot ? rows : nullptr); });
    return all;
}

bool LessonPanel::open(const QString& name) {
    const lessons::Lesson* const found = m_shelf->find(name);
    if (!found) {
        if (m_shelf->findListed(name)) m_errors->report(tr("This lesson cannot be read."), m_shelf->errors());
        return false;
    }
    if (found != lesson()) m_shelf->setReturning(*found, m_run.results().all());
    const int reached = m_shelf->page(*found);
    const int page = reached == 0 || reached == int(found->pages.size()) ? 0 : reached - 1;
    if (!lesson()) emit opens();
    m_stack->setCurrentIndex(1);
    m_run.open(*found, page);
    return true;
}

bool LessonPanel::openOwn(lessons::Lesson lesson) {
    const QString name = toQString(lesson.name);
    if (this->lesson() && toQString(this->lesson()->name) == name) close();  // its pages may be others now
    m_shelf->put(std::move(lesson));
    return open(name);
}

void LessonPanel::close() {
    if (!lesson()) return;
    m_run.close();
    m_stack->setCurrentIndex(0);
    m_list->setFocus();
    emit closed();
}

void LessonPanel::writeHandout() { m_handout->click(); }

bool LessonPanel::isOnlyThis() const { return QSettings().value(kOnlyThis, true).toBool(); }

void LessonPanel::setOnlyThis(bool only) {
    QSettings().setValue(kOnlyThis, only);
    const QSignalBlocker quiet(m_head->onlyThis());
    m_head->onlyThis().setChecked(only);
    emit onlyThisChanged();
}

bool LessonPanel::isHeld() const { return lesson() && isOnlyThis() && !m_document.hand().isEmpty(); }

QString LessonPanel::banner() const { return lesson() && !m_run.isAtEnd() ? m_page->card().banner() : QString(); }

void LessonPanel::showPage() {
    if (lesson()) {
        const bool atEnd = m_run.isAtEnd();
        m_shelf->setPage(*lesson(), std::min(page() + 1, m_run.pageCount()));
        m_page->setVisible(!atEnd);
        m_end->setVisible(atEnd);
        atEnd ? m_end->showRun() : m_page->showPage();
        m_sight->keep(nullptr);
        m_scroll->verticalScrollBar()->setValue(0);
        m_head->showRun();
        m_foot->showRun();
        atEnd ? m_keys->waitForNone() : m_keys->pageShown();
        if (atEnd) m_end->takeFocus();
    }
    emit pageChanged();
    emit bannerChanged();
}

void LessonPanel::showChange() {
    m_head->showRun();
    m_foot->showRun();
}

void LessonPanel::settle() {
    m_page->showThen();
    showChange();
    m_foot->takeFocus();
    emit bannerChanged();
}

void LessonPanel::askToForget() {
    auto* box = new QMessageBox(QMessageBox::Question, tr("Forget my results"),
                                tr("Everything that you have answered in lessons will be removed from this machine."),
                                QMessageBox::Cancel, this);
    box->setObjectName("forgetBox");
    QPushButton* forget = box->addButton(tr("Forget"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(forget, &QPushButton::clicked, this, [this] {
        m_run.results().forget();
        m_shelf->forgetPages();
        m_run.goTo(0);
    });
    box->open();
}

}  // namespace app
