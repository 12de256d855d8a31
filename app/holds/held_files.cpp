#include "app/holds/held_files.h"

#include <QScopedValueRollback>
#include <QScrollBar>
#include <algorithm>

#include "app/document/document.h"
#include "app/document/hand.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

HeldFiles::HeldFiles(Hand& hand, const Document& document, QWidget* parent)
    : QTextBrowser(parent), m_hand(hand), m_document(document) {
    setObjectName("heldFiles");
    setAccessibleName(tr("Files of the scene"));
    setFrameShape(QFrame::NoFrame);
    setOpenLinks(false);
    setLineWrapMode(QTextEdit::NoWrap);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    hide();
    connect(&hand, &Hand::taken, this, &HeldFiles::showFiles);
    connect(&hand, &Hand::changed, this, &HeldFiles::showFiles);
    followTheme(this, [this] {
        const ThemeColors& dark = Theme::colors(ThemeId::Dark);
        setFont(Theme::current().mono(14));
        setFixedWidth(Theme::current().px(300));
        setStyleSheet(
            QStringLiteral("QTextBrowser { background: #06080B; color: %1; border: 0; }").arg(dark.text.name()));
        showFiles();
    });
}

void HeldFiles::setOn(bool on) {
    m_isOn = on;
    showFiles();
}

// In the dark theme's colours, as all that stands on the black around a picture. Where there is no room for all, the file
// that follows the hand has it.
void HeldFiles::showFiles() {
    m_files =
        m_isOn && m_document.hasScene() ? filesOf(m_hand.held(), m_document.scene()) : std::vector<lessons::HeldFile>();
    setVisible(!m_files.empty());
    fold();
}

void HeldFiles::fold() {
    if (m_files.empty() || m_isFolding) return;
    const QScopedValueRollback folding(m_isFolding, true);  // its scroll bar that comes or goes is a resize, too
    const int scrolled = verticalScrollBar()->value();
    QTextDocument all;
    all.setDefaultFont(font());
    all.setHtml(htmlOf(0));
    const QString html = htmlOf(all.size().height() > height() ? m_files.size() - 1 : 0);
    for (int width = -1; width != viewport()->width();) width = viewport()->width(), setHtml(html);
    verticalScrollBar()->setValue(scrolled);
}

void HeldFiles::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    fold();
}

// Of the files before `opened` the names alone.
QString HeldFiles::htmlOf(std::size_t opened) const {
    const auto held = std::ranges::find(m_hand.holds(), pipeline::Hold::Kind::Vertex, &pipeline::Hold::kind);
    const ThemeColors& dark = Theme::colors(ThemeId::Dark);
    const QFont words = Theme::current().text(13);
    const QString meaning = QStringLiteral("font-family:%1; font-size:%2px").arg(words.family()).arg(words.pixelSize());
    QString html;
    for (std::size_t i = 0; i < m_files.size(); ++i) {
        html += QStringLiteral("<p><b>%1</b></p>").arg(toQString(m_files[i].title).toHtmlEscaped());
        if (i < opened) continue;
        html += QStringLiteral("<table width=\"100%\" cellspacing=\"0\" cellpadding=\"1\">");
        for (const pipeline::LectureLine& line : m_files[i].lines) {
            const bool isLit = line.vertex == held->vertex;
            const QString number = line.number > 0 ? QString::number(line.number) : QString();
            html +=
                QStringLiteral(
                    "<tr%1><td width=\"22\" style=\"color:%2\">%3</td><td style=\"color:%4\">%5</td>"
                    "<td align=\"right\" style=\"color:%6; %7\">%8</td></tr>")
                    .arg(isLit ? QStringLiteral(" bgcolor=\"#33291A\"") : QString(), dark.text3.name(), number,
                         isLit ? dark.L.name() : dark.text.name(), toQString(line.text).toHtmlEscaped(),
                         isLit ? dark.L.name() : dark.text3.name(), meaning, toQString(line.meaning).toHtmlEscaped());
        }
        html += QStringLiteral("</table>");
    }
    return html;
}

}  // namespace app
