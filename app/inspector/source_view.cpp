#include "app/inspector/source_view.h"

#include <QDir>
#include <QFileInfo>
#include <QPlainTextEdit>
#include <QTextBlock>
#include <QVBoxLayout>
#include <algorithm>

#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/on_screen.h"
#include "pipeline/formats/scene_folder.h"

namespace app {

SourceView::SourceView(const QString& file, const QString& text, int line, int column, QWidget* parent)
    : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("%1, line %2").arg(shownName(file)).arg(line));
    auto* lines = new QPlainTextEdit(text, this);
    lines->setReadOnly(true);
    lines->setLineWrapMode(QPlainTextEdit::NoWrap);
    lines->setAccessibleName(windowTitle());
    auto* all = new QVBoxLayout(this);
    all->addWidget(lines);
    const QTextBlock block = lines->document()->findBlockByNumber(line - 1);
    QTextCursor cursor(block);
    cursor.setPosition(block.position() + std::clamp(column - 1, 0, std::max(0, block.length() - 1)));
    lines->setTextCursor(cursor);
    lines->centerCursor();
    followTheme(this, [this, lines, cursor] {
        const Theme& theme = Theme::current();
        lines->setFont(theme.mono());
        QTextEdit::ExtraSelection marked;
        marked.cursor = cursor;
        marked.format.setBackground(theme.colors().tint);
        marked.format.setProperty(QTextFormat::FullWidthSelection, true);
        lines->setExtraSelections({marked});
        resize(onScreen(*this, theme.px(640), theme.px(420)));
    });
}

QString sourceFile(const std::string& sceneFile, const std::string& meshFile) {
    if (meshFile.empty()) return {};
    return QFileInfo(toQString(sceneFile)).dir().filePath(toQString(meshFile));
}

bool showSource(const QString& file, int line, int column, QWidget* parent) {
    constexpr std::size_t kMost = std::size_t{16} << 20;
    const auto text = pipeline::readFile(file.toStdString(), kMost);
    if (!text) return false;
    (new SourceView(file, toQString(*text), line, column, parent))->show();
    return true;
}

}  // namespace app
