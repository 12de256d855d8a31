#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/formats/text/line_scanner.h"

namespace pipeline {

enum class PlyForm : std::uint8_t { Text, LittleEndian, BigEndian };
enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float, Double };
std::size_t byteCount(PlyType type);

// What a property is to a mesh.
enum class PlyRole : std::uint8_t { X, Y, Z, NormalX, NormalY, NormalZ, Red, Green, Blue, Corners, Other };

struct PlyProperty {
    std::string name{};
    PlyType type = PlyType::Float;
    bool isList = false;
    PlyType countType = PlyType::Uint8;  // of a list's length
    PlyRole role = PlyRole::Other;
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;  // not yet compared with the file's size
    std::vector<PlyProperty> properties{};
};

struct PlyHeader {
    PlyForm form = PlyForm::Text;
    std::vector<PlyElement> elements;
    std::size_t unknownLines = 0;
    int firstUnknown = 0;  // its line
};

// What polygons are made of: "face", each row one, or "tristrips" (also "tristrip"), each row strips of triangles of
// which -1 begins the next one.
inline bool isStrips(const PlyElement& element) { return element.name == "tristrips" || element.name == "tristrip"; }
inline bool hasPolygons(const PlyElement& element) { return element.name == "face" || isStrips(element); }

// From "ply" to "end_header"; whatever is wrong is reported. There is an element vertex with
// x, y, z, and after it one with polygons that has a list of corners.
PlyHeader readPlyHeader(LineScanner& scanner);

}  // namespace pipeline
