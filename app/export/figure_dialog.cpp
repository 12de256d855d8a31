#include "app/export/figure_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMimeData>
#include <QShortcut>

#include "app/export/figure_fields.h"
#include "app/export/figure_preview.h"
#include "app/frames/derived_buffers.h"
#include "app/jobs/write_file.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/on_screen.h"
#include "app/widgets/save_dialog.h"
#include "app/widgets/surface.h"

namespace app {
FigureDialog::FigureDialog(Document& document, const FigureOrder& first, QWidget* parent)
    : QDialog(parent),
      m_document(document),
      m_changes(document),
      m_fields(new FigureFields(document, first, this)),
      m_preview(new FigurePreview(this)),
      m_foot(new JobBar("figure", tr("Save…"), this)) {
    setObjectName("figureDialog");
    setWindowTitle(tr("Figure"));
    QPushButton* copies = m_foot->addButton("figureCopy", tr("Copy"));
    connect(copies, &QPushButton::clicked, this, &FigureDialog::copy);
    connect(m_foot, &JobBar::startAsked, this, &FigureDialog::choose);
    connect(m_foot, &JobBar::cancelAsked, this, &FigureDialog::reject);
    connect(m_foot, &JobBar::closeAsked, this, &FigureDialog::reject);
    for (const int key : {Qt::Key_Return, Qt::Key_Enter})
        connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key(key)), this), &QShortcut::activated, this, [this] {
            if (parts().buffer && !m_writing.busy()) choose();
        });
    auto* halves = spaced(new QHBoxLayout, {}, 16);
    QScrollArea* fields = scrolling(m_fields, this);
    fields->setProperty("kind", "fields");
    halves->addWidget(fields);
    halves->addWidget(m_preview, 1);
    auto* column = spaced(new QVBoxLayout(this), {16, 12, 16, 12});
    column->addLayout(halves, 1);
    column->addWidget(m_foot);
    followTheme(this, [this, fields] {
        const Theme& theme = Theme::current();
        resize(onScreen(*this, theme.px(980), theme.px(640)));
        fields->setFixedWidth(std::min(theme.px(320), width() / 2));
    });
    connect(m_preview, &FigurePreview::made, m_fields, &FigureFields::show);
    connect(m_preview, &FigurePreview::refused, this, [this](const QString& why) { m_foot->setReady(false, why); });
    connect(m_preview, &FigurePreview::roomChanged, this, &FigureDialog::preview);
    connect(m_fields, &FigureFields::changed, this, &FigureDialog::follow);
    connect(&document.frames(), &FrameFeed::frameReady, this, &FigureDialog::preview);
    connect(&document.derived(), &DerivedBuffers::changed, this, &FigureDialog::preview);
    follow();
    m_fields->setFocus();
}

void FigureDialog::follow() {
    const FigureOrder order = m_fields->order();
    std::vector<pipeline::BufferName> derived;
    if (pipeline::isDerived(order.buffer.id)) derived.push_back(order.buffer);
    m_document.derived().want(this, std::move(derived));
    m_document.frames().want(this, buffersFor(order));
    preview();
}

FigureDialog::Parts FigureDialog::parts() const {
    Parts parts{.frame = m_document.frames().shown(), .order = m_fields->order()};
    const pipeline::BufferName name = parts.order.buffer;
    const pipeline::BufferInfo& info = bufferInfo(name.id);
    if (info.domain != pipeline::Domain::Pixel && info.domain != pipeline::Domain::Texel) {
        parts.whyNot = tr("%1 has no pixels, so that there is no picture of it.").arg(toQString(name.text()));
    } else if (!parts.frame) {
        parts.whyNot = tr("The first frame is not ready yet.");
    } else if (pipeline::isDerived(name.id)) {
        if (const lessons::DerivedBuffer* made = m_document.derived().made(name))
            parts.buffer = made->buffer, parts.meaning = made->meaning;
        else
            parts.whyNot = m_document.derived().whyNot(name);
    } else {
        parts.buffer = parts.frame->buffer(name), parts.meaning = info.meaning;
        if (!parts.buffer)
            parts.whyNot = m_document.frames().busy() ? tr("%1 is being computed.").arg(toQString(name.text()))
                                                      : toQString(parts.frame->whyAbsent(name));
    }
    if (parts.buffer) fit(parts.order, *parts.buffer);
    return parts;
}

void FigureDialog::preview() {
    const Parts now = parts();
    m_foot->setReady(now.buffer.has_value(), now.whyNot);
    const bool isInside = m_document.stepper().isInside();
    const QString file = toQString(now.order.buffer.text()) + '.' + endingOf(now.order.format);
    m_foot->setCommand(isInside ? tr("No command: this is a step inside of the frame.")
                                : figureCommand(m_document.scene(), m_changes.words(m_document.scene()), now.order,
                                                m_document.derived().recipe(), file));
    if (!now.buffer) return m_preview->showWords(now.whyNot);
    m_preview->ask([now] { return figureOf(now.order, *now.frame, *now.buffer, now.meaning); });
}

void FigureDialog::write(std::vector<pipeline::FigureFormat> formats,
                         std::function<void(const std::vector<std::string>&)> done) {
    const Parts now = parts();
    if (!now.buffer || m_writing.busy()) return;
    m_fields->remember();
    m_foot->begin();
    struct Files {
        std::vector<std::string> bytes;
        pipeline::Errors errors;
    };
    m_writing.ask(
        [now, formats = std::move(formats)](const BackgroundJob::Control& control) {
            const pipeline::Figure figure = figureOf(now.order, *now.frame, *now.buffer, now.meaning);
            Files files;
            for (const pipeline::FigureFormat format : formats) {
                if (control.stop.stop_requested()) break;
                auto file = figureFile(figure, format);
                if (!file) return Files{{}, file.errors()};
                files.bytes.push_back(std::move(file).value());
            }
            return files;
        },
        [this, done = std::move(done)](const Files& files) {
            if (files.errors.empty()) return done(files.bytes);
            m_foot->finish(toQString(format(files.errors)).trimmed(), {});
        });
}

void FigureDialog::save(const QString& file) {
    write({m_fields->order().format}, [this, file](const std::vector<std::string>& files) {
        const QFileInfo written(file);
        if (const pipeline::Errors errors =
                writeFile(file, QByteArrayView(files[0].data(), qsizetype(files[0].size())));
            !errors.empty())
            return m_foot->finish(toQString(format(errors)).trimmed(), {});
        m_file = file;
        m_foot->finish(tr("Saved as %1.").arg(written.fileName()), written.absolutePath());
    });
}

void FigureDialog::copy() {
    using pipeline::FigureFormat;
    write({FigureFormat::Svg, FigureFormat::Png}, [this](const std::vector<std::string>& files) {
        auto* copied = new QMimeData;
        copied->setData("image/svg+xml", QByteArray::fromStdString(files[0]));
        copied->setImageData(QImage::fromData(QByteArray::fromStdString(files[1]), "PNG"));
        QApplication::clipboard()->setMimeData(copied);
        m_foot->finish(tr("Copied as SVG and as a picture."), {});
    });
}

void FigureDialog::choose() {
    const FigureOrder order = m_fields->order();
    const QString ending = endingOf(order.format);
    const QDir folder = m_file.isEmpty() ? QDir::home() : QFileInfo(m_file).dir();
    const QString file =
        askWhereToSave(this, windowTitle(), folder.filePath(toQString(order.buffer.text()) + '.' + ending),
                       tr("%1 files (*.%2)").arg(ending.toUpper(), ending), ending);
    if (!file.isEmpty()) save(file);
}

void FigureDialog::reject() {
    if (!m_writing.busy()) return QDialog::reject();
    m_writing.forget();
    m_foot->finish(tr("Cancelled. Nothing was written."), {});
}

}  // namespace app
