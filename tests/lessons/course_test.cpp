// The ready assignments, and what a course's file gives to each of its scenes.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "lessons/grading/course.h"
#include "pipeline/compare/own/own_blocks.h"
#include "pipeline/formats/built_in_scenes.h"

namespace {

using namespace lessons;
namespace foreign = pipeline::foreign;

// A student's program without a process: reads the block of calls, applies a formula to each, writes the results.
foreign::Program programWith(const pipeline::OwnContract& contract, pipeline::OwnFormula formula) {
    return [&contract, formula](const std::string& input) -> pipeline::Result<foreign::ProgramOutput> {
        std::istringstream lines(input);
        std::string line;
        std::getline(lines, line);
        std::string rows;
        std::size_t count = 0;
        for (; std::getline(lines, line); ++count) {
            std::vector<double> in;
            std::istringstream words(line);
            for (std::string word; words >> word;) in.push_back(*foreign::numberIn(word));
            const pipeline::OwnValue value = valueOf(contract, formula, in);
            for (std::size_t i = 0; i < contract.size(); ++i) rows += foreign::numberText(value.at[i]) + ' ';
            rows += '\n';
        }
        std::string text(contract.name);
        text += ' ' + std::to_string(count) + ' ' + std::to_string(contract.size()) + '\n' + rows;
        return foreign::ProgramOutput{{}, std::move(text), {}};
    };
}

class Assignments : public testing::TestWithParam<const char*> {};

// No known mistake gets all points: some scene shows it, and some scene tells it from all others.
TEST_P(Assignments, NoticeEveryKnownMistakeByItsName) {
    const std::filesystem::path file = pipeline::resourceFolder() / "assignments" / GetParam();
    const auto course = readCourse(file);
    ASSERT_TRUE(course) << format(course.errors());
    for (const Course::Task& task : course->tasks) {
        ASSERT_TRUE(task.program && task.program->function) << task.name;
        const pipeline::OwnContract& contract = ownContract(*task.program->function);
        const auto judge = [&](const Course::Trial& trial, pipeline::OwnFormula formula) {
            return trial.function->judge(programWith(contract, formula), false, {}).value().verdict;
        };
        bool hasHidden = false;
        for (const Course::Trial& trial : task.program->trials) {
            hasHidden = hasHidden || trial.isHidden;
            EXPECT_TRUE(judge(trial, contract.right).isRight()) << task.name << " in " << trial.name;
        }
        EXPECT_TRUE(hasHidden) << task.name;
        for (const pipeline::OwnMistake& mistake : contract.mistakes) {
            bool isNoticed = false, isNamed = false;
            for (const Course::Trial& trial : task.program->trials) {
                const pipeline::OwnVerdict verdict = judge(trial, mistake.formula);
                isNoticed = isNoticed || !verdict.isRight();
                isNamed = isNamed || (verdict.names.size() == 1 && verdict.names[0]->id == mistake.id);
                if (isNamed) break;
            }
            EXPECT_TRUE(isNoticed && isNamed) << task.name << ": " << mistake.id;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Course, Assignments,
                         testing::Values("transform.toml", "cull.toml", "normals.toml", "shadow-buffer.toml",
                                         "z-buffer.toml", "shading.toml"),
                         [](const auto& of) {
                             std::string name = of.param;
                             name.resize(name.find('.'));
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
