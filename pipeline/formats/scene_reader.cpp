#include "pipeline/formats/scene_reader.h"

#include <new>

#include "pipeline/formats/format_table.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/no_memory.h"
#include "pipeline/formats/text_scanner.h"
#include "pipeline/scene/settings_table.h"

namespace pipeline {
namespace {

Errors inFile(Errors errors, const std::string& file) {
    for (Error& error : errors)
        if (error.where.file.empty()) error.where.file = file;
    return errors;
}

// Spares reading a large file that cannot be a scene.
bool beginsWithEndlessWord(std::string_view start) {
    Errors none;
    return TextScanner(start, {}, none).next().size() > kMaxWord;
}

Error refused(SourceLocation where, std::string found) { return {std::move(where), std::move(found), knownFormats()}; }

Result<Scene> readUnchecked(const std::filesystem::path& file, const ReadProgress& progress) {
    const std::string name = file.string();
    const Result<NamedFile> opened = openFile(file);
    if (!opened) return opened.errors();
    const std::string& start = opened->text;
    const Format* format = findFormat(start, file.extension().string());
    if (!format) return refused({name, 0, 0}, "found no scene");
    if (isModel(file.extension().string()))
        return format->read({start, name, progress, opened->tail}, filesBeside(file));
    if (!format->looksLike(start) && beginsWithEndlessWord(start))
        return refused({name, 1, 1}, "found a word of more than " + groupedDigits(kMaxWord) + " bytes");
    const Result<std::string> text = wholeText({start, name, progress, opened->tail});
    if (!text) return text.errors();
    return format->read({*text, name, progress}, filesBeside(file));
}

}  // namespace

Result<Scene> readScene(const std::filesystem::path& file, const ReadProgress& progress) {
    const std::string name = file.string();
    try {
        Result<Scene> result = readUnchecked(file, progress);
        if (!result) return inFile(result.errors(), name);
        Scene scene = std::move(result).value();
        if (scene.name.empty()) scene.name = printableText(file.filename().string());
        scene.file = name;
        const Errors errors = checkScene(scene);
        if (!errors.empty()) return inFile(errors, name);
        return scene;
    } catch (const std::bad_alloc&) {
        return noMemoryToRead({name, 0, 0}, "scene");
    }
}

}  // namespace pipeline
