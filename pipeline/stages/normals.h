#pragma once
#include <vector>

#include "pipeline/core/forms.h"
#include "pipeline/stages/transform.h"

namespace pipeline {

// Stage 3: unit normals, world space.

struct NormalsInputs {
    NormalWeight weight;
    bool polygonNormals, vertexNormals;  // whether anybody reads them
    std::vector<bool> ownNormals{};  // per object: no sum around a vertex is read; empty: some may be, of every object
    PolygonNormalForm form = PolygonNormalForm::Newell;
    CornerAngleForm angle = CornerAngleForm::Atan2;
    UnitForm unit = UnitForm::Scaled;
    bool asGiven = false;  // vertex normals are those of the mesh of the only object, which are Real
    Planted planted{};
    bool operator==(const NormalsInputs&) const = default;
};

template <class Real>
struct NormalsOutput : Oriented<Real> {
    // Room for work, given back at the end. Per polygon, twice the area times the normal, by its object's scale; and per
    // object, e where its edges are times 2^-e there, 0 but for objects whose areas Real cannot hold.
    RawVector<Vec3<Real>> weighted;
    std::vector<int> areaScale{};
};

template <class Real>
NormalsOutput<Real> prepareNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in);

// Polygons [begin, end): by default Newell's normal, relative to the first corner, which keeps its digits
// far from the origin. Outward also where the object is mirrored.
// M. Newell, in I. Sutherland, R. Sproull, R. Schumacker, "A characterization of ten hidden-surface
// algorithms", Computing Surveys 1974.
template <class Real>
void polygonNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t begin, std::size_t end,
                    NormalsOutput<Real>& out);

// Of one of them, by default: the same bits.
template <class Real>
Vec3<Real> polygonNormal(const TransformOutput<Real>& in, std::size_t polygon);

// Of the plane of one triangle, outward: that in which it is drawn, also where the polygon it is cut from is not planar;
// (0, 0, 0) without area.
template <class Real>
Vec3<Real> triangleNormal(const TransformOutput<Real>& in, std::size_t triangle);

// The vertices of one object, in three steps. First the sums over the polygons around each: of the unit normals
// (lecture 1), or weighted by area or by the angle at the vertex; 0 where no more is left than rounding may leave.
template <class Real>
void sumAroundVertices(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t object,
                       NormalsOutput<Real>& out);
// Then, of the object's vertices [begin, end), the sums normalised, or what the mesh gives where it gives one; in the form
// Scaled, what it gives at length 1, as far as Real can tell, stays as it is. Pieces may run at the same time.
template <class Real>
void unitVertexNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t object,
                       std::size_t begin, std::size_t end, NormalsOutput<Real>& out);
// And where a sum vanishes, the first normal around the vertex; (0, 0, 0) at a vertex of no polygon.
template <class Real>
void replaceVanishing(const TransformOutput<Real>& in, std::size_t object, NormalsOutput<Real>& out);

}  // namespace pipeline
