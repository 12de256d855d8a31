#include "app/lesson/prose_view.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QHash>
#include <QImage>
#include <QRegularExpression>
#include <QTextBlock>
#include <QWheelEvent>
#include <cmath>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "lessons/pages/picture.h"

namespace app {

namespace {

using pipeline::VectorCode;

VectorCode vectorIn(const QString& text) {
    constexpr std::pair<char, VectorCode> kLetters[]{
        {'N', VectorCode::N}, {'L', VectorCode::L}, {'V', VectorCode::V}, {'R', VectorCode::R}, {'H', VectorCode::H}};
    for (const auto& [letter, code] : kLetters)
        if (text.size() == 1 && text[0] == QLatin1Char(letter)) return code;
    return VectorCode::None;
}

// Of a fenced block of code: Qt marks the block, not its letters.
bool isCode(const QTextBlock& block) { return block.blockFormat().hasProperty(QTextFormat::BlockCodeLanguage); }

QColor colorOf(ProseView::Tone tone, const ThemeColors& colors) {
    switch (tone) {
        case ProseView::Tone::Right: return colors.run;
        case ProseView::Tone::NotYet: return colors.warn;
        case ProseView::Tone::Heading:
        case ProseView::Tone::Question: return colors.text;
        case ProseView::Tone::Plain: break;
    }
    return colors.text2;
}

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

ProseView::ProseView(QWidget* parent) : QTextBrowser(parent) {
    setOpenLinks(false);
    connect(this, &QTextBrowser::anchorClicked, this, [](const QUrl& url) { QDesktopServices::openUrl(url); });
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFrameShape(QFrame::NoFrame);
    setStyleSheet("QTextBrowser { background: transparent; border: 0; padding: 0; }");
    document()->setDocumentMargin(0);
    connect(document()->documentLayout(), &QAbstractTextDocumentLayout::documentSizeChanged, this,
            &ProseView::fitHeight);
    followTheme(this, [this] { typeset(); });
}

void ProseView::setProse(const QString& markdown, Tone tone) {
    m_markdown = markdown;
    m_tone = tone;
    typeset();
}

void ProseView::typeset() {
    const Theme& theme = Theme::current();
    const bool heading = m_tone == Tone::Heading;
    document()->setDefaultFont(heading                    ? theme.text(18, 700)
                               : m_tone == Tone::Question ? theme.text(14, 600)
                                                          : theme.text());
    document()->setIndentWidth(theme.px(14));
    document()->setMarkdown(m_markdown, QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub) |
                                            QTextDocument::MarkdownNoHTML);
    placePictures();
    dropForeignLinks();
    QTextCursor all(document());
    all.select(QTextCursor::Document);
    QTextCharFormat color;
    color.setForeground(colorOf(m_tone, theme.colors()));
    all.mergeCharFormat(color);
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        // Fixed, so that a line with a vector or a subscript in it stands no farther apart. A picture takes what it needs.
        const bool fixed = !block.text().contains(QChar::ObjectReplacementCharacter);
        format.setLineHeight(theme.px(heading ? 26 : 20),
                             fixed ? QTextBlockFormat::FixedHeight : QTextBlockFormat::MinimumHeight);
        format.setTopMargin(0);
        format.setNonBreakableLines(false);  // lines of code wrap as well: the column does not scroll sideways
        const bool inList = block.textList() && block.next().textList();
        const bool inCode = isCode(block) && isCode(block.next());
        format.setBottomMargin(block.next().isValid() ? theme.px(inCode ? 0 : inList ? 2 : 8) : 0);
        QTextCursor(block).setBlockFormat(format);
    }
    markVectors();
    raiseScripts();
    fitHeight();
}

void ProseView::markVectors() {
    const Theme& theme = Theme::current();
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        for (auto it = block.begin(); !it.atEnd(); ++it) {
            const QTextFragment fragment = it.fragment();
            QTextCharFormat format = fragment.charFormat();
            QTextCursor cursor(block);
            cursor.setPosition(fragment.position());
            cursor.setPosition(fragment.position() + fragment.length(), QTextCursor::KeepAnchor);
            if (format.fontFixedPitch() || isCode(block)) {
                QTextCharFormat code;
                code.setFont(theme.mono(12), QTextCharFormat::FontPropertiesSpecifiedOnly);
                code.setFontFixedPitch(true);
                cursor.mergeCharFormat(code);
            } else if (format.fontItalic() && format.fontWeight() >= QFont::Bold) {
                if (const VectorCode code = vectorIn(fragment.text()); code != VectorCode::None) {
                    QTextCharFormat vector;
                    vector.setForeground(theme.vector(code));
                    vector.setFontUnderline(true);
                    vector.setFontFamilies(theme.formula().families());
                    cursor.mergeCharFormat(vector);
                }
            }
        }
    }
}

void ProseView::raiseScripts() {
    static const QRegularExpression script("(?<=[\\p{L})])[_^][A-Za-z0-9]+");
    for (QTextCursor found = document()->find(script, 0); !found.isNull(); found = document()->find(script, found)) {
        if (found.charFormat().fontFixedPitch() || isCode(found.block())) continue;
        const bool below = found.selectedText().startsWith('_');
        const int start = found.selectionStart(), end = found.selectionEnd() - 1;  // without its sign
        QTextCursor sign(document());
        sign.setPosition(start);
        sign.deleteChar();
        found.setPosition(start);
        found.setPosition(end, QTextCursor::KeepAnchor);
        QTextCharFormat format;
        format.setVerticalAlignment(below ? QTextCharFormat::AlignSubScript : QTextCharFormat::AlignSuperScript);
        found.mergeCharFormat(format);
    }
}

void ProseView::fitHeight() {
    const int frame = height() - viewport()->height();
    const int wanted = int(std::ceil(document()->size().height())) + std::max(frame, 0);
    if (wanted != minimumHeight() || wanted != maximumHeight()) setFixedHeight(wanted);
}

void ProseView::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    fitPictures();
    fitHeight();
}

QString plainText(const QString& markdown) {
    QTextDocument words;
    words.setMarkdown(markdown, QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub) |
                                    QTextDocument::MarkdownNoHTML);
    return words.toPlainText();
}

// There are no pages to go back and forth between here: such keys are for what it is in, and so are those that write.
void ProseView::keyPressEvent(QKeyEvent* event) {
    const bool copies = event->matches(QKeySequence::Copy) || event->matches(QKeySequence::SelectAll);
    const bool moves = event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab;
    if (copies || moves || (event->modifiers() & Qt::ShiftModifier) != 0) return QTextBrowser::keyPressEvent(event);
    event->ignore();
}

void ProseView::wheelEvent(QWheelEvent* event) { event->ignore(); }

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
