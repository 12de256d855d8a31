#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/formats/obj/obj_materials.h"
#include "pipeline/formats/text/tally.h"
#include "pipeline/scene/mesh/mesh.h"

// An OBJ file as it is written, before its objects have meshes.
namespace pipeline {

inline constexpr std::uint32_t kNoNormal = UINT32_MAX;

struct ObjCorner {
    std::uint32_t position, normal;  // from 0; kNoNormal where it has none
};

// How the normals of a group's corners are numbered. Most files give none, or a normal with every position.
enum class NormalNumbers : std::uint8_t { None, AsPositions, Own };

// Nobody knows how many there will be, and a vector that grows by copying holds up to three times what is in it.
struct ObjFaces {
    std::deque<std::uint32_t> positions;  // per corner
    NormalNumbers numbers = NormalNumbers::None;
    std::deque<std::uint32_t> normals;  // per corner, of numbers Own; kNoNormal where one has none
    std::deque<std::uint32_t> firstCorner{0};
    std::deque<TextPosition> places;
    // The smoothing group of the faces from `first` on; 0: off, as before the first of these.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> smoothing;

    std::size_t count() const { return places.size(); }
    bool haveNormals() const;
    std::uint32_t normal(std::size_t corner) const;
    void addCorner(const ObjCorner& corner);
    void dropCorners(std::size_t first);
    void endFace(const TextPosition& place, std::uint32_t smoothingGroup);
};

// Faces of one object with one material.
struct ObjGroup {
    std::size_t object = 0;
    std::string name, material;
    ObjFaces faces;
};

// What the file has and the reader leaves out or treats otherwise.
struct ObjTallies {
    CaseTally badNormals, unknownNormals, fewCorners, badColors, points, lines, freeForms, calls, unknownStatements,
        furtherGroups;
    std::string firstUnknown;
};

struct ObjFile {
    VertexVectors positions, normals;  // a normal without direction is (0, 0, 0)
    VertexVectors colors;              // of the first positions; empty where no vertex has one
    std::vector<ObjGroup> groups;
    bool smooths = false;  // a face has a smoothing group
    ObjTallies tallies;
};

// Reads all of it; materials go to the library.
ObjFile parseObj(const SourceText& source, ObjMaterials& materials, Errors& errors);

}  // namespace pipeline
