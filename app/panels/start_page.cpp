#include "app/panels/start_page.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "app/core/recent_files.h"
#include "app/core/shown_name.h"
#include "app/core/text.h"
#include "app/panels/drop_field.h"
#include "app/panels/follow_theme.h"
#include "app/panels/segmented.h"
#include "app/panels/surface.h"

namespace app {

namespace {

QLabel* makeLabel(const QString& text, double size, int weight, int tone, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    if (tone > 1) label->setProperty("tone", tone);
    label->setWordWrap(true);
    followTheme(label, [=] { label->setFont(Theme::current().text(size, weight)); });
    return label;
}

QWidget* makeHeading(const QString& title, const QString& hint, QWidget* parent) {
    auto* heading = new QWidget(parent);
    auto* row = new QHBoxLayout(heading);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(Theme::current().px(12));
    auto* name = makeLabel(title, 16, 600, 1, heading);
    name->setWordWrap(false);
    row->addWidget(name, 0, Qt::AlignBaseline);
    row->addWidget(makeLabel(hint, 12, 400, 2, heading), 1, Qt::AlignBaseline);
    return heading;
}

QString whenText(const QDateTime& when) {
    const qint64 days = when.date().daysTo(QDate::currentDate());
    if (days == 0) return QStringLiteral("today ") + when.toString("HH:mm");
    if (days == 1) return QStringLiteral("yesterday");
    return when.date().toString(days < 7 ? "dddd" : "d MMM");
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
    setObjectName("startPage");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(makeLeft());
    row->addWidget(makeRight(), 1);
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
    column->addWidget(makeLabel(QStringLiteral("Shadescope"), 34, 600, 1, left));
    column->addWidget(makeLabel(tr("See how polygons become a picture, one step at a time."), 16, 400, 2, left));
    auto* open = new QPushButton(tr("Open a file"), left);
    open->setProperty("kind", "primary");
    open->setDefault(true);
    connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(open);
    buttons->addStretch(1);
    column->addSpacing(16);
    column->addLayout(buttons);
    column->addSpacing(8);
    column->addWidget(
        makeLabel(tr("New here? Open the pyramid, press Ctrl+→ and Ctrl+← to walk through the stages, click any "
                     "pixel to see why it has its colour. F1 opens the manual."),
                  13, 400, 2, left));
    column->addSpacing(16);
    column->addWidget(makeHeading(tr("Recent"), QString(), left));
    m_recent = new QVBoxLayout;
    m_recent->setSpacing(2);
    column->addLayout(m_recent);
    column->addStretch(1);
    m_drop = new DropField(tr("Drop a scene or a model here."), left);
    column->addWidget(m_drop);
    column->addSpacing(8);
    auto* theme = new Segmented({tr("Dark"), tr("Light"), tr("Projector")}, left);
    theme->setAccessibleName(tr("Theme"));
    connect(theme, &Segmented::chosen, this, [](int id) { Theme::current().set(ThemeId(id)); });
    auto* themeRow = new QHBoxLayout;
    auto* themeLabel = m_themeLabel = makeLabel(tr("Theme"), 13, 400, 2, left);
    themeLabel->setWordWrap(false);
    themeRow->addWidget(themeLabel);
    themeRow->addWidget(theme, 1);
    column->addLayout(themeRow);
    auto* keys = new QPushButton(tr("Keys, H"), left);
    keys->setProperty("kind", "link");
    connect(keys, &QPushButton::clicked, this, &StartPage::keysRequested);
    auto* foot = new QHBoxLayout;
    foot->addWidget(keys);
    foot->addStretch(1);
    auto* version = makeLabel(tr("Version %1").arg(QCoreApplication::applicationVersion()), 12, 400, 3, left);
    version->setWordWrap(false);
    foot->addWidget(version);
    column->addLayout(foot);
    followTheme(frame, [this, frame, column, theme, open] {
        const Theme& t = Theme::current();
        fitLeft();
        column->setSpacing(t.px(8));
        open->setFont(t.text(13, 500));
        open->setMinimumHeight(t.px(32));
        m_drop->setFont(t.text());
        m_drop->setMargin(t.px(16));
        m_drop->setMinimumHeight(t.px(48));
        theme->setCurrent(int(t.id()));
        frame->setStyleSheet(
            QStringLiteral("QFrame#startLeft { background: %1; border: 0; border-right: 1px solid %2; }")
                .arg(t.colors().surface.name(), t.colors().line.name()));
    });
    return frame;
}

QWidget* StartPage::makeRight() {
    auto* scroll = new QScrollArea(this);
    scroll->setObjectName("startRight");
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* page = new QWidget;
    page->setObjectName("startPageRight");
    auto* column = new QVBoxLayout(page);
    m_shelf = new StartShelf(page);
    column->addWidget(m_shelf);
    connect(m_shelf, &StartShelf::fileChosen, this, &StartPage::fileChosen);
    connect(m_shelf, &StartShelf::viewChosen, this, &StartPage::viewChosen);
    connect(m_shelf, &StartShelf::lessonChosen, this, &StartPage::lessonChosen);
    scroll->setWidget(page);
    followTheme(scroll, [scroll, column] {
        const Theme& t = Theme::current();
        column->setContentsMargins(t.px(24), t.px(20), t.px(24), t.px(24));
        column->setSpacing(t.px(12));
        scroll->setStyleSheet(
            QStringLiteral("QScrollArea#startRight, QWidget#startPageRight { background: %1; border: 0; }")
                .arg(t.colors().bg.name()));
    });
    return scroll;
}

void StartPage::refreshRecent() {
    while (QLayoutItem* item = m_recent->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const auto files = recentFiles();
    if (files.empty()) m_recent->addWidget(makeLabel(tr("Files that you open will be listed here."), 13, 400, 3, this));
    for (const RecentFile& entry : files) {
        auto* line = new QPushButton(shownName(entry.file), this);
        line->setProperty("kind", "link");
        line->setToolTip(entry.file);
        followTheme(line, [line] { line->setFont(Theme::current().text(13, 500)); });
        auto* row = new QWidget(this);
        auto* columns = new QHBoxLayout(row);
        columns->setContentsMargins(0, 0, 0, 0);
        columns->addWidget(line);
        auto* when = makeLabel(whenText(entry.when), 12, 400, 3, row);
        when->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        columns->addWidget(when, 1);
        m_recent->addWidget(row);
        if (!entry.where.isEmpty()) m_recent->addWidget(makeLabel(entry.where, 12, 400, 3, this));
        connect(line, &QPushButton::clicked, this, [this, file = entry.file] { emit recentChosen(file); });
    }
}

void StartPage::setDropHint(bool over) { m_drop->setOver(over); }

// Narrow windows leave the room to the pictures.
void StartPage::fitLeft() {
    const Theme& theme = Theme::current();
    const int wish = theme.px(width() < theme.px(1560) ? 352 : 440);
    m_left->setFixedWidth(std::min(wish, width() * 2 / 5));
    const int side = std::min(theme.px(40), m_left->width() / 12);
    m_column->setContentsMargins(side, theme.px(48), side, theme.px(24));
    const int themes = Segmented::widthFor({tr("Dark"), tr("Light"), tr("Projector")});
    m_themeLabel->setVisible(themes + theme.px(70) <= m_left->width() - 2 * side);
}

void StartPage::resizeEvent(QResizeEvent* event) {
    fitLeft();
    m_drop->setVisible(height() >= Theme::current().px(520));
    QWidget::resizeEvent(event);
}

void StartPage::hideEvent(QHideEvent* event) {
    m_shelf->setWatched(false);
    QWidget::hideEvent(event);
}

void StartPage::showEvent(QShowEvent* event) {
    refreshRecent();
    QWidget::showEvent(event);
    // Once the page itself is on the screen, and not when a scene is opened right away.
    QTimer::singleShot(200, this, [this] {
        if (isVisible()) m_shelf->setWatched(true);
    });
    m_shelf->focusFirst();
}

}  // namespace app
