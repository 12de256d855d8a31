#include "pipeline/plan/as_given.h"

#include "pipeline/core/numerics.h"
#include "pipeline/stages/transform.h"

namespace pipeline {
namespace {

// The mesh of the only object, if its matrix is the identity; else null.
const Mesh* onlyUnmovedMesh(const Scene& scene) {
    if (scene.objects.size() != 1) return nullptr;
    const ObjectMatrix matrix = makeObjectMatrix(scene.objects[0].transform);
    const bool isIdentity = matrix.linear == glm::dmat3(1.0) && matrix.translation == Vec3d(0);
    return isIdentity ? scene.objects[0].mesh.get() : nullptr;
}

bool areIn(Precision precision, const VertexVectors& vectors) {
    switch (precision) {
        case Precision::Float: return !vectors.floats().empty();
        case Precision::Double: return !vectors.doubles().empty();
        case Precision::Extended:
        case Precision::Quad: return false;
    }
    return false;
}

}  // namespace

std::string whyPlacesStay(const Scene& scene) {
    const Mesh* const mesh = onlyUnmovedMesh(scene);
    if (!mesh || !areIn(scene.settings.precision, mesh->positions)) return {};
    return "Its matrix is the identity: the mesh's own vertices are in world space.";
}

std::string whyNormalsStay(const Scene& scene) {
    const Settings& settings = scene.settings;
    if (settings.normalWeight != NormalWeight::Given) return {};
    if (settings.forms.unit != UnitForm::Scaled) return {};  // the others are shown at work
    const Mesh* const mesh = onlyUnmovedMesh(scene);
    if (!mesh || !areIn(settings.precision, mesh->normals)) return {};
    const double most = settings.precision == Precision::Float ? kOffUnit<float> : kOffUnit<double>;
    if (!mesh->facts.ownNormals || !(mesh->facts.offUnit <= most)) return {};
    return "The matrix is the identity, and every normal of the mesh has length 1.";
}

}  // namespace pipeline
