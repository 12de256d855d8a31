#include "pipeline/formats/obj/obj_smoothing.h"

#include <algorithm>
#include <unordered_map>

#include "pipeline/formats/model_formats.h"

namespace pipeline {
namespace {

// Goes over the faces of a group, with what smooths them.
class FaceWalk {
public:
    explicit FaceWalk(const ObjFaces& faces) : m_faces(faces) {}
    bool next() {
        if (m_face == m_faces.count()) return false;
        while (m_run < m_faces.smoothing.size() && m_faces.smoothing[m_run].first <= m_face)
            m_smoothing = m_faces.smoothing[m_run++].second;
        m_begin = m_faces.firstCorner[m_face], m_end = m_faces.firstCorner[++m_face];
        return true;
    }
    std::uint32_t begin() const { return m_begin; }
    std::uint32_t end() const { return m_end; }
    std::uint32_t smoothing() const { return m_smoothing; }

private:
    const ObjFaces& m_faces;
    std::size_t m_face = 0, m_run = 0;
    std::uint32_t m_begin = 0, m_end = 0, m_smoothing = 0;
};

// Of a face of any number of corners, by Newell's sum over differences from its first; 0 where it has no area.
Vec3d faceNormal(const ObjFile& file, const ObjFaces& faces, std::uint32_t begin, std::uint32_t end) {
    const Vec3d first = file.positions[faces.positions[begin]];
    Vec3d largest(0.0), sum(0.0);
    for (std::uint32_t i = begin; i < end; ++i)
        largest = glm::max(largest, glm::abs(file.positions[faces.positions[i]] - first));
    const double extent = std::max({largest.x, largest.y, largest.z});
    if (!(extent > 0)) return sum;
    Vec3d a = (file.positions[faces.positions[end - 1]] - first) / extent;
    for (std::uint32_t i = begin; i < end; ++i) {
        const Vec3d b = (file.positions[faces.positions[i]] - first) / extent;
        sum += glm::cross(a, b);
        a = b;
    }
    return unitVector(sum).value_or(Vec3d(0.0));
}

class Smoother {
public:
    Smoother(ObjFile& file, StopCheck& check) : m_file(file), m_check(check), m_firstGroup(file.positions.size(), 0) {}

    void add(const ObjFaces& faces) {
        if (m_sums.empty()) m_sums.resize(m_firstGroup.size());
        for (FaceWalk walk(faces); walk.next();) {
            if (m_check.stopped(walk.end() - walk.begin())) return;
            if (walk.smoothing() == 0) continue;
            const Vec3d normal = faceNormal(m_file, faces, walk.begin(), walk.end());
            for (std::uint32_t i = walk.begin(); i < walk.end(); ++i) {
                Sum& sum = m_sums[sumOf(faces.positions[i], walk.smoothing())];
                sum.normal += normal, ++sum.faces;
            }
        }
    }

    void give(ObjFaces& faces) {
        faces.normals.clear();
        faces.numbers = NormalNumbers::Own;
        for (FaceWalk walk(faces); walk.next();) {
            if (m_check.stopped(walk.end() - walk.begin())) return;
            const Vec3d normal = faceNormal(m_file, faces, walk.begin(), walk.end());
            std::uint32_t own = kNoNormal;
            for (std::uint32_t i = walk.begin(); i < walk.end(); ++i) {
                std::uint32_t number = kNoNormal;
                if (walk.smoothing() > 0) number = sumNumber(sumOf(faces.positions[i], walk.smoothing()));
                if (number == kNoNormal && own == kNoNormal)
                    own = append(normal == Vec3d(0) ? Vec3d(0, 0, 1) : normal);  // nothing is drawn of it
                faces.normals.push_back(number == kNoNormal ? own : number);
            }
        }
    }

private:
    struct Sum {
        Vec3d normal{0.0};
        std::uint32_t faces = 0;
        // A sum of n unit vectors that each err by a few roundings errs by n² of them at most: one that is no longer is
        // none, where normals are opposed.
        std::optional<Vec3d> direction() const {
            const double error = double(faces) * (double(faces) + 8) * 0x1p-53;
            return glm::length(normal) > error ? unitVector(normal) : std::nullopt;
        }
    };

    // The place of the sum at a position for a smoothing group, which is the position's own for the first that is met.
    std::size_t sumOf(std::uint32_t position, std::uint32_t group) {
        if (m_firstGroup[position] == 0) m_firstGroup[position] = group;
        if (m_firstGroup[position] == group) return position;
        const auto [found, isNew] = m_others.try_emplace(std::uint64_t{position} << 32 | group, m_sums.size());
        if (isNew) m_sums.emplace_back();
        return found->second;
    }

    std::uint32_t sumNumber(std::size_t sum) {
        m_numbers.resize(m_sums.size(), kNoNormal);
        if (m_numbers[sum] == kNoNormal)
            if (const auto unit = m_sums[sum].direction()) m_numbers[sum] = append(*unit);
        return m_numbers[sum];
    }

    std::uint32_t append(const Vec3d& normal) {
        m_file.normals.push_back(normal);
        return static_cast<std::uint32_t>(m_file.normals.size() - 1);
    }

    ObjFile& m_file;
    StopCheck& m_check;
    std::vector<std::uint32_t> m_firstGroup;                  // per position, 0: none yet
    std::unordered_map<std::uint64_t, std::size_t> m_others;  // by position and smoothing group
    std::vector<Sum> m_sums;
    std::vector<std::uint32_t> m_numbers;  // of the sums' normals, kNoNormal: not asked for yet, or without length
};

}  // namespace

void smoothNormals(ObjFile& file, StopCheck& check) {
    if (!file.smooths) return;
    Smoother smoother(file, check);
    std::vector<ObjFaces*> bare;
    for (ObjGroup& group : file.groups)
        if (!group.faces.haveNormals()) bare.push_back(&group.faces);
    for (const ObjFaces* faces : bare) smoother.add(*faces);
    for (ObjFaces* faces : bare) smoother.give(*faces);
}

}  // namespace pipeline
