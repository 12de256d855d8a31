#include <algorithm>
#include <cmath>

#include "pipeline/core/elementary.h"
#include "pipeline/scene/hold/hold_kinds.h"

namespace pipeline {

constexpr double kLogarithmicFrom = 50;  // high / low
bool isLogarithmic(const Hold& hold) { return hold.low > 0 && hold.high / hold.low >= kLogarithmicFrom; }

double numberNear(const Scene& scene, const Hold& hold, double value, bool coarse) {
    const auto ref = findSetting(scene, hold.keys[0]);
    double step = isLogarithmic(hold) ? powerBelow(std::abs(value)) / (coarse ? 1 : 10)
                                      : powerBelow((hold.high - hold.low) / (coarse ? 10 : 100));
    if (ref && ref->setting->kind == SettingKind::Integer) step = std::max(step, 1.0);
    return std::clamp(roundedTo(value, step), hold.low, hold.high);
}

std::string numberWords(const Scene& scene, const Hold& hold) {
    const std::string value = valueText(scene, hold, 0);
    if (!hold.symbol.empty()) return hold.symbol + " = " + value;
    std::string lower = hold.name;
    if (!lower.empty() && lower[0] >= 'A' && lower[0] <= 'Z') lower[0] = char(lower[0] + 32);
    return value + ' ' + lower;
}

namespace {

// The place of a number on its track, 0 to 1.
double shareOf(const Hold& hold, double value) {
    const double share = isLogarithmic(hold) ? log(value / hold.low) / log(hold.high / hold.low)
                                             : (value - hold.low) / (hold.high - hold.low);
    return std::clamp(share, 0.0, 1.0);
}
std::optional<HoldPlace> numberPlace(const Scene& scene, const Hold& hold) {
    return HoldPlace{glm::dvec2(shareOf(hold, valueOf(scene, hold.keys[0])))};
}
Assignments numberDragged(const Scene& start, const Hold& hold, const Drag& drag) {
    const double share = std::clamp(drag.target().x, 0.0, 1.0);
    const double value =
        isLogarithmic(hold) ? hold.low * pow(hold.high / hold.low, share) : hold.low + share * (hold.high - hold.low);
    return {{hold.keys[0], numberNear(start, hold, value, drag.isCoarse)}};
}
Assignments numberNudged(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse) {
    const double now = valueOf(scene, hold.keys[0]), way = onward(by);
    const auto ref = findSetting(scene, hold.keys[0]);
    if (ref && ref->setting->kind == SettingKind::Integer)
        return {{hold.keys[0], std::clamp(now + way * (coarse ? 10 : 1), hold.low, hold.high)}};
    if (isLogarithmic(hold))
        return {{hold.keys[0], numberNear(scene, hold, now * pow(coarse ? 2.0 : 1.12, way), false)}};
    const double step = powerBelow((hold.high - hold.low) / 100) * (coarse ? 10 : 1);
    return {{hold.keys[0], numberNear(scene, hold, now + way * step, false)}};
}

}  // namespace

const HoldKindRow kNumber{"number", numberPlace, numberDragged, numberNudged, numberWords, false, true};

}  // namespace pipeline
