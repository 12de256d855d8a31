#pragma once
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/formats/scene_folder.h"

// glTF files put together from their members.
namespace test {

template <class T>
std::string bytesOf(std::initializer_list<T> values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), std::data(values), bytes.size());
    return bytes;
}

std::string base64(const std::string& bytes);
std::string dataUri(const std::string& bytes);

// Four corners of a square in the plane z = 0 of the file, its two triangles as indices, and normals.
inline const std::string kSquare = bytesOf<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
inline const std::string kIndices = bytesOf<std::uint16_t>({0, 1, 2, 0, 2, 3});
inline const std::string kNormals = bytesOf<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});

// A file that shows the square, as the JSON of each member; one that is empty is left out.
// Accessors: 0 the corners, 1 the indices, 2 the normals, which the square does not use.
using Parts = std::map<std::string, std::string>;
Parts squareParts();
std::string fileOf(const Parts& parts);
std::string fileOf(const std::string& part, const std::string& json);  // the square with one part changed

// A .glb of chunks: type and content.
inline const std::string kJson = "JSON", kBin = std::string("BIN\0", 4);
std::string glbOf(const std::vector<std::pair<std::string, std::string>>& chunks);

pipeline::FileLoader filesOf(std::map<std::string, std::string, std::less<>> files);

}  // namespace test
