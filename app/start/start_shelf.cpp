#include "app/start/start_shelf.h"

#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QShortcut>
#include <algorithm>

#include "app/look/icons.h"
#include "app/look/text.h"
#include "app/start/start_card.h"
#include "app/start/start_lecture.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/segmented.h"
#include "app/widgets/surface.h"

namespace app {
namespace {

const QString kLectureKey = QStringLiteral("start/lecture");  // 0, 1, or 2 for both

QStringList lectureChoices() {
    return {StartShelf::tr("Lecture 1"), StartShelf::tr("Lecture 2"), StartShelf::tr("All")};
}

}  // namespace

StartShelf::StartShelf(QWidget* parent)
    : QWidget(parent),
      m_order(startOrder()),
      m_which(new Segmented(lectureChoices(), this)),
      m_filter(new QLineEdit(this)),
      m_keys(new QLabel(tr("Arrows move, Enter opens, Tab goes to the lessons"), this)),
      m_none(new QPushButton(this)),
      m_page(new QWidget),
      m_fit(fitStart({1366, 736})) {
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addWidget(makeTop());
    column->addWidget(m_none, 0, Qt::AlignLeft);
    m_area = scrolling(m_page, this);
    m_area->setObjectName("startScroll");
    m_area->setProperty("kind", "fields");
    column->addWidget(m_area, 1);
    m_columns = new QBoxLayout(QBoxLayout::TopToBottom, m_page);
    m_columns->setContentsMargins(0, 0, 0, 0);
    for (const StartLecture& lecture : m_order) addLecture(lecture);
    setLessons({});
    m_page->installEventFilter(this);
    connect(&m_gallery, &SceneGallery::pictureReady, this, &StartShelf::showPicture);
    followTheme(this, [this, column] { column->setSpacing(Theme::current().px(8)); });
}

QWidget* StartShelf::makeTop() {
    auto* top = new QWidget(this);
    auto* row = spaced(new QHBoxLayout(top), {}, 12);
    for (QWidget* part : {static_cast<QWidget*>(m_which), static_cast<QWidget*>(m_filter)}) row->addWidget(part);
    row->addWidget(m_keys);
    row->addStretch(0);
    row->setStretchFactor(m_filter, 1);
    m_filter->setObjectName("startFilter");
    m_filter->setAccessibleName(tr("Filter scenes and lessons"));
    m_filter->setToolTip(
        tr("Searches names, sentences and headings of both lectures. Press / to come here, Enter to "
           "open the first hit."));
    m_filter->setClearButtonEnabled(true);
    m_filter->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_filter->installEventFilter(this);
    m_which->setObjectName("startLecture");
    m_which->setAccessibleName(tr("Lecture"));
    m_which->setCurrent(std::clamp(QSettings().value(kLectureKey, 0).toInt(), 0, 2));
    m_keys->setProperty("tone", 2);
    m_none->setObjectName("startNoMatch");
    m_none->setProperty("kind", "link");
    connect(m_none, &QPushButton::clicked, this, [this] { m_filter->clear(), m_filter->setFocus(); });
    connect(m_filter, &QLineEdit::textChanged, this, &StartShelf::filter);
    connect(m_which, &Segmented::chosen, this, [this](int which) {
        m_which->setCurrent(which);
        QSettings().setValue(kLectureKey, which);
        arrange();
    });
    connect(new QShortcut(QKeySequence(Qt::Key_Slash), this), &QShortcut::activated, m_filter,
            [this] { m_filter->setFocus(Qt::ShortcutFocusReason), m_filter->selectAll(); });
    followTheme(top, [this] {
        const Theme& theme = Theme::current();
        m_filter->setFont(theme.text());
        m_filter->setFixedHeight(theme.px(31));
        m_which->setFixedSize(Segmented::widthFor(lectureChoices()) + theme.px(60), theme.px(31));
        m_keys->setFont(theme.text(12));
    });
    return top;
}

void StartShelf::addLecture(const StartLecture& lecture) {
    auto* shelf = new LectureShelf(lecture, m_gallery.scenes(), m_page);
    connect(shelf, &LectureShelf::sceneChosen, this, &StartShelf::openScene);
    connect(&shelf->first(), &StartViewCard::opened, this,
            [this, shelf] { emit viewChosen(shelf->first().view().state); });
    connect(&shelf->first(), &StartViewCard::talkAsked, this, [this, file = lecture.talk] { emit talkChosen(file); });
    connect(&shelf->lessons(), &StartLessons::chosen, this, &StartShelf::lessonChosen);
    m_columns->addWidget(shelf, 1);
    m_lectures.push_back({shelf, true});
}

void StartShelf::setLessons(const std::vector<StartLesson>& lessons) {
    for (std::size_t i = 0; i < m_lectures.size(); ++i) {
        std::vector<StartLesson> own;  // with those that belong to no lecture
        std::ranges::copy_if(lessons, std::back_inserter(own),
                             [i](const StartLesson& lesson) { return lesson.lecture.value_or(i) == i; });
        m_lectures[i].shelf->lessons().setLessons(own);
    }
    m_allLessons = lessons;
    filter();
}

void StartShelf::setTalk(std::size_t lecture, const StartTalk& talk) {
    m_lectures.at(lecture).shelf->first().setTalk(talk);
}

void StartShelf::showPicture(std::size_t picture) {
    const ScenePicture& shown = m_gallery.picture(picture);
    for (const auto& [lecture, hasHit] : m_lectures) {
        if (picture < m_gallery.scenes().size())
            if (const auto card = lecture->cards().find(m_gallery.scenes()[picture].name);
                card != lecture->cards().end())
                card->second->setPicture(shown);
        const auto& parts = lecture->first().view().parts;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (m_gallery.find(parts[i].scene, parts[i].buffer) == picture) lecture->first().setPicture(i, shown);
    }
}

void StartShelf::openScene(const std::string& name) {
    const auto& scenes = m_gallery.scenes();
    const auto scene = std::ranges::find(scenes, name, &pipeline::BuiltInScene::name);
    if (scene != scenes.end()) emit fileChosen(toQString(scene->file.string()));
}

std::optional<std::size_t> StartShelf::one() const {
    if (m_fit.isWide || !m_filter->text().isEmpty() || m_which->current() >= int(m_lectures.size())) return {};
    return std::size_t(m_which->current());
}

void StartShelf::fit(const StartFit& fit) {
    m_fit = fit;
    m_which->setVisible(!fit.isWide);
    m_keys->setVisible(fit.isWide);
    m_filter->setMaximumWidth(fit.isWide ? Theme::current().px(620) : QWIDGETSIZE_MAX);
    m_columns->setDirection(fit.isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_columns->setSpacing(fit.isWide ? Theme::current().px(28) : fit.gap);
    arrange();
}

// A lecture, group or card without a match gives its room to the others.
void StartShelf::filter() {
    for (Lecture& lecture : m_lectures) lecture.hasHit = lecture.shelf->filter(m_filter->text());
    m_area->verticalScrollBar()->setValue(0);
    arrange();
}

void StartShelf::arrange() {
    const auto shown = one();
    for (std::size_t i = 0; i < m_lectures.size(); ++i) {
        LectureShelf& lecture = *m_lectures[i].shelf;
        lecture.setVisible(m_lectures[i].hasHit && shown.value_or(i) == i);
        lecture.fit(m_fit, !shown);
        lecture.setMinimumHeight(shown || m_fit.isWide ? 0 : lecture.wantedHeight());
    }
    m_none->setVisible(!firstHit());
    m_none->setText(tr("No scene or lesson matches %1. Clear the filter").arg(m_filter->text()));
    m_filter->setPlaceholderText(width() < Theme::current().px(760)
                                     ? tr("Filter  /")
                                     : tr("Filter %1 scenes and %2 lessons: shadow, normal, painter   /")
                                           .arg(m_gallery.scenes().size())
                                           .arg(m_allLessons.size()));
}

void StartShelf::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

LectureShelf* StartShelf::firstHit() const {
    const auto hit = std::ranges::find_if(m_lectures, [](const Lecture& one) { return !one.shelf->isHidden(); });
    return hit == m_lectures.end() ? nullptr : hit->shelf;
}

bool StartShelf::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_page && event->type() == QEvent::Resize) arrange();  // in its new width
    if (watched == m_filter && event->type() == QEvent::KeyPress) {
        LectureShelf* const hit = firstHit();
        switch (static_cast<QKeyEvent*>(event)->key()) {
            case Qt::Key_Return:
            case Qt::Key_Enter:
                if (hit) hit->openFirst();
                return true;
            case Qt::Key_Down:
                if (hit) hit->focusFirst();
                return true;
            case Qt::Key_Escape: m_filter->clear(); return true;
            default: break;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void StartShelf::focusFirst() {
    if (LectureShelf* hit = firstHit()) hit->focusFirst();
}

}  // namespace app
