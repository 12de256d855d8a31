#include "app/stages/timeline.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "app/look/accessible.h"
#include "app/look/icons.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/stages/step_bar.h"
#include "app/widgets/fitting_font.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/segmented.h"

namespace app {
namespace {

constexpr std::array kIcons{"first", "previous", "play", "next", "last"};

constexpr std::array kSpeeds{0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};

QString speedText(double speed) {
    return speed == 0.25  ? QStringLiteral("¼×")
           : speed == 0.5 ? QStringLiteral("½×")
                          : QStringLiteral("%1×").arg(speed);
}

QStringList levelNames() {
    QStringList names;
    for (std::size_t level = 0; level < pipeline::kStepLevelCount; ++level)
        names += toQString(name(pipeline::StepLevel(level)));
    return names;
}

}  // namespace

Timeline::Timeline(Document& document, const Transport& transport, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_by(styled(new QLabel(tr("Step by"), this), {.tone = 2, .size = 12})),
      m_levels(new Segmented(levelNames(), this)),
      m_levelList(new QComboBox(this)),
      m_bar(new StepBar(document.stepper(), this)),
      m_words(new QLabel(this)),
      m_speed(new QComboBox(this)) {
    setObjectName("timeline");
    setAccessibleName(tr("Timeline"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    Stepper& stepper = document.stepper();
    auto* row = spaced(new QHBoxLayout(this), {4, 0, 4, 0}, 6);
    const std::array actions{transport.first, transport.back, transport.play, transport.next, transport.last};
    constexpr std::array kNames{"firstStep", "stepBack", "play", "stepOn", "lastStep"};
    for (std::size_t i = 0; i < actions.size(); ++i)
        row->addWidget(m_buttons[i] = addButton(actions[i], kNames[i], kIcons[i]));
    m_levels->setObjectName("stepLevel");
    m_levelList->setObjectName("stepLevelList");
    m_levels->setAccessibleName(tr("What a step is"));
    nameComboBox(*m_levelList, tr("What a step is"));
    for (const QString& level : levelNames()) m_levelList->addItem(tr("by %1").arg(level));
    m_levels->setToolTip(tr("What a step is. A stage without such parts takes its own next larger ones."));
    m_levelList->setToolTip(m_levels->toolTip());
    m_words->setObjectName("stepWords");
    m_speed->setObjectName("stepSpeed");
    nameComboBox(*m_speed, tr("Speed"));
    m_speed->setToolTip(tr("How fast it plays"));
    for (const double speed : kSpeeds) m_speed->addItem(speedText(speed), speed);
    m_speed->setCurrentIndex(2);
    row->addWidget(m_by);
    row->addWidget(m_levels);
    row->addWidget(m_levelList);
    row->addWidget(m_bar, 1);
    row->addWidget(m_words);
    row->addWidget(m_speed);

    connect(m_levels, &Segmented::chosen, this, [&stepper](int level) { stepper.setLevel(Stepper::Level(level)); });
    connect(m_levelList, &QComboBox::activated, this,
            [&stepper](int level) { stepper.setLevel(Stepper::Level(level)); });
    connect(m_speed, &QComboBox::activated, this,
            [this, &stepper](int i) { stepper.setSpeed(m_speed->itemData(i).toDouble()); });
    connect(&stepper, &Stepper::changed, this, &Timeline::show);
    connect(&document, &Document::stageChanged, this, &Timeline::show);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        for (QToolButton* button : m_buttons) button->setIconSize(QSize(1, 1) * theme.px(16));
        for (QComboBox* list : {m_speed, m_levelList}) list->setFont(theme.text(12));
        setCompact(m_compact);
    });
    show();
}

QToolButton* Timeline::addButton(QAction* action, const char* name, const char* icon) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setObjectName(name);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setIcon(app::icon(icon));
    button->setFocusPolicy(Qt::StrongFocus);
    button->setAccessibleName(action->text());
    connect(action, &QAction::changed, button, [this] { show(); });
    return button;
}

void Timeline::setCompact(bool compact) {
    m_compact = compact;
    const Theme& theme = Theme::current();
    setFixedHeight(theme.px(compact ? 40 : 50));  // and a margin of 3 above and below in the bar
    m_levels->setVisible(!compact);
    m_by->setVisible(!compact);
    m_levelList->setVisible(compact);
    m_bar->setCompact(compact);
    fitWords();
    show();
}

// Room for the longest words, so that the track does not move under the hand. In large letters the names of the stages
// go before: both ends, which the menu and keys have too, then letters give way.
void Timeline::fitWords() {
    const Theme& theme = Theme::current();
    const QFont mono = theme.mono(12);
    const QString longest(m_compact ? 25 : 29, QLatin1Char('0'));
    const auto widthIn = [&](const QFont& font) { return QFontMetrics(font).horizontalAdvance(longest); };
    const auto roomWith = [&](bool ends) {
        m_buttons.front()->setVisible(ends), m_buttons.back()->setVisible(ends);
        int room = width() - m_bar->widthForNames() - 2 * theme.px(4) - theme.px(6);
        for (int i = 0; i < layout()->count(); ++i)
            if (QWidget* part = layout()->itemAt(i)->widget(); part != m_bar && part != m_words && !part->isHidden())
                room -= part->sizeHint().width() + theme.px(6);
        return room;
    };
    int room = roomWith(true);
    if (room < widthIn(mono)) room = roomWith(false);
    m_words->setFont(fittingFont(mono, {longest}, room, std::max(12, theme.px(9))));
    m_words->setFixedWidth(widthIn(m_words->font()));
}

void Timeline::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitWords();
    show();
}

QString Timeline::words() const { return m_words->text(); }

void Timeline::show() {
    const Stepper& stepper = m_document.stepper();
    m_bar->setStage(m_document.stage());
    m_levels->setCurrent(int(stepper.level()));
    m_levelList->setCurrentIndex(int(stepper.level()));
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        const bool pauses = i == 2 && stepper.isPlaying();
        m_buttons[i]->setIcon(app::icon(pauses ? "pause" : kIcons[i]));
        m_buttons[i]->setAccessibleName(m_buttons[i]->defaultAction()->text());
    }
    QString words = tr("whole frame"), counts;
    if (stepper.isInside() && stepper.steps()) {
        const pipeline::Steps& steps = *stepper.steps();
        const pipeline::Moment at = *stepper.moment();
        words = stepper.words();
        const Stepper::Level level = stepper.level();
        if (!stepper.isLeftOut())
            counts = tr("%1 of %2").arg(count(steps.made(at, level)), count(steps.count(at.stage, level)));
        if (!counts.isEmpty() && (level == Stepper::Level::Object || level == Stepper::Level::Polygon))
            words += QStringLiteral(", ") + counts;
    }
    m_words->setText(QFontMetrics(m_words->font()).elidedText(words, Qt::ElideRight, m_words->width()));
    m_words->setToolTip(counts.isEmpty() ? words : tr("%1: %2 steps of this kind in the stage").arg(words, counts));
}

}  // namespace app
