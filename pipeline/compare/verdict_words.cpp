#include <fmt/format.h>

#include "pipeline/compare/verdict.h"
#include "pipeline/core/text.h"

namespace pipeline::foreign {

std::string_view words(Standing standing) {
    switch (standing) {
        case Standing::Agrees: return "agrees";
        case Standing::WrongHere: return "wrong here";
        case Standing::GivenInput: return "given what it got";
        case Standing::NoFile: return "no file";
        case Standing::CannotTell: return "cannot tell";
    }
    return {};
}

std::string headline(const Report& report) {
    if (report.agrees() && report.options.strict && report.conventionsDiffer())
        return "Everything handed in agrees but for its conventions, which count as errors.";
    if (report.agrees()) return "Everything handed in agrees.";
    if (report.options.hints < 1) return "Something differs.";
    const bool two = report.suspects && report.suspects->candidates.size() > 1;
    if (report.firstWrong) {
        const std::string_view stage = stageInfo(*report.firstWrong).label;
        if (report.isCertain) return fmt::format("{} is the first wrong stage.", stage);
        if (report.suspects && report.suspects->candidates.size() == 1)
            return fmt::format("{} is most likely the first wrong stage.", stage);
        return fmt::format("{} is the first stage that differs.", stage);
    }
    const bool onlyColor = report.findings.size() == 1 && report.findings[0].name.buffer.id == BufferId::Color;
    const std::string_view what = onlyColor ? "Colour alone" : "What was handed in";
    if (two)
        return fmt::format(
            "The picture differs. {} cannot decide between {} known errors.", what,
            report.suspects->candidates.size() == 2 ? "two" : std::to_string(report.suspects->candidates.size()));
    return fmt::format("The picture differs. {} cannot tell which stage is wrong.", what);
}

std::string evidence(const Report& report) {
    const bool mirrored = std::ranges::any_of(report.findings, [](const Finding& f) { return f.reading.mirrored; });
    if (report.agrees() && mirrored)
        return "But the picture is mirrored. If you do not mean that, an axis of the camera points the wrong way.";
    if (report.agrees()) {
        std::size_t said = 0;
        for (const Convention& one : report.conventions.said) said += !one.own;
        return said == 0 ? std::string()
                         : fmt::format("{} of yours {} read as such.", plural(std::int64_t(said), "convention"),
                                       said == 1 ? "was" : "were");
    }
    const Finding* const first = report.firstDifference();
    if (!first || report.options.hints < 1) return {};
    const std::string text = fmt::format("{}: {}.", first->name.text(), findingText(*first));
    return first->nan == 0 ? text : fmt::format("{} {} of its numbers are NaN.", text, first->nan);
}

std::vector<std::string> hints(const Report& report) {
    std::vector<std::string> out;
    if (report.agrees()) return out;
    const Finding* const first = report.firstDifference();
    if (report.options.hints >= 1)
        out.push_back(report.firstWrong ? fmt::format("Stage: {}.", stageInfo(*report.firstWrong).label)
                                        : "The files do not tell the stage. Hand in more of them.");
    if (report.options.hints >= 2 && first)
        out.push_back(first->worst
                          ? fmt::format("Look at {} of {}.", placeText(*first, *first->worst), first->name.text())
                          : fmt::format("Look at {}.", first->name.text()));
    if (report.options.hints >= 3 && report.suspects) {
        if (report.suspects->candidates.empty()) out.push_back("None of the known errors explains this.");
        for (const Candidate& one : report.suspects->candidates)
            out.push_back(fmt::format("{}: {} in place of {}.", one.error.name, one.error.wrong, one.error.right));
    }
    return out;
}

}  // namespace pipeline::foreign
