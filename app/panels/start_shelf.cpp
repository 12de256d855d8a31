#include "app/panels/start_shelf.h"

#include <QBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <algorithm>

#include "app/core/text.h"
#include "app/core/word_match.h"
#include "app/panels/follow_theme.h"
#include "app/panels/segmented.h"
#include "app/panels/start_card.h"
#include "app/panels/start_view_card.h"

namespace app {
namespace {

constexpr int kSideBySide = 1240;  // px of the theme: both lectures have room for three cards in a row

QLabel* startLabel(const QString& text, double size, int weight, int tone, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    if (tone > 1) label->setProperty("tone", tone);
    followTheme(label, [=] { label->setFont(Theme::current().text(size, weight)); });
    return label;
}

QString wordsOfCard(const QAbstractButton& card) {
    return card.text() + ' ' + card.accessibleDescription() + ' ' + card.objectName();
}

}  // namespace

StartShelf::StartShelf(QWidget* parent)
    : QWidget(parent),
      m_filter(new QLineEdit(this)),
      m_which(new Segmented({tr("All"), tr("Lecture 1"), tr("Lecture 2")}, this)),
      m_none(startLabel(tr("No match"), 13, 400, 2, this)),
      m_columns(new QBoxLayout(QBoxLayout::TopToBottom)),
      m_below(new QVBoxLayout),
      m_sceneCards(m_gallery.scenes().size()) {
    m_filter->setObjectName("startFilter");
    m_filter->setAccessibleName(tr("Filter scenes and lessons"));
    m_filter->setPlaceholderText(tr("Filter: shadow, normal, painter  ( / )"));
    m_filter->setClearButtonEnabled(true);
    m_which->setObjectName("startLecture");
    m_which->setAccessibleName(tr("Lecture"));
    m_which->setCurrent(0);
    auto* top = new QHBoxLayout;
    top->addWidget(m_which);
    top->addWidget(m_filter, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(top);
    column->addWidget(m_none);
    column->addLayout(m_columns);
    column->addLayout(m_below);
    column->addStretch(1);
    for (const StartLecture& lecture : startOrder()) addLecture(lecture);
    setLessons({});
    connect(m_filter, &QLineEdit::textChanged, this, &StartShelf::filter);
    connect(m_which, &Segmented::chosen, this, [this](int which) { m_which->setCurrent(which), filter(); });
    connect(new QShortcut(QKeySequence(Qt::Key_Slash), this), &QShortcut::activated, m_filter,
            [this] { m_filter->setFocus(Qt::ShortcutFocusReason), m_filter->selectAll(); });
    connect(&m_gallery, &SceneGallery::pictureReady, this, &StartShelf::showPicture);
    followTheme(this, [this, column, top] {
        const Theme& theme = Theme::current();
        column->setSpacing(theme.px(12));
        top->setSpacing(theme.px(12));
        m_columns->setSpacing(theme.px(24));
        m_filter->setFont(theme.text());
        m_filter->setMinimumHeight(theme.px(32));
        m_which->setFixedHeight(theme.px(32));
        m_which->setFixedWidth(Segmented::widthFor({tr("All"), tr("Lecture 1"), tr("Lecture 2")}) + theme.px(30));
    });
}

StartShelf::Group StartShelf::makeGroup(const QString& title, QWidget* parent) {
    auto* heading = startLabel(title, 12, 500, 2, parent);
    heading->setWordWrap(true);
    auto* cards = new CardGrid(parent);
    parent->layout()->addWidget(heading);
    parent->layout()->addWidget(cards);
    return {heading, cards};
}

void StartShelf::addLecture(const StartLecture& lecture) {
    auto* whole = new QWidget(this);
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    row->addWidget(startLabel(lecture.title, 18, 600, 1, whole), 0, Qt::AlignBaseline);
    auto* about = startLabel(lecture.about, 12, 400, 2, whole);
    about->setWordWrap(true);
    row->addWidget(about, 1, Qt::AlignBaseline);
    column->addLayout(row);
    Lecture made{whole, {}, {}, {}};
    for (const StartView& view : lecture.views) {
        auto* card = new StartViewCard(view, whole);
        column->addWidget(card);
        connect(card, &StartViewCard::clicked, this, [this, card] { emit viewChosen(card->view().state); });
        made.views.push_back(card);
    }
    const auto& scenes = m_gallery.scenes();
    for (const StartGroup& group : lecture.groups) {
        const Group cards = makeGroup(group.title, whole);
        for (const std::string& name : group.scenes) {
            const auto scene = std::ranges::find(scenes, name, &pipeline::BuiltInScene::name);
            if (scene == scenes.end()) continue;
            auto* card =
                new StartCard(StartCard::Kind::Scene, toQString(scene->title), toQString(scene->look), cards.cards);
            card->setObjectName(QStringLiteral("scene:") + toQString(name));
            cards.cards->add(card);
            m_sceneCards[std::size_t(scene - scenes.begin())] = card;
            connect(card, &StartCard::clicked, this,
                    [this, file = QString::fromStdString(scene->file.string())] { emit fileChosen(file); });
        }
        made.groups.push_back(cards);
    }
    made.lessons = makeGroup(tr("Lessons: a page at a time, with the window set for you"), whole);
    column->addStretch(1);
    (lecture.views.empty() ? m_below : m_columns)->addWidget(whole, 1);
    m_lectures.push_back(std::move(made));
}

void StartShelf::setLessons(const std::vector<LessonEntry>& lessons) {
    for (const Lecture& lecture : m_lectures) lecture.lessons.cards->clear();
    for (const LessonEntry& lesson : lessons) {
        CardGrid* grid = m_lectures[std::min(lectureOf(lesson.lecture), m_lectures.size() - 1)].lessons.cards;
        auto* card = new StartCard(StartCard::Kind::Lesson, lesson.title, lesson.text, grid);
        card->setObjectName(QStringLiteral("lesson:") + lesson.name);
        const bool begun = lesson.page > 0, done = lesson.page >= lesson.pages;
        card->setFoot(lesson.progress,
                      !begun ? tr("Begin")
                      : done ? tr("Again")
                             : tr("Go on"),
                      double(lesson.page) / lesson.pages);
        grid->add(card);
        card->show();
        connect(card, &StartCard::clicked, this, [this, name = lesson.name] { emit lessonChosen(name); });
    }
    filter();
}

void StartShelf::showPicture(std::size_t picture) {
    const QImage& image = m_gallery.picture(picture);
    if (picture < m_sceneCards.size() && m_sceneCards[picture]) m_sceneCards[picture]->setPicture(image);
    for (const Lecture& lecture : m_lectures)
        for (StartViewCard* card : lecture.views)
            for (std::size_t i = 0; i < card->view().parts.size(); ++i)
                if (m_gallery.find(card->view().parts[i].scene, card->view().parts[i].buffer) == picture)
                    card->setPicture(i, image);
}

// A lecture, group or card without a match gives its room to the others.
void StartShelf::filter() {
    const QString typed = m_filter->text();
    const auto matches = [&](const QAbstractButton& card, const QString& more) {
        return matchWords(typed, wordsOfCard(card) + ' ' + more) != WordMatch::None;
    };
    bool any = false;
    for (std::size_t i = 0; i < m_lectures.size(); ++i) {
        Lecture& lecture = m_lectures[i];
        bool shows = false;
        for (StartViewCard* card : lecture.views) {
            card->setVisible(matches(*card, {}));
            shows |= !card->isHidden();
        }
        std::vector<Group> groups = lecture.groups;
        groups.push_back(lecture.lessons);
        for (const Group& group : groups) {
            const QString title = static_cast<QLabel*>(group.heading)->text();
            const bool has = group.cards->choose([&](const StartCard& card) { return matches(card, title); });
            group.heading->setVisible(has);
            group.cards->setVisible(has);
            shows |= has;
        }
        shows = shows && (m_which->current() == 0 || std::size_t(m_which->current()) == i + 1);
        lecture.whole->setVisible(shows);
        any |= shows;
    }
    m_none->setVisible(!any);
}

void StartShelf::focusFirst() {
    for (const Lecture& lecture : m_lectures)
        for (StartViewCard* card : lecture.views)
            if (card->isVisible()) return card->setFocus(Qt::TabFocusReason);
}

void StartShelf::resizeEvent(QResizeEvent* event) {
    const bool isWide = width() >= Theme::current().px(kSideBySide);
    m_columns->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    QWidget::resizeEvent(event);
}

}  // namespace app
