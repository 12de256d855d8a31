#include "pipeline/compare/report/compare_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"

namespace pipeline::foreign {

namespace {

// The characters of a text: what a terminal shows in a column each.
std::size_t widthOf(std::string_view text) {
    return std::size_t(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}
std::string padded(std::string text, std::size_t width) {
    const std::size_t has = widthOf(text);
    if (has < width) text.append(width - has, ' ');
    return text;
}

class Writer {
public:
    Writer(const Report& report, bool plain, std::size_t columns)
        : m_report(report), m_plain(plain), m_narrow(columns < 80) {}

    std::vector<TextLine> lines() {
        const std::string why = evidence(m_report);
        m_lines.push_back({headline(m_report), true});
        if (!why.empty()) add(why);
        add("");
        if (m_report.options.hints >= 1 || m_report.agrees())
            for (const StageVerdict& stage : m_report.stages) addStage(stage);
        add("");
        if (m_report.options.hints >= 2)
            for (const BrokenContract& one : m_report.broken) labelled("contracts", contractText(one));
        if (m_report.options.hints >= 2) addWorst();
        if (m_report.options.hints >= 3) addLikely();
        addConventions();
        addFiles();
        return std::move(m_lines);
    }

private:
    void add(std::string text, bool bold = false) {
        while (text.ends_with(' ')) text.pop_back();
        m_lines.push_back({std::move(text), bold});
    }
    void labelled(std::string_view label, const std::string& text, bool bold = false) {
        add(padded(std::string(label == m_label ? "" : label), 13) + text, bold);
        m_label = label;
    }

    void addStage(const StageVerdict& stage) {
        const bool wrong = stage.standing == Standing::WrongHere;
        std::string word(words(stage.standing));
        if (wrong) std::ranges::transform(word, word.begin(), [](char c) { return char(std::toupper(c)); });
        const std::string head = padded(std::string(mark(stage.standing, m_plain)), m_plain ? 3 : 2) +
                                 padded(std::string(stageInfo(stage.stage).name), 15) + padded(word, 20);
        if (stage.findings.empty()) return add(head);
        bool first = true;
        for (const std::size_t i : stage.findings) {
            const Finding& finding = m_report.findings[i];
            const std::string tolerance = toleranceText(finding);
            std::string line = (first ? head : std::string(m_plain ? 38 : 37, ' ')) + padded(finding.name.text(), 18);
            line += padded(findingText(finding), 30);
            if (!tolerance.empty() && !m_narrow) line += fmt::format("  ({})", tolerance);
            add(line, wrong && first);
            if (!tolerance.empty() && m_narrow) add(std::string(37, ' ') + fmt::format("({})", tolerance));
            first = false;
        }
        if (!stage.own.empty()) add(std::string(m_plain ? 38 : 37, ' ') + stage.own);
    }

    void addWorst() {
        const Finding* const first = m_report.firstDifference();
        const auto worst = [&](const Finding& finding) {
            if (!finding.worst) return;
            const Values& right = m_report.reference->values.at(finding.name.buffer.text());
            labelled("worst", fmt::format("{}  {}  mine {}   reference {}", padded(finding.name.text(), 16),
                                          padded(placeText(finding, *finding.worst), 15),
                                          padded(mineText(m_report, finding, *finding.worst), 12),
                                          valueText(finding, right, *finding.worst)));
        };
        if (!first) return;
        worst(*first);
        for (const Finding& finding : m_report.findings)
            if (&finding != first && finding.name.buffer.id == BufferId::Color && !finding.agrees) worst(finding);
    }

    void addLikely() {
        if (!m_report.suspects) return;
        const Suspects& suspects = *m_report.suspects;
        labelled("likely", namesText(m_report), suspects.candidates.empty());
        int number = 0;
        for (const Candidate& one : suspects.candidates) {
            const std::string which = suspects.candidates.size() > 1 ? fmt::format("{}  ", ++number) : std::string();
            labelled("likely", which + one.error.name, true);
            labelled("likely",
                     fmt::format("{}{} in place of {}; {} {:.1f} %{}", std::string(which.size(), ' '), one.error.wrong,
                                 one.error.right, suspects.areTogether ? "both explain" : "explains",
                                 100 * one.explained, rowsText(one)));
            if (!one.error.lesson.empty())
                labelled("likely", fmt::format("{}lesson {}, page “{}”", std::string(which.size(), ' '),
                                               one.error.lesson, one.error.heading));
        }
        if (suspects.next && suspects.candidates.size() == 1)
            labelled("likely", fmt::format("the next known error explains {:.0f} %",
                                           100 * std::max(0.0, suspects.next->explained)));
        if (suspects.experiment) {
            std::string text = fmt::format("print {} of {}: ", suspects.experiment->place, suspects.experiment->buffer);
            for (std::size_t i = 0; i < suspects.experiment->values.size(); ++i)
                text += fmt::format("{}{} means {}", i ? ", " : "", suspects.experiment->values[i], i + 1);
            labelled("experiment", text, true);
        } else if (suspects.candidates.size() > 1 && suspects.kind.empty() && !suspects.areTogether) {
            labelled("experiment", "None: they leave the same numbers in every buffer of this scene.");
        }
    }
    std::string rowsText(const Candidate& one) const {
        if (m_report.suspects->candidates.size() < 2) return one.otherRows ? ", with the rows the other way round" : "";
        const bool mixed = std::ranges::any_of(
            m_report.suspects->candidates, [&](const Candidate& other) { return other.otherRows != one.otherRows; });
        if (!mixed) return {};
        return one.otherRows ? ", if the rows are the other way round" : ", if the rows are as read";
    }

    void addConventions() {
        std::string fix;
        for (const Convention& one : m_report.conventions.said) {
            labelled("conventions",
                     fmt::format("{}  {}  {}", padded(one.buffer, 16), padded(one.words, 34), certaintyText(one)));
            const std::string line = fmt::format("{} = \"{}\"", one.key, one.value);
            if (isAdvised(m_report, one) && fix.find(line) == fix.npos) fix += "  " + line;
        }
        if (!fix.empty()) labelled("conventions", "To fix them, write into mine.toml:" + fix);
    }

    void addFiles() {
        labelled("files", fmt::format("{} read.", m_report.findings.size()));
        const std::vector<std::string> missing = m_report.notHandedIn();
        if (!missing.empty()) labelled("files", fmt::format("Not handed in: {}.", fmt::join(missing, ", ")));
        for (const Finding& finding : m_report.findings) {
            const bool clears = finding.name.buffer.id == BufferId::ZView;
            if (finding.nan > 0) labelled("files", fmt::format("{} holds {} NaN.", finding.file, finding.nan));
            if (finding.infinite > 0 && !clears)
                labelled("files", fmt::format("{} holds {} infinite numbers.", finding.file, finding.infinite));
        }
        for (const std::string& other : m_report.in->others) labelled("files", other + ".");
        for (const Error& error : m_report.in->errors) {
            std::string text = format(error);
            while (text.ends_with('\n')) text.pop_back();
            labelled("files", text);
        }
    }

    const Report& m_report;
    bool m_plain, m_narrow;
    std::string_view m_label;
    std::vector<TextLine> m_lines;
};

}  // namespace

std::string certaintyText(const Convention& convention) {
    switch (convention.certainty) {
        case Certainty::Stated: return "stated in mine.toml";
        case Certainty::Agreed: return "as the other files";
        case Certainty::Explains: return "with the error named";
        case Certainty::CannotTell: return "cannot tell";
        case Certainty::Clear: break;
    }
    return convention.margin >= 1e4 ? "clear" : fmt::format("{:.0f} × closer", convention.margin);
}

bool isAdvised(const Report& report, const Convention& convention) {
    if (convention.key.empty() || convention.own || convention.certainty == Certainty::Stated) return false;
    std::size_t shared = 0;
    for (const Convention& other : report.conventions.said) {
        if (other.key != convention.key) continue;
        if (other.value != convention.value && !other.own) return false;
        shared += other.value == convention.value;
    }
    const bool ofRows = convention.key == "rows", ofPictures = ofRows || convention.key == "columns";
    bool agrees = false;
    for (const Finding& finding : report.findings) {
        const Reading& reading = finding.reading;
        if (ofPictures && finding.isPicture() && !(ofRows ? reading.bottomUp : reading.mirrored)) return false;
        const bool isItsOwn = finding.name.text() == convention.buffer || convention.buffer == "pictures";
        agrees = agrees || (isItsOwn && finding.agrees);
    }
    return shared > 1 || agrees;
}

std::string_view mark(Standing standing, bool plain) {
    switch (standing) {
        case Standing::Agrees: return plain ? "ok" : "✓";
        case Standing::WrongHere: return plain ? "XX" : "✗";
        case Standing::GivenInput: return plain ? "->" : "↯";
        case Standing::NoFile: return plain ? "--" : "–";
        case Standing::CannotTell: return plain ? "??" : "?";
    }
    return {};
}

std::vector<TextLine> reportText(const Report& report, bool plain, std::size_t columns) {
    return Writer(report, plain, columns).lines();
}

}  // namespace pipeline::foreign
