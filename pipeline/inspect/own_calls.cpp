#include "pipeline/inspect/own_calls.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "pipeline/core/numerics.h"
#include "pipeline/defects/own_hooks.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/runner.h"

namespace pipeline {
namespace {

std::string keyOf(std::span<const double> in) {
    std::string bytes(in.size_bytes(), '\0');
    std::memcpy(bytes.data(), in.data(), in.size_bytes());
    return bytes;
}

// Calls of functions whose results the pipeline has no use for by themselves, read from a frame.
class CallsAlone {
public:
    CallsAlone(const Own& own, const Scene& scene, const FrameData<double>& data)
        : m_own(own),
          m_scene(scene),
          m_data(data),
          m_topology(*data.transform->topology),
          m_view(data.transform->view) {
        for (std::size_t v = 0; v < m_topology.vertexCount(); ++v) m_seen.push_back(data.transform->viewSpace(v));
    }

    void make() const {
        switch (m_own.function) {
            case OwnFunction::Cut: return cuts();
            case OwnFunction::SignedArea: return areas();
            case OwnFunction::ScaledNormal: return scaledNormals();
            case OwnFunction::NormalColor: return normalColors();
            case OwnFunction::Intensity: return intensities();
            case OwnFunction::IsPaintedFirst: return paintedFirst();
            default: return;
        }
    }

private:
    glm::dvec2 screen(std::size_t vertex) const {
        const Vec3d v = m_seen[vertex];
        return m_view.centre + m_view.scale * glm::dvec2(v.x, -v.y) / (m_view.perspective ? v.z : 1.0);
    }
    // The vertices of a polygon, counter-clockwise as seen from outside.
    std::vector<std::uint32_t> cornersOf(std::size_t polygon) const {
        const Topology::Corners corners = m_topology.corners(polygon);
        std::vector<std::uint32_t> out;
        for (std::size_t i = 0; i < corners.size(); ++i) out.push_back(corners[i]);
        if (m_data.transform->mirrored[m_topology.objectOfPolygon(polygon)]) std::ranges::reverse(out);
        return out;
    }
    bool isInFront(std::span<const std::uint32_t> corners) const {
        return std::ranges::all_of(corners, [&](std::uint32_t v) { return m_seen[v].z >= m_view.near; });
    }

    void cuts() const {
        for (std::size_t polygon = 0; polygon < m_topology.polygonCount(); ++polygon) {
            const auto corners = cornersOf(polygon);
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const Vec3d a = m_seen[corners[i]], b = m_seen[corners[(i + 1) % corners.size()]];
                if ((a.z - m_view.near) * (b.z - m_view.near) >= 0) continue;
                OwnCall call(m_own);
                call << a << b << m_view.near;
                call.result(OwnPlace::Polygon, polygon);
            }
        }
    }
    void areas() const {
        constexpr double kNoArea = 0.05;  // px²: rounding decides the sign
        for (std::size_t polygon = 0; polygon < m_topology.polygonCount(); ++polygon) {
            const auto corners = cornersOf(polygon);
            if (!isInFront(corners)) continue;
            double area = 0;
            OwnCall call(m_own);
            call << double(corners.size());
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const glm::dvec2 p = screen(corners[i]), q = screen(corners[(i + 1) % corners.size()]);
                area += p.x * q.y - q.x * p.y;
                call << p;
            }
            if (std::abs(area) / 2 > kNoArea) call.result(OwnPlace::Polygon, polygon);
        }
    }
    void scaledNormals() const {
        for (std::size_t o = 0; o < m_scene.objects.size(); ++o) {
            const ObjectTransform& t = m_scene.objects[o].transform;
            const Mesh& mesh = *m_topology.meshes[o];
            if (mesh.normals.empty() || t.rotation != Vec3d(0) || !t.turns.empty() || t.up != UpAxis::Z) continue;
            for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
                const Vec3d normal = normalized(mesh.normals[i]);
                if (normal == Vec3d(0)) continue;
                OwnCall call(m_own);
                call << normal << t.scale;
                call.result(OwnPlace::Vertex, m_topology.firstVertex[o] + i);
            }
        }
    }
    void normalColors() const {
        const auto& normals = m_data.shading->vectors[index(BufferId::Normal)];
        for (std::size_t i = 0; !normals.empty() && i < normals[0].pixels.size(); ++i) {
            if (m_data.zBuffer->triangle->pixels[i] == kNoTriangle || normals[0].pixels[i] == Vec3d(0)) continue;
            OwnCall call(m_own);
            call << normals[0].pixels[i];
            call.result(OwnPlace::Pixel, i);
        }
    }
    void intensities() const {
        const auto& lit = m_data.shading->vertices;
        const Buffer2D<std::uint32_t>& seen = *m_data.zBuffer->triangle;
        for (std::size_t i = 0; i < seen.pixels.size() && lit.count() > 0; ++i) {
            if (seen.pixels[i] == kNoTriangle) continue;
            const auto corners = cornersOf(m_topology.polygonOf(seen.pixels[i]));
            if (!isInFront(corners)) continue;
            const std::size_t n = corners.size();
            std::size_t top = 0;
            for (std::size_t k = 1; k < n; ++k)
                if (screen(corners[k]).y < screen(corners[top]).y) top = k;
            const std::uint32_t one = corners[top], two = corners[(top + 1) % n], four = corners[(top + n - 1) % n];
            const glm::dvec2 p1 = screen(one), p2 = screen(two), p4 = screen(four);
            const double xs = double(i % std::size_t(seen.size.x)) + 0.5,
                         ys = double(i / std::size_t(seen.size.x)) + 0.5;
            if (ys <= p1.y + 0.2 || ys >= std::min(p2.y, p4.y)) continue;
            const auto crossing = [&](glm::dvec2 p) { return p1.x + (p.x - p1.x) * (ys - p1.y) / (p.y - p1.y); };
            const double xa = crossing(p2), xb = crossing(p4);
            if (std::abs(xb - xa) < 0.3) continue;  // pixels: too near for a difference
            const auto at = [&](std::uint32_t v) { return lit.intensity[lit.placeOf(v)].z; };
            OwnCall call(m_own);
            call << at(one) << at(two) << at(four) << p1.y << p2.y << p4.y << ys << xa << xb << xs;
            call.result(OwnPlace::Pixel, i);
        }
    }
    void paintedFirst() const {
        const std::size_t count = std::min<std::size_t>(m_topology.polygonCount(), 100);
        const auto depths = [&](std::size_t polygon) {
            std::vector<double> z;
            for (const std::uint32_t v : cornersOf(polygon)) z.push_back(m_seen[v].z);
            return z;
        };
        const auto mean = [](const std::vector<double>& z) {
            double sum = 0;
            for (const double d : z) sum += d;
            return sum / double(z.size());
        };
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < count; ++j) {
                const std::vector<double> a = depths(i), b = depths(j);
                if (std::abs(mean(a) - mean(b)) <= 1e-9 * std::abs(mean(a))) continue;  // rounding decides
                OwnCall call(m_own);
                call << double(a.size());
                for (const double z : a) call << z;
                call << double(b.size());
                for (const double z : b) call << z;
                call.result(OwnPlace::Polygon, i);
            }
    }

    const Own& m_own;
    const Scene& m_scene;
    const FrameData<double>& m_data;
    const Topology& m_topology;
    const View& m_view;
    std::vector<Vec3d> m_seen;  // vertices in view space
};

}  // namespace

Scene ownScene(Scene scene) {
    constexpr int kWidth = 160;
    const int width = scene.settings.width;
    if (width <= kWidth) return scene;
    scene.settings.width = kWidth;
    scene.settings.height = std::max(1, scene.settings.height * kWidth / width);
    scene.camera.pixelsPerUnit *= double(kWidth) / width;
    return scene;
}

void OwnRecord::add(const OwnElement& element, const std::optional<OwnValue>& result) {
    m_results.insert_or_assign(keyOf(element.in), result);
}
const std::optional<OwnValue>* OwnRecord::find(std::span<const double> in) const {
    const auto found = m_results.find(keyOf(in));
    return found == m_results.end() ? nullptr : &found->second;
}

OwnFrame ownFrame(const Scene& scene, OwnFunction function, std::shared_ptr<const OwnRecord> record, const Stop& stop) {
    OwnFrame out;
    const OwnContract& contract = ownContract(function);
    const auto answer = [record = std::move(record), &contract](std::span<const double> in, std::span<double> result) {
        const std::optional<OwnValue>* const known = record->find(in);
        const OwnValue value = known ? known->value_or(OwnValue()) : valueOf(contract, contract.right, in);
        std::copy_n(value.at.begin(), result.size(), result.begin());
        return known != nullptr;
    };
    std::unordered_map<std::string, std::size_t> asked;
    const auto own = std::make_shared<Own>();
    own->function = function;
    own->call = [&](OwnPlace kind, std::size_t place, std::span<const double> in, std::span<double> result) {
        if (answer(in, result) || !asked.emplace(keyOf(in), asked.size()).second) return;
        out.isCut = out.unknown.size() >= kMostOwnCalls;
        if (!out.isCut)
            out.unknown.push_back({kind, place, {in.begin(), in.end()}, valueOf(contract, contract.right, in)});
    };
    auto planted = std::make_shared<Scene>(scene);
    planted->settings.precision = Precision::Double, planted->settings.leaveOut = false;
    FrameRequest request{setOf({BufferId::Color, BufferId::Normal, BufferId::VerticesNormal}), StageId::Shading, 1,
                         stop};
    if (contract.picture) request.own = own;
    forgetOwnPlace();
    out.frame = runFrame(planted, request, nullptr);
    if (out.frame && !contract.picture) CallsAlone(*own, *planted, *dataOf<double>(*out.frame)).make();
    // What is computed from the frame later asks the record alone.
    own->call = [answer](OwnPlace, std::size_t, std::span<const double> in, std::span<double> result) {
        answer(in, result);
    };
    return out;
}

}  // namespace pipeline
