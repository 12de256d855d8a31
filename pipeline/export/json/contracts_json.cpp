#include "pipeline/export/json/contracts_json.h"

#include <cmath>

namespace pipeline {

Json toJson(std::span<const ContractResult> results, const ContractInput& input, bool everything) {
    Json list = Json::array();
    // What is not finite has no number in JSON.
    const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(x != x ? "NaN" : x > 0 ? "∞" : "−∞"); };
    for (const ContractResult& result : results) {
        if (!result.why.empty() && !everything) continue;
        Json one{{"contract", result.contract->id}};
        if (result.light >= 0) one["light"] = result.light;
        one["stage"] = stageInfo(result.contract->stage).name;
        one["formula"] = result.contract->formula;
        if (!result.why.empty()) {
            one["why"] = result.why;
            list.push_back(std::move(one));
            continue;
        }
        one["checked"] = result.checked, one["hold"] = result.hold;
        if (result.undecided > 0) one["undecided"] = result.undecided;
        const ContractFinding& found = result.worst->finding;
        one["worst"] = {{"place", contractPlace(result, input, result.worst->element)},
                        {"value", number(found.value)},
                        {"error", number(found.error)},
                        {"bound", number(found.bound)},
                        {"unit", result.contract->unit}};
        list.push_back(std::move(one));
    }
    return list;
}

}  // namespace pipeline
