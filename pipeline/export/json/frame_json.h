#pragma once
#include "pipeline/export/json/json.h"
#include "pipeline/scene/settings_table.h"

namespace pipeline {

// What a program that holds scenes and frames is told of them, as JSON: live pages and the Python module.

// {"errors": [{file, line, column, found, expected, keys, text}]}
Json errorsToJson(const Errors& errors);
// A setting with its value, range, choices and meaning; "idle": why it has no effect, or empty.
Json settingToJson(const SettingRef& ref, const Scene& scene);
// stage: the word for it. useless: why the scene has no use for the buffer, or empty.
Json bufferToJson(const BufferName& name, std::string_view stage, std::string_view useless);
// The plan with what each stage did, its time and the frame's, in milliseconds, and the remarks.
Json planToJson(const Frame& frame);
// The vertices of every polygon, over all objects, and the object of each.
Json meshToJson(const Frame& frame);

}  // namespace pipeline
