#include "app/canvas/violators.h"

#include <algorithm>

#include "app/look/numbers.h"
#include "app/look/text.h"
#include "pipeline/compare/report/compare_html.h"

namespace app {

namespace foreign = pipeline::foreign;
using foreign::Class;
using pipeline::Contract;
using pipeline::Domain;

namespace {

constexpr int kVeil = 140;  // of 255, 55 %: the buffer shows through
constexpr QRgb kNan = qRgb(255, 0, 255);

bool isAbout(const Contract& contract, pipeline::BufferId buffer) {
    return bufferInfo(*contract.reads.begin()).domain == Domain::Pixel &&
           std::ranges::find(contract.reads, buffer) != contract.reads.end();
}

// Every sixth of the diagonals: seen at any zoom, as it is of the picture's own pixels.
bool isHatched(std::size_t x, std::size_t y) { return (x + y) % 6 < 2; }

QString swatch(QRgb color, const QString& text) {
    return QStringLiteral("<span style='color:%1'>■</span> %2").arg(QColor(color).name(), text.toHtmlEscaped());
}

}  // namespace

pipeline::BufferSet violatorBuffers(pipeline::BufferId shown) {
    pipeline::BufferSet all;
    for (const Contract& contract : pipeline::contractTable())
        if (isAbout(contract, shown))
            for (const pipeline::BufferId id : contract.reads) all.set(index(id));
    return all;
}

QString violators(const pipeline::ContractInput& input, const pipeline::BufferName& shown, CanvasContent& content,
                  const std::stop_token& stop) {
    QStringList lines;
    std::vector<bool> mask;
    const auto width = std::size_t(content.size.width());
    for (const Contract& contract : pipeline::contractTable()) {
        if (!isAbout(contract, shown.id)) continue;
        // Of a light's buffer its own contracts, else those of every light.
        std::vector<int> lights{-1};
        if (contract.perLight() && shown.light >= 0) lights = {shown.light};
        if (contract.perLight() && shown.light < 0) {
            lights.clear();
            for (int k = 0; k < int(input.scene.lights.size()); ++k) lights.push_back(k);
        }
        for (const int k : lights) {
            const pipeline::ContractResult result =
                checkContract(contract, input, k, [&stop] { return !stop.stop_requested(); });
            if (stop.stop_requested()) return {};
            if (!result.why.empty() || result.holds()) continue;
            if (mask.empty()) mask.resize(result.violators.size());
            for (std::size_t i = 0; i < std::min(mask.size(), result.violators.size()); ++i)
                if (result.violators[i]) mask[i] = true;
            lines << swatch(kNan, QStringLiteral("not %1: %2 of %3, worst %4")
                                      .arg(toQString(contract.formula), count(qint64(result.checked - result.hold)),
                                           count(qint64(result.checked)), toQString(contractWorst(result, input))));
        }
    }
    if (mask.size() != width * std::size_t(content.size.height())) return {};
    QImage image(content.size, QImage::Format_ARGB32_Premultiplied);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        const std::size_t x = i % width, y = i / width;
        const QRgb color =
            isHatched(x, y) ? qRgba(255, 255, 255, 200) : qRgba(qRed(kNan), qGreen(kNan), qBlue(kNan), kVeil);
        reinterpret_cast<QRgb*>(image.scanLine(int(y)))[x] = mask[i] ? qPremultiply(color) : QRgb(0);
    }
    content.overlays.push_back(image);
    return lines.join(QStringLiteral("<br>"));
}

void addClasses(const foreign::Report& report, ShownBuffer& shown) {
    const auto finding = std::ranges::find_if(report.findings, [&](const foreign::Finding& one) {
        return one.name.buffer == shown.buffer.name && one.isPicture();
    });
    const QSize size = shown.content.size;
    if (finding == report.findings.end() ||
        finding->classes.size() != std::size_t(size.width()) * std::size_t(size.height()))
        return;
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    for (std::size_t i = 0; i < finding->classes.size(); ++i) {
        const Class of = finding->classes[i];
        const auto width = std::size_t(size.width()), x = i % width, y = i / width;
        const pipeline::Color8 c = foreign::classColor(of);
        QRgb color = qRgba(c.r, c.g, c.b, 255);
        if (of == Class::Wrong && (x + y) % 6 < 2) color = qRgba(255, 255, 255, 255);
        if (of == Class::Missing && (x + size_t(size.height()) - y) % 6 < 2) color = qRgba(255, 255, 255, 255);
        if (of == Class::Extra && (x % 6 == 0 || y % 6 == 0)) color = qRgba(0, 0, 0, 255);
        if (of == Class::Allowed && x % 3 == 0 && y % 3 == 0) color = qRgba(255, 255, 255, 255);
        if (of == Class::Equal || of == Class::Left) color = qRgba(238, 238, 236, 215);  // the picture shows, pale
        reinterpret_cast<QRgb*>(image.scanLine(int(y)))[x] = qPremultiply(color);
    }
    shown.content.overlays.push_back(image);
    QStringList parts;
    for (const Class of :
         {Class::Equal, Class::Tolerated, Class::Allowed, Class::Wrong, Class::Missing, Class::Extra}) {
        if (finding->count(of) == 0) continue;
        const pipeline::Color8 c = foreign::classColor(of);
        parts << swatch(of == Class::Equal ? qRgb(160, 160, 156) : qRgb(c.r, c.g, c.b),
                        QStringLiteral("%1 %2").arg(toQString(name(of)), count(qint64(finding->count(of)))));
    }
    if (!shown.notice.isEmpty()) parts.prepend(shown.notice);
    shown.notice = parts.join(QStringLiteral("  "));
}

}  // namespace app
