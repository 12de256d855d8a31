#include "app/panels/film_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "app/core/export_plan.h"
#include "app/core/text.h"
#include "app/panels/follow_theme.h"
#include "app/panels/job_foot.h"
#include "app/panels/on_screen.h"

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
    : QDialog(parent),
      m_document(document),
      m_changes(document),
      m_foot(new JobFoot("film", tr("Write the film"), this)) {
    setObjectName("filmDialog");
    setWindowTitle(tr("Step film"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(makeFields(buffer));
    column->addStretch(1);
    column->addWidget(m_foot);
    connect(m_foot, &JobFoot::startAsked, this, &FilmDialog::start);
    connect(m_foot, &JobFoot::cancelAsked, this, [this] { m_job->cancel(); });
    connect(m_foot, &JobFoot::closeAsked, this, &FilmDialog::reject);
    followTheme(this, [this, column] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(theme.px(16), theme.px(12), theme.px(16), theme.px(12));
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
    m_target = new QLineEdit(fields);
    m_target->setObjectName("filmTarget");
    m_target->setAccessibleName(tr("File, or folder for PNG files"));
    const QString base = QFileInfo(toQString(m_document.scene().name)).completeBaseName();
    m_target->setText(QDir::home().filePath(base + "-film.gif"));
    connect(m_target, &QLineEdit::textChanged, this, &FilmDialog::showOrder);
    auto* choose = new QPushButton(tr("Choose"), fields);
    connect(choose, &QPushButton::clicked, this, &FilmDialog::chooseTarget);
    auto* where = new QHBoxLayout;
    where->addWidget(m_target, 1);
    where->addWidget(choose);
    form->addRow(tr("Buffer"), m_buffer);
    form->addRow(tr("A picture for each"), m_level);
    form->addRow(tr("Until"), m_end);
    form->addRow(tr("Length"), m_pictures);
    form->addRow(tr("Speed"), m_milliseconds);
    form->addRow(QString(), m_captions);
    form->addRow(tr("File, or folder for PNG files"), where);

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

QString FilmDialog::message() const { return m_foot->message(); }

FilmOrder FilmDialog::order() const {
    const auto buffer = pipeline::findBuffer(m_buffer->currentText().toStdString());
    FilmOrder order = filmOf(buffer.value_or(pipeline::BufferName{pipeline::BufferId::Color}));
    order.level = pipeline::StepLevel(std::max(0, m_level->currentIndex()));
    if (m_end->currentIndex() == kHere && m_document.stepper().place()) order.to = *m_document.stepper().place();
    order.pictures = m_pictures->value();
    order.milliseconds = m_milliseconds->value();
    order.captions = m_captions->isChecked();
    order.target = m_target->text().toStdString();
    return order;
}

void FilmDialog::showOrder() {
    const bool single = m_target->text().endsWith(".gif");
    m_milliseconds->setEnabled(single);
    m_milliseconds->setToolTip(single ? QString() : tr("PNG files have no speed; a file that ends in .gif has."));
    m_foot->setReady(!m_target->text().isEmpty(), tr("Choose a file that ends in .gif, or a folder."));
    m_foot->setCommand(filmCommand(m_document.scene(), m_changes.words(m_document.scene()), order()));
}

void FilmDialog::chooseTarget() {
    const QString file = QFileDialog::getSaveFileName(this, tr("Step film"), m_target->text(),
                                                      tr("Film (*.gif);;Folder of PNG files (*)"));
    if (!file.isEmpty()) m_target->setText(file);
}

void FilmDialog::start() {
    if (m_job) return;
    const FilmOrder wanted = order();
    m_written = toQString(wanted.target.string());
    m_job = new FilmJob(std::make_shared<const pipeline::Scene>(m_document.scene()), wanted, this);
    connect(m_job, &FilmJob::progressed, this, [this](double share) { m_foot->setProgress(share); });
    connect(m_job, &FilmJob::finished, this, [this](const pipeline::FilmSummary& summary) {
        const QString behind =
            summary.behind == 0 ? QString() : tr(" %1 not of this film behind them.").arg(summary.behind);
        finish(summary.cancelled ? tr("Cancelled. Nothing was written.")
                                 : tr("%1 pictures, %2.").arg(summary.pictures).arg(sizeText(summary.bytes)) + behind,
               !summary.cancelled);
    });
    connect(m_job, &FilmJob::failed, this,
            [this](const pipeline::Errors& errors) { finish(toQString(format(errors)).trimmed(), false); });
    m_foot->begin();
}

void FilmDialog::finish(const QString& sentence, bool done) {
    m_job->deleteLater();
    m_job = nullptr;
    const QFileInfo target(m_written);
    m_foot->finish(sentence, !done ? QString() : target.isDir() ? target.filePath() : target.path());
}

}  // namespace app
