#include "app/panels/export_list.h"

#include <algorithm>

#include <QHeaderView>

#include "app/core/text.h"
#include "app/panels/follow_theme.h"

namespace app {

ExportList::ExportList(QWidget* parent) : QTreeWidget(parent) {
    setObjectName("exportBuffers");
    setAccessibleName(tr("Buffers"));
    setColumnCount(2);
    setHeaderHidden(true);
    setRootIsDecorated(false);
    setIndentation(8);
    setFrameShape(QFrame::NoFrame);
    header()->setStretchLastSection(true);
    followTheme(this, [this] { setFont(Theme::current().mono(12)); });
    connect(this, &QTreeWidget::itemChanged, this, &ExportList::chosenChanged);
}

void ExportList::setFrame(const pipeline::Frame& frame) {
    std::vector<pipeline::BufferName> unchecked;
    for (const Entry& entry : m_entries)
        if (entry.row.whyNot.isEmpty() && entry.item->checkState(0) != Qt::Checked) unchecked.push_back(entry.row.name);
    const QSignalBlocker quiet(this);
    clear();
    m_entries.clear();
    const Theme& theme = Theme::current();
    QTreeWidgetItem* stage = nullptr;
    for (ExportRow& row : exportRows(frame)) {
        const pipeline::StageInfo& info = stageInfo(bufferInfo(row.name.id).stage);
        const QString heading = QStringLiteral("%1 %2").arg(index(info.id) + 1).arg(toQString(info.label));
        if (!stage || stage->text(0) != heading) {
            stage = new QTreeWidgetItem(this, {heading});
            stage->setFont(0, theme.text(13, 600));
            stage->setFlags(Qt::ItemIsEnabled);
        }
        const bool there = row.whyNot.isEmpty();
        auto* item = new QTreeWidgetItem(
            stage, {toQString(row.name.text()), there ? sizeText(row.bytes) : tr("left out: %1").arg(row.whyNot)});
        const bool checked = there && std::ranges::find(unchecked, row.name) == unchecked.end();
        item->setCheckState(0, checked ? Qt::Checked : Qt::Unchecked);
        item->setTextAlignment(1, there ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
        item->setToolTip(1, row.whyNot);
        item->setFont(1, there ? theme.mono(12) : theme.text(12));
        if (!there) item->setForeground(1, theme.colors().text2);
        m_entries.push_back({std::move(row), item});
    }
    expandAll();
    resizeColumnToContents(0);
}

std::vector<pipeline::BufferName> ExportList::chosen() const {
    std::vector<pipeline::BufferName> names;
    for (const Entry& entry : m_entries)
        if (entry.item->checkState(0) == Qt::Checked) names.push_back(entry.row.name);
    return names;
}

bool ExportList::isAllChosen() const {
    return std::ranges::all_of(m_entries, [](const Entry& entry) {
        return entry.row.whyNot.isEmpty() == (entry.item->checkState(0) == Qt::Checked);
    });
}

}  // namespace app
