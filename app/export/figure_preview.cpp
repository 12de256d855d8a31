#include "app/export/figure_preview.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {
namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kDotsOfScreen = 96;  // of an inch at 100 %, as in a browser

}  // namespace

struct FigurePreview::Made {
    pipeline::Figure figure;
    pipeline::FigureSize size{};
    double dots = 0;  // per inch
    QImage image{};
    QString whyNot{};
};

FigurePreview::FigurePreview(QWidget* parent)
    : QWidget(parent),
      m_picture(styled(new QLabel(this), {.name = "figurePreview", .wraps = true})),
      m_size(styled(new QLabel(this), {.name = "figureSize", .tone = 2})) {
    auto* head = new QLabel(tr("Preview, as printed"), this);
    head->setProperty("tone", 2);
    head->setWordWrap(true);  // beside the size there is little room in large letters
    m_picture->setAccessibleName(tr("Preview"));
    m_picture->setAlignment(Qt::AlignCenter);
    m_picture->setMinimumSize(120, 90);
    m_picture->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    m_picture->installEventFilter(this);
    auto* row = new QHBoxLayout;
    row->addWidget(head, 1);
    row->addWidget(m_size);
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addLayout(row);
    column->addWidget(m_picture, 1);
    followTheme(this, [this] { m_size->setFont(Theme::current().mono(12)); });
}

QSize FigurePreview::room() const { return (QSizeF(m_picture->size()) * devicePixelRatioF()).toSize(); }

void FigurePreview::ask(std::function<pipeline::Figure()> make) {
    m_job.ask(
        [make = std::move(make), room = room()](const BackgroundJob::Control&) {
            Made made{.figure = make()};
            made.size = sizeOf(made.figure);
            const double fitting =
                std::min(room.width() / made.size.width, room.height() / made.size.height) * kMmPerInch;
            made.dots = std::clamp(fitting, pipeline::kLeastDots, pipeline::kMostDots);
            pipeline::Figure printed = made.figure;
            printed.dotsPerInch = made.dots;
            const auto png = figureFile(printed, pipeline::FigureFormat::Png);
            if (png)
                made.image = QImage::fromData(QByteArray::fromStdString(*png), "PNG");
            else
                made.whyNot = toQString(format(png.errors())).trimmed();
            return made;
        },
        [this](const Made& made) { take(made); });
}

void FigurePreview::take(const Made& made) {
    emit this->made(made.figure);
    if (!made.whyNot.isEmpty()) {
        showWords(made.whyNot);
        return emit refused(made.whyNot);
    }
    m_size->setText(tr("%1 × %2 mm, at %3 %")
                        .arg(made.size.width, 0, 'f', 1)
                        .arg(made.size.height, 0, 'f', 1)
                        .arg(qRound(100 * made.dots / devicePixelRatioF() / kDotsOfScreen)));
    const QSize most = room();
    QPixmap pixmap = QPixmap::fromImage(made.image);
    if (pixmap.width() > most.width() || pixmap.height() > most.height())
        pixmap = pixmap.scaled(most, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    m_picture->setPixmap(pixmap);
    m_picture->setAccessibleDescription(toQString(made.figure.caption));
}

void FigurePreview::showWords(const QString& words) {
    m_job.forget();
    m_size->clear();
    m_picture->setText(words);
    m_picture->setAccessibleDescription({});
}

bool FigurePreview::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_picture && event->type() == QEvent::Resize) emit roomChanged();
    return QWidget::eventFilter(watched, event);
}

}  // namespace app
