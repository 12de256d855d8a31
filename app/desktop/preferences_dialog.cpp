#include "app/desktop/preferences_dialog.h"

#include <QCheckBox>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QUrl>
#include <cmath>

#include "app/docks/layout_store.h"
#include "app/document/file_watch.h"
#include "app/document/session_file.h"
#include "app/look/number_format.h"
#include "app/look/numbers.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/on_screen.h"
#include "app/widgets/segmented.h"

namespace app {
namespace {

QLabel* makeHeading(const QString& text, QWidget* parent) {
    auto* heading = new QLabel(text, parent);
    followTheme(heading, [heading] { heading->setFont(Theme::current().text(13, 600)); });
    return heading;
}

QSpinBox* makeSpin(int low, int high, const char* objectName, const QString& name, QWidget* parent) {
    auto* spin = new QSpinBox(parent);
    spin->setRange(low, high);
    spin->setObjectName(objectName);
    spin->setAccessibleName(name);
    return spin;
}

// A depth, a dot product and an error, where the format leaves their digits to them as they stand there.
QString sampleText(const NumberFormat& format) {
    const double depthValue = float(688.8116), product = float(std::sqrt(0.5)), error = -1.25e-6;
    return written(format, depthValue).value_or(depth(depthValue)) + "   " +
           written(format, product).value_or(dotProduct(product)) + "   " +
           written(format, error).value_or(dotProduct(error));
}

}  // namespace

PreferencesDialog::PreferencesDialog(QWidget* parent) : QDialog(parent) {
    setObjectName("preferences");
    setWindowTitle(tr("Preferences"));
    auto* fields = new QWidget(this);
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    addLook(*form);
    addNumbers(*form);
    addScenes(*form);
    addFiles(*form);
    auto* keys = new QPushButton(tr("Keys…"), this);
    keys->setObjectName("preferencesKeys");
    keys->setToolTip(tr("List the keys (H)"));
    connect(keys, &QPushButton::clicked, this, [this] {
        accept();
        emit keysAsked();
    });
    auto* close = new QPushButton(tr("Close"), this);
    close->setDefault(true);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    auto* row = new QHBoxLayout;
    row->addWidget(keys);
    row->addStretch(1);
    row->addWidget(close);
    auto* column = spaced(new QVBoxLayout(this), {16, 12, 16, 12});
    column->addWidget(new FieldsArea(fields, this), 1);
    column->addLayout(row);
    followTheme(this, [this, form] {
        const Theme& theme = Theme::current();
        form->setHorizontalSpacing(theme.px(16));
        form->setVerticalSpacing(theme.px(8));
        m_sample->setFont(theme.mono(12));
        showValues();
        resize(wholeOnScreen(*this, theme.px(620)));
    });
}

void PreferencesDialog::addLook(QFormLayout& form) {
    form.addRow(makeHeading(tr("Look"), this));
    m_theme = new Segmented({tr("Dark"), tr("Light"), tr("Projector")}, this);
    m_theme->setObjectName("preferencesTheme");
    m_theme->setAccessibleName(tr("Theme"));
    connect(m_theme, &Segmented::chosen, this, [](int i) {
        Theme::current().set(ThemeId(i));
        saveTheme();
    });
    form.addRow(tr("Theme"), m_theme);
    m_letters = makeSpin(int(std::lround(100 * Theme::kLeastScale)), int(std::lround(100 * Theme::kMostScale)),
                         "preferencesLetters", tr("Text size in this theme"), this);
    m_letters->setSingleStep(5);
    m_letters->setSuffix(tr(" %"));
    m_letters->setKeyboardTracking(false);
    connect(m_letters, &QSpinBox::valueChanged, this, [](int percent) {
        Theme::current().setScale(percent / 100.0);
        saveTheme();
    });
    form.addRow(tr("Text size, in this theme"), m_letters);
}

void PreferencesDialog::addNumbers(QFormLayout& form) {
    form.addRow(makeHeading(tr("Numbers in buffers, tables and the inspector"), this));
    m_form = new Segmented({tr("As stored"), tr("Fixed"), tr("Scientific"), tr("Hexadecimal")}, this);
    m_form->setObjectName("preferencesForm");
    m_form->setAccessibleName(tr("How numbers are written"));
    m_form->setToolTip(
        tr("As stored: in the digits of what a number is; in the equation, those of the lecture. Hexadecimal: every "
           "bit of it, 0x1.8p-1 = 1.5 / 2."));
    connect(m_form, &Segmented::chosen, this, &PreferencesDialog::takeNumbers);
    m_digits = makeSpin(0, NumberFormat::kMostDigits, "preferencesDigits", tr("Digits after the point"), this);
    // The least value is read as "never".
    m_power = makeSpin(NumberFormat::kLeastPower - 1, NumberFormat::kMostPower, "preferencesPower",
                       tr("Power of ten from which on it is written out"), this);
    m_power->setPrefix(tr("from 10^"));
    m_power->setSpecialValueText(tr("never"));
    for (QSpinBox* spin : {m_digits, m_power})
        connect(spin, &QSpinBox::valueChanged, this, &PreferencesDialog::takeNumbers);
    m_sample = new QLabel(this);
    m_sample->setObjectName("preferencesSample");
    m_sample->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form.addRow(tr("Written"), m_form);
    form.addRow(tr("Digits after the point"), m_digits);
    form.addRow(tr("Power of ten"), m_power);
    form.addRow(tr("For example"), m_sample);
}

void PreferencesDialog::addScenes(QFormLayout& form) {
    const auto add = [&](const char* objectName, const QString& text, bool wanted, void (*set)(bool)) {
        auto* box = new QCheckBox(text, this);
        box->setObjectName(objectName);
        box->setChecked(wanted);
        connect(box, &QCheckBox::toggled, this, set);
        form.addRow(box);
    };
    form.addRow(makeHeading(tr("Scenes"), this));
    add("preferencesSession", tr("Begin with what the window showed when it was closed"), SessionFile::isWanted(),
        &SessionFile::setWanted);
    add("preferencesReadAgain", tr("Read a scene again when another program changes its file"), FileWatch::readsAgain(),
        &FileWatch::setReadsAgain);
}

void PreferencesDialog::addFiles(QFormLayout& form) {
    form.addRow(makeHeading(tr("Files of the program"), this));
    const auto add = [&](const QString& what, const QString& file) {
        auto* place = new ElidedLabel(QDir::toNativeSeparators(file), this);
        auto* open = new QPushButton(tr("Show"), this);
        open->setAccessibleName(tr("Show the folder of: %1").arg(what));
        const QString folder = QFileInfo(file).path();
        open->setEnabled(QFileInfo(folder).isDir());
        open->setToolTip(open->isEnabled() ? tr("Open %1").arg(folder) : tr("There is none yet."));
        connect(open, &QPushButton::clicked, this,
                [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
        auto* row = new QHBoxLayout;
        row->addWidget(place, 1);
        row->addWidget(open);
        form.addRow(what, row);
    };
    add(tr("Preferences, layouts, recent files"), QSettings().fileName());
    add(tr("Session"), SessionFile(SessionFile::usualFolder()).file());
}

void PreferencesDialog::takeNumbers() {
    NumberFormat format;
    format.form = NumberFormat::Form(m_form->current());
    format.digits = m_digits->value();
    if (m_power->value() >= NumberFormat::kLeastPower) format.power = m_power->value();
    NumberStyle::current().set(format);
    saveNumbers();
    showValues();
}

// What is in force; digits that say nothing tell why.
void PreferencesDialog::showValues() {
    using Form = NumberFormat::Form;
    const Theme& theme = Theme::current();
    const NumberFormat& format = NumberStyle::current().format();
    const QSignalBlocker letters(m_letters), digits(m_digits), power(m_power);
    m_theme->setCurrent(int(theme.id()));
    m_letters->setValue(int(std::lround(100 * theme.scale())));
    m_form->setCurrent(int(format.form));
    m_digits->setValue(format.digits);
    m_power->setValue(format.power.value_or(m_power->minimum()));
    const bool isHex = format.form == Form::Hexadecimal;
    m_digits->setEnabled(!isHex && (format.form != Form::AsStored || format.power));
    m_digits->setToolTip(m_digits->isEnabled() ? QString()
                         : isHex               ? tr("A hexadecimal number has all its digits.")
                                               : tr("As stored, a number has the digits of what it is."));
    m_power->setEnabled(format.form == Form::AsStored || format.form == Form::Fixed);
    m_power->setToolTip(m_power->isEnabled()
                            ? tr("n: from 10ⁿ on and below 10⁻ⁿ a number is written with its power of ten, 1.25e-6")
                            : tr("Here every number has its power."));
    m_sample->setText(sampleText(format));
}

}  // namespace app
