#include "app/panels/export_list.h"

#include <algorithm>

#include <QHeaderView>

#include "app/core/text.h"
#include "app/panels/airy_cells.h"
#include "app/panels/follow_theme.h"

namespace app {

ExportList::ExportList(QWidget* parent) : QTreeWidget(parent) {
    setObjectName("exportBuffers");
    setAccessibleName(tr("Buffers"));
    setColumnCount(2);
    setHeaderHidden(true);
    setRootIsDecorated(false);
    setIndentation(8);
    setItemDelegateForColumn(0, new AiryCells(this));  // between check boxes and names
    setFrameShape(QFrame::NoFrame);
    header()->setStretchLastSection(true);
    followTheme(this, [this] { setFont(Theme::current().mono(12)); });
    connect(this, &QTreeWidget::itemChanged, this, &ExportList::chosenChanged);
}

void ExportList::setFrame(const pipeline::Frame& frame, const DerivedRecipe& recipe) {
    std::vector<pipeline::BufferName> unchecked, derived;
    for (const Entry& entry : m_entries) {
        const bool isChecked = entry.item->checkState(0) == Qt::Checked;
        if (pipeline::isDerived(entry.row.name.id) && isChecked) derived.push_back(entry.row.name);
        if (entry.row.whyNot.isEmpty() && !isChecked) unchecked.push_back(entry.row.name);
    }
    const auto isIn = [](const std::vector<pipeline::BufferName>& names, const pipeline::BufferName& name) {
        return std::ranges::find(names, name) != names.end();
    };
    const QSignalBlocker quiet(this);
    clear();
    m_entries.clear();
    const Theme& theme = Theme::current();
    QTreeWidgetItem* stage = nullptr;
    for (ExportRow& row : exportRows(frame, recipe)) {
        const bool isDerived = pipeline::isDerived(row.name.id);
        const pipeline::StageInfo& info = stageInfo(bufferInfo(row.name.id).stage);
        const QString heading =
            isDerived ? tr("Derived") : QStringLiteral("%1 %2").arg(index(info.id) + 1).arg(toQString(info.label));
        if (!stage || stage->text(0) != heading) {
            stage = new QTreeWidgetItem(this, {heading});
            stage->setFont(0, theme.text(13, 600));
            stage->setFlags(Qt::ItemIsEnabled);
        }
        const bool there = row.whyNot.isEmpty();
        auto* item =
            new QTreeWidgetItem(stage, {toQString(row.name.text()), there       ? sizeText(row.bytes)
                                                                    : isDerived ? row.whyNot
                                                                                : tr("left out: %1").arg(row.whyNot)});
        const bool checked = there && (isDerived ? isIn(derived, row.name) : !isIn(unchecked, row.name));
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
        return pipeline::isDerived(entry.row.name.id) ||
               entry.row.whyNot.isEmpty() == (entry.item->checkState(0) == Qt::Checked);
    });
}

}  // namespace app
