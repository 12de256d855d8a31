#include "tests/support/gltf_files.h"

#include <fmt/format.h>

namespace test {

std::string base64(const std::string& bytes) {
    static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

std::string dataUri(const std::string& bytes) { return "data:application/octet-stream;base64," + base64(bytes); }

Parts squareParts() {
    return {
        {"asset", R"({"version": "2.0"})"},
        {"scenes", R"([{"nodes": [0]}])"},
        {"nodes", R"([{"name": "square", "mesh": 0}])"},
        {"meshes", R"([{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])"},
        {"accessors", R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                              {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
                              {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC3"}])"},
        {"bufferViews", R"([{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12},
                                {"buffer": 0, "byteOffset": 60, "byteLength": 48}])"},
        {"buffers", fmt::format(R"([{{"byteLength": 108, "uri": "{}"}}])", dataUri(kSquare + kIndices + kNormals))}};
}

std::string fileOf(const Parts& parts) {
    std::string text;
    for (const auto& [key, json] : parts)
        if (!json.empty()) text += fmt::format("{}\"{}\": {}", text.empty() ? "{" : ",\n", key, json);
    return text + "}";
}
std::string fileOf(const std::string& part, const std::string& json) {
    Parts parts = squareParts();
    parts[part] = json;
    return fileOf(parts);
}

std::string glbOf(const std::vector<std::pair<std::string, std::string>>& chunks) {
    std::string body;
    for (const auto& [type, content] : chunks)
        body += bytesOf<std::uint32_t>({static_cast<std::uint32_t>(content.size())}) + type + content;
    return "glTF" + bytesOf<std::uint32_t>({2, static_cast<std::uint32_t>(12 + body.size())}) + body;
}

pipeline::FileLoader filesOf(std::map<std::string, std::string, std::less<>> files) {
    return [files = std::move(files)](std::string_view name) -> pipeline::Result<pipeline::NamedFile> {
        const auto file = files.find(name);
        if (file == files.end()) return pipeline::Error{{}, fmt::format("\"{}\": no such file", name), {}};
        return pipeline::NamedFile{file->second, file->first};
    };
}

}  // namespace test
