#include "app/docks/status_line.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <QLabel>
#include <QPushButton>

#include "app/frames/stage_status.h"
#include "app/look/text.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/opening_bar.h"
#include "app/widgets/work_bar.h"
#include "pipeline/run/frame_remarks.h"
#include "pipeline/scene/settings_table.h"

namespace app {

using pipeline::BufferId;

QString pixelText(const pipeline::Frame& frame, glm::ivec2 pixel) {
    const pipeline::Settings& settings = frame.scene().settings;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= settings.width || pixel.y >= settings.height) return {};
    const std::size_t x = std::size_t(pixel.x), y = std::size_t(pixel.y);
    QString text = QStringLiteral("%1, %2").arg(pixel.x).arg(pixel.y);
    if (const auto id = frame.buffer({BufferId::PolygonId})) {
        const int polygon = int(id->value(x, y));
        text += polygon < 0 ? QStringLiteral("  background") : QStringLiteral("  polygon %1").arg(polygon);
    }
    if (const auto color = frame.buffer({BufferId::Color})) {
        for (int c = 0; c < 3; ++c)
            text += QStringLiteral("%1%2").arg(c == 0 ? "  " : " ").arg(int(color->value(x, y, c)));
    }
    return text;
}

StatusLine::StatusLine(Document& document, const SceneOpener& opener, QWidget* parent)
    : QStatusBar(parent), m_document(document) {
    setSizeGripEnabled(false);
    const auto add = [this] {
        auto* label = new QLabel(this);
        label->setProperty("tone", 2);
        addPermanentWidget(label);
        return label;
    };
    auto* opening = new OpeningBar(opener, this);
    addWidget(opening);
    addWidget(new WorkBar(document.work(), this));
    m_sentence = new ElidedLabel(this);
    m_sentence->setProperty("tone", 2);
    m_sentence->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    addWidget(m_sentence, 1);
    connect(opening, &OpeningBar::cancelAsked, this, &StatusLine::cancelAsked);
    m_hovered = add();
    m_turn = new QPushButton(this);
    m_turn->setObjectName("statusTurn");
    m_turn->setProperty("kind", "link");
    m_turn->hide();
    addPermanentWidget(m_turn);
    connect(m_turn, &QPushButton::clicked, this, [this] {
        const auto up = findSetting(m_document.scene(), "up");
        if (up) m_document.change(*up, 1 - up->get(m_document.scene()));
    });
    m_remarks = add();
    m_nan = add();
    m_nan->setTextFormat(Qt::RichText);
    m_error = add();
    m_threads = add();
    m_sentence->setObjectName("statusSentence");
    m_hovered->setObjectName("statusHovered");
    m_remarks->setObjectName("statusRemarks");
    m_nan->setObjectName("statusNan");
    m_error->setObjectName("statusError");
    m_threads->setObjectName("statusThreads");
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        for (QLabel* label : {static_cast<QLabel*>(m_sentence), m_hovered, m_remarks, m_nan, m_error, m_threads}) {
            label->setFont(theme.text(12));
            label->setIndent(theme.px(12));
        }
        m_turn->setFont(theme.text(12));
        m_hovered->setFont(theme.mono(12));
        m_sentence->setContentsMargins(theme.px(12), 0, 0, 0);
        setFixedHeight(theme.px(28));
        showCheck();
        makeRoom(true);
    });
    const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    m_threads->setText(threads == 1 ? tr("1 thread") : tr("%1 threads").arg(threads));
    connect(&document, &Document::said, this, &StatusLine::say);
    connect(&document.pointing(), &Pointing::hoverChanged, this, &StatusLine::showHovered);
    connect(&document.frames(), &FrameFeed::frameReady, this, &StatusLine::showHovered);
    connect(&document.frames(), &FrameFeed::frameReady, this, &StatusLine::showCheck);
    connect(&document.frames(), &FrameFeed::errorsReady, this, &StatusLine::showCheck);
    connect(&document, &Document::hiddenChanged, this, &StatusLine::showHovered);
    connect(&document, &Document::hiddenChanged, this, &StatusLine::showCheck);
    document.frames().want(this, pipeline::setOf({BufferId::PolygonId}));
}

void StatusLine::say(const QString& sentence) {
    m_sentence->setText(sentence);
    m_sentence->setToolTip(sentence);
    makeRoom(true);
}

void StatusLine::setQuiet(bool quiet) {
    if (std::exchange(m_isQuiet, quiet) == quiet) return;
    showCheck();
    makeRoom(true);
}

void StatusLine::showHovered() {
    const auto pixel = m_document.pointing().hovered();
    const lessons::Hidden& hidden = m_document.hidden();
    const bool known = pixel && m_document.frames().shown() && !hidden.hides({BufferId::PolygonId}) &&
                       !hidden.hides({BufferId::Color});
    m_hovered->setText(known ? tr("under the cursor: ") + pixelText(*m_document.frames().shown(), *pixel) : QString());
    makeRoom(false);
}

void StatusLine::showCheck() {
    const ThemeColors& c = Theme::current().colors();
    const auto badge = [](const char* mark, const QColor& color, const QString& text) {
        return QStringLiteral("<span style=\"color:%1\">%2</span> %3").arg(color.name(), mark, text);
    };
    const auto nan = m_document.frames().nanCount();
    m_nan->setText(!nan || (*nan == 0 && m_isQuiet) ? QString()
                   : *nan == 0                      ? badge("●", c.run, tr("no NaN"))
                                                    : badge("▲", c.failed, tr("%1 NaN").arg(qulonglong(*nan))));
    const auto& error = m_document.frames().errors()[index(pipeline::StageId::Shading)];
    showRemarks();
    m_error->setText(error ? tr("shading's error against double %1").arg(errorOf(*error)) : QString());
}

// The error stands in the stage's card too. What has given way comes back with the next sentence, not while the cursor
// moves.
void StatusLine::makeRoom(bool anew) {
    int needed = m_sentence->sizeHint().width() + (m_turn->isHidden() ? 0 : m_turn->sizeHint().width());
    for (const QLabel* label : {m_hovered, m_remarks, m_nan})
        if (!label->text().isEmpty()) needed += label->sizeHint().width();
    const QList<QLabel*> last{m_error, m_threads};
    for (QLabel* label : last) {
        needed += label->sizeHint().width();
        const bool fits = needed <= width() && !m_isQuiet;
        // Set once: a label that is shown and then hidden resizes the window, which calls this function again.
        if (fits != label->isVisibleTo(this) && (anew || !fits)) label->setVisible(fits);
    }
}

void StatusLine::resizeEvent(QResizeEvent* event) {
    QStatusBar::resizeEvent(event);
    makeRoom(true);
}

void StatusLine::showRemarks() {
    const pipeline::FramePtr frame = m_document.frames().shown();
    const auto remarks =
        frame && m_document.hidden().count() == 0 ? pipeline::frameRemarks(*frame) : std::vector<pipeline::Remark>();
    QStringList lines;
    for (const pipeline::Remark& remark : remarks)
        lines << toQString(remark.about.empty() ? remark.text : remark.about + ": " + remark.text);
    m_remarks->setText(remarks.empty()       ? QString()
                       : remarks.size() == 1 ? tr("1 remark")
                                             : tr("%1 remarks").arg(remarks.size()));
    m_remarks->setToolTip(lines.join(QLatin1Char('\n')));
    m_remarks->setAccessibleDescription(m_remarks->toolTip());
    // Which axis is up was a guess, and is still what was guessed.
    const auto up = frame && !remarks.empty() ? findSetting(frame->scene(), "up") : pipeline::Error{};
    const std::string guess = up ? "up=" + formatSetting(*up, up->get(frame->scene())) : std::string();
    m_turn->setVisible(up && std::ranges::count(frame->scene().remarks, guess, &pipeline::Remark::about) > 0);
    m_turn->setText(guess == "up=y" ? tr("y taken as up: use z") : tr("z taken as up: use y"));
}

}  // namespace app
