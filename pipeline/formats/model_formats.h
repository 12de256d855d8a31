#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/formats/model_reader.h"

// What the readers of models share.
namespace pipeline {

// Coordinates of a model, in its own units: the squares of the stages stay finite.
inline constexpr double kFarthestVertex = 1e9;
inline bool isCoordinate(double value) { return value >= -kFarthestVertex && value <= kFarthestVertex; }

// Of a colour of a vertex.
inline bool isColor(double value) { return value >= 0 && value <= 1e6; }
// The colours of a file's vertices as meshes hold them. White alone is none. Where one is above 1 all were written up to
// 255, which a remark says.
void settleColors(VertexVectors& colors, const std::string& file, std::vector<Remark>& remarks);
// Where the file gives no material: the colours of vertices, if any, are k_d and k_a.
Material defaultMaterial(const Mesh& mesh);

// The direction of a vector of any length; nothing for one without length.
std::optional<Vec3d> unitVector(const Vec3d& vector);

// Adds a polygon of vertices that are known to exist. A vertex that is written twice in a row
// counts once, and what then has fewer than three corners has no area and is left out: false.
// `place` goes to Mesh::polygonPlaces unless its line is 0.
bool addPolygon(Mesh& mesh, std::span<const std::uint32_t> corners, TextPosition place = {});

// The remark that so many polygons of the file were left out by addPolygon; none of none. about: the file, or with
// ":LINE" where the first of them stands.
void remarkOnLeftOut(std::size_t polygons, const std::string& about, std::vector<Remark>& remarks);

// Leaves out the vertices that no polygon uses; the order of the others stays.
void dropUnusedVertices(Mesh& mesh);

// "bunny" of "models/bunny.obj", and "bunny.obj".
std::string stemOf(const std::string& path);
std::string fileNameOf(const std::string& path);
// Mesh::file of what a model holds.
std::string meshFileOf(const SourceText& source);

// Adds an object of this mesh, without the vertices that no polygon uses; none if the mesh has no polygon.
void addObject(Mesh mesh, const SourceText& source, std::string name, LoadedModel& model);

// A name from a file where a window can show it, else the other one.
std::string shownName(std::string_view name, const std::string& otherwise);

// One function for each format; readModel checks what they promise together.
Result<LoadedModel> readObj(const SourceText& source, const FileLoader& load);
Result<LoadedModel> readPly(const SourceText& source, const FileLoader& load);
Result<LoadedModel> readStl(const SourceText& source, const FileLoader& load);
Result<LoadedModel> readOff(const SourceText& source, const FileLoader& load);
Result<LoadedModel> readGltf(const SourceText& source, const FileLoader& load);  // .gltf and .glb

}  // namespace pipeline
