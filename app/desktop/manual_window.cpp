#include "app/desktop/manual_window.h"

#include <QAbstractTextDocumentLayout>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QVBoxLayout>
#include <array>

#include "app/docks/panel_table.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_folder.h"

namespace app {
namespace {

struct PartPage {
    const char *part, *page;  // a widget's class, and its page
};
// What stands within another thing before that; panels have theirs in the table of panels.
constexpr auto kPages = std::to_array<PartPage>({
    {"app::BufferView", "buffers.md"},
    {"app::View3dPanel", "view3d.md"},
    {"app::ThumbnailStrip", "buffers.md"},
    {"app::StageStrip", "steps.md"},
    {"app::Timeline", "steps.md"},
    {"app::TermsSection", "mix.md"},
    {"app::StartPage", "README.md"},
    {"app::StudyPanel", "study.md"},
    {"app::CheckPanel", "check.md"},
});

}  // namespace

QString manualPageOf(const QWidget* widget) {
    for (; widget; widget = widget->parentWidget()) {
        for (const PartPage& row : kPages)
            if (QLatin1String(widget->metaObject()->className()) == row.part) return row.page;
        for (const PanelRow& row : panelTable())
            if (widget->objectName() == row.name) return row.manual;
    }
    return "window.md";
}

QString headingName(const QString& heading) {
    QString name;
    for (const QChar c : heading.toLower())
        if (c.isLetterOrNumber() || c == '-' || c == '_')
            name += c;
        else if (c == ' ')
            name += '-';
    return name;
}

ManualPage::ManualPage(QWidget* parent) : QTextBrowser(parent) {
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // every page has the same width
    m_reload.setSingleShot(true);
    m_reload.setInterval(50);
    connect(&m_reload, &QTimer::timeout, this, [this] {
        const int at = verticalScrollBar()->value();
        reload();
        verticalScrollBar()->setValue(at);
    });
}

void ManualPage::scrollToHeading(const QString& name) {
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0 || headingName(block.text()) != name) continue;
        setTextCursor(QTextCursor(block));
        document()->documentLayout()->documentSize();  // the page is laid out, and can be scrolled to its end
        verticalScrollBar()->setValue(int(document()->documentLayout()->blockBoundingRect(block).top()));
        return;
    }
}

// The manual's own pages and pictures: nothing is read from elsewhere. Qt would look for a file itself where it gets nothing.
QVariant ManualPage::loadResource(int type, const QUrl& name) {
    const auto folder = pipeline::resourceFolder();
    const QString within = QDir(toQString(folder.string())).relativeFilePath(source().resolved(name).toLocalFile());
    const auto file = pipeline::pathInFolder(folder, within.toStdString(), "manual");
    const auto text = file ? pipeline::readFile(*file) : pipeline::Result<std::string>(file.errors());
    const QByteArray bytes = text ? QByteArray(text->data(), qsizetype(text->size())) : QByteArray();
    if (type != QTextDocument::ImageResource) return bytes;
    QImage image;
    if (!image.loadFromData(bytes)) image = QImage(1, 1, QImage::Format_Mono);
    const double ratio = devicePixelRatioF();
    const int room = int((viewport()->width() - 2 * int(document()->documentMargin())) * ratio);
    if (image.width() > room) image = image.scaledToWidth(room, Qt::SmoothTransformation);
    image.setDevicePixelRatio(ratio);
    return image;
}

// Pictures are read again, in their new width; not at once: a page that is being laid out may bring a scroll bar.
void ManualPage::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    if (event->oldSize().width() == event->size().width() || source().isEmpty()) return;
    m_reload.start();
}

ManualWindow::ManualWindow(QWidget* parent) : QWidget(parent, Qt::Window), m_page(new ManualPage(this)) {
    setObjectName("manual");
    setWindowTitle(tr("The manual of Shadescope"));
    setAutoFillBackground(true);
    m_page->setOpenExternalLinks(true);
    m_page->setAccessibleName(windowTitle());
    m_page->setFrameShape(QFrame::NoFrame);
    auto* contents = new QPushButton(tr("Contents"), this);
    auto* back = new QPushButton(tr("Back"), this);
    auto* forward = new QPushButton(tr("Forward"), this);
    back->setShortcut(QKeySequence::Back);
    forward->setShortcut(QKeySequence::Forward);
    new QShortcut(QKeySequence(Qt::Key_Escape), this, [this] { close(); });
    back->setEnabled(false), forward->setEnabled(false);
    connect(contents, &QPushButton::clicked, this, [this] { open("README.md"); });
    connect(back, &QPushButton::clicked, m_page, &QTextBrowser::backward);
    connect(forward, &QPushButton::clicked, m_page, &QTextBrowser::forward);
    connect(m_page, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    connect(m_page, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
    connect(m_page, &QTextBrowser::sourceChanged, this, [this](const QUrl& page) {
        if (page.hasFragment()) m_page->scrollToHeading(page.fragment());
    });
    auto* row = spaced(new QHBoxLayout, {}, 6);
    for (QPushButton* button : {contents, back, forward}) row->addWidget(button);
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row);
    column->addWidget(m_page, 1);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_page->document()->setDefaultFont(theme.text(14));
        m_page->document()->setDocumentMargin(theme.px(24));
        resize(QSize(theme.px(860), theme.px(900)).boundedTo(screen()->availableSize()));
        m_page->reload();
    });
}

void ManualWindow::open(const QString& page) {
    const auto folder = pipeline::resourceFolder() / "manual";
    const QString file = toQString(folder.string()) + '/' + page;
    if (QFile::exists(file))
        m_page->setSource(QUrl::fromLocalFile(file));
    else
        m_page->setPlainText(tr("The manual is not installed: %1 is missing.").arg(file));
    show();
    raise();
    activateWindow();
}

}  // namespace app
