#include "pipeline/stages/transform.h"

#include <algorithm>
#include <cmath>

#include "pipeline/core/angles.h"
#include "pipeline/core/numerics.h"
#include "pipeline/scene/opacity.h"

namespace pipeline {

namespace {

// glRotate's matrix: c I + (1 - c) a aᵀ + s [a]×, with the unit axis a.
// OpenGL 2.1 specification, section 2.11.2.
glm::dmat3 aboutAxis(const AxisTurn& turn) {
    const double s = sinDegrees(turn.angle), c = cosDegrees(turn.angle);
    const Vec3d a = normalized(turn.axis);
    const glm::dmat3 cross{{0, a.z, -a.y}, {-a.z, 0, a.x}, {a.y, -a.x, 0}};  // glm takes columns
    return c * glm::dmat3(1.0) + (1 - c) * glm::outerProduct(a, a) + s * cross;
}

}  // namespace

ObjectMatrix makeObjectMatrix(const ObjectTransform& t) {
    const Vec3d sin{sinDegrees(t.rotation.x), sinDegrees(t.rotation.y), sinDegrees(t.rotation.z)};
    const Vec3d cos{cosDegrees(t.rotation.x), cosDegrees(t.rotation.y), cosDegrees(t.rotation.z)};
    // glm takes columns.
    const glm::dmat3 scale{{t.scale.x, 0, 0}, {0, t.scale.y, 0}, {0, 0, t.scale.z}};
    const glm::dmat3 aboutX{{1, 0, 0}, {0, cos.x, sin.x}, {0, -sin.x, cos.x}};
    const glm::dmat3 aboutY{{cos.y, 0, -sin.y}, {0, 1, 0}, {sin.y, 0, cos.y}};
    const glm::dmat3 aboutZ{{cos.z, sin.z, 0}, {-sin.z, cos.z, 0}, {0, 0, 1}};
    glm::dmat3 rotation = aboutZ * aboutY * aboutX;
    if (!t.turns.empty()) rotation = glm::dmat3(1.0);
    for (const AxisTurn& turn : t.turns) rotation = rotation * aboutAxis(turn);
    // The sign of the determinant from the factors: their product may underflow.
    const bool mirrors = (t.scale.x < 0) != ((t.scale.y < 0) != (t.scale.z < 0));
    const glm::dmat3 linear = rotation * scale;
    // The columns are where the mesh's axes go: upright, y goes where z went, and z where -y did.
    if (t.up == UpAxis::Y) return {{linear[0], linear[2], 0.0 - linear[1]}, t.translation, mirrors};
    return {linear, t.translation, mirrors};
}

Vec3d toWorld(const ObjectMatrix& matrix, Vec3d position) { return matrix.linear * position + matrix.translation; }

glm::dmat3 normalMatrix(const ObjectMatrix& matrix, NormalMatrixForm form) {
    if (form == NormalMatrixForm::InverseTranspose) return glm::transpose(glm::inverse(matrix.linear));
    // Scaled by a power of two first: products of two entries stay in range. To between 1 and 2, that of a rotation is the
    // rotation.
    double largest = 0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, largestComponent(matrix.linear[c]));
    int exponent = 0;
    std::frexp(largest, &exponent);
    const glm::dmat3 m = matrix.linear * std::ldexp(1.0, 1 - exponent);
    const double sign = matrix.mirrors ? -1 : 1;
    return {sign * glm::cross(m[1], m[2]), sign * glm::cross(m[2], m[0]), sign * glm::cross(m[0], m[1])};
}

TransformInputs transformInputs(const Scene& scene, std::shared_ptr<const Topology> topology, bool placesAsGiven) {
    TransformInputs inputs{std::move(topology),
                           {},
                           makeView(scene),
                           scene.settings.depthFormat,
                           transparentObjects(scene),
                           scene.settings.forms.normalMatrix,
                           placesAsGiven};
    for (const Object& object : scene.objects) inputs.transforms.push_back(object.transform);
    return inputs;
}

template <class Real>
TransformOutput<Real> prepareTransform(const TransformInputs& inputs) {
    TransformOutput<Real> out;
    out.topology = inputs.topology;
    out.view = inputs.view;
    out.depthFormat = inputs.depthFormat;
    out.transparent = inputs.transparent;
    for (const ObjectTransform& t : inputs.transforms) {
        const ObjectMatrix matrix = makeObjectMatrix(t);
        out.mirrored.push_back(matrix.mirrors);
        out.normalMatrix.push_back(normalMatrix(matrix, inputs.normalMatrix));
    }
    const std::size_t count = inputs.topology->vertexCount();
    out.done = count;
    if (inputs.placesAsGiven) {
        const std::shared_ptr<const Mesh>& mesh = inputs.topology->meshes[0];
        out.world.give(mesh, mesh->positions.in<Real>());
    } else {
        out.world.makeOwn(count);
    }
    return out;
}

template <class Real>
void transform(const TransformInputs& inputs, std::size_t object, std::size_t begin, std::size_t end,
               TransformOutput<Real>& out) {
    if (out.world.areGiven()) return;
    const ObjectMatrix matrix = makeObjectMatrix(inputs.transforms[object]);
    const glm::mat<3, 3, Real> linear(matrix.linear);
    const Vec3<Real> translation(matrix.translation);
    const VertexVectors& positions = inputs.topology->meshes[object]->positions;
    const std::size_t first = inputs.topology->firstVertex[object];

    const std::span<Vec3<Real>> world = out.world.own().subspan(first);
    for (std::size_t i = begin; i < end; ++i) world[i] = linear * Vec3<Real>(positions[i]) + translation;
}

template <class Real>
std::vector<Vec3<Real>> viewPlaces(const TransformOutput<Real>& in) {
    std::vector<Vec3<Real>> places(in.world.size(), Vec3<Real>(0));
    for (std::size_t i = 0; i < in.done; ++i) places[i] = in.viewSpace(i);
    return places;
}

template <class Real>
std::vector<Vec3<Real>> screenPlaces(const TransformOutput<Real>& in) {
    const View& view = in.view;
    const Vec2<Real> scale(view.scale), centre(view.centre);
    const DepthCode depth(view, in.depthFormat);
    std::vector<Vec3<Real>> places(in.world.size(), Vec3<Real>(Real(kNoScreenPosition)));
    for (std::size_t i = 0; i < in.done; ++i) {
        const Vec3<Real> v = in.viewSpace(i);
        if (view.perspective && !(v.z > 0)) continue;
        const Real spread = view.perspective ? v.z : Real(1);
        const AtLeastDouble<Real> z(v.z);
        const Vec3<Real> screen{centre.x + scale.x * v.x / spread, centre.y - scale.y * v.y / spread,
                                depth.format == DepthFormat::Linear ? v.z : Real(depth.encode(z, 1 / z))};
        // Where near and far planes leave no depth there is no position either.
        if (isfinite(screen.x) && isfinite(screen.y) && isfinite(screen.z)) places[i] = screen;
    }
    return places;
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                \
    template TransformOutput<Real> prepareTransform(const TransformInputs&);                                        \
    template void transform(const TransformInputs&, std::size_t, std::size_t, std::size_t, TransformOutput<Real>&); \
    template std::vector<Vec3<Real>> viewPlaces(const TransformOutput<Real>&);                                      \
    template std::vector<Vec3<Real>> screenPlaces(const TransformOutput<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
