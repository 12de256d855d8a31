#include "app/panels/held_files.h"

#include <QScrollBar>
#include <algorithm>

#include "app/core/document.h"
#include "app/core/hand.h"
#include "app/core/text.h"
#include "app/panels/follow_theme.h"

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
        setFixedWidth(Theme::current().px(330));
        setStyleSheet(
            QStringLiteral("QTextBrowser { background: #06080B; color: %1; border: 0; }").arg(dark.text.name()));
        showFiles();
    });
}

void HeldFiles::setOn(bool on) {
    m_isOn = on;
    showFiles();
}

// The dark theme's colours, as all that stands on the black around a picture.
void HeldFiles::showFiles() {
    const auto files =
        m_isOn && m_document.hasScene() ? filesOf(m_hand.held(), m_document.scene()) : std::vector<lessons::HeldFile>();
    setVisible(!files.empty());
    if (files.empty()) return;
    const auto held = std::ranges::find(m_hand.holds(), pipeline::Hold::Kind::Vertex, &pipeline::Hold::kind);
    const ThemeColors& dark = Theme::colors(ThemeId::Dark);
    QString html;
    for (const lessons::HeldFile& file : files) {
        html += QStringLiteral("<p><b>%1</b></p><table width=\"100%\" cellspacing=\"0\" cellpadding=\"1\">")
                    .arg(toQString(file.title).toHtmlEscaped());
        for (const pipeline::LectureLine& line : file.lines) {
            const bool isLit = line.vertex == held->vertex;
            const QString number = line.number > 0 ? QString::number(line.number) : QString();
            html += QStringLiteral(
                        "<tr%1><td style=\"color:%2\">%3&nbsp;</td><td style=\"color:%4\">%5</td>"
                        "<td align=\"right\" style=\"color:%6\">%7</td></tr>")
                        .arg(isLit ? QStringLiteral(" bgcolor=\"#33291A\"") : QString(), dark.text3.name(), number,
                             isLit ? dark.L.name() : dark.text.name(), toQString(line.text).toHtmlEscaped(),
                             isLit ? dark.L.name() : dark.text3.name(), toQString(line.meaning).toHtmlEscaped());
        }
        html += QStringLiteral("</table>");
    }
    const int scrolled = verticalScrollBar()->value();
    setHtml(html);
    verticalScrollBar()->setValue(scrolled);
}

}  // namespace app
