#include "app/export/film_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QSpinBox>

#include "app/document/export_plan.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/on_screen.h"
#include "app/widgets/save_dialog.h"

namespace app {
namespace {

// What the film ends with.
enum End : int { kWholeStage, kHere };

bool hasPixels(const pipeline::BufferName& name) {
    const auto domain = bufferInfo(name.id).domain;
    return domain == pipeline::Domain::Pixel || domain == pipeline::Domain::Texel;
}

}  // namespace

FilmDialog::FilmDialog(Document& document, const pipeline::BufferName& buffer, QWidget* parent)
    : JobDialog("film", tr("Write the film"), parent), m_document(document), m_changes(document) {
    setObjectName("filmDialog");
    setWindowTitle(tr("Step film"));
    auto* column = spaced(new QVBoxLayout(this), {16, 12, 16, 12});
    column->addWidget(new FieldsArea(makeFields(buffer), this), 1);
    column->addWidget(&foot());
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        resize(onScreen(*this, theme.px(620), theme.px(380)));
    });
    m_buffer->setFocus();
    showOrder();
}

QWidget* FilmDialog::makeFields(const pipeline::BufferName& buffer) {
    auto* fields = new QWidget(this);
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(0, 0, 0, 0);
    const auto box = [&](const char* name) {
        auto* combo = new QComboBox(fields);
        combo->setObjectName(name);
        connect(combo, &QComboBox::currentIndexChanged, this, &FilmDialog::showOrder);
        return combo;
    };
    m_buffer = box("filmBuffer"), m_level = box("filmLevel"), m_end = box("filmEnd");
    const auto spin = [&](int low, int high, int value, const QString& suffix) {
        auto* number = new QSpinBox(fields);
        number->setRange(low, high);
        number->setValue(value);
        number->setSuffix(suffix);
        connect(number, &QSpinBox::valueChanged, this, &FilmDialog::showOrder);
        return number;
    };
    m_pictures = spin(2, 10000, 120, tr(" pictures at most"));
    m_milliseconds = spin(10, 60000, 100, tr(" ms a picture"));
    m_pictures->setObjectName("filmPictures");
    m_captions = new QCheckBox(tr("A line of words below each picture"), fields);
    m_captions->setChecked(true);
    connect(m_captions, &QCheckBox::toggled, this, &FilmDialog::showOrder);
    form->addRow(tr("Buffer"), m_buffer);
    form->addRow(tr("A picture for each"), m_level);
    form->addRow(tr("Until"), m_end);
    form->addRow(tr("Length"), m_pictures);
    form->addRow(tr("Speed"), m_milliseconds);
    form->addRow(QString(), m_captions);
    m_algorithm = new QCheckBox(tr("The algorithm below each picture, at its line"), fields);
    connect(m_algorithm, &QCheckBox::toggled, this, &FilmDialog::showOrder);
    form->addRow(QString(), m_algorithm);
    const QString base = QFileInfo(toQString(m_document.scene().name)).completeBaseName();
    const QString place = tr("File, or folder for PNG files");
    form->addRow(place, makeTarget("filmTarget", place, QDir::home().filePath(base + "-film.gif")));

    for (const auto& name : pipeline::allBuffers(m_document.scene().lights.size()))
        if (hasPixels(name)) m_buffer->addItem(toQString(name.text()));
    for (std::size_t i = 0; i < pipeline::kStepLevelCount; ++i)
        m_level->addItem(toQString(name(pipeline::StepLevel(i))));
    m_end->addItem(tr("the end of the buffer's stage"));
    if (m_document.stepper().isInside()) m_end->addItem(tr("where the timeline stands"));
    m_buffer->setCurrentText(toQString(buffer.text()));
    m_level->setCurrentIndex(int(m_document.stepper().level()));
    return fields;
}

FilmOrder FilmDialog::order() const {
    const auto buffer = pipeline::findBuffer(m_buffer->currentText().toStdString());
    FilmOrder order = filmOf(buffer.value_or(pipeline::BufferName{pipeline::BufferId::Color}));
    order.level = pipeline::StepLevel(std::max(0, m_level->currentIndex()));
    if (m_end->currentIndex() == kHere && m_document.stepper().place()) order.to = *m_document.stepper().place();
    order.pictures = m_pictures->value();
    order.milliseconds = m_milliseconds->value();
    order.captions = m_captions->isChecked();
    order.algorithm = m_algorithm->isChecked();
    order.target = target();
    return order;
}

void FilmDialog::showOrder() {
    const bool single = pipeline::isGif(target());
    m_milliseconds->setEnabled(single);
    m_milliseconds->setToolTip(single ? QString() : tr("PNG files have no speed; a file that ends in .gif has."));
    foot().setReady(!field().text().isEmpty(), tr("Choose a file that ends in .gif, or a folder."));
    foot().setCommand(filmCommand(m_document.scene(), m_changes.words(m_document.scene()), order()));
}

QString FilmDialog::chooseTarget() {
    QStringList kinds{tr("Film (*.gif)"), tr("Folder of PNG files (*)")};
    if (!pipeline::isGif(target())) std::swap(kinds[0], kinds[1]);
    const QString file =
        askWhereToSave(this, windowTitle(), toQString(target().string()), kinds.join(";;"), QStringLiteral("gif"));
    if (pipeline::isGif(file.toStdString())) m_mayReplace = file.toStdString();
    return file;
}

void FilmDialog::start() {
    const FilmOrder wanted = order();
    const std::filesystem::path first = pipeline::firstFileOf(wanted.target);
    if (wanted.target != m_mayReplace && QFileInfo::exists(toQString(first.string()))) {
        const auto name = first.lexically_relative(wanted.target.parent_path());
        if (!askToReplace(this, windowTitle(), {toQString(name.string())})) return;
    }
    m_mayReplace = wanted.target;
    auto* job = new FilmJob(std::make_shared<const pipeline::Scene>(m_document.scene()), wanted, this);
    run(job, wanted.target, [](const pipeline::FilmSummary& summary) {
        const QString behind =
            summary.behind == 0 ? QString() : tr(" %1 not of this film behind them.").arg(summary.behind);
        const QString replaced = summary.inDoubt.empty()
                                     ? QString()
                                     : tr(" The film there was replaced: %1.").arg(toQString(summary.inDoubt));
        return tr("%1 pictures, %2.").arg(summary.pictures).arg(sizeText(summary.bytes)) + replaced + behind;
    });
}

}  // namespace app
