#include "pipeline/plan/as_given.h"

#include "pipeline/core/numerics.h"
#include "pipeline/stages/transform.h"

namespace pipeline {
namespace {

bool isIdentity(const ObjectTransform& transform) {
    const ObjectMatrix matrix = makeObjectMatrix(transform);
    return matrix.linear == glm::dmat3(1.0) && matrix.translation == Vec3d(0);
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
    if (scene.objects.size() != 1) return {};
    const Object& object = scene.objects[0];
    if (!areIn(scene.settings.precision, object.mesh->positions) || !isIdentity(object.transform)) return {};
    return "Its matrix is the identity: the mesh's own vertices are in world space.";
}

std::string whyNormalsStay(const Scene& scene) {
    const Settings& settings = scene.settings;
    if (scene.objects.size() != 1 || settings.normalWeight != NormalWeight::Given) return {};
    if (settings.forms.unit != UnitForm::Scaled) return {};  // the others are shown at work
    const Object& object = scene.objects[0];
    const MeshFacts& facts = object.mesh->facts;
    const double most = settings.precision == Precision::Float ? kOffUnit<float> : kOffUnit<double>;
    if (!areIn(settings.precision, object.mesh->normals) || !isIdentity(object.transform)) return {};
    if (!facts.ownNormals || !(facts.offUnit <= most)) return {};
    return "The matrix is the identity, and every normal of the mesh has length 1.";
}

}  // namespace pipeline
