#include "app/panels/prose_view.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QRegularExpression>
#include <QTextBlock>
#include <QWheelEvent>
#include <cmath>

#include "app/panels/follow_theme.h"

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
    document()->setDefaultFont(heading                    ? theme.text(16, 600)
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
        format.setLineHeight(theme.px(heading ? 24 : 20),
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

}  // namespace app
