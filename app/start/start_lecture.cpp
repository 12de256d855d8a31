#include "app/start/start_lecture.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <algorithm>

#include "app/look/text.h"
#include "app/look/word_match.h"
#include "app/start/start_card.h"
#include "app/start/start_lesson_row.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/surface.h"

namespace app {
namespace {

QWidget* makeLectureTitle(const StartLecture& lecture, QWidget* parent) {
    auto* title = new QWidget(parent);
    auto* row = spaced(new QHBoxLayout(title), {}, 12);
    auto* name = new QLabel(lecture.title, title);
    auto* about = styled(new QLabel(lecture.about, title), {.tone = 2, .size = 13});
    row->addWidget(name, 0, Qt::AlignBaseline);
    row->addWidget(about, 1, Qt::AlignBaseline);
    followTheme(title, [name] { name->setFont(Theme::current().text(16, 600)); });
    return title;
}

}  // namespace

LectureShelf::LectureShelf(const StartLecture& lecture, const std::vector<pipeline::BuiltInScene>& scenes,
                           QWidget* parent)
    : QWidget(parent),
      m_title(makeLectureTitle(lecture, this)),
      m_first(new StartViewCard(lecture, this)),
      m_grid(new SceneGrid),
      m_scenes(scrolling(m_grid, this)),
      m_lessons(new StartLessons(this)),
      m_fit(fitStart({1366, 736})) {
    m_scenes->setProperty("kind", "fields");
    for (const StartGroup& group : lecture.groups) {
        m_grid->beginGroup(group.title);
        for (const std::string& name : group.scenes) {
            const auto scene = std::ranges::find(scenes, name, &pipeline::BuiltInScene::name);
            if (scene == scenes.end()) continue;
            auto* card = new StartCard(toQString(scene->title), toQString(scene->look), m_grid);
            card->setObjectName(QStringLiteral("scene:") + toQString(name));
            m_grid->add(card);
            m_cards.emplace(name, card);
            connect(card, &StartCard::clicked, this, [this, name] { emit sceneChosen(name); });
        }
    }
    connect(m_first, &StartViewCard::sceneChosen, this, &LectureShelf::sceneChosen);
    connect(m_grid, &SceneGrid::leftUp, m_first, [this] { m_first->setFocus(Qt::TabFocusReason); });
    connect(m_first, &StartViewCard::leftDown, this, [this] {
        if (!m_grid->shown().isEmpty()) m_grid->shown().front()->setFocus(Qt::TabFocusReason);
    });
}

void LectureShelf::fit(const StartFit& fit, bool withTitle) {
    m_fit = fit;
    m_title->setVisible(withTitle);
    m_first->setPictureHeight(fit.pictures);
    m_lessons->setColumns(fit.isWide ? 2 : 1);
    m_grid->setMostPicture(fit.isWide ? 0.68 : 0.9);
    place();
}

int LectureShelf::gap() const { return m_fit.gap; }

int LectureShelf::wantedHeight() const {
    const int wide = std::max(1, width()), beside = m_lessons->isHidden() || m_fit.isWide ? 0 : m_fit.lessons + gap();
    const int scenes = m_grid->leastHeight(wide - beside);
    const int lessons = m_lessons->isHidden() ? 0 : m_lessons->wantedHeight(m_fit.isWide ? wide : m_fit.lessons);
    return (m_title->isHidden() ? 0 : m_title->sizeHint().height() + gap()) +
           (m_first->isHidden() ? 0 : m_first->wantedHeight() + gap()) +
           (m_fit.isWide ? scenes + gap() + lessons : std::max(scenes, lessons));
}

void LectureShelf::resizeEvent(QResizeEvent*) { place(); }

void LectureShelf::place() {
    int y = 0;
    const auto under = [&](QWidget& part, int high) {
        if (part.isHidden()) return;
        part.setGeometry(0, y, width(), high);
        y += high + gap();
    };
    under(*m_title, m_title->sizeHint().height());
    under(*m_first, m_first->wantedHeight());
    const int room = std::max(0, height() - y);
    if (m_lessons->isHidden()) return m_scenes->setGeometry(0, y, width(), room);
    if (m_scenes->isHidden()) {
        m_lessons->setGeometry(0, y, m_fit.isWide ? width() : m_fit.lessons, room);
    } else if (m_fit.isWide) {
        const int low = std::min(m_lessons->wantedHeight(width()), room / 2);
        m_lessons->setGeometry(0, height() - low, width(), low);
        m_scenes->setGeometry(0, y, width(), room - low - gap());
    } else {
        m_scenes->setGeometry(0, y, width() - m_fit.lessons - gap(), room);
        m_lessons->setGeometry(width() - m_fit.lessons, y, m_fit.lessons, room);
    }
}

bool LectureShelf::filter(const QString& typed) {
    const auto matches = [&](const QString& words) { return matchWords(typed, words) != WordMatch::None; };
    m_first->setVisible(matches(m_first->words()));
    m_grid->choose([&](const StartCard& card, const QString& heading) {
        return matches(
            QStringList{card.text(), card.accessibleDescription(), card.objectName(), heading}.join(QChar(' ')));
    });
    const bool lessons = m_lessons->choose([&](const LessonRow& row) {
        return matches(QStringList{row.text(), row.accessibleDescription(), row.objectName()}.join(QChar(' ')));
    });
    m_lessons->setVisible(lessons);
    m_scenes->setVisible(!m_grid->shown().isEmpty());
    place();
    return lessons || !m_first->isHidden() || !m_scenes->isHidden();
}

void LectureShelf::openFirst() {
    if (!m_first->isHidden()) return m_first->press();
    if (!m_grid->shown().isEmpty()) return m_grid->shown().front()->click();
    if (!m_lessons->shown().isEmpty()) m_lessons->shown().front()->click();
}

void LectureShelf::focusFirst() {
    QWidget* first = m_first;
    if (m_first->isHidden()) first = m_grid->shown().value(0);
    if (!first) first = m_lessons->shown().value(0);
    if (first) first->setFocus(Qt::TabFocusReason);
}

}  // namespace app
