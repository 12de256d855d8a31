#include "app/buffer_view/region_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/canvas/shown_buffer.h"
#include "app/frames/buffer_place.h"
#include "app/frames/large_frame.h"
#include "app/look/icons.h"
#include "app/look/working_bar.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace {

// The lines of regionText as a table: names on the left, numbers flush right.
QString asTable(const QString& text) {
    QString table = QStringLiteral("<table cellspacing='0' cellpadding='1'>");
    const QStringList lines = text.split('\n');
    for (qsizetype i = 0; i + 1 < lines.size(); ++i) {
        table += QStringLiteral("<tr>");
        const QStringList cells = lines[i].split('\t');
        for (qsizetype c = 0; c < cells.size(); ++c)
            table += QStringLiteral("<td align='%1'>%2&nbsp;&nbsp;</td>")
                         .arg(c == 0 ? "left" : "right", cells[c].toHtmlEscaped());
        table += QStringLiteral("</tr>");
    }
    return table + QStringLiteral("</table>") + lines.back().toHtmlEscaped();
}

}  // namespace

RegionPanel::RegionPanel(QWidget* parent) : QFrame(parent), m_table(new QLabel(this)) {
    setProperty("kind", "overlay");
    setAccessibleName(tr("Statistics of the region"));
    m_table->setTextFormat(Qt::RichText);
    auto* copy = new QToolButton(this);
    copy->setIcon(icon("copy"));
    copy->setAccessibleName(tr("Copy the statistics"));
    copy->setToolTip(tr("Copy the statistics as text, with tabs between the columns"));
    auto* close = new QToolButton(this);
    close->setIcon(icon("close"));
    close->setAccessibleName(tr("Close the statistics"));
    close->setToolTip(tr("Close (Esc)"));
    // With the signs that other programs read.
    connect(copy, &QToolButton::clicked, this,
            [this] { QApplication::clipboard()->setText(QString(m_text).replace(QChar(0x2212), '-')); });
    connect(close, &QToolButton::clicked, this, &RegionPanel::closed);
    auto* row = new QHBoxLayout(this);
    row->addWidget(m_table);
    auto* buttons = new QVBoxLayout;
    buttons->addWidget(close);
    buttons->addWidget(copy);
    buttons->addStretch();
    row->addLayout(buttons);
    followTheme(this, [this, row] {
        const int padding = Theme::current().px(6);
        row->setContentsMargins(padding, padding, padding, padding);
        m_table->setFont(Theme::current().mono(12));
        adjustSize();
    });
    auto* working = new WorkingBar(this);
    connect(&m_job, &BackgroundJob::busyChanged, working, &WorkingBar::setWorking);
    hide();
}

void RegionPanel::show(const pipeline::AnyBuffer& buffer, const std::optional<Region>& region,
                       lessons::ShownChannel channel) {
    setVisible(region.has_value());
    if (!region) {
        m_job.forget();
        m_asked.reset();
        return;
    }
    const NumberFormat& numbers = NumberStyle::current().format();
    const bool isSame = m_asked && m_asked->buffer.name == buffer.name && placeOf(m_asked->buffer) == placeOf(buffer) &&
                        m_asked->region == *region && m_asked->channel == channel && m_asked->numbers == numbers;
    if (isSame) return;
    m_asked = Question{buffer, *region, channel, numbers};
    const auto text = [buffer, region = *region, channel] {
        return regionText(buffer, region, channel, channelNames(*buffer.info));
    };
    const glm::ivec2 extent = region->last() - region->first() + 1;
    if (std::size_t(extent.x) * std::size_t(extent.y) * std::size_t(buffer.channels()) <= kManyNumbers) {
        m_job.forget();
        return take(text());
    }
    m_job.ask([text](const BackgroundJob::Control&) { return text(); }, [this](const QString& made) { take(made); },
              BackgroundJob::Running::Finish);
}

void RegionPanel::take(const QString& text) {
    m_text = text;
    m_table->setText(asTable(m_text));
    setAccessibleDescription(m_text);
    adjustSize();
    emit resized();
}

}  // namespace app
