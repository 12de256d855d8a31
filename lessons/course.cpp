#include "lessons/course.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lessons/lesson.h"
#include "pipeline/compare/values.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/file_hash.h"
#include "pipeline/export/json.h"
#include "pipeline/formats/toml_values.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::Errors;
using pipeline::TomlEntry;
using pipeline::TomlValues;

constexpr double kMostMb = 1024, kMostCheckPoints = 1000;
constexpr std::size_t kMostTasks = 50, kMostTaskName = 40;

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
        for (const TomlEntry& entry : pipeline::inFileOrder(table)) {
            const std::string key(entry.key->str());
            if (key == "title")
                m_course.title = m_values.name(*entry.node, key).value_or("");
            else if (key == "hints")
                m_course.hints = int(m_values.wholeNumber(*entry.node, key, 0, 3).value_or(3));
            else if (key == "most_mb")
                m_course.mostBytes =
                    std::size_t(m_values.wholeNumber(*entry.node, key, 1, kMostMb).value_or(1)) * 1000 * 1000;
            else if (key == "task")
                for (const toml::table* task : m_values.tables(*entry.node, key, kMostTasks)) readTask(*task);
            else
                m_values.unknown(*entry.key, key, std::array<std::string, 4>{"title", "hints", "most_mb", "task"});
            if (m_stop.stop_requested()) return pipeline::Error{{}, "cancelled", {}};
        }
        if (m_course.tasks.empty()) m_values.fail(table.source(), "there is no task", "[[task]] with scene and points");
        if (const Errors errors = m_values.errors(); !errors.empty()) return errors;
        if (m_course.tasks.size() == 1 && m_course.tasks[0].folder == m_course.tasks[0].name && !m_namesFolder)
            m_course.tasks[0].folder.clear();
        return std::move(m_course);
    }

private:
    void readTask(const toml::table& table) {
        Course::Task task;
        std::string scene;
        const toml::node* sceneNode = &table;
        std::vector<std::string> set;
        const toml::table* points = nullptr;
        const std::array<std::string, 5> known{"name", "scene", "set", "folder", "points"};
        for (const TomlEntry& entry : pipeline::inFileOrder(table)) {
            const std::string key(entry.key->str());
            const auto plain = [&](std::string& to) {
                const auto name = m_values.name(*entry.node, key);
                if (name && !isPlainName(*name))
                    m_values.refuse(*entry.node, key,
                                    "letters, digits, - and _, at most 40, and none of index, results and marks");
                else if (name)
                    to = *name;
            };
            if (key == "name")
                plain(task.name);
            else if (key == "folder")
                plain(task.folder), m_namesFolder = true;
            else if (key == "scene")
                scene = m_values.name(*entry.node, key).value_or(""), sceneNode = entry.node;
            else if (key == "set")
                readSet(*entry.node, set);
            else if (key == "points")
                points = m_values.table(*entry.node, key);
            else if (key == "stage")
                return m_values.fail(entry.key->source(), "tasks that run a program, with stage, cannot be marked yet",
                                     "a task that compares files");
            else
                m_values.unknown(*entry.key, key, known);
        }
        if (task.name.empty() || scene.empty() || !points)
            return m_values.fail(table.source(), "the task lacks a name, a scene or points", "all three");
        if (task.folder.empty()) task.folder = task.name;
        if (std::ranges::find(m_course.tasks, task.name, &Course::Task::name) != m_course.tasks.end())
            return m_values.fail(table.source(), "two tasks are called " + task.name, "a name for each");
        readScene(scene, *sceneNode, set, task);
        if (task.scene) readPoints(*points, task);
        m_course.tasks.push_back(std::move(task));
    }

    void readSet(const toml::node& node, std::vector<std::string>& set) {
        const toml::array* const array = node.as_array();
        if (!array) return m_values.refuse(node, "set", "an array of strings: [\"shading=phong\"]");
        for (const toml::node& one : *array)
            if (const auto text = m_values.text(one, "set")) set.push_back(*text);
    }

    void readScene(const std::string& name, const toml::node& node, const std::vector<std::string>& set,
                   Course::Task& task) {
        auto scene = sceneOfLesson(name, m_folder, m_stop);
        for (const std::string& assignment : set)
            if (scene) scene = withSetting(std::move(scene).value(), assignment);
        Errors errors = scene ? checkScene(*scene) : scene.errors();
        if (errors.empty()) {
            pipeline::FrameRequest request;
            for (const auto& row : pipeline::foreign::toleranceTable()) request.wanted.set(index(row.buffer));
            errors = checkMemory(*scene, request.wanted, request.until);
        }
        for (pipeline::Error& error : errors)
            if (error.where.file.empty()) error.where = m_values.place(node.source());
        m_values.add(errors);
        if (errors.empty()) task.scene = std::make_shared<const pipeline::Scene>(std::move(scene).value());
    }

    void readPoints(const toml::table& table, Course::Task& task) {
        for (const TomlEntry& entry : pipeline::inFileOrder(table)) {
            const std::string name(entry.key->str());
            const auto points = m_values.number(*entry.node, "points." + name, 0, kMostCheckPoints);
            Course::Check check{name, pipeline::findStage(name), {}, points.value_or(0)};
            if (!check.stage) {
                const auto buffer = pipeline::foreign::findHanded(name, task.scene->lights.size());
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
    for (const Course::Task& task : read.tasks) read.key += bytesOf(*task.scene);
    read.key = pipeline::sha256Of(read.key);
    return read;
}

}  // namespace lessons
