#include "app/export/export_list.h"

#include <algorithm>

#include <QHeaderView>
#include <QKeyEvent>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/padded_cells.h"

namespace app {

namespace {

void check(QTreeWidgetItem& item, bool checked) { item.setCheckState(0, checked ? Qt::Checked : Qt::Unchecked); }

}  // namespace

bool ExportList::Entry::isIn(const std::vector<pipeline::BufferName>& names) const {
    return std::ranges::find(names, row.name) != names.end();
}

ExportList::ExportList(QWidget* parent) : QTreeWidget(parent) {
    setObjectName("exportBuffers");
    setAccessibleName(tr("Buffers"));
    setColumnCount(2);
    setHeaderHidden(true);
    setRootIsDecorated(false);
    setIndentation(8);
    setSelectionMode(ExtendedSelection);
    setItemDelegateForColumn(0, new PaddedCells(this));  // between check boxes and names
    setFrameShape(QFrame::NoFrame);
    header()->setStretchLastSection(true);
    followTheme(this, [this] { setFont(Theme::current().mono(12)); });
    connect(this, &QTreeWidget::itemChanged, this, &ExportList::follow);
}

void ExportList::setFrame(const pipeline::Frame& frame, const lessons::DerivedRecipe& recipe) {
    std::vector<pipeline::BufferName> known, checked;
    for (const Entry& entry : m_entries) {
        if (entry.isThere()) known.push_back(entry.row.name);
        if (entry.isChecked()) checked.push_back(entry.row.name);
    }
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
            stage->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        }
        const bool there = row.whyNot.isEmpty();
        auto* item = new QTreeWidgetItem(
            stage, {toQString(row.name.text()), there || isDerived ? row.whyNot : tr("left out: %1").arg(row.whyNot)});
        item->setTextAlignment(1, there ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
        item->setToolTip(1, row.whyNot);
        item->setFont(1, there ? theme.mono(12) : theme.text(12));
        if (!there) item->setForeground(1, theme.colors().text2);
        m_entries.push_back({std::move(row), item});
        const Entry& entry = m_entries.back();
        if (there) showSize(entry);
        check(*item, entry.isIn(checked) || (there && !isDerived && m_takesNew && !entry.isIn(known)));
    }
    checkStages();
    expandAll();
    resizeColumnToContents(0);
}

void ExportList::showSize(const Entry& entry) {
    const bool pixels = pipeline::bufferInfo(entry.row.name.id).domain == pipeline::Domain::Pixel;
    entry.item->setText(1, sizeText(std::uint64_t(double(entry.row.bytes) * (pixels ? m_scale : 1))));
}

void ExportList::setScale(double scale) {
    m_scale = scale;
    const QSignalBlocker quiet(this);
    for (const Entry& entry : m_entries)
        if (entry.isThere()) showSize(entry);
}

void ExportList::chooseAll() {
    {
        const QSignalBlocker quiet(this);
        for (const Entry& entry : m_entries)
            check(*entry.item, entry.isThere() && !pipeline::isDerived(entry.row.name.id));
    }
    m_takesNew = true;
    follow(nullptr);
}

void ExportList::choose(const std::vector<pipeline::BufferName>& names) {
    {
        const QSignalBlocker quiet(this);
        for (const Entry& entry : m_entries) check(*entry.item, entry.isIn(names));
    }
    m_takesNew = false;
    follow(nullptr);
}

// A stage that was checked checks what it has, one that was unchecked all of its own.
void ExportList::follow(QTreeWidgetItem* item) {
    {
        const QSignalBlocker quiet(this);
        for (const Entry& entry : m_entries)
            if (item && entry.item->parent() == item)
                check(*entry.item, item->checkState(0) == Qt::Checked && entry.isThere());
        checkStages();
    }
    viewport()->update();
    emit chosenChanged();
}

// Of a stage that has nothing there is nothing to check.
void ExportList::checkStages() {
    for (int i = 0; i < topLevelItemCount(); ++i) {
        QTreeWidgetItem* stage = topLevelItem(i);
        int there = 0, checked = 0;
        for (const Entry& entry : m_entries) {
            if (entry.item->parent() != stage) continue;
            there += entry.isThere();
            checked += entry.isChecked();
        }
        if (there + checked == 0)
            stage->setData(0, Qt::CheckStateRole, {});
        else
            stage->setCheckState(0, checked == 0      ? Qt::Unchecked
                                    : checked < there ? Qt::PartiallyChecked
                                                      : Qt::Checked);
    }
}

// Qt checks the current row alone.
void ExportList::keyPressEvent(QKeyEvent* event) {
    const QList<QTreeWidgetItem*> selected = selectedItems();
    if (event->key() != Qt::Key_Space || selected.size() < 2 || !currentItem())
        return QTreeWidget::keyPressEvent(event);
    const bool checked = currentItem()->checkState(0) != Qt::Checked;
    {
        const QSignalBlocker quiet(this);
        for (QTreeWidgetItem* item : selected)
            if (item->parent()) check(*item, checked);
    }
    follow(nullptr);
}

std::vector<pipeline::BufferName> ExportList::chosen() const {
    std::vector<pipeline::BufferName> names;
    for (const Entry& entry : m_entries)
        if (entry.isChecked()) names.push_back(entry.row.name);
    return names;
}

bool ExportList::isAllChosen() const {
    return std::ranges::all_of(m_entries, [](const Entry& entry) {
        return pipeline::isDerived(entry.row.name.id) || entry.isThere() == entry.isChecked();
    });
}

}  // namespace app
