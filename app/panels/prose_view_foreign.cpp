// What a text brings along from elsewhere: pictures and links.
#include <QHash>
#include <QImage>
#include <QTextBlock>

#include "app/core/text.h"
#include "app/panels/prose_view.h"
#include "lessons/picture.h"

namespace app {

namespace {

// A run of characters of one format; a picture counts as one character. Found before anything is changed: a change may
// join runs.
struct Run {
    int at, length;
    QTextCharFormat format;
};
template <class Is>
QList<Run> runsWhere(const QTextDocument& document, Is is) {
    QList<Run> found;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        for (auto it = block.begin(); !it.atEnd(); ++it)
            if (const QTextFragment fragment = it.fragment(); is(fragment.charFormat()))
                found << Run{fragment.position(), fragment.length(), fragment.charFormat()};
    return found;
}
QList<Run> picturesIn(const QTextDocument& document) {
    return runsWhere(document, [](const QTextCharFormat& format) { return format.isImageFormat(); });
}

QTextCursor cursorOver(QTextDocument& document, const Run& run) {
    QTextCursor cursor(&document);
    cursor.setPosition(run.at);
    cursor.setPosition(run.at + run.length, QTextCursor::KeepAnchor);
    return cursor;
}

constexpr const char* kPictureName = "picture:";

}  // namespace

// Each picture gets a name of ours, under which the document has it; of one that may not be shown the words and the reason.
void ProseView::placePictures() {
    lessons::Pictures pictures(m_folder);
    const QList<Run> all = picturesIn(*document());
    QHash<QString, QImage> read;
    QHash<QString, QString> whyNot;
    for (const Run& one : all) {  // in their order: the first ones are shown where there are too many
        const QString name = one.format.toImageFormat().name();
        if (read.contains(name) || whyNot.contains(name)) continue;
        const auto picture = pictures.read(name.toStdString());
        QImage image;
        if (picture)
            image.loadFromData(QByteArrayView(picture->bytes.data(), qsizetype(picture->bytes.size())),
                               std::string(picture->type).c_str());
        if (!image.isNull())
            read.insert(name, image);
        else
            whyNot.insert(name, picture ? tr("found no picture") : toQString(format(picture.errors().front())));
    }
    for (auto one = all.crbegin(); one != all.crend(); ++one) {  // what is replaced moves only what comes after it
        QTextCursor cursor = cursorOver(*document(), *one);
        QTextImageFormat format = one->format.toImageFormat();
        const QString name = format.name();
        const QString words = format.property(QTextFormat::ImageAltText).toString();
        if (const auto found = read.constFind(name); found != read.constEnd()) {
            format.setName(kPictureName + QString::number(std::distance(read.constBegin(), found)));
            document()->addResource(QTextDocument::ImageResource, QUrl(format.name()), *found);
            cursor.setCharFormat(format);
        } else {
            cursor.insertText(tr("%1 (not shown: %2)").arg(words, whyNot[name]), QTextCharFormat());
        }
    }
    fitPictures();
}

// No wider than the text.
void ProseView::fitPictures() {
    const double ratio = devicePixelRatioF();
    for (const Run& one : picturesIn(*document())) {
        const auto image =
            document()->resource(QTextDocument::ImageResource, QUrl(one.format.toImageFormat().name())).value<QImage>();
        QTextImageFormat format = one.format.toImageFormat();
        const double width = std::min(image.width() / ratio, double(viewport()->width()));
        if (format.width() == width) continue;
        format.setWidth(width);
        format.setHeight(image.height() * width / std::max(image.width(), 1));
        cursorOver(*document(), one).setCharFormat(format);
    }
}

// What is no page of the web stays as words: in the window a link of a stranger opens no file.
void ProseView::dropForeignLinks() {
    const auto isForeign = [](const QTextCharFormat& format) {
        return format.isAnchor() && lessons::linkTarget(format.anchorHref().toStdString()) != lessons::LinkTarget::Web;
    };
    for (Run& run : runsWhere(*document(), isForeign)) {
        for (const int property :
             {QTextFormat::IsAnchor, QTextFormat::AnchorHref, QTextFormat::AnchorName, QTextFormat::TextUnderlineStyle,
              QTextFormat::ForegroundBrush, QTextFormat::TextToolTip})
            run.format.clearProperty(property);
        cursorOver(*document(), run).setCharFormat(run.format);
    }
}

// Qt asks here while it takes the text in, and would look for a file where it gets nothing.
QVariant ProseView::loadResource(int, const QUrl&) {
    static const QImage nothing = [] {
        QImage image(1, 1, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        return image;
    }();
    return nothing;
}

}  // namespace app
