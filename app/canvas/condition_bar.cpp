#include "app/canvas/condition_bar.h"

#include <QApplication>
#include <QGridLayout>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include "app/frames/derived_buffers.h"
#include "app/look/icons.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;

namespace {

constexpr BufferName kMask{BufferId::Condition}, kNumbers{BufferId::Expression};

}  // namespace

ConditionBar::ConditionBar(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_text(new QLineEdit(this)),
      m_said(new ElidedLabel(this)),
      m_previous(new QToolButton(this)),
      m_next(new QToolButton(this)),
      m_stop(new QToolButton(this)),
      m_close(new QToolButton(this)) {
    hide();
    m_text->setAccessibleName(tr("Condition over all pixels"));
    m_text->setPlaceholderText("n_dot_l.0 > 0.9 && x < 300");
    m_text->setToolTip(tr("Buffers by name, x and y, + − * / ^, < <= > >= == !=, ! && ||, length and dot of vectors"));
    const auto button = [](QToolButton* made, const char* iconName, const QString& name) {
        made->setIcon(icon(iconName));
        made->setAccessibleName(name);
        made->setToolTip(name);
    };
    button(m_previous, "chevron-left", tr("The pixel before for which it holds (Shift+Enter)"));
    button(m_next, "chevron-right", tr("The next pixel for which it holds (Enter)"));
    button(m_stop, "flag",
           tr("On to the next step after which it holds at a pixel (Ctrl+Enter); Play stops there too"));
    button(m_close, "close", tr("No condition (Esc)"));
    auto* grid = new QGridLayout(this);
    auto* words = new QLabel(this);  // in place of all else, for an audience
    words->setObjectName("conditionWords");
    words->setTextFormat(Qt::PlainText);
    words->hide();
    grid->addWidget(words, 0, 0, 1, 5);
    grid->addWidget(m_text, 0, 0);
    grid->addWidget(m_previous, 0, 1);
    grid->addWidget(m_next, 0, 2);
    grid->addWidget(m_stop, 0, 3);
    grid->addWidget(m_close, 0, 4);
    grid->addWidget(m_said, 1, 0, 1, 5);
    grid->setColumnStretch(0, 1);

    connect(m_text, &QLineEdit::textChanged, words, &QLabel::setText);
    m_text->setText(document.derived().text());
    connect(m_text, &QLineEdit::textChanged, &document.derived(), &DerivedBuffers::setText);
    connect(&document.derived(), &DerivedBuffers::textChanged, this, [this] {
        if (m_text->text() != m_document.derived().text()) m_text->setText(m_document.derived().text());
        read();
    });
    connect(&document.derived(), &DerivedBuffers::changed, this, [this](const BufferName& name) {
        if (!isHidden() && (name == kMask || name == kNumbers)) tell();
    });
    connect(m_previous, &QToolButton::clicked, this, [this] { goTo(false); });
    connect(m_next, &QToolButton::clicked, this, [this] { goTo(true); });
    connect(m_stop, &QToolButton::clicked, this, &ConditionBar::runToStop);
    connect(m_close, &QToolButton::clicked, this, &ConditionBar::close);
    connect(&m_searching, &BackgroundJob::progressed, this, [this](double share) {
        say(tr("Looking for the next step, %1 %. Esc cancels.").arg(int(100 * share)), false);
    });
    connect(&m_document.frames(), &FrameFeed::frameReady, this, [this] {
        if (isHidden()) return;
        // A frame that holds more buffers of the same scene has the same steps.
        if (m_document.frames().shown()->sharedScene() != m_searchedScene) m_searching.forget();
        if (!m_searching.busy()) tell();
    });
    Stepper& stepper = m_document.stepper();
    connect(&stepper, &Stepper::changed, this, &ConditionBar::watchPlay);
    connect(this, &QObject::destroyed, &stepper, [this, &stepper] {
        stepper.setStop(this, {});
        stepper.setHeld(this, false);
    });
    connect(this, &ConditionBar::changed, this, &ConditionBar::watchPlay);
    connect(&stepper, &Stepper::stopped, this, [this](const QObject* who) {
        if (who != this) return;
        m_document.pointing().pick(m_stopsAt);
        emit m_document.said(tr("Play stopped: the condition holds at %1, %2.").arg(m_stopsAt.x).arg(m_stopsAt.y));
    });
    connect(&m_watching, &BackgroundJob::progressed, this,
            [this](double share) { say(tr("Looking for where Play stops, %1 %.").arg(int(100 * share)), false); });
    connect(&m_document, &Document::sceneChanged, this, [this] {
        if (!isHidden()) read();  // lights may come and go
    });
    followTheme(this, [this, grid] {
        const Theme& theme = Theme::current();
        grid->setContentsMargins(theme.px(6), theme.px(4), theme.px(6), theme.px(2));
        grid->setSpacing(theme.px(2));
        m_text->setFont(theme.mono(13));
        m_said->setFont(theme.text(12));
        for (QToolButton* made : {m_previous, m_next, m_stop, m_close}) made->setIconSize(QSize(1, 1) * theme.px(16));
    });
}

void ConditionBar::open() {
    reveal();
    showWords(false);
    m_text->setFocus();
    m_text->selectAll();
}

void ConditionBar::reveal() {
    showWords(property("bare").toBool());
    show();
    read();
}

void ConditionBar::setBare(bool bare) {
    setProperty("bare", bare);
    showWords(bare);
}

void ConditionBar::showWords(bool words) {
    auto* label = findChild<QLabel*>("conditionWords");
    label->setVisible(words);
    for (QWidget* part : std::initializer_list<QWidget*>{m_text, m_said, m_previous, m_next, m_stop, m_close})
        part->setVisible(!words);
    label->setFont(Theme::current().mono(14));  // one set while it was hidden does not outlive a style sheet
}

void ConditionBar::close() {
    if (isAncestorOf(QApplication::focusWidget())) emit left();
    hide();
    read();
}

void ConditionBar::setText(const QString& text) { m_text->setText(text); }
QString ConditionBar::said() const { return m_said->text(); }

std::shared_ptr<const lessons::ConditionMask> ConditionBar::mask() const {
    const lessons::DerivedBuffer* made = m_condition && !isHidden() ? m_document.derived().made(kMask) : nullptr;
    return made ? made->mask : nullptr;
}

bool ConditionBar::busy() const {
    const DerivedJob* job = m_document.derived().find(kMask);
    return m_searching.busy() || (job && job->busy());
}

void ConditionBar::say(const QString& text, bool isWrong) {
    const ThemeColors& c = Theme::current().colors();
    const QString style = QString("color: %1").arg((isWrong ? c.failed : c.text2).name());
    if (style != m_said->styleSheet()) m_said->setStyleSheet(style);
    m_said->setText(text);
    setAccessibleDescription(text);
    const auto found = mask();
    const QString why = found && found->count > 0 ? QString() : tr("It holds for no pixel.");
    for (QToolButton* made : {m_previous, m_next}) made->setEnabled(why.isEmpty());
}

void ConditionBar::read() {
    m_searching.forget();  // of another text or scene, or of a bar that is closed
    m_condition.reset();
    m_wrong.clear();
    m_isOfNumbers = false;
    DerivedBuffers& derived = m_document.derived();
    const std::string text = derived.text().trimmed().toStdString();
    if (!isHidden() && m_document.hasScene() && !text.empty()) {
        auto condition = lessons::parseCondition(text, {{}, 1, 1}, {m_document.scene()});
        m_isOfNumbers = !condition && lessons::parseNumbers(text, {{}, 1, 1}, {m_document.scene()});
        if (condition)
            m_condition = std::move(condition).value();
        else if (!m_isOfNumbers)
            m_wrong = DerivedBuffers::sentenceOf(condition.errors().front());
    }
    std::vector<BufferName> wanted;
    if (m_condition) wanted = {kMask};
    if (m_isOfNumbers) wanted = {kNumbers};
    derived.want(this, wanted);
    watchPlay();  // which may no longer wait for it
    tell();
}

void ConditionBar::tell() {
    const DerivedBuffers& derived = m_document.derived();
    if (const auto found = mask()) {
        const double share = found->drawn > 0 ? 100.0 * double(found->count) / double(found->drawn) : 0;
        say(tr("Holds for %1 of %2 drawn pixels, %3 %")
                .arg(count(qint64(found->count)), count(qint64(found->drawn)), number(share, 1)),
            false);
    } else if (m_isOfNumbers) {
        const QString why = derived.whyNot(kNumbers);
        say(why.isEmpty() ? tr("A number at every pixel: the buffer \"expression\" shows it.") : why, false);
    } else {
        say(m_condition ? derived.whyNot(kMask) : m_wrong, !m_wrong.isEmpty());
    }
    emit changed();
}

void ConditionBar::goTo(bool next) {
    const auto found = mask();
    if (!found) return;
    if (const auto pixel = lessons::nextHolding(*found, m_document.pointing().pixel(), next))
        m_document.pointing().pick(*pixel);
}

void ConditionBar::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (event->modifiers() & Qt::ControlModifier) return runToStop();
            return goTo(!(event->modifiers() & Qt::ShiftModifier));
        case Qt::Key_Escape:
            if (!m_searching.busy()) return close();
            m_searching.forget();
            return tell();
        default: event->accept();  // letters typed here are no keys of the view
    }
}

QImage veilOf(const lessons::ConditionMask& mask) {
    const QColor ground = Theme::current().colors().view;
    const QRgb veil = qPremultiply(qRgba(ground.red(), ground.green(), ground.blue(), 200));
    QImage image(mask.size.x, mask.size.y, QImage::Format_ARGB32_Premultiplied);
    std::size_t i = 0;
    for (int y = 0; y < mask.size.y; ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < mask.size.x; ++x) line[x] = mask.holds[i++] ? QRgb(0) : veil;
    }
    return image;
}

void ConditionBar::runToStop() {
    const Stepper& stepper = m_document.stepper();
    if (!m_condition) return;
    if (!stepper.steps()) return say(tr("The steps of the frame are being counted."), false);
    const StepsPtr steps = stepper.steps();
    const pipeline::Moment from = stepper.isInside() && stepper.moment() ? *stepper.moment() : steps->first();
    m_searchedScene = m_document.frames().shown()->sharedScene();
    m_searching.ask(
        [condition = *m_condition, steps, from](const BackgroundJob::Control& control) {
            return nextStop(*steps, from, condition, control.stop, control.progress);
        },
        [this](const std::optional<lessons::ConditionStop>& found) {
            if (!found) return say(tr("No later step makes it hold at a pixel."), false);
            m_document.stepper().goTo(found->moment);
            m_document.pointing().pick(found->pixel);
            emit m_document.said(tr("The condition holds at %1, %2.").arg(found->pixel.x).arg(found->pixel.y));
        });
}

void ConditionBar::watchPlay() {
    Stepper& stepper = m_document.stepper();
    const auto forget = [&] {
        m_watching.forget();
        m_ahead.reset();
        stepper.setStop(this, {});
        stepper.setHeld(this, false);
    };
    if (!m_condition || !stepper.isPlaying() || !stepper.steps() || !stepper.moment()) return forget();
    const pipeline::Moment now = *stepper.moment();
    const bool known = m_ahead && m_ahead->steps == stepper.steps() && m_ahead->condition == m_condition->text &&
                       now >= m_ahead->from && !(m_ahead->stop && now > m_ahead->stop->moment);
    if (known) return;
    forget();
    stepper.setHeld(this, true);
    m_ahead = Ahead{stepper.steps(), now, m_condition->text, {}};
    m_watching.ask(
        [condition = *m_condition, steps = stepper.steps(), now](const BackgroundJob::Control& control) {
            return nextStop(*steps, now, condition, control.stop, control.progress);
        },
        [this](const std::optional<lessons::ConditionStop>& found) {
            if (m_ahead) m_ahead->stop = found;
            if (found) m_stopsAt = found->pixel;
            m_document.stepper().setStop(this, found ? std::optional(found->moment) : std::nullopt);
            m_document.stepper().setHeld(this, false);
            tell();  // how many, again
        });
}

}  // namespace app
