#include "app/canvas/overlays.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/canvas/buffer_legend.h"
#include "app/canvas/violators.h"
#include "app/jobs/free_in_background.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "pipeline/inspect/overlay_values.h"

namespace app {

using pipeline::BufferId;
using pipeline::DepthTests;
using pipeline::Domain;
using pipeline::Frame;
using pipeline::Palette;
using pipeline::Strange;

namespace {

constexpr int kAlpha = 205;  // of 255: what is below still shows

QRgb onTop(pipeline::Color8 c) { return qPremultiply(qRgba(c.r, c.g, c.b, kAlpha)); }

QString swatch(const QColor& color, const QString& text) {
    return QString("<span style='color:%1'>■</span> %2").arg(color.name(), text);
}
QString swatch(pipeline::Color8 c, const QString& text) { return swatch(QColor(c.r, c.g, c.b), text); }

// One colour a pixel; colorOf(i) gives 0 where there is none.
template <class ColorOf>
QImage imageOf(QSize size, ColorOf colorOf) {
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    std::size_t i = 0;
    for (int y = 0; y < size.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < size.width(); ++x) line[x] = colorOf(i++);
    }
    return image;
}

// A scale that begins light with what is more, as counts have it.
pipeline::Color8 scaleColor(double value, double least, double most) {
    return paletteColor(Palette::Sequential, value, most, least == most ? most - 1 : least);
}

QString fragments(const Frame& frame, QSize size, std::vector<QImage>& images) {
    const auto buffer = frame.buffer({BufferId::Overdraw});
    if (!buffer) return {};
    const auto counts = std::get<std::span<const std::int32_t>>(buffer->data);
    const auto most = *std::max_element(counts.begin(), counts.end());
    images.push_back(
        imageOf(size, [&](std::size_t i) { return counts[i] == 0 ? QRgb(0) : onTop(scaleColor(counts[i], 1, most)); }));
    QStringList parts;
    if (most <= 6)
        for (int n = 1; n <= most; ++n) parts << swatch(scaleColor(n, 1, most), QString("×%1").arg(n));
    else
        parts << swatch(scaleColor(1, 1, most), "×1") << swatch(scaleColor(most, 1, most), QString("×%1").arg(most));
    return "fragments " + parts.join(' ');
}

QString polygonSizes(const Frame& frame, QSize size, std::vector<QImage>& images) {
    const auto buffer = frame.buffer({BufferId::PolygonId});
    if (!buffer) return {};
    const auto ids = std::get<std::span<const std::int32_t>>(buffer->data);
    const std::vector<double> areas = pipeline::screenAreas(frame);
    std::vector<bool> seen(areas.size());
    for (const std::int32_t id : ids)
        if (id >= 0) seen[std::size_t(id)] = true;
    double least = INFINITY, most = 0;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        if (!seen[i] || areas[i] <= 0) continue;
        least = std::min(least, areas[i]);
        most = std::max(most, areas[i]);
    }
    if (most == 0) return {};
    // Sizes range over powers of ten.
    const auto colorOf = [&](double area) { return scaleColor(std::log(area), std::log(least), std::log(most)); };
    images.push_back(imageOf(size, [&](std::size_t i) {
        return ids[i] < 0 || areas[std::size_t(ids[i])] <= 0 ? QRgb(0) : onTop(colorOf(areas[std::size_t(ids[i])]));
    }));
    return QString("size %1 %2")
        .arg(swatch(colorOf(least), number(least, least < 10 ? 1 : 0)),
             swatch(colorOf(most), number(most, most < 10 ? 1 : 0) + " px²"));
}

QString depthTest(const Frame& frame, QSize size, std::vector<QImage>& images) {
    if (!frame.buffer({BufferId::Overdraw}) || !frame.buffer({BufferId::DepthWrites})) return {};
    const std::vector<DepthTests> tests = pipeline::depthTests(frame);
    // Of the palette of names: apart in every kind of colour vision.
    const auto names = paletteStops(Palette::Categorical);
    const std::array colors{names[2], names[1], names[4]};
    std::array<qint64, 4> counts{};
    for (const DepthTests test : tests) ++counts[std::size_t(test)];
    images.push_back(imageOf(size, [&](std::size_t i) {
        return tests[i] == DepthTests::None ? QRgb(0) : onTop(colors[std::size_t(tests[i]) - 1]);
    }));
    return QString("depth test %1 %2 %3")
        .arg(swatch(colors[0], "one fragment " + count(counts[1])),
             swatch(colors[1], "overwritten " + count(counts[2])), swatch(colors[2], "not nearer " + count(counts[3])));
}

// NaN and infinities have colours of their own already: they get a frame of marks, negative ones a hatch.
QString strange(const pipeline::AnyBuffer& buffer, const std::vector<bool>& drawn, lessons::ShownChannel channel,
                pipeline::ProjectionKind projection, CanvasContent& content) {
    auto found = pipeline::strangeNumbers(buffer, index(channel), drawn, projection);
    if (found.nan + found.infinite + found.negative == 0) return {};
    const auto width = std::size_t(content.size.width());
    content.overlays.push_back(imageOf(content.size, [&](std::size_t i) {
        const bool isHatched = (i % width + i / width) % 3 == 0;
        return found.elements[i] == Strange::Negative && isHatched ? qRgba(0, 0, 0, 255) : QRgb(0);
    }));
    content.strange = [elements = std::move(found.elements), width](int x, int y) {
        switch (elements[std::size_t(y) * width + std::size_t(x)]) {
            case Strange::Nan: return QString("×");
            case Strange::Infinite: return QString("∞");
            case Strange::Negative: return QString("−");
            case Strange::No: break;
        }
        return QString();
    };
    QStringList parts;
    if (found.negative > 0) parts << count(qint64(found.negative)) + " negative (hatched)";
    return parts.join(", ");
}

}  // namespace

std::span<const OverlayInfo, kOverlayCount> overlayTable() {
    using O = OverlayId;
    using B = BufferId;
    static const std::array<OverlayInfo, kOverlayCount> kTable{{
        {O::Edges, "Polygon edges", "The polygons' outlines; from 12 times on they are always there.", {}},
        {O::EdgeFunctions, "Edge functions",
         "Of the triangle at the picked pixel: its exact edges, and which pixel centres they cover. Zoom in.",
         pipeline::setOf({B::PolygonId})},
        {O::Verdict, "Culling verdict", "Which polygons go on, and why not the others.",
         pipeline::setOf({B::PolygonsVerdict})},
        {O::Fragments, "Fragments per pixel", "The number of fragments at each pixel.", pipeline::setOf({B::Overdraw})},
        {O::PolygonSize, "Polygon size", "The area of each polygon on the screen.", pipeline::setOf({B::PolygonId})},
        {O::DepthTest, "Depth test", "Where fragments were overwritten, or failed the test.",
         pipeline::setOf({B::Overdraw, B::DepthWrites})},
        {O::Strange, "NaN, infinite, negative", "Marks numbers that should not be there.", {}},
        {O::Violators, "Contract violators", "Masks the pixels at which something that must hold does not.", {}},
        {O::Classes, "Classes of my renderer", "Which pixels of your renderer agree, and how the others differ.", {}},
    }};
    return kTable;
}

pipeline::BufferSet buffersOf(OverlaySet overlays, BufferId shown) {
    pipeline::BufferSet needs;
    if (overlays[index(OverlayId::Violators)]) needs = violatorBuffers(shown);
    for (const OverlayInfo& overlay : overlayTable())
        if (overlays[index(overlay.id)]) needs |= overlay.needs;
    return needs;
}

QString whyNoOverlays(const pipeline::BufferInfo& info) {
    if (info.domain == Domain::Texel) return "The texels of a shadow buffer are not those of the picture.";
    if (standsOnShapes(info)) return "This buffer stands on polygons or vertices and has no pixels.";
    return {};
}

QString whyNoOverlay(OverlayId overlay, const pipeline::BufferInfo& info, bool isFlipped) {
    if (overlay == OverlayId::Strange) return {};
    if (const QString why = whyNoOverlays(info); !why.isEmpty()) return why;
    if (overlay == OverlayId::EdgeFunctions && isFlipped)
        return "Which edges are top ones is seen with row 0 on top: Y turns the picture over.";
    return {};
}

void addOverlays(const Frame& frame, OverlaySet overlays, ShownBuffer& shown, const std::stop_token& stop) {
    const pipeline::BufferInfo& info = *shown.buffer.info;
    CanvasContent& content = shown.content;
    QStringList legend;
    if (!shown.notice.isEmpty()) legend << shown.notice;
    const auto isOn = [&](OverlayId id) { return overlays[index(id)] && !stop.stop_requested(); };
    const bool mayBeStrange = shown.numbers.nan + shown.numbers.infinite + shown.numbers.negative > 0;
    if (isOn(OverlayId::Strange) && mayBeStrange && !standsOnShapes(info)) {
        const auto drawn = drawnElements(shown.buffer, polygonsUnder(frame, info), shown.look.channel);
        legend << strange(shown.buffer, drawn, shown.look.channel, frame.scene().camera.projection, content);
    }
    if (whyNoOverlays(info).isEmpty()) {
        if (isOn(OverlayId::Fragments)) legend << fragments(frame, content.size, content.overlays);
        if (isOn(OverlayId::PolygonSize)) legend << polygonSizes(frame, content.size, content.overlays);
        if (isOn(OverlayId::Violators)) legend << violators(contractInput(frame), shown.buffer.name, content, stop);
        if (isOn(OverlayId::DepthTest)) legend << depthTest(frame, content.size, content.overlays);
        const auto verdicts = frame.buffer({BufferId::PolygonsVerdict});
        if (isOn(OverlayId::Verdict) && verdicts) {
            content.verdicts = freedInBackground(
                std::make_shared<const ShapePicture>(shapePicture(frame, *verdicts, {}, false, stop)));
            QStringList names;
            for (const LegendEntry& entry : legendOf(frame, *verdicts, {})) names << swatch(entry.color, entry.text);
            legend << names.join(' ');
        }
    }
    legend.removeAll(QString());
    shown.notice = legend.join("<br>");
}

}  // namespace app
