#include "app/stages/contract_list.h"

#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScreen>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/standing_row.h"

namespace app {

using pipeline::Contract;
using pipeline::ContractResult;
using pipeline::foreign::Standing;

namespace {

QIcon markOf(Standing standing, double ratio) {
    const int side = Theme::current().px(16);
    QPixmap picture(QSize(1, 1) * int(side * ratio));
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paintStanding(painter, QRectF(1, 1, side - 2, side - 2), standing);
    return QIcon(picture);
}

pipeline::BufferName bufferOf(const ContractResult& result) {
    const pipeline::BufferId id = *result.contract->reads.begin();
    return {id, bufferInfo(id).perLight ? std::max(0, result.light) : -1};
}

}  // namespace

QString shareText(const ContractResult& result) {
    if (!result.why.empty() || result.checked == 0) return QStringLiteral("–");
    if (result.holds()) return QStringLiteral("100 %");
    const double share = 100 * double(result.hold) / double(result.checked);
    return QStringLiteral("%1 %").arg(std::min(share, 99.9), 0, 'f', 1);
}

ContractList::ContractList(Document& document, QWidget* parent)
    : QFrame(parent, Qt::Popup),
      m_document(document),
      m_title(new QLabel(this)),
      m_worst(styled(new QLabel(this), {.name = "contractWorst", .size = 12, .wraps = true})),
      m_list(new QTreeWidget(this)),
      m_show(new QPushButton(tr("Show violators"), this)) {
    setObjectName("contractList");
    setProperty("kind", "panel");
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setWordWrap(false);
    m_list->header()->setStretchLastSection(false);
    m_list->setAccessibleName(tr("Contracts"));
    m_worst->setTextFormat(Qt::PlainText);
    m_show->setObjectName("showViolators");
    m_show->setAutoDefault(true);
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_worst, 1);
    foot->addWidget(m_show, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_title);
    column->addWidget(m_list, 1);
    column->addLayout(foot);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ContractList::showCurrent);
    connect(m_list, &QTreeWidget::itemActivated, this, &ContractList::askForViolators);
    connect(m_show, &QPushButton::clicked, this, &ContractList::askForViolators);
    connect(&document.frames(), &FrameFeed::frameReady, this, &ContractList::start);
    connect(&document.renderer(), &RendererCheck::compared, this, [this] {
        m_frame.reset();
        start();
    });
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_title->setFont(theme.text(13, 600));
        m_list->setFont(theme.text(12));
        resize(theme.px(560), theme.px(400));
    });
}

void ContractList::open(QPoint global, pipeline::StageId stage) {
    m_stage = stage;
    m_frame.reset();
    m_rows.reset();
    m_list->clear();
    // All that contracts read of what the scene has a use for, as long as they are looked at.
    m_document.frames().want(this, pipeline::contractBuffers() & pipeline::usefulBuffers(m_document.scene()));
    const QRect screen = parentWidget()->screen()->availableGeometry();
    resize(size().boundedTo(screen.size()));
    move(std::clamp(global.x(), screen.left(), std::max(screen.left(), screen.right() - width())),
         std::clamp(global.y(), screen.top(), std::max(screen.top(), screen.bottom() - height())));
    show();
    m_list->setFocus();
    start();
}

void ContractList::hideEvent(QHideEvent*) {
    m_job.forget();
    m_document.frames().want(this, {});
}

ContractList::Rows ContractList::evaluate(const pipeline::FramePtr& frame, const RendererCheck::ReportPtr& report,
                                          pipeline::StageId stage, const std::stop_token& stop) {
    const pipeline::ContractInput ours = contractInput(*frame);
    std::optional<pipeline::ContractInput> theirs;
    if (report) theirs.emplace(theirInput(report->conventions, *report->reference));
    const auto goOn = [&stop] { return !stop.stop_requested(); };
    Rows rows;
    for (const Contract& contract : pipeline::contractTable()) {
        if (contract.stage != stage) continue;
        const int lights = contract.perLight() ? int(frame->scene().lights.size()) : 0;
        for (int k = contract.perLight() ? 0 : -1; k < lights; ++k) {
            if (!goOn()) return rows;
            Row row{checkContract(contract, ours, k, goOn), {}, {}};
            if (theirs) row.mine = checkContract(contract, *theirs, k, goOn);
            row.worst = toQString(row.mine && Row::isBroken(*row.mine) ? contractWorst(*row.mine, *theirs)
                                                                       : contractWorst(row.ours, ours));
            rows.push_back(std::move(row));
        }
    }
    std::ranges::stable_partition(rows, &Row::isViolated);
    return rows;
}

void ContractList::start() {
    if (!isVisible()) return;
    const pipeline::FramePtr& frame = m_document.frames().shown();
    m_title->setText(tr("%1 %2: what must hold").arg(index(m_stage) + 1).arg(toQString(stageInfo(m_stage).label)));
    if (!frame || frame == m_frame) return;
    m_frame = frame;
    if (!m_rows) m_worst->setText(tr("They are being checked."));
    m_job.ask(
        [frame, report = m_document.renderer().report(), stage = m_stage](const BackgroundJob::Control& control) {
            return std::make_shared<const Rows>(evaluate(frame, report, stage, control.stop));
        },
        [this](const std::shared_ptr<const Rows>& rows) { take(rows); });
}

void ContractList::take(std::shared_ptr<const Rows> rows) {
    m_rows = std::move(rows);
    const bool hasMine = std::ranges::any_of(*m_rows, [](const Row& row) { return row.mine.has_value(); });
    m_list->clear();
    m_list->setColumnCount(hasMine ? 4 : 3);
    m_list->setHeaderLabels(hasMine ? QStringList{tr("Contract"), tr("Buffer"), tr("This frame"), tr("My renderer")}
                                    : QStringList{tr("Contract"), tr("Buffer"), tr("Holds")});
    const Theme& theme = Theme::current();
    for (const Row& row : *m_rows) {
        const bool isChecked = row.ours.why.empty() || (row.mine && row.mine->why.empty());
        const Standing standing = row.isViolated() ? Standing::WrongHere
                                  : isChecked      ? Standing::Agrees
                                                   : Standing::NoFile;
        auto* item = new QTreeWidgetItem(
            m_list, {toQString(row.ours.contract->formula), toQString(bufferOf(row.ours).text()), shareText(row.ours)});
        if (row.mine) item->setText(3, shareText(*row.mine));
        item->setIcon(0, markOf(standing, devicePixelRatioF()));
        item->setData(0, Qt::AccessibleTextRole,
                      QStringLiteral("%1: %2").arg(toQString(row.ours.contract->claim),
                                                   row.isViolated() ? tr("violated") : tr("holds")));
        item->setToolTip(0, toQString(row.ours.contract->claim).toHtmlEscaped());
        item->setFont(1, theme.mono(12));
        for (int c = 2; c < m_list->columnCount(); ++c) {
            item->setFont(c, theme.mono(12));
            item->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
        }
        if (Row::isBroken(row.ours)) item->setForeground(2, theme.colors().failed);
        if (row.mine && Row::isBroken(*row.mine)) item->setForeground(3, theme.colors().failed);
    }
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    if (m_rows->empty()) m_worst->setText(tr("This stage has no contracts."));
    if (m_list->topLevelItemCount() > 0) m_list->setCurrentItem(m_list->topLevelItem(0));
    showCurrent();
}

void ContractList::showCurrent() {
    const int at = m_list->indexOfTopLevelItem(m_list->currentItem());
    m_show->setEnabled(false);
    if (!m_rows || at < 0) return;
    const Row& row = (*m_rows)[std::size_t(at)];
    const bool isSeen = bufferInfo(*row.ours.contract->reads.begin()).domain == pipeline::Domain::Pixel;
    const std::string& why = row.ours.why;
    const QString claim = toQString(row.ours.contract->claim);
    m_worst->setText(why.empty() || row.isViolated() ? tr("%1 Worst: %2.").arg(claim, row.worst)
                                                     : claim + ' ' + toQString(why));
    m_show->setEnabled(row.isViolated() && isSeen);
    m_show->setToolTip(!row.isViolated() ? tr("It holds everywhere.")
                       : isSeen          ? tr("Mask the pixels at which it does not hold")
                                         : tr("It is about polygons or vertices, which have no pixels."));
}

void ContractList::askForViolators() {
    const int at = m_list->indexOfTopLevelItem(m_list->currentItem());
    if (!m_rows || at < 0 || !m_show->isEnabled()) return;
    const Row& row = (*m_rows)[std::size_t(at)];
    const ContractResult& broken = row.mine && Row::isBroken(*row.mine) ? *row.mine : row.ours;
    std::optional<glm::ivec2> worst;
    const int width = m_document.scene().settings.width;
    if (broken.worst) worst = glm::ivec2(int(broken.worst->element) % width, int(broken.worst->element) / width);
    const pipeline::BufferName buffer = bufferOf(row.ours);
    hide();
    emit violatorsAsked(buffer, worst);
}

}  // namespace app
