// What is wrong on purpose stands in one folder; elsewhere are calls of it, one line each.
#include <gtest/gtest.h>

#include <regex>

#include "tests/architecture/source_tree.h"

namespace architecture {
namespace {

bool isRightText(const std::string& path) {
    return path.starts_with("pipeline/") && !path.starts_with("pipeline/defects/") &&
           !path.starts_with("pipeline/compare/");  // which names errors to recognise them
}

// Lines of the right text that name a defect, or call a hook other than after a condition in the same line.
std::vector<std::string> misplaced(const SourceTree& tree) {
    static const std::regex names(R"(\bDefect::(?!None\b)\w)");
    static const std::regex hook(R"(\bspoil[A-Z]\w*\()");
    static const std::regex oneLine(R"(^\s*if \([\w.]*(planted|defect != Defect::None)\) spoil[A-Z]\w*\(.*\);$)");
    std::vector<std::string> lines;
    for (const SourceFile& file : tree) {
        if (!isRightText(file.path)) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            const std::string& line = file.lines[i];
            const bool isCall = std::regex_search(line, hook) && !std::regex_match(line, oneLine);
            if (isCall || std::regex_search(line, names))
                lines.push_back(file.path + ':' + std::to_string(i + 1) + ": " + line);
        }
    }
    return lines;
}

TEST(Architecture, WhatIsWrongOnPurposeStandsInOneFolder) {
    const auto in = [](const char* line) { return SourceTree{{"pipeline/stages/cull.cpp", {line}}}; };
    EXPECT_EQ(misplaced(in("    if (inputs.planted) spoilVerdicts(inputs, in, count, out);")).size(), 0u);
    EXPECT_EQ(misplaced(in("    spoilVerdicts(inputs, in, count, out);")).size(), 1u);
    EXPECT_EQ(misplaced(in("    if (planted.defect == Defect::CullSign) area = -area;")).size(), 1u);
    for (const std::string& line : misplaced(readSourceTree(SHADESCOPE_ROOT))) ADD_FAILURE() << line;
}

}  // namespace
}  // namespace architecture
