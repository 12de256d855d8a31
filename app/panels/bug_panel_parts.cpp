// What a BugPanel is made of; the game is in bug_panel.cpp.
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/core/spoken.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/bug_panel.h"
#include "app/panels/follow_theme.h"
#include "app/panels/math_view.h"
#include "app/panels/surface.h"

namespace app {

namespace {

QPushButton* bugButton(const QString& text, const char* name, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(name);
    button->setAutoDefault(true);  // Enter presses the one that has the focus
    return button;
}

QVBoxLayout* bare(QWidget* parent) {
    auto* column = new QVBoxLayout(parent);
    column->setContentsMargins(0, 0, 0, 0);
    return column;
}

}  // namespace

BugPanel::BugPanel(QWidget* parent) : QWidget(parent) {
    setObjectName("bugPanel");
    setWindowTitle(tr("The wrong picture"));
    setAttribute(Qt::WA_StyledBackground);
    auto* middle = new QSplitter(Qt::Horizontal, this);
    QWidget* boxes = makeBoxes();
    middle->addWidget(makePictures());
    middle->addWidget(makeCard());
    middle->setChildrenCollapsible(false);
    middle->setStretchFactor(0, 1);
    auto* column = new QVBoxLayout(this);
    column->addWidget(boxes);
    column->addWidget(middle, 1);
    addShortcuts();
    connect(&m_job, &BackgroundJob::busyChanged, this, &BugPanel::showState);
    followTheme(this, [this, column, middle] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(theme.px(8), theme.px(8), theme.px(8), theme.px(8));
        column->setSpacing(theme.px(8));
        middle->setHandleWidth(theme.px(8));
        middle->setSizes({theme.px(1000), theme.px(340)});
        setStyleSheet(QStringLiteral("#bugPanel { background: %1; }").arg(theme.colors().bg.name()));
    });
    showState();
}

QLabel* BugPanel::makeLabel(const char* name, double size, int weight, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    followTheme(label, [label, size, weight] { label->setFont(Theme::current().text(size, weight)); });
    return label;
}

QWidget* BugPanel::makePictures() {
    auto* both = new QSplitter(Qt::Horizontal, this);
    both->setChildrenCollapsible(false);
    const auto canvas = [&](const QString& name, const char* object) {
        auto* made = new BufferCanvas(both);
        made->setObjectName(object);
        made->setAccessibleName(name);
        made->setFocusPolicy(Qt::StrongFocus);
        connect(made, &BufferCanvas::nudged, this, &BugPanel::moveCursor);
        return made;
    };
    m_picture = canvas(tr("The wrong picture"), "bugPicture");
    connect(m_picture, &BufferCanvas::picked, this, [this](QPoint at) {
        if (m_game && m_game->phase() != lessons::WrongPicture::Phase::Over) look(glm::ivec2(at.x(), at.y()));
    });
    both->addWidget(surface(m_picture, both));
    auto* right = new QWidget(both);
    auto* column = new QVBoxLayout(right);
    m_buffers = new QComboBox(right);
    m_buffers->setObjectName("bugBuffers");
    nameChoice(*m_buffers, tr("Open a buffer: it counts as a look"));
    m_buffers->setToolTip(tr("Opening a buffer is a look. Alt+1 to Alt+6 open the main buffer of a stage."));
    connect(m_buffers, &QComboBox::activated, this, [this](int row) {
        const auto name = pipeline::findBuffer(m_buffers->itemData(row).toString().toStdString());
        if (name) look(*name);
    });
    m_opened = canvas(tr("The buffer that was opened"), "bugOpened");
    connect(m_opened, &BufferCanvas::picked, this, [this](QPoint at) {
        const bool isPicture = m_buffer && bufferInfo(m_buffer->id).domain == pipeline::Domain::Pixel;
        if (m_game && isPicture && m_game->phase() != lessons::WrongPicture::Phase::Over)
            look(glm::ivec2(at.x(), at.y()));
    });
    column->addWidget(m_buffers);
    column->addWidget(m_opened, 1);
    both->addWidget(surface(right, both));
    both->setStretchFactor(0, 3);
    both->setStretchFactor(1, 2);
    followTheme(both, [both, column] {
        const Theme& theme = Theme::current();
        both->setHandleWidth(theme.px(8));
        column->setContentsMargins(0, theme.px(4), 0, 0);
        column->setSpacing(theme.px(4));
    });
    for (BufferCanvas* one : {m_picture, m_opened})
        connect(one, &BufferCanvas::wiped, this, [this](double share) { moveWipe(share - m_share); });
    return both;
}

QWidget* BugPanel::makeCard() {
    auto* card = new QWidget(this);
    m_heading = makeLabel("bugHeading", 15, 600, card);
    m_what = makeLabel("bugWhat", 13, 400, card);
    m_count = makeLabel("bugCount", 13, 600, card);
    m_looks = new QListWidget(card);
    m_looks->setObjectName("bugLooks");
    m_looks->setAccessibleName(tr("Looks"));
    m_text = new QPlainTextEdit(card);
    m_text->setObjectName("bugText");
    m_text->setReadOnly(true);
    m_text->setTabChangesFocus(true);
    m_text->setAccessibleName(tr("What was seen and said last"));
    m_pixel = new QLineEdit(card);
    m_pixel->setObjectName("bugPixel");
    m_pixel->setPlaceholderText(tr("Look at a pixel: column, row"));
    m_pixel->setAccessibleName(m_pixel->placeholderText());
    connect(m_pixel, &QLineEdit::returnPressed, this, &BugPanel::lookAtText);

    m_stagePart = new QWidget(card);
    auto* stage = bare(m_stagePart);
    m_stageWords = makeLabel("bugStageWords", 12, 400, m_stagePart);
    m_accuse = bugButton(tr("This one is wrong  Enter"), "bugAccuse", m_stagePart);
    m_accuse->setProperty("kind", "primary");
    m_hint = bugButton(tr("Hint  H"), "bugHint", card);
    connect(m_accuse, &QPushButton::clicked, this, &BugPanel::accuse);
    connect(m_hint, &QPushButton::clicked, this, &BugPanel::giveHint);
    stage->addWidget(m_stageWords);
    stage->addWidget(m_accuse);

    m_causePart = new QWidget(card);
    auto* cause = bare(m_causePart);
    m_causeWords = makeLabel("bugCauseWords", 12, 400, m_causePart);
    for (std::size_t i = 0; i < m_causes.size(); ++i) {
        m_causes[i] = new QRadioButton(m_causePart);
        m_causes[i]->setObjectName(QStringLiteral("bugCause:%1").arg(i + 1));
        connect(m_causes[i], &QRadioButton::toggled, this, [this, i](bool on) {
            if (on) name(int(i));
        });
        cause->addWidget(m_causes[i]);
    }
    m_nameCause = bugButton(tr("That is the cause  Enter"), "bugNameCause", m_causePart);
    m_nameCause->setProperty("kind", "primary");
    connect(m_nameCause, &QPushButton::clicked, this, &BugPanel::nameCause);
    cause->addWidget(m_causeWords);
    cause->addWidget(m_nameCause);

    m_overPart = new QWidget(card);
    auto* over = bare(m_overPart);
    m_wrongName = makeLabel("bugWrongName", 12, 600, m_overPart);
    m_rightName = makeLabel("bugRightName", 12, 600, m_overPart);
    m_wrongEquation = new MathView(m_overPart);
    m_rightEquation = new MathView(m_overPart);
    m_fix = makeLabel("bugFix", 13, 400, m_overPart);
    m_next = bugButton(tr("Next picture  Enter"), "bugNext", m_overPart);
    m_next->setProperty("kind", "primary");
    m_lesson = bugButton({}, "bugLesson", m_overPart);
    m_lesson->setProperty("kind", "link");
    connect(m_next, &QPushButton::clicked, this, &BugPanel::next);
    for (QWidget* part : std::initializer_list<QWidget*>{m_wrongName, m_wrongEquation, m_rightName, m_rightEquation,
                                                         m_fix, m_next, m_lesson})
        over->addWidget(part);
    connect(m_lesson, &QPushButton::clicked, this, [this] {
        const pipeline::DefectRow& row = m_game->row();
        emit lessonAsked(QString::fromUtf8(row.lesson.data(), qsizetype(row.lesson.size())),
                         QString::fromUtf8(row.heading.data(), qsizetype(row.heading.size())));
    });

    m_foot = makeLabel("bugFoot", 12, 400, card);
    m_seedField = new QLineEdit(card);
    m_seedField->setObjectName("bugSeed");
    m_seedField->setPlaceholderText(tr("Seed: the same number, the same pictures"));
    m_seedField->setAccessibleName(m_seedField->placeholderText());
    connect(m_seedField, &QLineEdit::returnPressed, this, [this] {
        bool isNumber = false;
        const qulonglong seed = m_seedField->text().trimmed().toULongLong(&isNumber);
        if (!isNumber) return say(tr("A seed is a whole number, such as 2026."));
        m_seedField->clear();
        begin(seed);
    });
    auto* scrolled = new QWidget(card);
    auto* column = new QVBoxLayout(scrolled);
    for (QWidget* part : std::initializer_list<QWidget*>{m_heading, m_what, m_stagePart, m_causePart, m_overPart,
                                                         m_hint, m_count, m_looks, m_pixel, m_text})
        column->addWidget(part);
    auto* scroll = new QScrollArea(card);
    scroll->setWidget(scrolled);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* rows = new QVBoxLayout(card);
    rows->addWidget(scroll, 1);
    rows->addWidget(m_foot);
    rows->addWidget(m_seedField);
    followTheme(card, [this, column, rows, card] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(theme.px(7));
        rows->setContentsMargins(theme.px(12), theme.px(10), theme.px(12), theme.px(10));
        rows->setSpacing(theme.px(6));
        card->setMinimumWidth(theme.px(280));
        m_looks->setFont(theme.mono(12));
        m_looks->setFixedHeight(theme.px(84));
        m_text->setFont(theme.mono(12));
        m_text->setMinimumHeight(theme.px(120));
        for (QRadioButton* one : m_causes) one->setFont(theme.text(13));
        for (MathView* one : {m_wrongEquation, m_rightEquation}) one->setBaseSize(14);
    });
    return surface(card, this);
}

}  // namespace app
