#include "app/study/study_details.h"

#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/padded_cells.h"
#include "pipeline/study/analysis_text.h"

namespace app {

using pipeline::ErrorRow;
using pipeline::StageBlame;

BlameBars::BlameBars(QWidget* parent) : QWidget(parent) {
    setObjectName("blameBars");
    followTheme(this, [this] { updateGeometry(); });
}

void BlameBars::setBlame(std::vector<StageBlame> blame) {
    m_blame = std::move(blame);
    QStringList words;
    for (const StageBlame& stage : m_blame)
        words << tr("%1 %2 %").arg(toQString(stageInfo(stage.stage).label), number(100 * stage.share, 0));
    setAccessibleName(words.join(", "));
    updateGeometry();
    update();
}

QSize BlameBars::sizeHint() const {
    const Theme& theme = Theme::current();
    return {theme.px(240), int(m_blame.size()) * theme.px(24)};
}

void BlameBars::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int row = theme.px(24), left = theme.px(110), right = width() - theme.px(56), height = theme.px(8);
    for (std::size_t i = 0; i < m_blame.size(); ++i) {
        const QRect place(0, int(i) * row, width(), row);
        const double share = std::clamp(m_blame[i].share, 0.0, 1.0);
        painter.setFont(theme.text(13));
        painter.setPen(colors.text);
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, toQString(stageInfo(m_blame[i].stage).label));
        painter.setFont(theme.mono(12));
        painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, tr("%1 %").arg(number(100 * m_blame[i].share, 0)));
        const QRectF track(left, place.center().y() - height / 2.0, std::max(0, right - left), height);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colors.hover);
        painter.drawRoundedRect(track, height / 4.0, height / 4.0);
        painter.setBrush(colors.accent);
        painter.drawRoundedRect(QRectF(track.topLeft(), QSizeF(track.width() * share, height)), height / 4.0,
                                height / 4.0);
    }
}

StudyDetails::StudyDetails(QWidget* parent) : QWidget(parent) {
    m_blamePart = new QWidget(this), m_errorPart = new QWidget(this);
    for (QWidget* part : {m_blamePart, m_errorPart}) part->setProperty("kind", "page");
    const auto label = [](QWidget* part, int tone) {
        auto* made = new QLabel(part);
        made->setWordWrap(true);
        if (tone > 1) made->setProperty("tone", tone);
        return made;
    };
    m_blameTitle = label(m_blamePart, 1);
    m_blameText = label(m_blamePart, 2);
    m_errorTitle = label(m_errorPart, 1);
    m_blameTitle->setText(tr("Which stage is to blame"));
    m_errorTitle->setText(tr("Every buffer of the selected point"));
    m_blame = new BlameBars(m_blamePart);
    m_errors = new QTableWidget(m_errorPart);
    m_errors->setObjectName("studyErrors");
    m_errors->setAccessibleName(m_errorTitle->text());
    m_errors->setTabKeyNavigation(false);
    m_errors->setEditTriggers(QTableWidget::NoEditTriggers);
    m_errors->setSelectionMode(QTableWidget::NoSelection);
    m_errors->setShowGrid(false);
    m_errors->setItemDelegate(new PaddedCells(m_errors));
    m_errors->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_errors->setWordWrap(false);
    m_errors->verticalHeader()->hide();
    m_errors->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_errors->horizontalHeader()->setHighlightSections(false);
    m_errors->setColumnCount(5);
    m_errors->setHorizontalHeaderLabels({tr("Buffer"), tr("Measure"), tr("Model"), tr("Arithmetic"), tr("Storage")});
    auto* blame = new QVBoxLayout(m_blamePart);
    for (QWidget* part :
         {static_cast<QWidget*>(m_blameTitle), static_cast<QWidget*>(m_blameText), static_cast<QWidget*>(m_blame)})
        blame->addWidget(part);
    blame->addStretch(1);
    auto* errors = new QVBoxLayout(m_errorPart);
    errors->addWidget(m_errorTitle);
    errors->addWidget(m_errors, 1);
    spaced(new QVBoxLayout(this), {}, 0);
    unite();
    followTheme(this, [this, blame, errors] {
        const Theme& theme = Theme::current();
        m_blameTitle->setFont(theme.text(13, 600));
        m_errorTitle->setFont(theme.text(13, 600));
        m_blameText->setFont(theme.text(12));
        m_errors->verticalHeader()->setDefaultSectionSize(theme.px(28));
        for (QVBoxLayout* part : {blame, errors}) {
            part->setContentsMargins(theme.px(12), theme.px(8), theme.px(12), theme.px(8));
            part->setSpacing(theme.px(6));
        }
    });
    setPoint(nullptr, {});
}

void StudyDetails::unite() {
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->addWidget(m_blamePart);
    column->addWidget(m_errorPart, 1);
    m_blamePart->show(), m_errorPart->show();
}

void StudyDetails::setPoint(const pipeline::StudyPoint* point, const std::string& label) {
    const bool blame = point && !point->blame.empty();
    m_blameText->setText(!point  ? tr("Choose a point to see which stage its error comes from.")
                         : blame ? tr("Share of the frame's error that goes when one stage alone is replaced by its "
                                      "reference; %1")
                                       .arg(toQString(label))
                                 : tr("There is no reference that could replace a stage."));
    m_blame->setBlame(blame ? point->blame : std::vector<StageBlame>{});
    m_errors->setRowCount(point ? int(point->errors.size()) : 0);
    const QFont mono = Theme::current().mono(12);
    for (int row = 0; row < m_errors->rowCount(); ++row) {
        const ErrorRow& error = point->errors[std::size_t(row)];
        auto* buffer = new QTableWidgetItem(toQString(error.buffer));
        buffer->setFont(mono);
        m_errors->setItem(row, 0, buffer);
        const bool named = error.unit.empty() || error.measure.find(error.unit) != std::string::npos;
        const std::string measure = named ? error.measure : error.measure + ", " + error.unit;
        m_errors->setItem(row, 1, new QTableWidgetItem(toQString(measure)));
        for (std::size_t kind = 0; kind < pipeline::kErrorKinds; ++kind) {
            const auto& value = error.value[kind];
            auto* number = new QTableWidgetItem(value ? toQString(pipeline::errorText(*value)) : QString("–"));
            number->setFont(mono);
            number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            if (value) number->setToolTip(fullPrecision(*value));
            m_errors->setItem(row, 2 + int(kind), number);
        }
    }
    m_errors->resizeColumnsToContents();
}

}  // namespace app
