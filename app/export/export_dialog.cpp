#include "app/export/export_dialog.h"

#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QIntValidator>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "app/export/export_formats.h"
#include "app/export/export_job.h"
#include "app/export/export_list.h"
#include "app/frames/derived_buffers.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/on_screen.h"
#include "app/widgets/wrapping_check_box.h"
#include "pipeline/plan/needs.h"
#include "pipeline/scene/framing.h"

namespace app {
namespace {

QLabel* makeLabel(const QString& name, int tone, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setProperty("tone", tone);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

}  // namespace

ExportDialog::ExportDialog(Document& document, QWidget* parent)
    : JobDialog("export", tr("Export"), parent),
      m_document(document),
      m_changes(document),
      m_choices(makeChoices()),
      m_buffers(new ExportList(this)) {
    setObjectName("exportDialog");
    setWindowTitle(tr("Export buffers"));
    auto* halves = spaced(new QHBoxLayout, {}, 16);
    auto* left = new QVBoxLayout;
    left->addWidget(m_choices);
    left->addWidget(m_buffers, 1);
    halves->addLayout(left, 5);
    auto* fields = new FieldsArea(makeFields(), this);
    fields->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // their words fold
    halves->addWidget(fields, 5);
    auto* column = spaced(new QVBoxLayout(this), {16, 12, 16, 12});
    column->addLayout(halves, 1);
    column->addWidget(&foot());
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_total->setFont(theme.text(13, 600));
        m_files->setFont(theme.mono(12));
        resize(onScreen(*this, theme.px(880), theme.px(620)));
    });
    // Everything that the scene has a use for is computed while the dialog is open, so that the
    // list can tell what is there from what is left out.
    connect(&document.frames(), &FrameFeed::frameReady, this, &ExportDialog::showFrame);
    connect(m_buffers, &ExportList::chosenChanged, this, &ExportDialog::showOrder);
    document.frames().want(this, pipeline::usefulBuffers(document.scene()));
    showFrame();
}

// Above the list that they check.
QWidget* ExportDialog::makeChoices() {
    auto* row = new QWidget(this);
    auto* links = spaced(new QHBoxLayout(row), {});
    const auto link = [&](const char* name, const QString& text, auto run) {
        auto* button = new QPushButton(text, row);
        button->setObjectName(name);
        button->setProperty("kind", "link");
        button->setAutoDefault(false);
        button->setMinimumWidth(Theme::current().px(40));  // the ring of the focus takes from a short word
        connect(button, &QPushButton::clicked, this, run);
        links->addWidget(button);
        return button;
    };
    link("exportAll", tr("All"), [this] { m_buffers->chooseAll(); })->setFocus();  // a dialog begins at its first field
    link("exportNone", tr("None"), [this] { m_buffers->choose({}); });
    m_onlyShown = link("exportShown", tr("Only what is shown"), [this] { m_buffers->choose(m_shown); });
    m_onlyShown->hide();
    links->addStretch(1);
    return row;
}

void ExportDialog::setShown(std::vector<pipeline::BufferName> buffers) {
    m_shown = std::move(buffers);
    m_onlyShown->setVisible(!m_shown.empty());
}

void ExportDialog::setViews(WriteViews write, QStringList files) {
    m_writeViews = std::move(write), m_viewFiles = std::move(files);
    m_views->show();
}

void ExportDialog::choose(const pipeline::BufferName& buffer) { m_buffers->choose({buffer}); }

QWidget* ExportDialog::makeFields() {
    auto* right = new QWidget(this);
    auto* form = new QFormLayout;
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    const QString base = QFileInfo(toQString(m_document.scene().name)).completeBaseName();
    form->addRow(tr("Folder"), makeTarget("exportFolder", tr("Folder"), QDir::home().filePath(base + "-buffers")));

    m_formats = new ExportFormats(m_document.scene(), right);
    connect(m_formats, &ExportFormats::changed, this, &ExportDialog::showOrder);
    form->addRow(tr("Formats"), m_formats);
    m_views = new WrappingCheckBox(tr("Pictures of the 3D views"), right);
    m_views->setObjectName("exportViews");
    m_views->hide();
    connect(m_views, &QCheckBox::toggled, this, &ExportDialog::showOrder);
    form->addRow(QString(), m_views);

    auto* size = new QHBoxLayout;
    const auto makeSide = [&](int value, const char* name, const QString& words) {
        auto* field = new QLineEdit(QString::number(value), right);
        field->setObjectName(name);
        field->setAccessibleName(words);
        field->setAlignment(Qt::AlignRight);
        field->setValidator(new QIntValidator(1, 16384, field));
        connect(field, &QLineEdit::textChanged, this, &ExportDialog::showOrder);
        size->addWidget(field);
        return field;
    };
    m_width = makeSide(m_document.scene().settings.width, "exportWidth", tr("Width in pixels"));
    size->addWidget(new QLabel(QStringLiteral("×"), right));
    m_height = makeSide(m_document.scene().settings.height, "exportHeight", tr("Height in pixels"));
    size->addWidget(new QLabel(tr("pixels"), right), 1);
    form->addRow(tr("Size"), size);

    m_total = makeLabel("exportTotal", 1, right);
    m_files = makeLabel("exportFiles", 2, right);
    auto* note = makeLabel("exportNote", 2, right);
    note->setText(tr("Files appear whole or not at all. An export of another frame in the folder is replaced."));
    auto* column = spaced(new QVBoxLayout(right), {});
    column->addLayout(form);
    column->addSpacing(Theme::current().px(12));
    column->addWidget(m_total);
    column->addWidget(m_files);
    column->addWidget(note);
    column->addStretch(1);
    return right;
}

void ExportDialog::showFrame() {
    if (!m_document.frames().whole() || isRunning()) return;
    m_buffers->setFrame(*m_document.frames().whole(), m_document.derived().recipe());
    showOrder();
}

pipeline::ExportRequest ExportDialog::request() const {
    pipeline::ExportRequest request;
    request.folder = target();
    request.formats = m_formats->chosen();
    request.buffers = m_buffers->chosen();
    request.state = m_state;
    return request;
}

std::shared_ptr<const pipeline::Scene> ExportDialog::sceneToExport() const {
    auto scene = std::make_shared<pipeline::Scene>(m_document.scene());
    setSize(*scene, {m_width->text().toInt(), m_height->text().toInt()});
    return scene;
}

void ExportDialog::showOrder() {
    if (!m_document.frames().whole()) return;
    const pipeline::ExportRequest wanted = request();
    const auto& settings = m_document.scene().settings;
    const double scale =
        double(m_width->text().toInt()) * m_height->text().toInt() / (double(settings.width) * settings.height);
    m_buffers->setScale(scale);
    double bytes = 0;
    QStringList files = m_formats->sceneFiles();
    if (m_views->isChecked()) files += m_viewFiles;
    std::vector<pipeline::PlannedFile> planned = plannedFiles(*m_document.frames().whole(), wanted);
    for (pipeline::PlannedFile& file : plannedDerived(m_document.scene(), wanted)) planned.push_back(std::move(file));
    for (const pipeline::PlannedFile& file : planned) {
        if (file.file.empty()) continue;
        const bool pixels = pipeline::bufferInfo(file.buffer.id).domain == pipeline::Domain::Pixel;
        bytes += double(file.bytes) * (pixels ? scale : 1);
        files += toQString(file.file);
    }
    m_total->setText(
        (wanted.buffers.size() == 1 ? tr("%1 buffer, %2 files, about %3") : tr("%1 buffers, %2 files, about %3"))
            .arg(wanted.buffers.size())
            .arg(files.size() + 1)
            .arg(sizeText(std::uint64_t(bytes))));
    const QString rest = files.size() > 7 ? tr("\nand %1 more").arg(files.size() - 7) : QString();
    m_files->setText("manifest.json\n" + files.mid(0, 7).join('\n') + rest);
    const auto scene = sceneToExport();
    QStringList more = m_changes.words(*scene);
    if (m_views->isChecked()) more.prepend("--views");
    if (m_views->isChecked() && m_document.pointing().pixel())
        more.insert(1, QStringLiteral("--pixel %1,%2")
                           .arg(m_document.pointing().pixel()->x)
                           .arg(m_document.pointing().pixel()->y));
    foot().setCommand(exportCommand(*scene, more, wanted, m_document.derived().recipe(), m_buffers->isAllChosen()));
    const bool ready = !wanted.buffers.empty() && !wanted.formats.empty() && !field().text().isEmpty() &&
                       m_width->hasAcceptableInput() && m_height->hasAcceptableInput();
    foot().setReady(ready, tr("Choose a buffer, a format, a folder and a size first."));
}

QString ExportDialog::chooseTarget() {
    return QFileDialog::getExistingDirectory(this, tr("Folder"), toQString(target().string()));
}

void ExportDialog::start() {
    const pipeline::ExportRequest wanted = request();
    WriteMore more;
    if (m_views->isChecked())
        more = [write = m_writeViews, pixel = m_document.pointing().pixel()](const auto& frame, const auto& folder) {
            return write(frame, pixel, folder);
        };
    auto* job =
        new ExportJob(sceneToExport(), m_document.frames().whole(), wanted, m_document.derived().recipe(), more, this);
    run(job, wanted.folder, [](const pipeline::ExportSummary& summary) {
        const QString done =
            tr("%1 files, %2, are in the folder.").arg(summary.files.size()).arg(sizeText(summary.bytes));
        if (summary.inDoubt.empty()) return done;
        return done + tr(" The export there was replaced: %1.").arg(toQString(summary.inDoubt));
    });
}

}  // namespace app
