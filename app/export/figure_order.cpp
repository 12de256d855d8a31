#include "app/export/figure_order.h"

#include <QLocale>

#include "app/document/export_plan.h"
#include "app/look/text.h"

namespace app {
namespace {

QString plain(double value) { return QString::number(value, 'g', QLocale::FloatingPointShortest); }

bool isInside(glm::ivec2 pixel, const pipeline::Figure::Part& part) {
    return pixel.x >= part.first.x && pixel.y >= part.first.y && pixel.x <= part.last.x && pixel.y <= part.last.y;
}

}  // namespace

pipeline::BufferSet buffersFor(const FigureOrder& order) {
    pipeline::BufferSet buffers = pipeline::setOf({pipeline::BufferId::PolygonId});
    if (!pipeline::isDerived(order.buffer.id)) buffers.set(index(order.buffer.id));
    return order.hasEdges ? buffers | pipeline::outlineBuffers() : buffers;
}

void fit(FigureOrder& order, const pipeline::AnyBuffer& buffer) {
    const pipeline::Figure::Part all{{0, 0}, {int(buffer.columns()) - 1, int(buffer.rows()) - 1}};
    if (order.part && !(isInside(order.part->first, all) && isInside(order.part->last, all))) order.part.reset();
    if (order.pixel && !isInside(*order.pixel, order.part.value_or(all))) order.pixel.reset();
    order.hasEdges = order.hasEdges && buffer.info->domain == pipeline::Domain::Pixel;
}

pipeline::Figure figureOf(const FigureOrder& order, const pipeline::Frame& frame, pipeline::AnyBuffer buffer,
                          std::string_view meaning) {
    pipeline::Figure figure = pipeline::figureOf(frame, std::move(buffer));
    figure.part = order.part, figure.pixel = order.pixel;
    if (order.range) figure.range = *order.range;
    if (order.hasEdges) figure.outlines = polygonOutlines(frame, figure.part);
    figure.hasBar = order.hasBar, figure.hasScale = order.hasScale, figure.hasGrid = order.hasGrid;
    figure.width = order.width, figure.letters = order.letters, figure.dotsPerInch = order.dotsPerInch;
    figure.isForProjector = order.isForProjector;
    figure.caption = order.caption ? order.caption->toStdString() : captionOf(figure, frame.scene(), meaning);
    return figure;
}

QString endingOf(pipeline::FigureFormat format) {
    return format == pipeline::FigureFormat::Svg   ? QStringLiteral("svg")
           : format == pipeline::FigureFormat::Pdf ? QStringLiteral("pdf")
                                                   : QStringLiteral("png");
}

QString figureCommand(const pipeline::Scene& scene, const QStringList& changes, const FigureOrder& order,
                      const lessons::DerivedRecipe& recipe, const QString& file) {
    QStringList words{"shadescope", "figure", sceneWord(scene), "--buffer", toQString(order.buffer.text())};
    if (order.pixel) words << "--pixel" << QStringLiteral("%1,%2").arg(order.pixel->x).arg(order.pixel->y);
    if (const auto& part = order.part)
        words
            << "--part"
            << QStringLiteral("%1,%2,%3,%4").arg(part->first.x).arg(part->first.y).arg(part->last.x).arg(part->last.y);
    if (order.range) words << "--range=" + plain(order.range->first) + ',' + plain(order.range->last);
    if (order.caption) words << "--caption" << (order.caption->isEmpty() ? "''" : shellWord(*order.caption));
    words << "--width" << plain(order.width) + "mm";
    const FigureOrder usual;
    if (order.letters != usual.letters) words << "--text" << plain(order.letters);
    if (order.format == pipeline::FigureFormat::Png && order.dotsPerInch != usual.dotsPerInch)
        words << "--dpi" << plain(order.dotsPerInch);
    if (!order.hasBar) words << "--no-bar";
    if (order.hasGrid) words << "--grid";
    if (order.hasEdges) words << "--edges";
    if (order.hasScale) words << "--scale-bar";
    if (order.isForProjector)
        words << "--colors"
              << "projector";
    words << recipeWords({order.buffer}, recipe) << "-o" << shellWord(file);
    return (words + changes).join(' ');
}

}  // namespace app
