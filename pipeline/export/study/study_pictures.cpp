#include "pipeline/export/study/study_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/buffers/palette.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/stages/shading.h"
#include "pipeline/study/errors.h"

namespace pipeline {
namespace {

// The frame buffer of intensities.
Buffer2D<Color8> shown(const Picture& picture, double white) {
    Buffer2D<Color8> out(picture.size, Color8(0));
    for (std::size_t i = 0; i < out.pixels.size(); ++i)
        out.pixels[i] = frameBufferValue(picture.intensity.pixels[i], white);
    return out;
}

double meanOf(Vec3d v) { return (v.x + v.y + v.z) / 3; }

}  // namespace

ComparedPictures comparedPictures(const PointPictures& point) {
    const double white = whiteOf(point.frame->scene());
    ComparedPictures out;
    out.image = shown(point.picture, white);
    if (!point.reference) return out;
    out.reference = shown(point.reference->picture, white);
    const Buffer2D<Vec3d> error = signedError(point.picture, point.reference->picture, white);
    for (const Vec3d& e : error.pixels) out.largest = std::max(out.largest, std::abs(meanOf(e)));
    out.error = {error.size, Color8(0)};
    for (std::size_t i = 0; i < error.pixels.size(); ++i)
        out.error.pixels[i] = paletteColor(Palette::Diverging, meanOf(error.pixels[i]), -out.largest, out.largest);
    return out;
}

std::vector<StudyPictures> frontPictures(const StudyRequest& request, const StudyReport& report, std::size_t most,
                                         Stop stop) {
    const std::vector<std::size_t> front = analyse(report, report.choice).front;
    std::vector<StudyPictures> out;
    ErrorFinder finder(request);
    const std::size_t count = std::min(front.size(), most);
    for (std::size_t i = 0; i < count && !stop.stop_requested(); ++i) {
        const std::size_t point = front[count > 1 ? i * (front.size() - 1) / (count - 1) : 0];
        const auto found = finder.show(report.points[point], stop);
        if (!found) continue;
        const ComparedPictures pictures = comparedPictures(*found);
        StudyPictures& entry = out.emplace_back();
        entry.point = point;
        entry.image = pngOf(pictures.image);
        if (pictures.reference.empty()) continue;
        entry.reference = pngOf(pictures.reference);
        entry.error = pngOf(pictures.error);
        entry.errorRange = fmt::format("−{0:.2g} to {0:.2g} of I_max", pictures.largest);
    }
    return out;
}

}  // namespace pipeline
