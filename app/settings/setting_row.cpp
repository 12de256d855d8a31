#include "app/settings/setting_row.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QRegularExpression>
#include <QStyle>
#include <algorithm>

#include "app/frames/equation_symbols.h"
#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/number_field.h"
#include "app/widgets/segmented.h"
#include "app/widgets/value_slider.h"

namespace app {

using pipeline::SettingKind;

namespace {

constexpr int kLabelWidth = 84;

// What the left dock leaves beside the labels: its width grows less than the letters.
int choiceRoom() {
    const Theme& theme = Theme::current();
    return int(296 * (0.4 + 0.6 * theme.scale())) - theme.px(kLabelWidth + 46);
}

}  // namespace

QString labelWithSymbol(const QString& label) {
    static const QRegularExpression symbol("^(\\p{L})(?:_(\\w+))?(?: |$)(.*)$",
                                           QRegularExpression::UseUnicodePropertiesOption);
    const auto match = symbol.match(label);
    if (!match.hasMatch()) return label.toHtmlEscaped();
    const QString script =
        match.captured(2).isEmpty() ? QString() : QStringLiteral("<sub>%1</sub>").arg(match.captured(2));
    return QStringLiteral("<span style=\"font-family:STIX,'STIX Two Math',serif;font-size:%1px\"><i>%2%3</i></span> %4")
        .arg(Theme::current().px(15))
        .arg(match.captured(1), script, match.captured(3).toHtmlEscaped());
}

QString choiceName(std::string_view choice) {
    QString name = toQString(choice);
    if (name == "at-infinity") return QStringLiteral("At infinity");
    if (name.startsWith("fixed")) return name.mid(5) + QStringLiteral(" bit");
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    return name;
}

SettingRow::SettingRow(Document& document, pipeline::SettingRef setting, QGridLayout& form, int row, QWidget* parent)
    : QObject(parent),
      m_document(document),
      m_setting(setting),
      m_form(form),
      m_row(row),
      m_label(styled(new QLabel(parent), {.size = 13, .wraps = true})),
      m_note(styled(new QLabel(parent), {.tone = 3, .size = 12, .wraps = true})) {
    m_label->setTextFormat(Qt::RichText);
    followTheme(m_label, [this] { m_label->setText(labelWithSymbol(labelOf(m_setting))); });
    const bool isNumber = setting.setting->kind == SettingKind::Number || setting.setting->kind == SettingKind::Integer;
    isNumber ? addNumber(parent) : addChoice(parent);
    for (QWidget* control : m_controls) {
        control->setAccessibleName(labelOf(m_setting));
        if (auto* list = qobject_cast<QComboBox*>(control)) nameComboBox(*list, list->accessibleName());
        control->setObjectName(toQString(setting.key()));
    }
    connect(&document, &Document::sceneChanged, this, &SettingRow::showScene);
    connect(document.history().stack(), &QUndoStack::indexChanged, this, &SettingRow::showScene);
    connect(&document.pointing(), &Pointing::symbolChanged, this, &SettingRow::showPointed);
    place();
    showScene();
    showPointed();
}

int SettingRow::widthBeside() const {
    return Theme::current().px(kLabelWidth) + m_form.horizontalSpacing() + widthStacked();
}

int SettingRow::widthStacked() const {
    int width = int(m_controls.size() - 1) * m_form.horizontalSpacing();
    for (const QWidget* control : m_controls)
        width += std::max(control->minimumWidth(), control->minimumSizeHint().width());
    return width;
}

void SettingRow::setStacked(bool stacked) {
    if (stacked == m_stacked) return;
    m_stacked = stacked;
    for (QWidget* part : QList<QWidget*>{m_label, m_note} + m_controls) m_form.removeWidget(part);
    place();
}

void SettingRow::place() {
    const int first = m_stacked ? 0 : 1, columns = 3 - first;
    const int width = Theme::current().px(kLabelWidth);
    m_label->setMinimumWidth(width);
    m_label->setMaximumWidth(m_stacked ? QWIDGETSIZE_MAX : width);
    m_form.addWidget(m_label, m_stacked ? m_row : m_row + 1, 0, 1, m_stacked ? 3 : 1);
    const bool hasField = m_controls.size() > 1;
    m_form.addWidget(m_controls[0], m_row + 1, first, 1, hasField ? columns - 1 : columns);
    if (hasField) m_form.addWidget(m_controls[1], m_row + 1, 2);
    m_form.addWidget(m_note, m_row + 2, first, 1, columns);
}

void SettingRow::addNumber(QWidget* parent) {
    const pipeline::Setting& setting = *m_setting.setting;
    auto* slider = new ValueSlider(setting.low, setting.high, setting.kind == SettingKind::Integer ? 1 : 0, parent);
    auto* field = new NumberField(m_setting, parent);
    m_controls = {slider, field};
    connect(slider, &ValueSlider::moved, this, [this](double value) { change(value, Document::Change::Live); });
    connect(slider, &ValueSlider::released, this, [this](double value) { change(value, Document::Change::Done); });
    connect(field, &NumberField::dragged, this, [this](double value) { change(value, Document::Change::Live); });
    connect(field, &NumberField::entered, this, [this](double value) { change(value, Document::Change::Done); });
    m_show = [slider, field](double value, std::optional<double> before) {
        if (!slider->isDragged()) slider->setValue(value);
        slider->setMark(before);
        field->setValue(value);
    };
}

void SettingRow::addChoice(QWidget* parent) {
    QStringList names;
    for (const std::string_view choice : m_setting.setting->choices) names += choiceName(choice);
    const auto chosen = [this](int choice) { change(choice, Document::Change::Done); };
    // Side by side where the dock at its usual width has room for it, else in a list.
    if (Segmented::widthFor(names) <= choiceRoom()) {
        auto* segmented = new Segmented(names, parent);
        m_controls = {segmented};
        connect(segmented, &Segmented::chosen, this, chosen);
        m_show = [segmented](double value, std::optional<double>) { segmented->setCurrent(int(value)); };
    } else {
        auto* list = new QComboBox(parent);
        list->addItems(names);
        list->setSizeAdjustPolicy(
            QComboBox::AdjustToMinimumContentsLengthWithIcon);  // a long choice is cut, no other row
        list->setMinimumContentsLength(6);
        list->setFocusPolicy(Qt::StrongFocus);  // the wheel scrolls the panel instead
        m_controls = {list};
        connect(list, &QComboBox::activated, this, chosen);
        m_show = [list](double value, std::optional<double>) { list->setCurrentIndex(int(value)); };
    }
}

void SettingRow::change(double value, Document::Change kind) { m_document.change(m_setting, value, kind); }

void SettingRow::showScene() {
    const pipeline::Scene& scene = m_document.scene();
    // While another scene takes the place of this one, the row may outlive its light or object.
    if (m_setting.index >= m_setting.setting->count(scene)) return;
    const auto last = m_document.history().lastChange();
    m_show(m_setting.get(scene), last && last->setting == m_setting ? std::optional(last->before) : std::nullopt);
    m_idle = toQString(m_setting.setting->idle(scene));
    const QString unit = toQString(m_setting.setting->unit);
    QString tip = toQString(m_setting.setting->meaning);
    if (!unit.isEmpty()) tip += QStringLiteral(" Unit: %1.").arg(unit);
    if (isIdle()) tip = m_idle + QLatin1Char('\n') + tip;
    m_label->setToolTip(tip);
    const int tone = isIdle() ? 3 : 2;
    if (m_label->property("tone") != tone) {
        m_label->setProperty("tone", tone);
        m_label->style()->polish(m_label);
    }
    m_note->setText(m_idle);
    for (QWidget* control : m_controls) {
        control->setToolTip(tip);
        control->setEnabled(!isIdle());
    }
    setShown(m_shown);
}

// The equation's symbol for this setting is under the cursor.
void SettingRow::showPointed() {
    const bool isPointed = toQString(m_setting.key()) == m_document.pointing().symbol();
    m_label->setProperty("pointed", isPointed);
    m_label->style()->polish(m_label);
    for (QWidget* control : m_controls)
        if (auto* slider = qobject_cast<ValueSlider*>(control)) slider->setRinged(isPointed);
}

void SettingRow::setShown(bool shown) {
    m_shown = shown;
    m_label->setVisible(shown);
    for (QWidget* control : m_controls) control->setVisible(shown);
    m_note->setVisible(shown && isIdle());
}

}  // namespace app
