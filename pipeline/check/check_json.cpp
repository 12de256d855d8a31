#include "pipeline/check/check_json.h"

#include <algorithm>

namespace pipeline::check {

Json toJson(const Case& which) {
    return {{"case", which.id},
            {"group", name(which.group)},
            {"title", which.title},
            {"input", which.input},
            {"naive_form", which.naive},
            {"stable_form", which.stable},
            {"measure", which.measure},
            {"unit", which.unit},
            {"reference", which.reference},
            {"bound", which.bound},
            {"ends_in", name(which.outcome)}};
}

Json toJson(const CaseResult& result) {
    Json json = toJson(*result.what);
    json["naive"] = result.finding.naive;
    json["naive_text"] = result.naiveText();
    json["ours"] = result.finding.ours;
    json["ours_text"] = result.oursText();
    json["holds"] = result.holds;
    json["reason"] = result.reason;
    json["milliseconds"] = result.milliseconds;
    return json;
}

Json toJson(const std::vector<CaseResult>& results, double seconds) {
    Json cases = Json::array();
    for (const CaseResult& result : results) cases.push_back(toJson(result));
    return {{"cases", results.size()},
            {"hold", std::ranges::count(results, true, &CaseResult::holds)},
            {"seconds", seconds},
            {"results", cases}};
}

}  // namespace pipeline::check
