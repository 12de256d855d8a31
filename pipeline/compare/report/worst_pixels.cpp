#include "pipeline/compare/report/worst_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace pipeline::foreign {

const Finding* firstWrongPicture(const Report& report) {
    const Finding* first = nullptr;
    for (const Finding& finding : report.findings) {
        if (finding.agrees || !finding.isPicture() || !finding.worst) continue;
        if (report.firstWrong == finding.stage) return &finding;
        if (!first) first = &finding;
    }
    return first;
}

std::vector<glm::ivec2> worstPixels(const Report& report, int apart) {
    constexpr std::size_t kMost = 64;  // nobody looks at more of them
    const Finding* const finding = firstWrongPicture(report);
    if (!finding) return {};
    const Values &mine = report.fileOf(*finding).mine,
                 &reference = report.reference->values.at(finding->name.buffer.text());
    const Measure measure = toleranceOf(finding->name.buffer.id)->measure;
    struct Bad {
        std::size_t element;
        double difference;
    };
    std::vector<Bad> bad;
    for (std::size_t i = 0; i < finding->classes.size(); ++i) {
        const Class of = finding->classes[i];
        if (of != Class::Wrong && of != Class::Missing && of != Class::Extra) continue;
        // What one of the two alone draws has no difference: it comes after the numbers that differ.
        const double difference = differenceAt(measure, mine, reference, i);
        bad.push_back({i, std::isnan(difference) ? 0 : difference});
    }
    std::ranges::stable_sort(bad, std::greater(), &Bad::difference);
    if (finding->worst) {  // as the report says it
        const auto worst = std::ranges::find(bad, *finding->worst, &Bad::element);
        if (worst != bad.end()) std::rotate(bad.begin(), worst, worst + 1);
    }
    std::vector<glm::ivec2> pixels;
    for (const Bad& one : bad) {
        const glm::ivec2 at(int(one.element % finding->columns), int(one.element / finding->columns));
        const bool isFar = std::ranges::all_of(pixels, [&](const glm::ivec2& other) {
            return std::max(std::abs(other.x - at.x), std::abs(other.y - at.y)) >= apart;
        });
        if (isFar) pixels.push_back(at);
        if (pixels.size() == kMost) break;
    }
    return pixels;
}

}  // namespace pipeline::foreign
