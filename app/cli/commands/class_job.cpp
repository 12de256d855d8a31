#include "app/cli/commands/class_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/cli/arguments/output_argument.h"
#include "app/cli/arguments/scene_argument.h"
#include "app/cli/cli.h"
#include "app/cli/commands/foreign_program.h"
#include "app/cli/hand_in_folder.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "app/cli/progress_printer.h"
#include "lessons/grading/class_report.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/formats/scene_folder.h"

namespace app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostStudents = 10000;

int wrongClass(const std::string& message) {
    tell("shadescope compare --class: {}\n", message);
    return kWrongUsage;
}

struct HandIns {
    std::vector<fs::path> folders;  // one a student, sorted
    std::vector<std::string> refused;
};
pipeline::Result<HandIns> handInsIn(const fs::path& folder) {
    HandIns out;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
        const std::string name = at->path().filename().string();
        if (name.starts_with('.')) continue;
        if (!at->is_symlink(failed) && at->is_directory(failed))
            out.folders.push_back(at->path());
        else
            out.refused.push_back(pipeline::escaped(name) +
                                  (at->is_symlink(failed) ? ": a link to another place" : ": no folder"));
        if (out.folders.size() + out.refused.size() > kMostStudents)
            return pipeline::Error{{folder.string()}, fmt::format("found more than {} hand-ins", kMostStudents), {}};
    }
    if (failed) return pipeline::Error{{folder.string()}, "the folder cannot be read: " + failed.message(), {}};
    if (out.folders.empty())
        return pipeline::Error{{folder.string()}, "found no hand-in", "a folder with one folder for each student"};
    std::ranges::sort(out.folders), std::ranges::sort(out.refused);
    return out;
}

// What is written may not be handed in.
bool isWithin(const fs::path& path, const fs::path& folder) {
    std::error_code failed;
    const fs::path inner = fs::weakly_canonical(path, failed), outer = fs::weakly_canonical(folder, failed);
    return std::ranges::mismatch(outer, inner).in1 == outer.end();
}

std::vector<std::string> namesOf(const std::vector<std::pair<std::string, std::string>>& files) {
    std::vector<std::string> names;
    for (const auto& [name, text] : files) names.push_back(name);
    return names;
}

class ClassJob {
public:
    ClassJob(const ClassRequest& request, const lessons::Course& course, HandIns handIns, const Interrupt& interrupt)
        : m_request(request),
          m_course(course),
          m_handIns(std::move(handIns)),
          m_interrupt(interrupt),
          m_marker(course, opensHandIn(course, interrupt.token())) {}

    int run(std::size_t part, std::size_t parts) {
        lessons::MarkedClass all{m_course.title, {}, m_handIns.refused};
        {
            ProgressPrinter progress("compare");
            for (std::size_t i = part; i < m_handIns.folders.size(); i += parts) {
                progress.show(i / parts, (m_handIns.folders.size() - part + parts - 1) / parts, "hand-ins");
                if (const int status = mark(m_handIns.folders[i], all); status != kDone) return status;
            }
        }
        std::size_t below = 0, unread = m_handIns.refused.size();
        for (const lessons::StudentMarks& student : all.students) {
            below += 100 * student.points() < m_request.pass * student.of();
            unread += !student.isCompared();
        }
        const std::string count = pipeline::plural(std::int64_t(all.students.size()), "hand-in");
        if (parts > 1) {
            say("{} of {} are in {}; the same command without --shard joins the parts\n", count,
                m_handIns.folders.size(), m_request.folder);
            return unread > 0 ? kBadInput : kDone;
        }
        const auto written = pipeline::writeFiles(classFiles(all), m_request.folder);
        if (!written) {
            printErrors(written.errors());
            return kCouldNotWrite;
        }
        std::string line = count;
        if (m_request.pass > 0) line += fmt::format(", {} below {} %", below, pipeline::shortestText(m_request.pass));
        if (unread > 0) line += fmt::format(", {} could not be compared", unread);
        say("{}; {} in {}\n", line, fmt::join(*written, ", "), m_request.folder);
        return unread > 0 ? kBadInput : below > 0 ? kAnswerIsNo : kDone;
    }

private:
    // All of a student at once, or what was there before.
    int mark(const fs::path& handIn, lessons::MarkedClass& all) {
        const std::string name = handIn.filename().string();
        const fs::path target = fs::path(m_request.folder) / "students" / name;
        const auto files = readHandIn(m_course, handIn, m_interrupt.token());
        if (!m_request.restart) {
            std::error_code none;
            if (const auto before = fs::exists(target / "marks.json", none)
                                        ? pipeline::readFile(target / "marks.json")
                                        : pipeline::Result<std::string>(std::string()))
                if (auto marks = lessons::marksFromJson(*before); marks && marks->key == files.key) {
                    all.students.push_back(std::move(*marks));
                    return kDone;
                }
        }
        const auto names = namesOf(studentFiles(m_course, {name, files.key, {}}, {}));
        if (!mayWriteInto(target.string(), names, names.back(), m_request.force)) return kCouldNotWrite;
        auto marked = m_marker.mark(name, files, m_interrupt.token());
        if (m_interrupt.asked() || !marked) {
            tell("Cancelled. The same command goes on from here.\n");
            return kInterrupted;
        }
        const auto written =
            pipeline::writeFiles(studentFiles(m_course, marked->marks, std::move(marked->pages)), target);
        if (!written) {
            printErrors(written.errors());
            return kCouldNotWrite;
        }
        all.students.push_back(std::move(marked->marks));
        return kDone;
    }

    const ClassRequest& m_request;
    const lessons::Course& m_course;
    HandIns m_handIns;
    const Interrupt& m_interrupt;
    lessons::Marker m_marker;
};

}  // namespace

pipeline::Result<std::monostate> writeCommands(const std::string& file,
                                               const std::vector<std::vector<std::string>>& commands) {
    std::error_code failed;
    const fs::path self = fs::read_symlink("/proc/self/exe", failed);
    std::string text;
    for (const std::vector<std::string>& command : commands) {
        text += inShell(failed ? "shadescope" : self.string());
        for (const std::string& word : command) text += ' ' + inShell(word);
        text += '\n';
    }
    return pipeline::writeWhole(file, text);
}

int runClass(const ClassRequest& request) {
    if (request.handedIn.empty()) return wrongClass("the folder with the hand-ins is missing");
    if (request.folder.empty()) return wrongClass("-o needs the name of a folder");
    const auto shard = request.shard.empty() ? glm::ivec2(1, 1) : parsePair(request.shard, '/').value_or(glm::ivec2(0));
    if (shard.x < 1 || shard.y < shard.x)
        return wrongClass(
            fmt::format("--shard is {}, expected I/N with I from 1 to N", pipeline::inQuotes(request.shard)));
    if (isWithin(request.folder, request.handedIn))
        return wrongClass("-o is within the hand-ins, which are only read: name another folder");
    const Interrupt interrupt;
    const auto course = lessons::readCourse(request.course, interrupt.token());
    if (interrupt.asked()) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    auto handIns = course ? handInsIn(request.handedIn) : pipeline::Result<HandIns>(course.errors());
    if (!handIns) {
        printErrors(handIns.errors());
        return kBadInput;
    }
    if (!request.commands.empty()) {
        std::vector<std::vector<std::string>> commands;
        const std::size_t count = handIns->folders.size();
        for (std::size_t i = 0; i < count; ++i) {
            commands.push_back({"compare", "--class", request.course, request.handedIn, "-o", request.folder, "--shard",
                                fmt::format("{}/{}", i + 1, count)});
            if (request.restart) commands.back().emplace_back("--restart");
            if (request.force) commands.back().emplace_back("--force");
        }
        if (const auto written = writeCommands(request.commands, commands); !written) {
            printErrors(written.errors());
            return kCouldNotWrite;
        }
        say("{} in {}; then the same command without --commands\n", pipeline::plural(std::int64_t(count), "command"),
            request.commands);
        return kDone;
    }
    if (const auto names = namesOf(lessons::classFiles({}));
        !mayWriteInto(request.folder, names, names.back(), request.force))
        return kCouldNotWrite;
    tellOfPrograms(*course);
    return ClassJob(request, *course, std::move(handIns).value(), interrupt)
        .run(std::size_t(shard.x - 1), std::size_t(shard.y));
}

}  // namespace app
