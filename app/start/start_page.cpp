#include "app/start/start_page.h"

#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/document/recent_files.h"
#include "app/look/shown_name.h"
#include "app/start/drop_field.h"
#include "app/start/start_line.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/segmented.h"
#include "app/widgets/surface.h"
#include "lessons/state/cue_list.h"

namespace app {

namespace {

QLabel* makeLabel(const QString& text, double size, int weight, int tone, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    if (tone > 1) label->setProperty("tone", tone);
    label->setWordWrap(true);
    followTheme(label, [=] { label->setFont(Theme::current().text(size, weight)); });
    return label;
}

QString whenText(const QDateTime& when) {
    const qint64 days = when.date().daysTo(QDate::currentDate());
    return days == 0 ? StartPage::tr("today") : when.date().toString(days < 7 ? "ddd" : "d MMM");
}

QStringList themeNames() { return {StartPage::tr("Dark"), StartPage::tr("Light"), StartPage::tr("Projector")}; }

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
    setObjectName("startPage");
    auto* row = spaced(new QHBoxLayout(this), {}, 0);
    row->addWidget(makeLeft());
    m_right = new QVBoxLayout;
    row->addLayout(m_right, 1);
    m_shelf = new StartShelf(this);
    m_right->addWidget(m_shelf);
    connect(m_shelf, &StartShelf::fileChosen, this, &StartPage::fileChosen);
    connect(m_shelf, &StartShelf::viewChosen, this, &StartPage::viewChosen);
    connect(m_shelf, &StartShelf::lessonChosen, this, &StartPage::lessonChosen);
    connect(m_shelf, &StartShelf::talkChosen, this, &StartPage::talkChosen);
    followTheme(this, [this] {
        const Theme& t = Theme::current();
        m_left->setStyleSheet(
            QStringLiteral("QFrame#startLeft { background: %1; border: 0; border-right: 1px solid %2; }")
                .arg(t.colors().surface.name(), t.colors().line.name()));
        fit();
    });
}

QWidget* StartPage::makeLeft() {
    auto* frame = new QFrame(this);
    m_left = frame;
    frame->setObjectName("startLeft");
    auto* left = new QWidget(frame);
    left->setProperty("kind", "page");
    auto* column = m_column = new QVBoxLayout(left);
    auto* around = new QVBoxLayout(frame);
    around->setContentsMargins(0, 0, 1, 0);  // the line at its right
    around->addWidget(scrolling(left, frame));
    column->addWidget(makeLabel(QStringLiteral("Shadescope"), 24, 600, 1, left));
    m_slogan = makeLabel(tr("See how polygons become a picture, one step at a time."), 13, 400, 2, left);
    column->addWidget(m_slogan);
    column->addWidget(makeButtons(left));
    column->addWidget(makeLabel(tr("Recent"), 13, 600, 1, left));
    column->addLayout(m_recent = new QVBoxLayout);
    column->addWidget(makeLabel(tr("Tools"), 13, 600, 1, left));
    column->addLayout(m_tools = new QVBoxLayout);
    for (QVBoxLayout* lines : {m_recent, m_tools}) lines->setSpacing(0);
    column->addStretch(1);
    m_drop = new DropField(tr("Drop a scene, a model or your renderer's folder here."), left);
    m_drop->setWordWrap(true);
    column->addWidget(m_drop);
    makeThemes(left);
    followTheme(m_drop, [this] {
        m_drop->setFont(Theme::current().text());
        m_drop->setMargin(Theme::current().px(12));
    });
    return frame;
}

QWidget* StartPage::makeButtons(QWidget* left) {
    auto* buttons = new QWidget(left);
    auto* row = spaced(new QHBoxLayout(buttons), {});
    auto* open = new QPushButton(tr("Open a file"), buttons);
    open->setProperty("kind", "primary");
    m_new = new QPushButton(tr("New…"), buttons);
    m_new->setObjectName("startNew");
    m_new->setToolTip(tr("A new scene with one shape."));
    connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
    for (QPushButton* button : {open, m_new}) {
        button->setAutoDefault(true);  // Enter presses it
        row->addWidget(button);
        followTheme(button, [button] {
            button->setFont(Theme::current().text(13, 500));
            button->setMinimumHeight(Theme::current().px(28));
        });
    }
    row->addStretch(1);
    return buttons;
}

// Side by side, or as a list where there is no room.
void StartPage::makeThemes(QWidget* left) {
    auto* themes = new Segmented(themeNames(), left);
    m_themes = themes;
    m_themeList = new QComboBox(left);
    for (const QString& name : themeNames()) m_themeList->addItem(tr("Theme: %1").arg(name));
    for (QWidget* part : {m_themes, static_cast<QWidget*>(m_themeList)}) {
        part->setAccessibleName(tr("Theme"));
        m_column->addWidget(part);
    }
    const auto choose = [](int id) { Theme::current().set(ThemeId(id)); };
    connect(themes, &Segmented::chosen, this, choose);
    connect(m_themeList, &QComboBox::activated, this, choose);
    followTheme(themes, [this, themes] {
        const int id = int(Theme::current().id());
        themes->setCurrent(id);
        themes->setMinimumHeight(Theme::current().px(24));
        m_themeList->setCurrentIndex(id);
        m_themeList->setFont(Theme::current().text());
    });
}

void StartPage::addTool(const QString& icon, const QString& text, const QString& tip,
                        const std::function<void(QWidget& line)>& run) {
    auto* line = new StartLine(text, tip, m_left);
    line->setIcon(icon);
    line->setObjectName(QStringLiteral("tool:") + text);
    connect(line, &StartLine::clicked, this, [line, run] { run(*line); });
    m_tools->addWidget(line);
}

void StartPage::refreshRecent() {
    while (QLayoutItem* item = m_recent->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_lines.clear();
    const auto files = recentFiles();
    if (files.empty()) m_recent->addWidget(makeLabel(tr("Files that you open will be listed here."), 13, 400, 2, this));
    for (const RecentFile& entry : files) {
        if (m_lines.size() == 4) break;  // File, Open recent has all of them
        auto* line = new StartLine(nameOf(entry), entry.file, this);
        line->setPlace(whenText(entry.when), entry.where);
        line->setAccessibleDescription(entry.where);
        connect(line, &StartLine::clicked, this, [this, file = entry.file] { emit recentChosen(file); });
        m_recent->addWidget(line);
        m_lines += line;
    }
}

// What each lecture's list of cues has, and where its talk was left.
void StartPage::refreshTalks() {
    const auto files = recentFiles();
    for (std::size_t i = 0; i < m_shelf->lectures().size(); ++i) {
        const QString& file = m_shelf->lectures()[i].talk;
        const auto list = lessons::readCueFile(file.toStdString());
        if (!list) continue;
        StartTalk talk{.cues = int(list->cues.size()), .minutes = list->minutes};
        const auto left = std::ranges::find(files, file, &RecentFile::file);
        if (left != files.end() && !left->state.isEmpty())
            if (const auto cue = findCue(*list, left->state.toStdString())) talk.cue = int(*cue) + 1;
        m_shelf->setTalk(i, talk);
    }
}

void StartPage::setDropHint(bool over) { m_drop->setOver(over); }

void StartPage::fit() {
    const StartFit fit = fitStart(size());
    m_right->setContentsMargins(fit.side, Theme::current().px(10), fit.side, Theme::current().px(10));
    m_shelf->fit(fit);
    fitLeft(fit);
}

// Where the column is too low, its parts are left out in this order until the rest fits.
void StartPage::fitLeft(const StartFit& fit) {
    const Theme& theme = Theme::current();
    m_left->setFixedWidth(fit.left);
    const int side = fit.isWide ? theme.px(28) : theme.px(fit.left >= theme.px(230) ? 18 : 13);
    m_column->setContentsMargins(side, theme.px(fit.isWide ? 28 : 12), side, theme.px(10));
    m_column->setSpacing(theme.px(8));
    const auto setShown = [this](int recent, bool isTimed) {
        for (qsizetype i = 0; i < m_lines.size(); ++i)
            m_lines[i]->setVisible(i < recent), m_lines[i]->setTimed(isTimed);
    };
    const bool isNarrow = Segmented::widthFor(themeNames()) > fit.left - 2 * side;
    for (int gone = 0; gone <= 5; ++gone) {
        m_drop->setVisible(gone < 1);
        setShown(gone >= 2 ? 2 : fit.isWide ? 4 : 3, gone < 4);
        m_slogan->setVisible(gone < 3);
        m_themes->setVisible(gone < 5 && !isNarrow);
        m_themeList->setVisible(gone >= 5 || isNarrow);
        m_column->invalidate();
        if (m_column->totalHeightForWidth(fit.left - 1) <= height()) break;
    }
}

void StartPage::resizeEvent(QResizeEvent* event) {
    fit();
    QWidget::resizeEvent(event);
}

void StartPage::hideEvent(QHideEvent* event) {
    m_shelf->setWatched(false);
    QWidget::hideEvent(event);
}

void StartPage::showEvent(QShowEvent* event) {
    refreshRecent();
    refreshTalks();
    QWidget::showEvent(event);
    fit();
    // Once the page itself is on the screen, and not when a scene is opened right away.
    QTimer::singleShot(200, this, [this] {
        if (isVisible()) m_shelf->setWatched(true);
    });
    m_shelf->focusFirst();
}

}  // namespace app
