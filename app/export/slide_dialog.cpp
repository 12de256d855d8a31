#include "app/export/slide_dialog.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_painter.h"
#include "app/compare/buffer_compare.h"
#include "app/jobs/write_file.h"
#include "app/look/hidden_in_window.h"
#include "app/look/text.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/view_area.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/on_screen.h"
#include "app/widgets/save_dialog.h"

namespace app {
namespace {

constexpr std::array<QSize, 4> kSizes{QSize(1280, 720), QSize(1920, 1080), QSize(1600, 1200), QSize(3840, 2160)};
constexpr int kMaxSide = 8192;
constexpr int kViewRole = Qt::UserRole + 1;  // of a buffer view: which of them

}  // namespace

SlideDialog::SlideDialog(const Document& document, ViewArea& views, lessons::WindowState state, QWidget* parent)
    : QDialog(parent), m_document(document), m_views(views), m_state(std::move(state)) {
    setObjectName("slideDialog");
    setWindowTitle(tr("Picture for a slide"));
    m_picture = new QLabel(this);
    m_picture->setAlignment(Qt::AlignCenter);
    m_picture->setMinimumSize(160, 120);
    m_picture->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);  // its pixmap asks for no room
    m_picture->setAccessibleName(tr("Preview"));
    m_message = styled(new QLabel(this), {.name = "slideMessage", .wraps = true});
    auto* halves = new QHBoxLayout;
    halves->addWidget(m_picture, 1);
    halves->addWidget(new FieldsArea(makeFields(), this));
    m_progress = new QProgressBar(this);
    m_progress->setAccessibleName(tr("Progress"));
    m_progress->setTextVisible(false);
    m_progress->hide();
    m_copy = new QPushButton(tr("Copy"), this);
    m_close = new QPushButton(tr("Close"), this);
    m_close->setObjectName("slideClose");
    m_save = new QPushButton(tr("Save…"), this);
    m_save->setProperty("kind", "primary");
    m_save->setDefault(true);
    connect(m_copy, &QPushButton::clicked, this, &SlideDialog::copy);
    connect(m_close, &QPushButton::clicked, this, &SlideDialog::reject);
    connect(&m_job, &BackgroundJob::progressed, this, [this](double share) {
        m_progress->setRange(0, share < 1 ? 100 : 0);  // a file is written after that
        if (share < 1) m_progress->setValue(int(100 * share));
    });
    connect(&m_job, &BackgroundJob::busyChanged, this, &SlideDialog::showWork);
    connect(m_save, &QPushButton::clicked, this, &SlideDialog::choose);
    auto* row = new QHBoxLayout;
    row->addWidget(m_message, 1);
    row->addWidget(m_copy);
    row->addWidget(m_close);
    row->addWidget(m_save);
    auto* column = spaced(new QVBoxLayout(this), {16, 12, 16, 12});
    column->addLayout(halves, 1);
    column->addWidget(m_progress);
    column->addLayout(row);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_progress->setFixedHeight(theme.px(6));
        resize(onScreen(*this, theme.px(900), theme.px(480)));
    });
    m_ready = true;
    preview();
}

QWidget* SlideDialog::makeFields() {
    auto* fields = new QWidget(this);
    auto* form = new QFormLayout(fields);
    m_what = new QComboBox(fields);
    m_what->setObjectName("slideWhat");
    const std::vector<BufferView*> buffers = m_views.shownBuffers();
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const bool compared = buffers[i]->compare().showsOther();
        m_what->addItem(
            (compared ? tr("Buffer: %1, compared") : tr("Buffer: %1")).arg(toQString(m_state.views[i].buffer)),
            int(SlideRequest::What::Buffer));
        m_what->setItemData(int(i), int(i), kViewRole);
        if (buffers[i] == &m_views.activeBuffer()) m_what->setCurrentIndex(int(i));
    }
    if (!isHiddenInWindow(m_views.view3d())) {
        m_what->addItem(tr("3D view"), int(SlideRequest::What::Space));
        m_what->addItem(tr("Buffer and 3D view"), int(SlideRequest::What::Beside));
    }
    m_sizes = new QComboBox(fields);
    for (const QSize& size : kSizes) m_sizes->addItem(tr("%1 × %2").arg(size.width()).arg(size.height()));
    m_sizes->addItem(tr("Own size"));
    m_sizes->setCurrentIndex(1);
    const auto side = [&](int value, const QString& name) {
        auto* spin = new QSpinBox(fields);
        spin->setRange(16, kMaxSide);
        spin->setValue(value);
        spin->setAccessibleName(name);
        connect(spin, &QSpinBox::valueChanged, this, [this] {
            if (!m_ready) return;
            const auto own = std::ranges::find(kSizes, QSize(m_width->value(), m_height->value()));
            m_sizes->setCurrentIndex(int(own - kSizes.begin()));
            preview();
        });
        return spin;
    };
    m_width = side(1920, tr("Width in pixels")), m_height = side(1080, tr("Height in pixels"));
    connect(m_sizes, &QComboBox::activated, this, [this](int i) {
        if (i >= int(kSizes.size())) return;
        const QSize size = kSizes[std::size_t(i)];  // while a width and the height before make one's own
        m_width->setValue(size.width());
        m_height->setValue(size.height());
    });
    const auto check = [&](const QString& text, bool on) {
        auto* box = new QCheckBox(text, fields);
        box->setChecked(on);
        connect(box, &QCheckBox::toggled, this, &SlideDialog::preview);
        return box;
    };
    m_transparent = check(tr("Transparent background"), true);
    m_caption = check(tr("Caption"), false);
    m_marks = check(tr("Picked pixel, pins, selection and region"), true);
    connect(m_what, &QComboBox::currentIndexChanged, this, &SlideDialog::preview);
    auto* pixels = new QHBoxLayout;
    pixels->addWidget(m_width);
    pixels->addWidget(new QLabel(QStringLiteral("×"), fields));
    pixels->addWidget(m_height);
    pixels->addStretch(1);
    form->addRow(tr("Picture of"), m_what);
    form->addRow(tr("Size"), m_sizes);
    form->addRow(tr("Pixels"), pixels);
    for (QCheckBox* box : {m_transparent, m_caption, m_marks}) form->addRow(QString(), box);
    auto* note =
        styled(new QLabel(tr("The file carries the scene and what the window shows: dropped on the window, it opens "
                             "them again."),
                          fields),
               {.tone = 2, .wraps = true});
    form->addRow(note);
    return fields;
}

SlideRequest SlideDialog::request() const {
    return {SlideRequest::What(m_what->currentData().toInt()),
            {m_width->value(), m_height->value()},
            m_transparent->isChecked(),
            m_caption->isChecked(),
            m_marks->isChecked(),
            std::size_t(m_what->currentData(kViewRole).toInt())};
}

QString SlideDialog::message() const { return m_message->text(); }

// In the proportions of the picture, on the checker that stands for nothing.
void SlideDialog::preview() {
    if (!m_ready) return;
    SlideRequest small = request();
    const QSize room = m_picture->size().expandedTo({480, 270});
    // As many pixels as the screen has there.
    const double ratio = devicePixelRatioF();
    small.size = small.size.scaled((QSizeF(room) * ratio).toSize(), Qt::KeepAspectRatio);
    const auto image = slidePicture(m_document, m_views, small);
    m_save->setEnabled(bool(image));
    m_message->setText(image ? QString() : toQString(format(image.errors())).trimmed());
    if (!image) return m_picture->setPixmap({});
    QPixmap pixmap(small.size);
    pixmap.setDevicePixelRatio(ratio);
    const QRectF all(QPointF(), pixmap.deviceIndependentSize());
    QPainter painter(&pixmap);
    paintChecker(painter, all.toAlignedRect());
    painter.drawImage(all, *image);
    painter.end();
    m_picture->setPixmap(pixmap);
}

void SlideDialog::reject() {
    if (!m_job.busy()) return QDialog::reject();
    if (m_decided->exchange(true)) return;  // a file half a moment from done is finished, and told
    m_job.forget();
    m_message->setText(tr("Cancelled. Nothing was written."));
}

void SlideDialog::showWork() {
    const bool works = m_job.busy();
    m_progress->setRange(0, 100);
    m_progress->setValue(0);
    m_progress->setVisible(works);
    m_save->setDisabled(works), m_copy->setDisabled(works);
    m_close->setText(works ? tr("Cancel") : tr("Close"));
    if (works) m_message->clear();
}

void SlideDialog::make(std::function<void(Made&, std::atomic<bool>&)> finish, std::function<void(const Made&)> done) {
    const auto content = slideContent(m_document, m_views, request());
    if (!content) return m_message->setText(toQString(format(content.errors())).trimmed());
    m_decided = std::make_shared<std::atomic<bool>>(false);
    m_job.ask(
        [content = *content, finish, decided = m_decided](const BackgroundJob::Control& control) {
            auto image = drawSlide(content, control);
            if (!image) return Made{{}, image.errors()};
            Made made{std::move(image).value(), {}};
            if (!control.stop.stop_requested()) finish(made, *decided);
            return made;
        },
        [this, done](const Made& made) {
            made.errors.empty() ? done(made) : m_message->setText(toQString(format(made.errors)).trimmed());
        });
}

void SlideDialog::save(const QString& file) {
    const auto write = [file, scene = m_document.sharedScene(), state = m_state](Made& made,
                                                                                 std::atomic<bool>& decided) {
        const std::string png = slidePng(made.image, *scene, state);
        if (decided.exchange(true)) return;
        made.errors = png.empty() ? pipeline::Errors{{{file.toStdString(), 0, 0}, "the picture cannot be packed", {}}}
                                  : writeFile(file, png);
    };
    make(write, [this, file](const Made&) {
        const QString path = QDir::toNativeSeparators(QFileInfo(file).absoluteFilePath());
        const QString words = tr("Saved as %1.");
        const QFontMetrics metrics = m_message->fontMetrics();
        const int room = m_message->width() - metrics.horizontalAdvance(words.arg(QString())) - 4;
        m_message->setText(words.arg(metrics.elidedText(path, Qt::ElideMiddle, room)));
        m_message->setToolTip(path);
    });
}

void SlideDialog::choose() {
    const QString base = QFileInfo(toQString(m_document.scene().name)).completeBaseName();
    const QString file = askWhereToSave(this, tr("Picture for a slide"), QDir::home().filePath(base + ".png"),
                                        tr("Pictures (*.png)"), "png");
    if (!file.isEmpty()) save(file);
}

void SlideDialog::copy() {
    make([](Made&, std::atomic<bool>&) {},
         [this](const Made& made) {
             QApplication::clipboard()->setImage(made.image);
             m_message->setText(tr("Copied the picture."));
         });
}

}  // namespace app
