#include "app/inspector/why_section.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "app/frames/large_frame.h"
#include "app/inspector/source_view.h"
#include "app/look/icons.h"
#include "app/look/number_format.h"
#include "app/look/numbers.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/inspect/shadow_blocker.h"
#include "pipeline/run/frame_data.h"

namespace app {

namespace {

// "kept", or "clipped": nothing else is seen.
std::string_view verdictOf(const pipeline::Frame& frame, std::size_t polygon) {
    return readStages(frame, [&](const auto& data) {
        return name(polygon < data.verdicts().size() ? data.verdicts()[polygon] : pipeline::Verdict::Kept);
    });
}

}  // namespace

using pipeline::BufferId;
using pipeline::PixelReport;
using pipeline::StageId;

namespace {

// Numbers in the face for numbers, within a sentence.
QString digits(const QString& text) {
    return QString("<span style=\"font-family:'JetBrains Mono','DejaVu Sans Mono'\">%1</span>")
        .arg(text.toHtmlEscaped());
}

}  // namespace

WhySection::WhySection(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_grid(new QGridLayout(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setColumnStretch(1, 1);
    addRow(tr("Pixel"), StageId::Shading, BufferId::Color);
    addRow(tr("Fragment"), StageId::ZBuffer, BufferId::ZView);
    addRow(tr("Weights"), StageId::ZBuffer, BufferId::Barycentric);
    addRow(tr("Polygon"), StageId::Cull, BufferId::PolygonsVerdict);
    addRow(tr("Vertices"), StageId::Transform, BufferId::VerticesScreen);
    addRow(tr("Object"), StageId::Transform, BufferId::VerticesScreen);
    addRow(tr("Shadow"), StageId::ShadowBuffer, BufferId::ShadowBuffer);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_grid->setHorizontalSpacing(theme.px(8));
        m_grid->setVerticalSpacing(theme.px(1));
        m_grid->setColumnMinimumWidth(0, theme.px(64));
        for (const Row& row : m_rows) {
            row.label->setFont(theme.text(12));
            row.value->setFont(theme.text(12));
            row.go->setIconSize(QSize(1, 1) * theme.px(12));
            // A link has the colour of the theme that its text was set in; the same text would not be set again.
            const QString text = row.value->text();
            row.value->clear();
            row.value->setText(text);
        }
    });
}

WhySection::Row& WhySection::addRow(const QString& label, StageId stage, BufferId buffer) {
    const int n = int(m_rows.size());
    Row row{new QLabel(label, this), new QLabel(this), new QToolButton(this), stage, buffer};
    row.label->setProperty("tone", "3");
    row.value->setTextFormat(Qt::RichText);
    row.value->setWordWrap(true);
    row.value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::LinksAccessibleByMouse |
                                       Qt::LinksAccessibleByKeyboard);
    row.value->setFocusPolicy(Qt::ClickFocus);  // words alone are no stop of Tab
    connect(row.value, &QLabel::linkActivated, this, &WhySection::follow);
    row.go->setIcon(icon("chevron-right"));
    const QString stageName = toQString(pipeline::stageInfo(stage).label);
    row.go->setAccessibleName(tr("%1: go to %2").arg(label, stageName));
    row.go->setToolTip(tr("Go to the stage %1").arg(stageName));
    connect(row.go, &QToolButton::clicked, this, [this, n] { go(std::size_t(n)); });
    m_grid->addWidget(row.label, n, 0, Qt::AlignVCenter);
    m_grid->addWidget(row.value, n, 1, Qt::AlignVCenter);
    m_grid->addWidget(row.go, n, 2, Qt::AlignVCenter);
    m_rows.push_back(row);
    return m_rows.back();
}

void WhySection::go(std::size_t row) {
    if (row == 6) {
        const auto first = std::ranges::find_if(m_blockers, [](int polygon) { return polygon >= 0; });
        return goToShadow(int(first - m_blockers.begin()));
    }
    m_document.setStage(m_rows[row].stage);
    emit bufferAsked({m_rows[row].buffer});
    using Kind = lessons::Selection::Kind;
    if (row == 3 && m_polygon) m_document.pointing().select(lessons::Selection{Kind::Polygon, *m_polygon});
    if (row == 5 && m_object) m_document.pointing().select(lessons::Selection{Kind::Object, *m_object});
}

// To the light's buffer, with what stands before the light selected.
void WhySection::goToShadow(int light) {
    m_document.setStage(StageId::ShadowBuffer);
    emit bufferAsked({BufferId::ShadowBuffer, light});
    m_document.pointing().select(
        lessons::Selection{lessons::Selection::Kind::Polygon, std::size_t(m_blockers[std::size_t(light)])});
}

// "vertex:3", "shadow:0" or "file".
void WhySection::follow(const QString& link) {
    if (link == "file") {
        if (!showSource(m_file, m_line, m_column, window())) emit m_document.said(tr("%1 cannot be read.").arg(m_file));
        return;
    }
    if (link.startsWith("shadow:")) return goToShadow(link.section(':', 1).toInt());
    go(4);
    m_document.pointing().select(
        lessons::Selection{lessons::Selection::Kind::Vertex, std::size_t(link.section(':', 1).toULongLong())});
}

// "of polygon 6 of box before light 0": a link for each light that something stands before.
QString WhySection::shadowsText(const pipeline::Frame& frame) const {
    QStringList links;
    for (std::size_t k = 0; k < m_blockers.size(); ++k) {
        if (m_blockers[k] < 0) continue;
        const auto place = frame.placeOf(m_blockers[k]);
        links << tr("of <a href=\"shadow:%1\">polygon %2 of %3</a>, before light %1")
                     .arg(k)
                     .arg(digits(QString::number(m_blockers[k])))
                     .arg(onOneLine(frame.scene().objects[place.object].name).toHtmlEscaped());
    }
    return links.join("<br>");
}

void WhySection::show(const pipeline::Frame& frame, const PixelReport& r) {
    m_rows[0].value->setText(
        tr("centre %1").arg(digits(QString("(%1, %2)").arg(r.pixel.x + 0.5).arg(r.pixel.y + 0.5))));
    QString fragments = toQString(pipeline::fragmentCounts(r.fragments));
    if (r.covered)
        fragments += tr(" at z %1")
                         .arg(digits(chosenText(r.zView).value_or(
                             app::depth(r.zView, frame.scene().settings.precision != pipeline::Precision::Float))));
    m_rows[1].value->setText(fragments);
    // Every triangle is asked whether it stands before the light.
    m_blockers = r.covered && !isLarge(frame) ? pipeline::blockersOf(frame, r) : std::vector<int>();
    const QString shadows = shadowsText(frame);
    for (std::size_t i = 2; i < m_rows.size(); ++i)
        for (QWidget* part : {static_cast<QWidget*>(m_rows[i].label), static_cast<QWidget*>(m_rows[i].value),
                              static_cast<QWidget*>(m_rows[i].go)})
            part->setVisible(r.covered && (i < 6 || !shadows.isEmpty()));
    m_rows[6].value->setText(shadows);
    m_sentence = fragments;
    if (!r.covered) return;

    const auto weight = [&r](int i) { return chosenText(r.barycentric[i]).value_or(dotProduct(r.barycentric[i])); };
    const QString weights = QString("λ %1 %2 %3").arg(weight(0), weight(1), weight(2));
    m_rows[2].value->setText(digits(weights));
    const auto place = frame.placeOf(r.polygon);
    const pipeline::Object& object = frame.scene().objects[place.object];
    const QString vertices = QString("%1, %2, %3").arg(r.vertices[0]).arg(r.vertices[1]).arg(r.vertices[2]);
    m_polygon = std::size_t(r.polygon), m_object = place.object;
    m_rows[3].label->setText(tr("Polygon"));
    m_rows[3].value->setText(
        tr("%1; %2").arg(digits(QString::number(r.polygon)), toQString(verdictOf(frame, std::size_t(r.polygon)))));
    QStringList links;
    for (const int vertex : r.vertices)
        links << QString("<a href=\"vertex:%1\">%2</a>").arg(vertex).arg(digits(QString::number(vertex)));
    m_rows[4].value->setText(links.join(", "));
    QString source = onOneLine(object.name).toHtmlEscaped();
    // A scene out of a picture or a session has places in its text, but no file that one could look into.
    if (!object.mesh->file.empty() && place.polygon < object.mesh->polygonPlaces.size()) {
        const pipeline::TextPosition at = object.mesh->polygonPlaces[place.polygon];
        m_file = sourceFile(frame.scene().file, object.mesh->file), m_line = at.line, m_column = at.column;
        const QString line = digits(QString("%1:%2:%3").arg(toQString(object.mesh->file)).arg(at.line).arg(at.column));
        source += ", " + (QFileInfo(m_file).isFile() ? QString("<a href=\"file\">%1</a>").arg(line) : line);
    }
    m_rows[5].value->setText(source);
    for (const std::size_t i : {4, 5, 6})
        m_rows[i].value->setFocusPolicy(m_rows[i].value->text().contains("href") ? Qt::StrongFocus : Qt::ClickFocus);
    m_sentence = tr("%1 fragments, polygon %2, vertices %3").arg(r.fragments.size()).arg(r.polygon).arg(vertices);
    if (r.fragments.size() == 1) m_sentence.replace("fragments", "fragment");
}

}  // namespace app
