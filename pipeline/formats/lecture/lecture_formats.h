#pragma once
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Lecture 1's text formats: numbers and names in a fixed order, as its two examples show them.
//
// Scene description:
//     d, rho, theta, phi
//     number of objects; for each: file name, scale x y z, rotation x y z, translation x y z
//     number of lights; for each: x, y, z, intensity
//     intensity of the ambient light
// Lights are at infinity and white. Object description:
//     number of vertices, number of polygons
//     for each vertex: x, y, z
//     for each polygon: number of vertices, their indices from 0
//     k_r, k_g, k_b, k_s, n

struct ObjectDescription {
    Mesh mesh;  // before makeMesh
    Material material;
};
// Errors are appended to `errors` until there are kMaxErrors; only without any is the
// description of use.
ObjectDescription readObjectDescription(const SourceText& source, Errors& errors);

// Object descriptions that the scene names come from `load`.
Result<Scene> readLectureScene(const SourceText& source, const FileLoader& load);

// An object description as a scene: the object around the world's origin, seen from the
// direction of the lecture's example so that all of it shows, with one light.
Result<Scene> readLectureObject(const SourceText& source, const FileLoader& load);

// Whether the first bytes of a file could be one of the two.
bool looksLikeLectureScene(std::string_view start);
bool looksLikeLectureObject(std::string_view start);

}  // namespace pipeline
