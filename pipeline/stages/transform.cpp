#include "pipeline/stages/transform.h"

#include <algorithm>
#include <cmath>

#include "pipeline/core/angles.h"
#include "pipeline/core/numerics.h"
#include "pipeline/scene/opacity.h"

namespace pipeline {

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
        if (inputs.planted) spoilNormalMatrix(inputs.planted, inputs.view, matrix, out.normalMatrix.back());
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
