#include "app/inspector/equation_section.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "app/document/changed_settings.h"
#include "app/frames/equation_symbols.h"
#include "app/inspector/math_view.h"
#include "app/look/number_format.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/segmented.h"

namespace app {

using pipeline::EquationLine;
using pipeline::Formula;

namespace {

// A line of words.
EquationLine words(const char* role, const QString& text) {
    Formula formula;
    formula.kind = Formula::Kind::Text;
    formula.text = text.toStdString();
    return {role, formula, {}};
}

const EquationLine* resultOf(const std::vector<EquationLine>& lines) {
    const auto found =
        std::find_if(lines.begin(), lines.end(), [](const EquationLine& l) { return l.role == "result"; });
    return found == lines.end() ? nullptr : &*found;
}

// "45.000 + 69.714 + 0.025 = 114.739"
QString resultText(const std::vector<EquationLine>& lines) {
    const EquationLine* result = resultOf(lines);
    QString text = result ? toQString(toText(result->formula)) : QString();
    if (text.startsWith('=')) text = text.mid(1).trimmed();
    return text;
}

// ", with n = 4": what the settings that have changed were before.
QString settingsText(const pipeline::Scene& before, const pipeline::Scene& now) {
    constexpr std::size_t kMost = 2;
    const std::vector<pipeline::SettingRef> changed = differingSettings(before, now);
    if (changed.empty() || changed.size() > kMost) return changed.empty() ? QString() : EquationSection::tr(", before");
    QStringList settings;
    for (const pipeline::SettingRef& setting : changed)
        settings << QStringLiteral("%1 = %2").arg(symbolOf(setting),
                                                  toQString(formatSetting(setting, setting.get(before))));
    return EquationSection::tr(", with %1").arg(settings.join(", "));
}

QString modelName(pipeline::Model model) { return toQString(pipeline::modelFacts(model).label); }

// Where the terms were evaluated is said at the end, below the vectors, when it is said once.
void moveRemarkDown(std::vector<EquationLine>& lines) {
    if (lines.empty() ||
        std::count_if(lines.begin(), lines.end(), [](const EquationLine& l) { return l.role == "symbols"; }) != 1)
        return;
    if (lines[0].remark.empty()) return;
    lines.push_back(words("note", toQString(lines[0].remark) + '.'));
    lines[0].remark.clear();
}

}  // namespace

EquationSection::EquationSection(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_math(new MathView(this)),
      m_switcher(new QWidget(this)),
      m_model(styled(new QLabel(m_switcher), {.tone = 2, .size = 12})),
      m_keep(new QToolButton(m_switcher)),
      m_channels(new Segmented({"r", "g", "b"}, m_switcher)) {
    auto* row = spaced(new QHBoxLayout(m_switcher), {});
    row->addStretch();
    row->addWidget(m_keep);
    row->addWidget(m_model);
    row->addWidget(m_channels);
    m_channels->setAccessibleName(tr("Channel of the equation"));
    m_keep->setText(tr("Keep"));
    m_keep->setCheckable(true);
    m_keep->setAccessibleName(tr("Keep the result before"));
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addWidget(m_math);
    m_math->setAccessibleName(tr("Illumination equation"));

    connect(m_channels, &Segmented::chosen, &document.pointing(), &Pointing::setChannel);
    connect(m_keep, &QToolButton::clicked, this, &EquationSection::setKept);
    connect(m_math, &MathView::pointedAt, this, [this](const QString& refers) {
        const bool isMaximum = refers == "i_max" && m_now.scene;  // no buffer and no setting: other views have none
        if (isMaximum) m_math->setToolTip(maximumText(*m_now.scene, m_now.report.iMax));
        m_document.pointing().setSymbol(isMaximum ? QString() : refers);
    });
    connect(m_math, &MathView::activated, this, [this](const QString& refers) {
        if (const auto name = pipeline::findBuffer(refers.toStdString())) return emit bufferAsked(*name);
        if (m_document.hasScene() && pipeline::findSetting(m_document.scene(), refers.toStdString()))
            emit settingAsked(refers);
    });
    // Digits written otherwise are no change: before the panel shows all of it anew.
    connect(&NumberStyle::current(), &NumberStyle::changed, this, [this] { layLines(false); });
    followTheme(this, [this] { m_keep->setFont(Theme::current().text(12)); });
    layLines(false);
}

void EquationSection::forget() {
    m_now = m_before = {};
    m_was.reset();
    m_kept.reset();
}

std::vector<EquationLine> EquationSection::Result::lines() const {
    if (!scene) return {};
    return equation(*scene, report, channel, chosenNumbers());
}

QString EquationSection::Result::text() const { return resultText(lines()); }

QString EquationSection::sentence() const {
    const QString text = m_now.text();
    return text.isEmpty() ? tr("nothing was drawn here") : text;
}

void EquationSection::show(const pipeline::Frame& frame, const pipeline::PixelReport& report) {
    const int channel = m_document.pointing().channel();
    m_channels->setCurrent(channel);
    static const QStringList names{tr("red"), tr("green"), tr("blue")};
    m_model->setText(QStringLiteral("%1, %2").arg(modelName(frame.scene().settings.model), names[channel]));

    const Result now{frame.sharedScene(), report, channel};
    const bool isSamePlace = m_now.scene && m_now.report.pixel == report.pixel && m_now.channel == channel;
    if (!isSamePlace) {
        m_before = {};
        m_was.reset();
    } else if (now.scene != m_now.scene) {
        // While a slider is dragged all its values are one step of undo: what was is what was before it.
        if (!m_before.scene || m_document.history().sceneBefore() != m_before.scene) m_before = m_now;
        const QString before = m_before.text();
        m_was.reset();
        if (!before.isEmpty() && before != now.text())
            m_was = Past{m_before, settingsText(*m_before.scene, *now.scene)};
    }
    m_now = now;
    layLines(isSamePlace);
}

void EquationSection::setKept(bool kept) {
    m_kept = kept ? m_was : std::nullopt;
    layLines(false);
}

void EquationSection::layLines(bool showChange) {
    std::vector<EquationLine> lines = m_now.lines();
    moveRemarkDown(lines);
    if (const EquationLine* result = resultOf(lines)) {
        auto after = lines.begin() + (result - lines.data()) + 1;
        const QString was = m_was ? m_was->text() : QString(), kept = m_kept ? m_kept->text() : QString();
        if (!was.isEmpty() && was != kept) after = lines.insert(after, words("was", tr("was %1").arg(was))) + 1;
        if (!kept.isEmpty()) lines.insert(after, words("was", tr("kept %1").arg(kept)));
    }
    m_math->setLines(std::move(lines), showChange);
    m_keep->setVisible(canKeep());
    m_keep->setChecked(keeps());
    m_keep->setToolTip(keeps() ? tr("Drops the line that was kept.")
                               : tr("Keeps the line before, whatever changes from here on."));
    emit keptChanged();
}

}  // namespace app
