#include "app/compare/stage_differences.h"

#include <QHeaderView>
#include <QLabel>
#include <QScreen>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/compare/buffer_compare.h"
#include "app/document/renderer_check.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

using pipeline::BufferInfo;
using pipeline::Palette;
using pipeline::StageDifference;

namespace {

bool hasSize(const BufferInfo& info) { return !isOfNames(info); }

QString differText(const StageDifference& row) {
    if (!row.why.empty()) return toQString(row.why);
    if (row.differing == 0) return "the same";
    return QString("%1 of %2").arg(count(qint64(row.differing)), count(qint64(row.elements)));
}

QString largestText(const StageDifference& row) {
    const BufferInfo& info = bufferInfo(row.buffer.id);
    if (row.differing == 0 || !hasSize(info)) return {};
    const QString unit = toQString(info.unit).section(',', 0, 0);  // of x and y; the depth's is another
    return unit.isEmpty() ? errorText(row.largest) : errorText(row.largest) + ' ' + unit;
}

}  // namespace

StageDifferences::StageDifferences(Document& document, BufferCompare& compare, QWidget* parent)
    : QFrame(parent, Qt::Popup),
      m_document(document),
      m_compare(compare),
      m_title(new QLabel(this)),
      m_list(new QTreeWidget(this)) {
    setProperty("kind", "panel");
    setAccessibleName(tr("Differences stage by stage"));
    m_list->setAccessibleName(tr("Differences stage by stage"));
    m_list->setHeaderLabels({tr("Stage and buffer"), tr("Differ"), tr("Largest |A − B|")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->header()->setStretchLastSection(true);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_title);
    column->addWidget(m_list, 1);
    connect(&compare, &BufferCompare::changed, this, &StageDifferences::start);
    connect(&document.frames(), &FrameFeed::frameReady, this, &StageDifferences::start);
    connect(m_list, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        const int row = item->data(0, Qt::UserRole).toInt();
        if (!item->parent() || row >= int(m_rows.size())) return;
        const StageDifference difference = m_rows[std::size_t(row)];
        hide();
        emit chosen(difference);
    });
    connect(m_list, &QTreeWidget::itemClicked, m_list, &QTreeWidget::itemActivated);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_title->setFont(theme.text(13, 600));
        m_list->setFont(theme.text(12));
        resize(theme.px(560), theme.px(520));
        m_list->setColumnWidth(0, theme.px(200));
        m_list->setColumnWidth(1, theme.px(170));
    });
}

void StageDifferences::open(QPoint global) {
    m_a.reset();
    // All that the scene has a use for, as long as it is looked at; B follows.
    m_document.frames().want(this, pipeline::usefulBuffers(m_document.scene()));
    const QRect screen = parentWidget()->screen()->availableGeometry();
    resize(size().boundedTo(screen.size()));
    QRect place(QPoint(0, 0), size());
    place.moveTopRight(global);
    place.moveLeft(std::clamp(place.left(), screen.left(), screen.right() - width()));
    place.moveTop(std::clamp(place.top(), screen.top(), screen.bottom() - height()));
    move(place.topLeft());
    show();
    m_list->setFocus();
    start();
}

void StageDifferences::hideEvent(QHideEvent*) {
    m_job.forget();
    m_document.frames().want(this, {});
}

void StageDifferences::start() {
    if (!isVisible()) return;
    const pipeline::FramePtr &a = m_document.frames().shown(), &b = m_compare.other().frame();
    const QString other = m_compare.source() ? nameOf(*m_compare.source()) : QString();
    m_title->setText(tr("A against B, %1").arg(other));
    const bool isFile = m_compare.source() && m_compare.source()->kind == OtherSource::Kind::File;
    if (a && isFile) return startFile(a);
    if (a && m_compare.isMine()) return startMine(a);
    m_file.reset();
    if (!a || !b || a == b) {
        m_list->clear();
        m_title->setText(a && a == b ? tr("B is a buffer of the same frame: no stage differs.")
                                     : tr("B is being computed."));
        return;
    }
    if (a == m_a && b == m_b) return;
    clear();
    m_a = a, m_b = b;
    for (const pipeline::AnyBuffer& buffer : a->buffers())
        if (b->buffer(buffer.name)) m_names.push_back(buffer.name);
    compareNext();
}

// A file holds one buffer: that of the view.
void StageDifferences::startFile(const pipeline::FramePtr& frame) {
    const auto& file = m_compare.other().file();
    const bool isThere = file && frame->buffer(file->name);
    if (!isThere) {
        clear();
        m_title->setText(file ? toQString(frame->whyAbsent(file->name)) : m_compare.other().why());
        return;
    }
    if (frame == m_a && file->owner == m_file) return;
    clear();
    m_a = frame, m_file = file->owner;
    m_job.ask([a = m_a, b = *file](const BackgroundJob::Control&) { return stageDifference(*a, b); },
              [this](const StageDifference& row) { add(row); });
}

// Each stage is compared with the file that it has in the folder.
void StageDifferences::startMine(const pipeline::FramePtr& frame) {
    const RendererCheck& renderer = m_document.renderer();
    const RendererCheck::ReportPtr& report = renderer.report();
    if (!report) {
        clear();
        return m_title->setText(renderer.whyNo({pipeline::BufferId::Color}));
    }
    m_title->setText(tr("A against B, %1").arg(renderer.name()));
    if (frame == m_a && report == m_file) return;
    clear();
    m_a = frame, m_file = report;
    for (const pipeline::AnyBuffer& buffer : frame->buffers())
        if (renderer.buffer(buffer)) m_names.push_back(buffer.name);
    compareNext();
}

void StageDifferences::clear() {
    m_job.forget();
    m_a.reset(), m_b.reset(), m_file.reset();
    m_rows.clear();
    m_names.clear();
    m_list->clear();
}

// One buffer at a time, off the GUI thread: the first rows are there at once.
void StageDifferences::compareNext() {
    if (m_names.empty()) return m_job.forget();
    const pipeline::BufferName name = m_names.front();
    m_names.pop_front();
    const auto mine = m_b ? std::nullopt : m_document.renderer().buffer(*m_a->buffer(name));
    if (!m_b && !mine) return;  // another report is on its way
    m_job.ask(
        [a = m_a, b = m_b, mine, name](const BackgroundJob::Control&) {
            return mine ? stageDifference(*a, *mine) : stageDifference(*a, *b, name);
        },
        [this](const StageDifference& row) {
            add(row);
            compareNext();
        });
}

void StageDifferences::add(const StageDifference& row) {
    const pipeline::StageInfo& stage = stageInfo(bufferInfo(row.buffer.id).stage);
    const QString title = QString("%1 %2").arg(index(stage.id) + 1).arg(toQString(stage.label));
    QTreeWidgetItem* top = m_list->topLevelItem(m_list->topLevelItemCount() - 1);
    const Theme& theme = Theme::current();
    if (!top || top->text(0) != title) {
        top = new QTreeWidgetItem(m_list, {title, "the same"});
        top->setFont(0, theme.text(12, 600));
        top->setFlags(Qt::ItemIsEnabled);
        top->setExpanded(true);
    }
    auto* item = new QTreeWidgetItem(top, {toQString(row.buffer.text()), differText(row), largestText(row)});
    item->setData(0, Qt::UserRole, int(m_rows.size()));
    for (const int c : {0, 1, 2}) item->setFont(c, theme.mono(12));
    if (row.differing > 0) {
        if (top->text(1) == "the same") top->setText(1, QString());
        item->setForeground(1, theme.colors().warn);
    } else {
        for (const int c : {0, 1}) item->setForeground(c, theme.colors().text3);
    }
    m_rows.push_back(row);
}

}  // namespace app
