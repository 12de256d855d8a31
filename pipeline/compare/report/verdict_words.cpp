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

namespace {

// "Normals or Shading"
std::string stagesText(const std::vector<StageId>& stages) {
    std::string text;
    for (std::size_t i = 0; i < stages.size(); ++i)
        text += fmt::format("{}{}", i == 0 ? "" : i + 1 == stages.size() ? " or " : ", ", stageInfo(stages[i]).label);
    return text;
}

// Conventions that are errors where they are not meant: students ask for the error that they have made.
std::string askedBack(const Report& report) {
    const auto isRead = [&](auto holds) { return std::ranges::any_of(report.findings, holds); };
    std::string text;
    if (isRead([](const Finding& f) { return f.reading.mirrored; }))
        text += " Your picture is mirrored. If you do not mean that, an axis of the camera points the wrong way.";
    if (isRead(
            [](const Finding& f) { return f.reading.coding == Coding::Srgb || f.reading.coding == Coding::Gamma22; }))
        text += " Your picture is encoded as sRGB. If you do not mean that, it is the error gamma.";
    if (isRead([](const Finding& f) { return whiteOf(f.reading.coding) > 0; }))
        text += " Your picture cuts off what is brighter than white. The program's own colours are scaled by I_max.";
    if (report.reference && report.reference->corner != PixelCorner::None)
        text += " Your pixels are sampled at their corners. If you do not mean that, they are half a pixel off.";
    return text;
}

}  // namespace

std::string headline(const Report& report) {
    if (report.agrees() && !report.in->errors.empty()) {
        const std::string& file = report.in->errors[0].where.file;
        const std::string name = file.substr(file.rfind('/') + 1);
        const std::size_t others = report.in->errors.size() - 1;
        return fmt::format("{}{} could not be compared; the other files agree.", name,
                           others == 0 ? "" : fmt::format(" and {} more", plural(std::int64_t(others), "file")));
    }
    if (report.agrees() && report.options.strict && report.conventionsDiffer())
        return "Everything handed in agrees but for its conventions, which count as errors.";
    if (report.agrees()) return "Everything handed in agrees.";
    if (report.options.hints < 1) return "Something differs.";
    if (report.evidence.isOneColored) return "The picture has one colour.";
    if (report.evidence.isEmpty) return "Nothing is drawn.";
    const auto named = report.suspects ? report.suspects->candidates.size() : 0;
    if (report.firstWrong) {
        const std::string_view stage = stageInfo(*report.firstWrong).label;
        if (report.isCertain) return fmt::format("{} is the first wrong stage.", stage);
        const bool differs = std::ranges::any_of(
            report.findings, [&](const Finding& f) { return f.stage == *report.firstWrong && !f.agrees; });
        if (named > 0 || !differs) return fmt::format("{} is most likely the first wrong stage.", stage);
        return fmt::format("{} is the first stage that differs.", stage);
    }
    if (report.possiblyWrong.size() == 2)
        return fmt::format("The first wrong stage is {}.", stagesText(report.possiblyWrong));
    if (report.possiblyWrong.size() > 2)
        return fmt::format("{} is the first wrong stage.", stagesText(report.possiblyWrong));
    const bool onlyColor = report.findings.size() == 1 && report.findings[0].name.buffer.id == BufferId::Color;
    const std::string_view what = onlyColor ? "Colour alone" : "What was handed in";
    if (named > 1)
        return fmt::format("The picture differs. {} cannot decide between {} known errors.", what,
                           named == 2 ? "two" : std::to_string(named));
    return fmt::format("The picture differs. {} cannot tell which stage is wrong.", what);
}

std::string evidence(const Report& report) {
    std::string text;
    for (const std::string& words : report.evidence.words) text += " " + words + ".";
    const Finding* const first = report.firstDifference();
    if (report.agrees()) {
        const std::string asked = askedBack(report);
        std::size_t said = 0;
        for (const Convention& one : report.conventions.said) said += !one.own;
        text += asked;
        if (asked.empty() && said > 0)
            text += fmt::format(" {} of yours {} read as such.", plural(std::int64_t(said), "convention"),
                                said == 1 ? "was" : "were");
    } else if (first && report.options.hints >= 1) {
        text += fmt::format(" {}: {}.", first->name.text(), findingText(*first));
        if (first->nan > 0) text += fmt::format(" {} of its numbers are NaN.", first->nan);
        text += askedBack(report);
    }
    return text.empty() ? text : text.substr(1);
}

std::string namesText(const Report& report) {
    if (!report.suspects) return {};
    const Suspects& suspects = *report.suspects;
    if (suspects.candidates.empty()) return fmt::format("None of the {} known errors explains this.", suspects.tried);
    if (!suspects.kind.empty()) return fmt::format("The shadow test alone is wrong: {}.", suspects.kind);
    std::string whose = "Your files are those";
    if (suspects.files.size() < report.findings.size()) {
        std::vector<std::string> names;
        for (const std::size_t i : suspects.files) names.push_back(report.findings[i].name.text());
        whose = fmt::format("Your {} {}", fmt::join(names, ", "), names.size() == 1 ? "is that" : "are those");
    }
    return fmt::format("{} of a renderer with {}.", whose,
                       suspects.areTogether             ? "both of these errors"
                       : suspects.candidates.size() > 1 ? "one of these errors"
                                                        : "this error");
}

std::string mineText(const Report& report, const Finding& finding, std::size_t element) {
    const ReadFile& file = report.fileOf(finding);
    const std::string text = valueText(finding, file.mine, element);
    const bool isNothing = !file.mine.there[element];
    if (!finding.isPicture() || (finding.name.buffer.id != BufferId::Color && !isNothing)) return text;
    std::string numbers;
    for (const double v : numbersAt(*file.file, file.reading, element % finding.columns, element / finding.columns))
        numbers += fmt::format("{}{:.6g}", numbers.empty() ? "" : " ", v);
    return isNothing ? fmt::format("{} ({})", text, numbers) : numbers;
}

std::vector<std::string> hints(const Report& report) {
    std::vector<std::string> out;
    if (report.agrees()) return out;
    const Finding* const first = report.firstDifference();
    if (report.options.hints >= 1)
        out.push_back(!report.possiblyWrong.empty() ? fmt::format("Stage: {}.", stagesText(report.possiblyWrong))
                                                    : "The files do not tell the stage. Hand in more of them.");
    if (report.options.hints >= 2 && first)
        out.push_back(first->worst
                          ? fmt::format("Look at {} of {}.", placeText(*first, *first->worst), first->name.text())
                          : fmt::format("Look at {}.", first->name.text()));
    if (report.options.hints >= 3 && report.suspects) {
        if (report.suspects->candidates.empty()) out.push_back(namesText(report));
        for (const Candidate& one : report.suspects->candidates)
            out.push_back(fmt::format("{}: {} in place of {}.", one.error.name, one.error.wrong, one.error.right));
    }
    return out;
}

}  // namespace pipeline::foreign
