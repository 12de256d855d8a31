#pragma once
#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/remark.h"

namespace pipeline {

// What is said of a file once, with the number of things that it is said of.
struct GltfRemark {
    std::string text;       // a sentence
    std::string_view noun;  // of what is counted, "node"; empty: nothing is
    std::size_t count = 1;
    std::string consequence{};  // of dropErrors
};

// A glTF file whose JSON has been parsed; nothing of what it says has been checked.
struct GltfFile {
    std::string name, meshFile;                // Mesh::file of its meshes
    nlohmann::json json;                       // an object
    std::optional<std::string_view> binary{};  // the BIN chunk of a .glb, bytes of the source
    Errors errors{};                           // at most kMaxErrors
    std::vector<GltfRemark> remarks{};
    bool doubleSided = false;  // a material that is drawn is
    StopCheck check{Stop()};   // of the reading; loops over what the file holds ask it
};

// Parses a .gltf or a .glb, which its first bytes tell apart. JSON that nests more than 64 deep or
// has more than 4 194 304 values is refused before it is parsed: a parser may recurse, and a value
// takes many times the memory of its text.
Result<GltfFile> parseGltf(const SourceText& source);

// Adds a remark about the file, or counts one more of its kind.
void remark(GltfFile& file, std::string text, std::string_view noun = {});
std::vector<Remark> remarksOf(const GltfFile& file);
// Takes back the errors from that one on, for the geometry does not depend on what they are about: the first of them
// becomes a remark, with what follows from it.
void dropErrors(GltfFile& file, std::size_t from, std::string_view consequence, std::string_view noun);

// A value of the file with its JSON pointer (RFC 6901), or nothing. What is not as it must be is
// reported as "/accessors/3/count is -1, expected …".
class GltfValue {
public:
    explicit GltfValue(GltfFile& file) : m_file(&file), m_json(&file.json) {}

    bool isThere() const { return m_json != nullptr; }
    const std::string& pointer() const { return m_pointer; }
    GltfFile& file() const { return *m_file; }

    // A member; nothing where there is none. One of something that is no object is reported.
    GltfValue operator[](std::string_view key) const;
    // Elements; 0 for nothing. Something that is no array is reported.
    std::size_t size() const;
    GltfValue at(std::size_t index) const;  // index < size()

    // Nothing for a value that is not there, and for a wrong one.
    std::optional<std::uint64_t> whole(std::uint64_t min, std::uint64_t max) const;
    std::optional<double> number(double min, double max) const;
    // As many numbers as `values` holds, which stay as they are where the value is not there or wrong.
    bool numbers(std::span<double> values, double min, double max) const;
    std::optional<std::string_view> text() const;
    std::optional<bool> truth() const;
    // The element of `list`, an array at the file's root, that this value is the index of.
    std::optional<GltfValue> element(std::string_view list) const;

    // Reports "POINTER is VALUE" or "POINTER is missing".
    void refuse(std::string expected) const;
    void fail(std::string found, std::string expected = {}) const;

private:
    GltfValue(GltfFile& file, const nlohmann::json* json, std::string pointer)
        : m_file(&file), m_json(json), m_pointer(std::move(pointer)) {}

    GltfFile* m_file;
    const nlohmann::json* m_json;
    std::string m_pointer;
};

}  // namespace pipeline
