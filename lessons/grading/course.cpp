#include "lessons/grading/course.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lessons/lesson.h"
#include "pipeline/compare/handed_in/values.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/folder/file_hash.h"
#include "pipeline/export/json/json.h"
#include "pipeline/formats/toml/toml_values.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::Errors;
using pipeline::TomlEntry;
using pipeline::TomlValues;

constexpr double kMostMb = 1024, kMostCheckPoints = 1000;
constexpr std::size_t kMostTasks = 50, kMostTaskName = 40, kMostTrials = 20;
constexpr int kMostSeconds = 600;
constexpr std::string_view kPlainName = "letters, digits, - and _, at most 40, and none of index, results and marks";

// The name of a folder and of a page.
bool isPlainName(const std::string& name) {
    constexpr std::array kTaken{"index", "results", "marks"};
    const auto isPlain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    };
    return !name.empty() && name.size() <= kMostTaskName && std::ranges::all_of(name, isPlain) &&
           std::ranges::find(kTaken, name) == kTaken.end();
}

class CourseReader {
public:
    CourseReader(const std::filesystem::path& file, const pipeline::Stop& stop)
        : m_folder(file.parent_path()), m_stop(stop), m_values(file.string()) {}

    pipeline::Result<Course> read(const toml::table& table) {
        const std::array<std::string, 6> known{"title", "hints", "most_mb", "seconds", "confine", "task"};
        for (const TomlEntry& entry : pipeline::inFileOrder(table)) {
            const std::string key(entry.key->str());
            if (key == "title")
                m_course.title = m_values.name(*entry.node, key).value_or("");
            else if (key == "hints")
                m_course.hints = int(m_values.wholeNumber(*entry.node, key, 0, 3).value_or(3));
            else if (key == "most_mb")
                m_course.mostBytes =
                    std::size_t(m_values.wholeNumber(*entry.node, key, 1, kMostMb).value_or(1)) * 1000 * 1000;
            else if (key == "seconds")
                m_course.seconds = int(m_values.wholeNumber(*entry.node, key, 1, kMostSeconds).value_or(1));
            else if (key == "confine")
                m_course.confine = m_values.name(*entry.node, key).value_or("");
            else if (key == "task")
                for (const toml::table* task : m_values.tables(*entry.node, key, kMostTasks)) readTask(*task);
            else
                m_values.unknown(*entry.key, key, known);
            if (m_stop.stop_requested()) return pipeline::Error{{}, "cancelled", {}};
        }
        if (m_course.tasks.empty()) m_values.fail(table.source(), "there is no task", "[[task]] with scene and points");
        if (const Errors errors = m_values.errors(); !errors.empty()) return errors;
        if (m_course.tasks.size() == 1 && m_course.tasks[0].folder == m_course.tasks[0].name && !m_namesFolder)
            m_course.tasks[0].folder.clear();
        return std::move(m_course);
    }

private:
    // Keys of a task that need others before they can be understood; null: not there.
    struct Written {
        const toml::node *scene = nullptr, *stage = nullptr, *scenes = nullptr, *hidden = nullptr, *points = nullptr;
        std::vector<std::string> set;
    };

    void readTask(const toml::table& table) {
        Course::Task task;
        Course::Program program;
        Written written;
        const std::array<std::string, 10> known{"name",  "folder", "scene",  "set",   "points",
                                                "stage", "scenes", "hidden", "build", "run"};
        for (const TomlEntry& entry : pipeline::inFileOrder(table)) {
            const std::string key(entry.key->str());
            const auto plain = [&](std::string& to) {
                const auto name = m_values.name(*entry.node, key);
                if (name && !isPlainName(*name))
                    m_values.refuse(*entry.node, key, std::string(kPlainName));
                else if (name)
                    to = *name;
            };
            const toml::node* const node = entry.node;
            if (key == "name")
                plain(task.name);
            else if (key == "folder")
                plain(task.folder), m_namesFolder = true;
            else if (key == "scene")
                written.scene = node;
            else if (key == "stage")
                written.stage = node;
            else if (key == "scenes")
                written.scenes = node;
            else if (key == "hidden")
                written.hidden = node;
            else if (key == "points")
                written.points = node;
            else if (key == "set")
                written.set = texts(*node, key, "an array of strings: [\"shading=phong\"]");
            else if (key == "build")
                program.build = m_values.name(*node, key).value_or("");
            else if (key == "run")
                program.run = m_values.name(*node, key).value_or("");
            else
                m_values.unknown(*entry.key, key, known);
        }
        if (written.stage)
            readProgram(table, written, program, task);
        else
            readFiles(table, written, task);
        if (std::ranges::find(m_course.tasks, task.name, &Course::Task::name) != m_course.tasks.end())
            return m_values.fail(table.source(), "two tasks are called " + task.name, "a name for each");
        m_course.tasks.push_back(std::move(task));
    }

    void readFiles(const toml::table& table, const Written& written, Course::Task& task) {
        if (task.name.empty() || !written.scene || !written.points)
            return m_values.fail(table.source(), "the task lacks a name, a scene or points", "all three");
        if (task.folder.empty()) task.folder = task.name;
        const std::string scene = m_values.name(*written.scene, "scene").value_or("");
        pipeline::BufferSet wanted;
        for (const auto& row : pipeline::foreign::toleranceTable()) wanted.set(index(row.buffer));
        task.scene = readScene(scene, *written.scene, written.set, wanted);
        const toml::table* const points = m_values.table(*written.points, "points");
        if (task.scene && points) readPoints(*points, *task.scene, task);
    }

    void readProgram(const toml::table& table, const Written& written, Course::Program& program, Course::Task& task) {
        const std::string name = m_values.name(*written.stage, "stage").value_or("");
        program.function = pipeline::findOwn(name);
        const auto stage = pipeline::findStage(name);
        const pipeline::foreign::StageBlocks* const blocks = stage ? pipeline::foreign::stageBlocks(*stage) : nullptr;
        if (!program.function && !blocks)
            return m_values.refuse(*written.stage, "stage",
                                   "a function of the manual's page \"Write the stage\", or a stage");
        program.stage = program.function ? ownContract(*program.function).stage : *stage;
        if (task.name.empty()) task.name = name;
        if (program.run.empty() || !written.scenes || !written.points || written.scene)
            return m_values.fail(table.source(), "the task runs a program", "scenes, run and points, and no scene");
        readTrials(*written.scenes, "scenes", written.set, blocks, program);
        if (written.hidden) readTrials(*written.hidden, "hidden", written.set, blocks, program);
        if (program.trials.empty()) return;
        if (program.function) {
            const double points = m_values.number(*written.points, "points", 0, kMostCheckPoints).value_or(0);
            task.checks.push_back({name, {}, {}, points});
        } else if (const toml::table* const points = m_values.table(*written.points, "points")) {
            readPoints(*points, *program.trials[0].scene, task);
        }
        task.program = std::move(program);
    }

    void readTrials(const toml::node& node, const std::string& key, const std::vector<std::string>& set,
                    const pipeline::foreign::StageBlocks* blocks, Course::Program& program) {
        for (const std::string& name : texts(node, key, "an array of scenes: [\"pyramid\", \"house.toml\"]")) {
            Course::Trial trial;
            trial.name = std::filesystem::path(name).stem().string(), trial.isHidden = key == "hidden";
            if (!isPlainName(trial.name)) return m_values.refuse(node, key, std::string(kPlainName));
            if (std::ranges::find(program.trials, trial.name, &Course::Trial::name) != program.trials.end())
                return m_values.fail(node.source(), "two scenes are called " + trial.name, "a name for each");
            if (program.trials.size() == kMostTrials)
                return m_values.refuse(node, key, fmt::format("at most {} scenes", kMostTrials));
            const auto scene =
                readScene(name, node, set, pipeline::setOf({pipeline::BufferId::Color, pipeline::BufferId::Normal}));
            if (!scene || m_stop.stop_requested()) continue;
            trial.scene = std::make_shared<const pipeline::Scene>(pipeline::ownScene(*scene));
            if (blocks) {
                trial.stage = std::make_shared<const pipeline::foreign::StageTrial>(*trial.scene, *blocks, m_stop);
            } else {
                trial.function =
                    std::make_shared<const pipeline::foreign::FunctionTrial>(*trial.scene, *program.function, m_stop);
                if (const auto error = trial.function->whyNot(); error && !m_stop.stop_requested())
                    m_values.fail(node.source(), trial.name + ": " + error->found, error->expected);
            }
            program.trials.push_back(std::move(trial));
        }
    }

    std::vector<std::string> texts(const toml::node& node, const std::string& key, const char* expected) {
        std::vector<std::string> out;
        const toml::array* const array = node.as_array();
        if (!array) return m_values.refuse(node, key, expected), out;
        for (const toml::node& one : *array)
            if (const auto text = m_values.text(one, key)) out.push_back(*text);
        return out;
    }

    // Null after the reason is among the errors.
    std::shared_ptr<const pipeline::Scene> readScene(const std::string& name, const toml::node& node,
                                                     const std::vector<std::string>& set, pipeline::BufferSet wanted) {
        auto scene = sceneOfLesson(name, m_folder, m_stop);
        for (const std::string& assignment : set)
            if (scene) scene = withSetting(std::move(scene).value(), assignment);
        Errors errors = scene ? checkScene(*scene) : scene.errors();
        if (errors.empty()) {
            pipeline::FrameRequest request;
            request.wanted = wanted;
            errors = checkMemory(*scene, request.wanted, request.until);
        }
        for (pipeline::Error& error : errors)
            if (error.where.file.empty()) error.where = m_values.place(node.source());
        m_values.add(errors);
        if (!errors.empty()) return nullptr;
        return std::make_shared<const pipeline::Scene>(std::move(scene).value());
    }

    void readPoints(const toml::table& table, const pipeline::Scene& scene, Course::Task& task) {
        for (const TomlEntry& entry : pipeline::inFileOrder(table)) {
            const std::string name(entry.key->str());
            const auto points = m_values.number(*entry.node, "points." + name, 0, kMostCheckPoints);
            Course::Check check{name, pipeline::findStage(name), {}, points.value_or(0)};
            if (!check.stage) {
                const auto buffer = pipeline::foreign::findHanded(name, scene.lights.size());
                if (!buffer) {
                    m_values.fail(entry.key->source(),
                                  fmt::format("no stage and no buffer of this scene is called {}; {}",
                                              pipeline::inQuotes(name), pipeline::foreign::insteadOfHanded(name)));
                    continue;
                }
                check.buffer = *buffer;
            }
            task.checks.push_back(std::move(check));
        }
        if (task.checks.empty()) m_values.fail(table.source(), "points is empty", "{color = 4}");
    }

    std::filesystem::path m_folder;
    const pipeline::Stop& m_stop;
    TomlValues m_values;
    Course m_course;
    bool m_namesFolder = false;
};

// What a scene is made of, for a hash.
std::string bytesOf(const pipeline::Scene& scene) {
    std::string bytes = sceneToJson(scene).dump();
    for (const pipeline::Object& object : scene.objects) {
        for (const auto& p : object.mesh->positions) bytes += fmt::format("{} {} {}\n", p.x, p.y, p.z);
        for (const auto& n : object.mesh->normals) bytes += fmt::format("{} {} {}\n", n.x, n.y, n.z);
        for (std::size_t i = 0; i < object.mesh->polygonCount(); ++i)
            bytes += fmt::format("{}\n", fmt::join(object.mesh->polygon(i), " "));
    }
    return bytes;
}

}  // namespace

bool Course::runsPrograms() const {
    return std::ranges::any_of(tasks, [](const Task& task) { return task.program.has_value(); });
}

pipeline::Result<Course> readCourse(const std::filesystem::path& file, const pipeline::Stop& stop) {
    const auto text = pipeline::readFile(file, pipeline::kMaxFileBytes);
    if (!text) return pipeline::namedAt({file.string()}, text.errors());
    const auto table = pipeline::parseToml({*text, file.string(), {{}, stop}});
    if (!table) return table.errors();
    auto course = CourseReader(file, stop).read(*table);
    if (!course) return course;
    Course read = std::move(course).value();
    read.key = pipeline::programVersion();
    read.key += *text;
    for (const Course::Task& task : read.tasks) {
        if (task.scene) read.key += bytesOf(*task.scene);
        for (const Course::Trial& trial : task.program ? task.program->trials : std::vector<Course::Trial>())
            read.key += bytesOf(*trial.scene);
    }
    read.key = pipeline::sha256Of(read.key);
    return read;
}

}  // namespace lessons
