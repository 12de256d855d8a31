#include "pipeline/run/frame.h"

#include <algorithm>
#include <type_traits>

#include "pipeline/run/frame_data.h"

namespace pipeline {
namespace {

// Wraps the memory of a buffer without copying it. Numbers with more digits than double are rounded to it.
template <class T>
AnyBuffer view(const BufferName& name, std::vector<std::size_t> shape, const T* data, std::size_t count,
               std::shared_ptr<const void> owner) {
    if constexpr (std::numeric_limits<T>::digits > 53) {
        auto rounded = std::make_shared<std::vector<double>>(count);
        for (std::size_t i = 0; i < count; ++i) (*rounded)[i] = static_cast<double>(data[i]);
        return view(name, std::move(shape), rounded->data(), count, rounded);
    } else {
        return {name, &bufferInfo(name.id), std::move(shape), std::span<const T>(data, count), std::move(owner)};
    }
}

// Takes over values that were computed for this request.
template <class T>
AnyBuffer own(const BufferName& name, std::vector<std::size_t> shape, std::vector<T> values) {
    const auto kept = std::make_shared<const std::vector<T>>(std::move(values));
    return view(name, std::move(shape), kept->data(), kept->size(), kept);
}

template <class Real>
AnyBuffer view(const BufferName& name, std::span<const Vec3<Real>> v, std::shared_ptr<const void> owner) {
    return view(name, {v.size(), 3}, v.empty() ? nullptr : &v[0].x, 3 * v.size(), std::move(owner));
}
template <class Real, class Allocator>
AnyBuffer view(const BufferName& name, const std::vector<Vec3<Real>, Allocator>& v, std::shared_ptr<const void> owner) {
    return view(name, std::span<const Vec3<Real>>(v), std::move(owner));
}
template <class Real>
AnyBuffer view(const BufferName& name, const Buffer2D<Vec3<Real>>& b, std::shared_ptr<const void> owner) {
    return view(name, {std::size_t(b.size.y), std::size_t(b.size.x), 3}, &b.pixels[0].x, 3 * b.pixels.size(),
                std::move(owner));
}
template <class T>
AnyBuffer view(const BufferName& name, const Buffer2D<T>& b, std::shared_ptr<const void> owner) {
    return view(name, {std::size_t(b.size.y), std::size_t(b.size.x)}, b.pixels.data(), b.pixels.size(),
                std::move(owner));
}

// Empty if the buffer was not kept.
template <class T>
std::optional<AnyBuffer> kept(const BufferName& name, const Buffer2D<T>& b, std::shared_ptr<const void> owner) {
    if (b.empty()) return {};
    return view(name, b, std::move(owner));
}

// object_id or polygon_id, from the visible triangle of each pixel.
template <class Real>
AnyBuffer ids(const BufferName& name, const FrameData<Real>& data) {
    const Topology& topology = *data.transform->topology;
    const Buffer2D<std::uint32_t>& seen = *data.zBuffer->triangle;
    std::vector<std::int32_t> values(seen.pixels.size(), kNothing);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (seen.pixels[i] == kNoTriangle) continue;
        const std::uint32_t polygon = topology.polygonOf(seen.pixels[i]);
        values[i] = std::int32_t(name.id == BufferId::PolygonId ? polygon : topology.objectOfPolygon(polygon));
    }
    return own(name, {std::size_t(seen.size.y), std::size_t(seen.size.x)}, std::move(values));
}

// In float if that holds the stored number, or if the run is in float. 32-bit fixed point needs a double.
template <class Real>
std::optional<AnyBuffer> depth(const BufferName& name, const FrameData<Real>& data) {
    if (data.keys.zBuffer.visibility != Visibility::ZBuffer) return {};
    const DepthFormat format = data.transform->depthFormat;
    if (format == DepthFormat::Linear) return view(name, *data.zBuffer->zView, data.zBuffer);
    const Buffer2D<double>& stored = data.zBuffer->depth;
    if (!std::is_same_v<Real, float> || format == DepthFormat::Fixed32) return view(name, stored, data.zBuffer);
    return own(name, {std::size_t(stored.size.y), std::size_t(stored.size.x)},
               std::vector<float>(stored.pixels.begin(), stored.pixels.end()));
}

// The faces of a light in sequence, sample by sample.
template <class Real>
std::optional<AnyBuffer> shadowDepth(const BufferName& name, const FrameData<Real>& data) {
    const auto& lights = data.shadowBuffer->lights;
    const auto k = std::size_t(name.light);
    if (k >= lights.size() || lights[k].empty()) return {};
    const std::vector<LateBuffer2D<Real>>& first = lights[k][0].depth;
    if (lights[k].size() == 1 && first.size() == 1) return view(name, *first[0], data.shadowBuffer);
    const std::size_t faces = lights[k].size() * first.size();
    std::vector<Real> values;
    values.reserve(faces * first[0]->pixels.size());
    for (const LightView<Real>& sample : lights[k])
        for (const LateBuffer2D<Real>& face : sample.depth)
            values.insert(values.end(), face->pixels.begin(), face->pixels.end());
    const glm::ivec2 size = first[0]->size;
    return own(name, {faces, std::size_t(size.y), std::size_t(size.x)}, std::move(values));
}

// Per polygon or vertex whether it has an intensity: it is evaluated, and the cull stage keeps it, or one of the
// polygons of the vertex. Null if all have one.
template <class Real>
std::shared_ptr<const std::vector<bool>> litElements(const FrameData<Real>& data, bool ofPolygons) {
    const auto& elements = ofPolygons ? data.shading->polygons : data.shading->vertices;
    if (!data.cull && elements.places.empty()) return nullptr;
    std::vector<bool> keeps(elements.count(), !data.cull);
    const Topology& topology = *data.transform->topology;
    for (std::size_t polygon = 0; data.cull && polygon < topology.polygonCount(); ++polygon) {
        if (!goesOn(data.cull->verdicts[polygon])) continue;
        const Topology::Corners corners = topology.corners(polygon);
        if (ofPolygons)
            keeps[polygon] = true;
        else
            for (std::size_t i = 0; i < corners.size(); ++i) keeps[corners[i]] = true;
    }
    for (std::size_t i = 0; i < keeps.size(); ++i) keeps[i] = keeps[i] && elements.isEvaluated(i);
    if (std::ranges::find(keeps, false) == keeps.end()) return nullptr;
    return std::make_shared<const std::vector<bool>>(std::move(keeps));
}

template <class Real>
std::optional<AnyBuffer> shaded(const BufferName& name, const FrameData<Real>& data) {
    const ShadingOutput<Real>& out = *data.shading;
    const auto k = std::size_t(std::max(0, name.light));
    if (name.id == BufferId::Color) {
        const Buffer2D<Color8>& b = out.color;
        return view(name, {std::size_t(b.size.y), std::size_t(b.size.x), 3}, &b.pixels[0].x, 3 * b.pixels.size(),
                    data.shading);
    }
    if (name.id == BufferId::Layers) {
        if (out.layers.empty()) return {};
        return view(name, out.layers, data.shading);
    }
    if (name.id == BufferId::PolygonsIntensity || name.id == BufferId::VerticesIntensity) {
        const auto& elements = name.id == BufferId::PolygonsIntensity ? out.polygons : out.vertices;
        if (elements.intensity.empty()) return {};
        const auto lit = litElements(data, name.id == BufferId::PolygonsIntensity);
        if (!lit && elements.places.empty()) return view(name, elements.intensity, data.shading);
        const auto all = std::make_shared<std::vector<Vec3<Real>>>(elements.count(), Vec3<Real>(0));
        for (std::size_t i = 0; i < all->size(); ++i)
            if (!lit || (*lit)[i]) (*all)[i] = elements.intensity[elements.placeOf(i)];
        AnyBuffer buffer = view(name, *all, all);
        buffer.hasValue = lit;
        return buffer;
    }
    const auto& vectors = out.vectors[index(name.id)];
    if (k < vectors.size()) return view(name, vectors[k], data.shading);
    const auto& scalars = out.scalars[index(name.id)];
    if (k < scalars.size()) return view(name, scalars[k], data.shading);
    return {};
}

template <class Real>
std::optional<AnyBuffer> find(const BufferName& name, const FrameData<Real>& data) {
    const BufferInfo& info = bufferInfo(name.id);
    if (!data.has(info.stage)) return {};
    using enum BufferId;
    switch (name.id) {
        case VerticesWorld: return view(name, data.transform->world.all(), data.transform);
        case VerticesView:
        case VerticesScreen: {
            const TransformOutput<Real>& in = *data.transform;
            const auto places = std::make_shared<const std::vector<Vec3<Real>>>(
                name.id == VerticesView ? viewPlaces(in) : screenPlaces(in));
            return view(name, *places, places);
        }
        case PolygonsVerdict: {
            static_assert(sizeof(Verdict) == 1);
            const auto& verdicts = data.cull->verdicts;
            return view(name, {verdicts.size()}, reinterpret_cast<const std::uint8_t*>(verdicts.data()),
                        verdicts.size(), data.cull);
        }
        case PolygonsNormal:
            if (data.normals->polygon.empty()) return {};
            return view(name, data.normals->polygon, data.normals);
        case VerticesNormal:
            if (data.normals->vertex.empty()) return {};
            return view(name, data.normals->vertex.all(), data.normals);
        case BufferId::ShadowBuffer: return shadowDepth(name, data);
        case Depth: return depth(name, data);
        case ZView: return view(name, *data.zBuffer->zView, data.zBuffer);
        case ObjectId:
        case PolygonId: return ids(name, data);
        case Barycentric: return kept(name, data.zBuffer->barycentric, data.zBuffer);
        case Overdraw: return kept(name, data.zBuffer->overdraw, data.zBuffer);
        case DepthWrites: return kept(name, data.zBuffer->depthWrites, data.zBuffer);
        default: return shaded(name, data);
    }
}

}  // namespace

const Plan& Frame::plan() const {
    std::call_once(m_explained, [this] { explain(*m_scene, m_needs, m_plan); });
    return m_plan;
}

std::optional<AnyBuffer> Frame::buffer(const BufferName& name) const {
    if (isDerived(name.id)) return {};
    const bool perLight = bufferInfo(name.id).perLight;
    if (perLight ? name.light < 0 || std::size_t(name.light) >= m_scene->lights.size() : name.light >= 0) return {};
    const std::scoped_lock lock(m_readMutex);
    if (const auto kept = std::ranges::find(m_read, name, &AnyBuffer::name); kept != m_read.end()) return *kept;
    std::optional<AnyBuffer> buffer = readStages(*this, [&](const auto& data) { return find(name, data); });
    if (buffer) m_read.push_back(*buffer);
    return buffer;
}

std::string Frame::whyAbsent(const BufferName& name) const {
    if (buffer(name)) return {};
    if (isDerived(name.id)) return "It was not derived.";
    const BufferInfo& info = bufferInfo(name.id);
    if (info.perLight && (name.light < 0 || std::size_t(name.light) >= m_scene->lights.size()))
        return "The scene has no light " + std::to_string(name.light) + ".";
    if (index(info.stage) > index(m_until)) return m_plan[index(info.stage)].why;
    if (name.id == BufferId::ShadowBuffer) return m_needs.of(Part::ShadowBuffer, std::size_t(name.light)).notBecause;
    const std::string useless = whyUseless(*m_scene, name.id);
    return useless.empty() ? "Nobody has asked for it yet." : useless;
}

std::vector<AnyBuffer> Frame::buffers() const {
    std::vector<AnyBuffer> found;
    for (const BufferName& name : allBuffers(m_scene->lights.size()))
        if (auto it = buffer(name)) found.push_back(std::move(*it));
    return found;
}

Frame::PolygonPlace Frame::placeOf(int polygon) const {
    const std::size_t object = m_topology->objectOfPolygon(std::size_t(polygon));
    return {object, std::size_t(polygon) - m_topology->firstPolygon[object]};
}

}  // namespace pipeline
