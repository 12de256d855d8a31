#include "pipeline/compare/handed_in/reading_cost.h"

#include <algorithm>
#include <cmath>

namespace pipeline::foreign {

namespace {

constexpr double kMissing = 200;         // tolerances: of an element that is drawn in one alone
constexpr std::size_t kSamples = 20000;  // elements whose numbers are compared
constexpr double kTrimmed = 0.8;         // of the elements, the nearest

}  // namespace

std::vector<std::uint8_t> drawnIn(const HandedName& name, const Values& mine) {
    using enum BufferId;
    switch (name.buffer.id) {
        case Color: {
            std::vector<std::uint8_t> drawn(mine.count());
            for (std::size_t i = 0; i < mine.count(); ++i)
                drawn[i] = mine.at(i)[0] > 0.5 || mine.at(i)[1] > 0.5 || mine.at(i)[2] > 0.5;
            return drawn;
        }
        case ZView:
        case Normal:
        case ObjectId:
        case PolygonId: return mine.there;
        default: return {};
    }
}

double readingCost(const HandedFile& file, const Values& mine, const Values& reference, const ReadingContext& context,
                   double tolerance) {
    const Measure measure = toleranceOf(file.name.buffer.id)->measure;
    const std::vector<std::uint8_t> drawn = drawnIn(file.name, mine);
    const std::vector<std::uint8_t>& covered = reference.domain == Domain::Pixel ? context.covered : reference.there;
    std::vector<double> differences;
    std::size_t alone = 0, either = 0;
    // Of a large picture samples are enough.
    const std::size_t step = mine.count() > kSamples ? mine.count() / kSamples : 1;
    std::size_t next = 0;
    for (std::size_t i = 0; i < mine.count(); ++i) {
        const bool here = drawn.empty() ? mine.there[i] != 0 : drawn[i] != 0, there = covered[i] != 0;
        either += here || there;
        if (!drawn.empty() && here != there) ++alone;
        if (!here || !there || i < next) continue;
        next = i + step;
        const double d = differenceAt(measure, mine, reference, i);
        if (std::isnan(d)) continue;
        differences.push_back(std::min(
            kFarthestElement, measure == Measure::Same ? kFarthestElement * d : d / mine.allowed(i, tolerance)));
    }
    double mean = kFarthestElement;
    if (!differences.empty()) {
        const std::size_t kept = std::max<std::size_t>(1, std::size_t(kTrimmed * double(differences.size())));
        std::ranges::nth_element(differences, differences.begin() + std::ptrdiff_t(kept) - 1);
        std::sort(differences.begin(),
                  differences.begin() + std::ptrdiff_t(kept));  // a sum in the same order everywhere
        mean = 0;
        for (std::size_t i = 0; i < kept; ++i) mean += differences[i];
        mean /= double(kept);
    }
    return mean + (either ? kMissing * double(alone) / double(either) : 0);
}

}  // namespace pipeline::foreign
