#pragma once
#include <string_view>

#include "pipeline/scene/settings_table.h"

// "vertex.OBJECT.NUMBER.x", y and z: where a vertex of an object is, in the object's own coordinates. They are no rows of
// the table and settingsOf() has none of them: there are as many as vertices. Setting one makes the object's mesh anew; from
// then on it is the scene's own, and neither of a file nor a built-in shape. Its normals stay as they were given.

namespace pipeline {

inline constexpr std::string_view kVertexPrefix = "vertex.";

// key: with the prefix.
Result<SettingRef> findVertexSetting(const Scene& scene, std::string_view key);
// Object and vertex of such a setting; nothing of any other.
struct VertexOfObject {
    std::size_t object = 0, vertex = 0;
};
std::optional<VertexOfObject> vertexOf(const SettingRef& ref);

}  // namespace pipeline
