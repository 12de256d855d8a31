#include "app/cli/commands/stage_course.h"

#include <filesystem>

#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/cli.h"
#include "app/cli/hand_in_folder.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "lessons/grading/class_report.h"
#include "pipeline/core/text.h"
#include "pipeline/export/folder/staging.h"

namespace app {

namespace fs = std::filesystem;

namespace {

std::string pointsText(double points, double of) {
    return fmt::format("{} of {}", pipeline::shortestText(points), pipeline::shortestText(of));
}

void sayMarks(const lessons::StudentMarks& student) {
    for (const lessons::TaskMarks& task : student.tasks) {
        say("{}: {}\n", task.task, task.headline);
        for (const lessons::TaskMarks::Mark& mark : task.marks)
            say("  {:>14}  {}: {}\n", pointsText(mark.points, mark.of), mark.name, mark.words);
        for (const std::string& hint : task.hints) say("    {}\n", hint);
        for (const std::string& problem : task.problems) say("    {}\n", problem);
    }
    say("{} points\n", pointsText(student.points(), student.of()));
}

}  // namespace

int runStageCourse(const StageCourse& request) {
    const Interrupt interrupt;
    const auto course = lessons::readCourse(request.course, interrupt.token());
    if (interrupt.asked()) return tellCancelled();
    if (!course) return printErrors(course.errors()), kBadInput;
    std::error_code failed;
    const fs::path folder = fs::weakly_canonical(request.folder, failed);
    if (failed || !fs::is_directory(folder, failed)) {
        printErrors({{{request.folder}, "there is no such folder", "the folder with your programs"}});
        return kBadInput;
    }
    if (!request.output.empty()) {
        std::vector<std::string> names;
        for (const auto& [name, bytes] : studentFiles(*course, {}, {})) names.push_back(name);
        if (!mayWriteInto(request.output, names, names.back(), request.force)) return kCouldNotWrite;
    }
    const lessons::HandInFiles files = readHandIn(*course, folder, interrupt.token());
    lessons::Marker marker(*course, opensHandIn(*course, interrupt.token()));
    auto marked = marker.mark(folder.filename().string(), files, interrupt.token());
    if (interrupt.asked() || !marked) return tellCancelled();
    const lessons::StudentMarks& marks = marked->marks;
    if (!request.output.empty())
        if (const auto written =
                pipeline::writeFiles(studentFiles(*course, marks, std::move(marked->pages)), request.output);
            !written)
            return printErrors(written.errors()), kCouldNotWrite;
    if (request.json)
        say("{}\n", toJson(marks).dump(2));
    else
        sayMarks(marks);
    return !marks.isCompared() ? kBadInput : marks.points() < marks.of() ? kAnswerIsNo : kDone;
}

}  // namespace app
