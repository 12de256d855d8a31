#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/defects/defect.h"

// Where a planted defect changes what the right text has made: one line each, `if (planted) spoil…`. All that
// is wrong stands behind these functions, in this folder. The structs are declared here and known to the .cpp files alone,
// so that every layer of the pipeline may include this header.
namespace pipeline {

enum class Domain : std::uint8_t;
struct Illumination;
struct Light;
struct Material;
struct Mesh;
struct ObjectMatrix;
struct Scene;
struct StageKeys;
struct Topology;
struct View;
struct CullInputs;
struct NormalsInputs;
struct TransformInputs;
struct Culled;
struct DepthCode;
struct ShadowSettings;
struct ShadingInputs;
template <class Real>
struct TransformOutput;
template <class Real>
struct NormalsOutput;
template <class Real>
struct ZBufferOutput;
template <class Real>
struct RasterTriangle;
template <class Real>
struct Fragment;
template <class Real>
struct ShadingSources;
template <class Real>
struct VertexWeights;
template <class Real>
struct Surface;
template <class Real>
struct LightSample;
template <class Real>
struct LightView;
template <class Real>
struct Layer;
template <class Real>
struct ShadowTest;
template <class Real>
struct TexelTest;
template <class Real>
struct BaseTerms;
template <class Real>
struct ShadingScratch;

// Given: what the stages read of the scene, and which stage gets the defect to change its own text.
void spoilGiven(const Scene& scene, StageKeys& keys);
// What the files hold. before: of the frame before, whose meshes serve again where they are alike; may be null.
void spoilMeshes(const Scene& scene, const Topology* before, std::vector<std::shared_ptr<const Mesh>>& meshes);

// Left: what a stage has left. Of the first so many polygons.
template <class Real>
void spoilVerdicts(const CullInputs& inputs, const TransformOutput<Real>& in, std::size_t polygons, Culled& out);
template <class Real>
void spoilPolygonNormals(const Planted& planted, const TransformOutput<Real>& in, std::size_t polygons,
                         NormalsOutput<Real>& out);
// The vertices of all objects in world space; and the normals of those of one object.
template <class Real>
void spoilPlaces(const TransformInputs& inputs, TransformOutput<Real>& out);
template <class Real>
void spoilVertexNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t object,
                        NormalsOutput<Real>& out);

// Within: one result of a function at a point.
void spoilNormalMatrix(const Planted& planted, const View& view, const ObjectMatrix& matrix, glm::dmat3& normalMatrix);

// What a z-buffer is cleared to.
template <class Real>
void spoilCleared(ZBufferOutput<Real>& out);
// The depth of a fragment, and whether it wins. e: the edge functions at its pixel; at: the pixel's place in `out`.
template <class Real>
void spoilTest(const DepthCode& code, const RasterTriangle<Real>& triangle, const std::array<std::int64_t, 3>& e,
               ZBufferOutput<Real>& out, std::size_t at, Fragment<Real>& fragment, double& depth, bool& won);
// What a fragment that won has written.
template <class Real>
void spoilWritten(const DepthCode& code, ZBufferOutput<Real>& out, std::size_t at);

template <class Real>
void spoilDirections(const Illumination& illumination, const Light& light, const Surface<Real>& at,
                     LightSample<Real>& s);
template <class Real>
void spoilTerms(const Illumination& illumination, const Light& light, const Material& material, const Surface<Real>& at,
                bool attenuated, LightSample<Real>& s);

template <class Real>
void spoilShadowPoint(const ShadowSettings& settings, Vec3<Real>& position);
void spoilTexel(const ShadowSettings& settings, glm::ivec2 size, glm::ivec2& texel);
// Where a point of world space falls on a light's face, columns and rows, and how far away it is.
template <class Real>
void spoilLightPlace(const ShadowSettings& settings, const View& face, Vec3<Real> position, Vec2<Real>& place, Real& z);
template <class Real>
void spoilShadowed(const ShadowSettings& settings, const ShadowTest<Real>& test, TexelTest<Real>& found);

// Shading takes one pixel, vertex or polygon after the other: where the calls of a student's function belong that this thread
// makes from now on. index: of a pixel x + y · width.
void setOwnPlace(Domain kind, std::size_t index);
void forgetOwnPlace();

template <class Real>
void spoilSurface(const ShadingInputs& inputs, Surface<Real>& surface);
template <class Real>
void spoilPixel(const ShadingInputs& inputs, const ShadingSources<Real>& in, const VertexWeights<Real>& weights,
                Surface<Real>& surface);
// The ambient term, light by light. whole: the right one; intensity: the sum so far, which follows.
template <class Real>
void spoilAmbient(const Planted& planted, std::size_t light, Real shadow, Vec3<Real> whole, Vec3<Real>& ambient,
                  Vec3<Real>& intensity);
// The sum of a pixel's terms after a light and its shadow factor. base: emission and the ambient term.
template <class Real>
void spoilSum(const ShadingInputs& inputs, std::size_t light, Real shadow, const BaseTerms<Real>& base,
              ShadingScratch<Real>& scratch, Vec3<Real>& intensity);
// transparent: as maximumIntensity has it.
void spoilMaximum(const ShadingInputs& inputs, const std::vector<std::uint8_t>& transparent, double& iMax);
void spoilFrameBuffer(const Planted& planted, Vec3d intensity, double iMax, Color8& value);
template <class Real>
void spoilLayers(const Planted& planted, std::vector<Layer<Real>>& layers);
// A pixel with its layers over it. layers: of a tile, pixel by pixel, the farthest first; lit: their intensities.
template <class Real>
void spoilBlended(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::span<const Layer<Real>> layers,
                  std::span<const Vec3<Real>> lit, glm::ivec2 pixel, Vec3<Real> behind, Vec3<Real>& intensity);

}  // namespace pipeline
