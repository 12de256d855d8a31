#include "app/panels/equation_section.h"

#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>

#include "app/core/text.h"
#include "app/panels/follow_theme.h"
#include "app/panels/math_view.h"
#include "app/panels/segmented.h"

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
      m_model(new QLabel(m_switcher)),
      m_channels(new Segmented({"r", "g", "b"}, m_switcher)) {
    auto* row = new QHBoxLayout(m_switcher);
    row->setContentsMargins(0, 0, 0, 0);
    row->addStretch();
    row->addWidget(m_model);
    row->addWidget(m_channels);
    m_channels->setAccessibleName(tr("Channel of the equation"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_math);
    m_math->setAccessibleName(tr("Illumination equation"));

    connect(m_channels, &Segmented::chosen, &document, &Document::setChannel);
    connect(m_math, &MathView::pointedAt, this, &EquationSection::pointedAt);
    connect(m_math, &MathView::activated, this, [this](const QString& refers) {
        if (const auto name = pipeline::findBuffer(refers.toStdString())) emit bufferAsked(*name);
    });
    m_model->setProperty("tone", "2");
    followTheme(this, [this] { m_model->setFont(Theme::current().text(12)); });
}

void EquationSection::forget() {
    m_pixel.reset();
    m_plain.clear();
    m_was.clear();
}

QString EquationSection::sentence() const {
    const QString text = resultText(m_plain);
    return text.isEmpty() ? tr("nothing was drawn here") : text;
}

void EquationSection::show(const pipeline::Frame& frame, const pipeline::PixelReport& report) {
    const int channel = m_document.channel();
    m_channels->setCurrent(channel);
    static const QStringList names{tr("red"), tr("green"), tr("blue")};
    m_model->setText(tr("Phong (L1), %1").arg(names[channel]));

    std::vector<EquationLine> plain = equation(frame, report, channel);
    const bool isSamePlace = m_pixel == report.pixel && m_channel == channel;
    if (!isSamePlace) {
        m_was.clear();
    } else if (const QString before = resultText(m_plain); !before.isEmpty() && before != resultText(plain)) {
        m_was = tr("was %1").arg(before);
        if (const auto change = m_document.lastChange(); change && change->before != change->after)
            m_was += tr(", with %1 = %2")
                         .arg(toQString(change->setting.setting->label),
                              toQString(formatSetting(change->setting, change->before)));
    }
    m_pixel = report.pixel;
    m_channel = channel;
    m_plain = plain;

    moveRemarkDown(plain);
    if (!m_was.isEmpty())
        if (const EquationLine* result = resultOf(plain))
            plain.insert(plain.begin() + (result - plain.data()) + 1, words("was", m_was));
    m_math->setLines(std::move(plain), isSamePlace);
}

}  // namespace app
