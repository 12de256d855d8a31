#include "pipeline/scene/settings_choices.h"
#include "pipeline/scene/settings_idle.h"
#include "pipeline/scene/settings_rows.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pipeline {

namespace {

using namespace settings_choices;
using namespace settings_rows;
using namespace settings_idle;

// Lecture 1 has one k_s for the three colours.
constexpr Setting specular(Words words, Range range) {
    Setting setting = component<OfMaterial, &Material::specular, 0>(words, range);
    setting.set = [](Scene& scene, std::size_t i, double value) { scene.objects[i].material.specular = Vec3d(value); };
    return setting;
}

using S = Settings;
using C = Camera;
using G = OpenGlLight;
using A = AreaLight;
using F = Forms;

constexpr auto kSceneTable = std::to_array<Setting>({
    side<&S::width>({"width", "Width", "pixels", "Columns of the picture."}, kSide),
    side<&S::height>({"height", "Height", "pixels", "Rows of the picture."}, kSide),
    choice<OfPicture, &S::precision>(
        {"precision", "Precision", "", "The precision of the stages: 24, 53, 64 or 113 bits of significand."},
        kPrecision),
    choice<OfPicture, &S::arithmetic>({"arithmetic", "Arithmetic", "",
                                       "Exact: the same bits on every machine in float and double. Fast: fused "
                                       "multiply-add and estimated roots in SIMD shading, within 1/255 of exact."},
                                      kArithmetic, onlyFloat),
    row<OfPicture, &S::antialiasing>(
        {"antialiasing", "Antialiasing", "samples along a side",
         "Samples along each side of a pixel; the frame buffer shows their mean. 1 is the centre only."},
        {1, 16, 1, 8}),
    choice<OfPicture, &S::antialiasingPattern>({"antialiasing_pattern", "Samples stand", "",
                                                "Positions of a pixel's samples, the same in all pixels: on a grid, "
                                                "anywhere in the grid's cells, anywhere, or on Hammersley's points."},
                                               kPattern, onlyAntialiased),
    upAxis({"up", "Up axis of the file", "",
            "The axis that points up in the file of an opened model. Changing it turns all objects about the file's "
            "centre."},
           kUpAxis),

    choice<OfCamera, &C::kind>(
        {"camera.kind", "Camera", "",
         "Spherical: on a sphere around the world's origin. Look-at: from an eye towards a target."},
        kCameraKind),
    choice<OfCamera, &C::projection>({"camera.projection", "Projection", "",
                                      "Perspective: lines of sight meet in the eye. Orthographic: they are parallel."},
                                     kProjection),
    row<OfCamera, &C::rho>({"camera.rho", "ρ distance", "world units", "Distance of the eye from the world's origin."},
                           {0, kFar, 1, 2000}, {}, onlySpherical),
    row<OfCamera, &C::theta>(
        {"camera.theta", "θ around z", "degrees", "Direction of the eye around z, from x towards y."}, kAngle, {},
        onlySpherical),
    row<OfCamera, &C::phi>({"camera.phi", "φ from z", "degrees", "Angle between the direction of the eye and +z."},
                           {-kTurns, kTurns, 0, 180}, {}, onlySpherical),
    row<OfCamera, &C::screenDistance>(
        {"camera.distance", "d screen", "screen units", "Distance of the screen from the eye."},
        {kNearest, kFar, 1, 1000}, {}, onlySpherical),
    row<OfCamera, &C::pixelsPerUnit>(
        {"camera.scale", "s scale", "pixels per screen unit", "Pixels along one screen unit."},
        {kNearest, kFar, 0.1, 10}, {}, onlySpherical),
    component<OfCamera, &C::eye, 0>({"camera.eye_x", "Eye x", "world units", "Position of the eye."}, kPlace,
                                    onlyLookAt),
    component<OfCamera, &C::eye, 1>({"camera.eye_y", "Eye y", "world units", "Position of the eye."}, kPlace,
                                    onlyLookAt),
    component<OfCamera, &C::eye, 2>({"camera.eye_z", "Eye z", "world units", "Position of the eye."}, kPlace,
                                    onlyLookAt),
    component<OfCamera, &C::target, 0>(
        {"camera.target_x", "Target x", "world units", "The point that the eye looks at."}, kPlace, onlyLookAt),
    component<OfCamera, &C::target, 1>(
        {"camera.target_y", "Target y", "world units", "The point that the eye looks at."}, kPlace, onlyLookAt),
    component<OfCamera, &C::target, 2>(
        {"camera.target_z", "Target z", "world units", "The point that the eye looks at."}, kPlace, onlyLookAt),
    component<OfCamera, &C::up, 0>({"camera.up_x", "Up x", "", "The direction that points up in the picture."},
                                   {-kFar, kFar, -1, 1}, onlyLookAt),
    component<OfCamera, &C::up, 1>({"camera.up_y", "Up y", "", "The direction that points up in the picture."},
                                   {-kFar, kFar, -1, 1}, onlyLookAt),
    component<OfCamera, &C::up, 2>({"camera.up_z", "Up z", "", "The direction that points up in the picture."},
                                   {-kFar, kFar, -1, 1}, onlyLookAt),
    row<OfCamera, &C::fovY>(
        {"camera.fov", "Field of view", "degrees", "Angle from the top to the bottom of the picture."},
        {0.01, 179.99, 5, 120}, {}, onlyLookAtPerspective),
    row<OfCamera, &C::height>({"camera.height", "View height", "world units",
                               "Height of the visible region, from the top to the bottom of the picture."},
                              {kNearest, kFar, 0.1, 1000}, {}, onlyLookAtOrthographic),
    row<OfCamera, &C::near>({"camera.near", "Near plane", "world units",
                             "Distance of the near plane along the viewing direction; 0 uses the scene's bounds. In "
                             "orthographic projection it may be negative, behind the eye."},
                            kPlane),
    row<OfCamera, &C::far>({"camera.far", "Far plane", "world units",
                            "Distance of the far plane along the viewing direction; 0 uses the scene's bounds. In "
                            "orthographic projection it may be negative, behind the eye."},
                           kPlane),

    choice<OfShading, &S::shading>({"shading", "Shading", "", "Where the illumination model is evaluated."}, kShading,
                                   notOutlines),
    choice<OfShading, &S::interpolation>(
        {"interpolation", "Interpolation", "",
         "How intensities or normals are interpolated: linearly over the polygon in space, over the triangle in the "
         "picture, or along the polygon's edges and then along the row."},
        kInterpolation, notFlat),
    choice<OfShading, &S::model>({"model", "Model", "", "The illumination model."}, kModelWords),
    row<OfShading, &S::exponentFactor>(
        {"exponent_factor", "Exponent factor", "",
         "The factor of the exponent in Blinn–Phong; with 4 the highlight is about as wide as Phong's."},
        {0, 1000, 1, 8}, {}, onlyFactored),
    row<OfShading, &S::localViewer>(
        {"local_viewer", "Local viewer", "", "Whether V points to the eye; otherwise it is the viewing axis."},
        {0, 1, 0, 1}, kSwitch, onlyViewer),
    row<OfShading, &S::twoSided>(
        {"two_sided", "Two-sided lighting", "", "Whether back faces are lit with the reversed normal."}, {0, 1, 0, 1},
        kSwitch, onlyTwoSided),
    choice<OfShading, &S::normalWeight>(
        {"normal_weight", "Vertex normals", "", "How the polygons around a vertex are weighted in its normal."},
        kNormalWeight, onlyVertexNormals),

    choice<OfDepth, &S::cull>({"cull", "Cull", "", "Whether back-facing polygons are dropped."}, kCull),
    choice<OfDepth, &S::visibility>({"visibility", "Visibility", "",
                                     "How hidden surfaces are removed: by comparing depths at every pixel, by painting "
                                     "from back to front, or not at all (outlines only)."},
                                    kVisibility),
    row<OfDepth, &S::split>({"split", "Split polygons", "",
                             "Whether the painter's algorithm splits polygons that intersect or overlap in a cycle."},
                            {0, 1, 0, 1}, kSwitch, onlyPainter),
    choice<OfDepth, &S::depthFormat>(
        {"depth_format", "Depth format", "", "The number that the z-buffer stores and compares."}, kDepthFormat,
        onlyZBuffer),
    choice<OfDepth, &S::translucency>({"translucency", "Translucent surfaces", "",
                                       "How the layers of a pixel are ordered: by their depths at the pixel, or by the "
                                       "mean depths of their polygons."},
                                      kTranslucency, onlyTranslucent),

    row<OfShadow, &S::shadowSize>({"shadow.size", "Shadow buffer", "texels", "Texels along a side of a shadow buffer."},
                                  {1, 8192, 16, 4096}, {}, onlyShadow),
    choice<OfShadow, &S::shadowCull>({"shadow.cull", "Cull in shadow buffer", "",
                                      "The polygons that a shadow buffer leaves out: none, those that face away from "
                                      "the light, or those that face it."},
                                     kShadowCull, onlyShadow),
    choice<OfShadow, &S::shadowBias>(
        {"shadow.bias", "Bias", "",
         "The bias added to Z' before the comparison: chosen for each texel, constant, or by the polygon's slope."},
        kShadowBias, onlyShadow),
    row<OfShadow, &S::shadowBiasValue>({"shadow.bias_value", "Bias value", "world units; a factor with slope",
                                        "The constant bias, or the factor of the slope's bias."},
                                       {-kFar, kFar, 0, 20}, {}, onlyBias),
    row<OfShadow, &S::shadowFilter>({"shadow.filter", "Filter radius", "texels",
                                     "Radius r of percentage-closer filtering over (2r+1)² texels; 0 is none."},
                                    {0, 32, 0, 8}, {}, onlyShadow),

    choice<OfForms, &F::power>(
        {"numerics.power", "Specular power", "",
         "How the power of the specular term is computed: exp(n log1p(-q)), pow, repeated squaring, exp2(n log2), "
         "Schlick's fraction, or exp(n (x - 1))."},
        kPowerForm, onlyPower),
    choice<OfForms, &F::unit>({"numerics.normalize", "Normalisation", "",
                               "How normals, V, L and H are normalised: scaled first, by the square root alone, or by "
                               "a guess of its inverse with none, one or two of Newton's steps."},
                              kUnitForm),
    choice<OfForms, &F::polygonNormal>(
        {"numerics.polygon_normal", "Polygon normal", "",
         "Newell's sum relative to the first vertex, relative to the origin, or the first three vertices only."},
        kPolygonNormalForm),
    choice<OfForms, &F::normalMatrix>(
        {"numerics.normal_matrix", "Normal matrix", "",
         "The matrix that transforms the mesh's own normals to world space: the cofactors, or the inverse transpose."},
        kNormalMatrixForm, onlyGivenNormals),
    choice<OfForms, &F::cornerAngle>({"numerics.corner_angle", "Angle at a corner", "",
                                      "How the angle that weights a normal is computed: atan2 of cross and dot "
                                      "product, or acos of the dot product."},
                                     kCornerAngleForm, onlyAngleWeights),
    choice<OfForms, &F::cameraBasis>({"numerics.camera_basis", "Camera axes", "",
                                      "How the spherical camera's axes are computed: from its angles, or by cross "
                                      "products with z, which vanish if it looks along z."},
                                     kCameraBasisForm, onlySpherical),
    row<OfNumerics, &S::subPixelBits>({"numerics.subpixel_bits", "Sub-pixel bits", "bits",
                                       "Vertices are snapped to 2^-bits pixels before coverage is decided."},
                                      {1, 16, 4, 16}),

    ambientIntensity({"ambient.intensity", "I_a intensity", "",
                      "Intensity of the ambient light; if none is given, 0.2 in OpenGL's model, else 0."},
                     kIntensity),
    component<OfAmbient, &AmbientLight::color, 0>({"ambient.red", "I_a red", "", "Red part of the ambient light."},
                                                  kFraction),
    component<OfAmbient, &AmbientLight::color, 1>(
        {"ambient.green", "I_a green", "", "Green part of the ambient light."}, kFraction),
    component<OfAmbient, &AmbientLight::color, 2>({"ambient.blue", "I_a blue", "", "Blue part of the ambient light."},
                                                  kFraction),

    choice<OfLight, &Light::kind>(
        {"light.#.kind", "Light", "",
         "At infinity (the same direction everywhere), at a point, or a rectangle around a point."},
        kLightKind),
    component<OfLight, &Light::position, 0>(
        {"light.#.x", "L x", "world units", "Position of the light, or direction to it."}, kPlace),
    component<OfLight, &Light::position, 1>(
        {"light.#.y", "L y", "world units", "Position of the light, or direction to it."}, kPlace),
    component<OfLight, &Light::position, 2>(
        {"light.#.z", "L z", "world units", "Position of the light, or direction to it."}, kPlace),
    row<OfLight, &Light::intensity>({"light.#.intensity", "I_p intensity", "", "Intensity of the light."}, kIntensity),
    component<OfLight, &Light::color, 0>({"light.#.red", "I_p red", "", "Red part of the light."}, kFraction),
    component<OfLight, &Light::color, 1>({"light.#.green", "I_p green", "", "Green part of the light."}, kFraction),
    component<OfLight, &Light::color, 2>({"light.#.blue", "I_p blue", "", "Blue part of the light."}, kFraction),
    row<OfLight, &Light::castsShadow>(
        {"light.#.shadow", "Casts a shadow", "", "Whether polygons throw shadows in this light."}, {0, 1, 0, 1},
        kSwitch),
    row<OfAreaLight, &A::width>(
        {"light.#.width", "Width", "world units",
         "Side of an area light perpendicular to world z, or along x if the light faces along z."},
        {0, kFar, 0, 10}, {}, onlyArea),
    row<OfAreaLight, &A::height>({"light.#.height", "Height", "world units", "The other side of an area light."},
                                 {0, kFar, 0, 10}, {}, onlyArea),
    component<OfAreaLight, &A::facing, 0>(
        {"light.#.facing_x", "Facing x", "", "Direction perpendicular to an area light's rectangle."}, kToward,
        onlyArea),
    component<OfAreaLight, &A::facing, 1>(
        {"light.#.facing_y", "Facing y", "", "Direction perpendicular to an area light's rectangle."}, kToward,
        onlyArea),
    component<OfAreaLight, &A::facing, 2>(
        {"light.#.facing_z", "Facing z", "", "Direction perpendicular to an area light's rectangle."}, kToward,
        onlyArea),
    row<OfAreaLight, &A::samples>(
        {"light.#.samples", "Samples", "along a side",
         "Sample points along each side of an area light, each with its own shadow buffers; 1 gives a hard shadow."},
        {1, 16, 1, 8}, {}, onlyArea),
    component<OfOpenGlLight, &G::ambient, 0>(
        {"light.#.ambient_red", "Ambient red", "", "The light's own ambient part."}, kFraction, onlyGlLights),
    component<OfOpenGlLight, &G::ambient, 1>(
        {"light.#.ambient_green", "Ambient green", "", "The light's own ambient part."}, kFraction, onlyGlLights),
    component<OfOpenGlLight, &G::ambient, 2>(
        {"light.#.ambient_blue", "Ambient blue", "", "The light's own ambient part."}, kFraction, onlyGlLights),
    component<OfOpenGlLight, &G::specular, 0>(
        {"light.#.specular_red", "Specular red", "", "Colour of the light's specular part."}, kFraction, onlyGlLights),
    component<OfOpenGlLight, &G::specular, 1>(
        {"light.#.specular_green", "Specular green", "", "Colour of the light's specular part."}, kFraction,
        onlyGlLights),
    component<OfOpenGlLight, &G::specular, 2>(
        {"light.#.specular_blue", "Specular blue", "", "Colour of the light's specular part."}, kFraction,
        onlyGlLights),
    row<OfOpenGlLight, &G::constant>({"light.#.constant", "Constant attenuation", "", "c of 1 / (c + l d + q d²)."},
                                     kFading, {}, onlyFading),
    row<OfOpenGlLight, &G::linear>(
        {"light.#.linear", "Linear attenuation", "1 / world units", "l of 1 / (c + l d + q d²)."}, kFading, {},
        onlyFading),
    row<OfOpenGlLight, &G::quadratic>(
        {"light.#.quadratic", "Quadratic attenuation", "1 / world units²", "q of 1 / (c + l d + q d²)."}, kFading, {},
        onlyFading),
    component<OfOpenGlLight, &G::spotDirection, 0>({"light.#.spot_x", "Spot direction x", "", "Direction of the spot."},
                                                   {-kFar, kFar, -1, 1}, onlyGlLights),
    component<OfOpenGlLight, &G::spotDirection, 1>({"light.#.spot_y", "Spot direction y", "", "Direction of the spot."},
                                                   {-kFar, kFar, -1, 1}, onlyGlLights),
    component<OfOpenGlLight, &G::spotDirection, 2>({"light.#.spot_z", "Spot direction z", "", "Direction of the spot."},
                                                   {-kFar, kFar, -1, 1}, onlyGlLights),
    row<OfOpenGlLight, &G::spotCutoff>(
        {"light.#.spot_cutoff", "Spot cut-off", "degrees", "Half the angle of the spot's cone; 180: no spot."},
        {0, 180, 0, 90}, {}, onlyGlLights),
    row<OfOpenGlLight, &G::spotExponent>(
        {"light.#.spot_exponent", "Spot exponent", "", "How much the spot fades towards its edge."}, {0, 128, 0, 128},
        {}, onlyGlLights),
    choice<OfOpenGlLight, &G::space>(
        {"light.#.space", "Space", "", "Whether the light is fixed in the world or moves with the eye."}, kLightSpace,
        onlyGlLights),

    choice<OfObject, &ObjectTransform::up>(
        {"object.#.up", "Up axis", "",
         "The axis of the mesh's file that points up: y turns it about x. Applied first."},
        kUpAxis),
    component<OfObject, &ObjectTransform::scale, 0>({"object.#.sx", "Scale x", "", "Applied before rotations."},
                                                    kScale),
    component<OfObject, &ObjectTransform::scale, 1>({"object.#.sy", "Scale y", "", "Applied before rotations."},
                                                    kScale),
    component<OfObject, &ObjectTransform::scale, 2>({"object.#.sz", "Scale z", "", "Applied before rotations."},
                                                    kScale),
    component<OfObject, &ObjectTransform::rotation, 0>(
        {"object.#.rx", "Rotation about x", "degrees", "Applied after scaling."}, kAngle),
    component<OfObject, &ObjectTransform::rotation, 1>(
        {"object.#.ry", "Rotation about y", "degrees", "Applied after the rotation about x."}, kAngle),
    component<OfObject, &ObjectTransform::rotation, 2>(
        {"object.#.rz", "Rotation about z", "degrees", "Applied after the rotation about y."}, kAngle),
    component<OfObject, &ObjectTransform::translation, 0>(
        {"object.#.tx", "Translation x", "world units", "Applied last."}, kPlace),
    component<OfObject, &ObjectTransform::translation, 1>(
        {"object.#.ty", "Translation y", "world units", "Applied last."}, kPlace),
    component<OfObject, &ObjectTransform::translation, 2>(
        {"object.#.tz", "Translation z", "world units", "Applied last."}, kPlace),
    tessellation({"object.#.tessellation", "Tessellation", "pieces",
                  "Pieces along a quarter of a circle, a side or a patch of a built-in shape."},
                 {1, 256, 1, 64}, onlyShapes),

    component<OfMaterial, &Material::diffuse, 0>(
        {"material.#.kr", "k_r red", "", "Fraction of red ambient and diffuse light that is reflected."}, kFraction),
    component<OfMaterial, &Material::diffuse, 1>(
        {"material.#.kg", "k_g green", "", "Fraction of green ambient and diffuse light that is reflected."},
        kFraction),
    component<OfMaterial, &Material::diffuse, 2>(
        {"material.#.kb", "k_b blue", "", "Fraction of blue ambient and diffuse light that is reflected."}, kFraction),
    specular(
        {"material.#.ks", "k_s specular", "", "Fraction of light that is reflected towards R, in all three colours."},
        kFraction),
    row<OfMaterial, &Material::exponent>(
        {"material.#.n", "n exponent", "", "Specular exponent; a larger one makes a smaller highlight."},
        {0, 1e6, 0, 64}, {}, onlySpecular),
    choice<OfMaterial, &Material::highlight>({"material.#.highlight", "Highlight", "",
                                              "The specular term: that of the illumination model, (R·V)^n or (N·H)^n."},
                                             kHighlight, onlyChosenLobe),
    component<OfMaterial, &Material::specular, 0>(
        {"material.#.ksr", "k_s red", "", "Fraction of light of this colour reflected in the highlight."}, kFraction,
        neverIdle),
    component<OfMaterial, &Material::specular, 1>(
        {"material.#.ksg", "k_s green", "", "Fraction of light of this colour reflected in the highlight."}, kFraction,
        neverIdle),
    component<OfMaterial, &Material::specular, 2>(
        {"material.#.ksb", "k_s blue", "", "Fraction of light of this colour reflected in the highlight."}, kFraction,
        neverIdle),
    component<OfMaterial, &Material::ambient, 0>(
        {"material.#.kar", "k_a red", "", "Fraction of ambient light of this colour that is reflected."}, kFraction,
        onlyOwnAmbient),
    component<OfMaterial, &Material::ambient, 1>(
        {"material.#.kag", "k_a green", "", "Fraction of ambient light of this colour that is reflected."}, kFraction,
        onlyOwnAmbient),
    component<OfMaterial, &Material::ambient, 2>(
        {"material.#.kab", "k_a blue", "", "Fraction of ambient light of this colour that is reflected."}, kFraction,
        onlyOwnAmbient),
    row<OfMaterial, &Material::alpha>({"material.#.alpha", "α opacity", "",
                                       "Opacity: 1 hides everything behind the surface, 0 nothing, as if the object "
                                       "were absent; values outside [0, 1] are clamped."},
                                      {-kFar, kFar, 0, 1}),
    component<OfMaterial, &Material::emission, 0>(
        {"material.#.ker", "Emission red", "", "The light that the material emits."}, kFraction, onlyEmission),
    component<OfMaterial, &Material::emission, 1>(
        {"material.#.keg", "Emission green", "", "The light that the material emits."}, kFraction, onlyEmission),
    component<OfMaterial, &Material::emission, 2>(
        {"material.#.keb", "Emission blue", "", "The light that the material emits."}, kFraction, onlyEmission),

    choice<OfDefect, &S::defect>({"defect", "Planted defect", "",
                                  "A classic error of renderers that is made on purpose; none is the right picture."},
                                 kDefectIds),
    row<OfDefect, &S::defectWay>({"defect_way", "Way of making it", "", "The variant of the planted defect, from 0."},
                                 {0, 9, 0, 3}, {}, onlyWithDefect),

    row<OfLeavingOut, &S::leaveOut>({"leave_out", "Leave out what is not needed", "",
                                     "Whether the plan leaves out work that cannot change the picture."},
                                    {0, 1, 0, 1}, kSwitch),
});

// One switch for each rule by which something is left out.
template <std::size_t rule>
constexpr Setting ruleSwitch() {
    Setting setting = row<OfLeavingOut, &S::leaveOut>({kRules[rule].key, kRules[rule].label, "", kRules[rule].when},
                                                      {0, 1, 0, 1}, kSwitch, onlyLeavingOut);
    setting.get = [](const Scene& scene, std::size_t) { return scene.settings.rules[rule] ? 1.0 : 0.0; };
    setting.set = [](Scene& scene, std::size_t, double value) { scene.settings.rules[rule] = value != 0; };
    return setting;
}

template <std::size_t... rules>
constexpr auto withRules(std::index_sequence<rules...>) {
    std::array<Setting, kSceneTable.size() + sizeof...(rules)> table{};
    std::copy(kSceneTable.begin(), kSceneTable.end(), table.begin());
    ((table[kSceneTable.size() + rules] = ruleSwitch<rules>()), ...);
    return table;
}
constexpr auto kTable = withRules(std::make_index_sequence<kRuleCount>());

}  // namespace

std::string_view name(SettingGroup group) {
    constexpr std::array<std::string_view, 12> kNames{"Picture", "Camera",   "Shading",        "Depth",
                                                      "Shadow",  "Numerics", "Ambient",        "Light",
                                                      "Object",  "Material", "Planted defect", "Leaving out"};
    return kNames[static_cast<std::size_t>(group)];
}

std::span<const Setting> settingsTable() { return kTable; }

std::vector<SettingRef> settingsOf(const Scene& scene) {
    std::vector<SettingRef> refs;
    // Rows of a group stand together: all of light 0, then all of light 1.
    for (auto first = kTable.begin(); first != kTable.end();) {
        const auto last = std::find_if(first, kTable.end(), [&](const Setting& s) { return s.group != first->group; });
        for (std::size_t i = 0; i < first->count(scene); ++i)
            for (auto row = first; row != last; ++row)
                if (row->absent(scene, i).empty()) refs.push_back({&*row, i});
        first = last;
    }
    return refs;
}

}  // namespace pipeline
