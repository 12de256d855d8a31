#include "lessons/library.h"

#include <algorithm>
#include <system_error>

#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/scene/key_places.h"
#include "pipeline/scene/mesh/same_shapes.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::inQuotes;
using pipeline::Result;

constexpr const char* kFile = "lesson.md";
constexpr std::size_t kMaxLessonBytes = std::size_t{1} << 20;

// Each lesson before the one that it names as the next; those that no other names come first.
std::vector<Lesson> inOrder(std::vector<Lesson> lessons) {
    std::vector<Lesson> ordered;
    const auto take = [&](std::vector<Lesson>::iterator from) {
        while (from != lessons.end()) {
            const std::string next = from->next;
            ordered.push_back(std::move(*from));
            lessons.erase(from);
            from = std::ranges::find(lessons, next, &Lesson::name);
        }
    };
    const auto isFirst = [&](const Lesson& lesson) {
        return std::ranges::find(lessons, lesson.name, &Lesson::next) == lessons.end();
    };
    while (!lessons.empty()) {
        const auto first = std::ranges::find_if(lessons, isFirst);
        take(first != lessons.end() ? first : lessons.begin());  // a circle begins anywhere
    }
    return ordered;
}

std::filesystem::path sheetFolder() { return pipeline::resourceFolder() / "sheets"; }

// The folders with a lesson in them, sorted.
std::vector<std::string> namesIn(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    std::error_code ignored;  // a folder that cannot be listed has no lessons
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (std::filesystem::exists(entry.path() / kFile, ignored)) names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

}  // namespace

// Where the program is installed the lessons stand among its resources, in the source tree beside them.
std::filesystem::path lessonFolder() {
    const std::filesystem::path resources = pipeline::resourceFolder();
    std::error_code ignored;
    const std::filesystem::path inside = resources / "lessons";
    return std::filesystem::is_directory(inside, ignored) ? inside : resources.parent_path() / "lessons";
}

std::vector<std::string> lessonNames() { return namesIn(lessonFolder()); }

std::vector<std::string> sheetTemplateNames() { return namesIn(sheetFolder()); }

std::filesystem::path sheetTemplateAt(const std::filesystem::path& path) {
    std::filesystem::path folder = lessonAt(path);
    if (folder.empty() && !path.has_parent_path()) folder = lessonAt(sheetFolder() / path);
    return folder;
}

Result<pipeline::Scene> sceneOfLesson(std::string_view name, const std::filesystem::path& folder,
                                      const pipeline::Stop& stop) {
    if (const auto scene = pipeline::builtInScene(name)) return pipeline::readScene(scene->file, {{}, stop});
    const std::filesystem::path file = std::filesystem::path(name).filename();  // of this folder alone
    std::error_code ignored;
    if (file == name && std::filesystem::is_regular_file(folder / file, ignored)) {
        const auto inside = pipeline::pathInFolder(folder, name, "lesson");
        return inside ? pipeline::readScene(folder / file, {{}, stop}) : inside.errors();
    }
    std::vector<std::string> names;
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes()) names.push_back(scene.name);
    return Error{{}, "no scene " + inQuotes(name) + "; " + pipeline::insteadOf(name, names), {}};
}

Result<LessonText> lessonText(const std::filesystem::path& folder, const pipeline::Stop& stop) {
    const std::filesystem::path file = folder / kFile;
    const auto text = pipeline::readFile(file, kMaxLessonBytes);
    if (!text) return pipeline::namedAt({file.string()}, text.errors());
    return LessonText{pipeline::escapedControls(*text), file.string(), folder,
                      [folder, stop](std::string_view name) { return sceneOfLesson(name, folder, stop); }};
}

Result<LessonText> otherLesson(std::string_view name, const pipeline::Stop& stop) {
    const std::vector<std::string> names = lessonNames();
    if (std::ranges::find(names, name) != names.end()) return lessonText(lessonFolder() / name, stop);
    return Error{{}, "no lesson " + inQuotes(name) + "; " + pipeline::insteadOf(name, names), {}};
}

namespace {

Lesson named(Lesson lesson, const std::filesystem::path& folder) {
    std::error_code ignored;
    const std::filesystem::path whole = std::filesystem::absolute(folder, ignored).lexically_normal();  // "." and "x/"
    lesson.folder = folder;
    lesson.name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
    return lesson;
}

Library libraryOf(Result<Lesson> (*read)(const std::filesystem::path& folder, const pipeline::Stop& stop)) {
    Library library;
    for (const std::string& name : lessonNames()) {
        auto lesson = read(lessonFolder() / name, {});
        if (lesson)
            library.lessons.push_back(std::move(lesson).value());
        else
            library.errors.insert(library.errors.end(), lesson.errors().begin(), lesson.errors().end());
    }
    library.lessons = inOrder(std::move(library.lessons));
    return library;
}

}  // namespace

Result<Lesson> readOutline(const std::filesystem::path& folder, const pipeline::Stop& stop) {
    const auto text = lessonText(folder, stop);
    if (!text) return text.errors();
    auto lesson = parseOutline(text->text, text->file);
    return lesson ? Result<Lesson>(named(std::move(lesson).value(), folder)) : lesson;
}

Result<Lesson> readLesson(const std::filesystem::path& folder, const pipeline::Stop& stop) {
    const auto text = lessonText(folder, stop);
    if (!text) return text.errors();
    auto lesson = parseLesson(text->text, text->file, text->sceneNamed,
                              [&](std::string_view name) { return otherLesson(name, stop); });
    return lesson ? Result<Lesson>(named(std::move(lesson).value(), folder)) : lesson;
}

Library allOutlines() { return libraryOf(readOutline); }

Library allLessons() {
    // Expressions that change an object's tessellation are checked in the scene as changed, one after the other.
    const pipeline::SameShapes shapes;
    return libraryOf(readLesson);
}

pipeline::Result<Lesson> findLesson(std::string_view name, const pipeline::Stop& stop) {
    const std::vector<std::string> names = lessonNames();
    if (std::ranges::find(names, name) != names.end()) return readLesson(lessonFolder() / name, stop);
    if (const std::filesystem::path folder = lessonAt(name); !folder.empty()) return readLesson(folder, stop);
    return pipeline::Error{{}, "no lesson " + pipeline::inQuotes(name) + "; " + pipeline::insteadOf(name, names), {}};
}

std::filesystem::path lessonAt(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::exists(path / kFile, ignored)) return path;
    if (path.filename() != kFile || !std::filesystem::exists(path, ignored)) return {};
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

}  // namespace lessons
