// The lectures' algorithms in their own notation.
#include "pipeline/steps/algorithm.h"

namespace pipeline {
namespace {

using enum LineKind;
using Line = AlgorithmLine;
constexpr Begins kOnce = Begins::Phase, kElement = Begins::Element;

constexpr std::string_view kReversed = "depth_format=reversed|reversed-half|infinite";
constexpr std::string_view kNotReversed = "depth_format!=reversed|reversed-half|infinite";

// L2, "Z-Buffering", inside the loops of L1.
constexpr std::array kSetpixelLines{
    Line{"zbuffer(x, y) = ∞ for all x, y", Do, {}, kOnce, "depth_format=linear"},
    Line{"zbuffer(x, y) = 0 for all x, y", Do, {}, kOnce, kReversed},
    Line{"zbuffer(x, y) = 1 for all x, y", Do, {}, kOnce, "depth_format=float|fixed16|fixed24|fixed32|half"},
    Line{"for each {polygon}", Loop, {}, kElement},
    Line{"  for each pixel {x, y}", Loop},
    Line{"    calculate {z}"},
    Line{"    if({z} < {zbuffer(x, y)}) then", If, "nearer", Begins::Step, kNotReversed},
    Line{"    if({z} > {zbuffer(x, y)}) then", If, "nearer", Begins::Step, kReversed},
    Line{"      zbuffer(x, y) = {z}"},
    Line{"      color(x, y) = c", Elsewhere, "in shading, once per pixel"},
};

// L2, "Painter's Algorithm".
constexpr std::array kPainterLines{
    Line{"sort {polygons} by their mean depth", Do, {}, kOnce, "split=off", "z-buffer/sort"},
    Line{"sort {polygons} by their farthest point", Do, {}, kOnce, "split=on", "z-buffer/sort"},
    Line{"split those that intersect: {pieces}", Do, {}, kOnce, {}, "z-buffer/split"},
    Line{"for each {piece}, from back to front", Loop, {}, kElement},
    Line{"  for each pixel {x, y}", Loop},
    Line{"    paint {polygon} over {what is there}"},
    Line{"    color(x, y) = c", Elsewhere, "in shading, once per pixel"},
};

// Visibility none: L1, "no hidden surface removal".
constexpr std::array kOutlineLines{
    Line{"color(x, y) = black for all x, y", Do, {}, kOnce},
    Line{"for each {polygon}", Loop, {}, kElement},
    Line{"  for each of its {edges}", Loop},
    Line{"    for each pixel x, y on the edge", Loop},
    Line{"      color(x, y) = white"},
};

// L1: the scene file's scale, rotation and translation, then its spherical camera; or the look-at camera.
constexpr std::array kTransformLines{
    Line{"for each {vertex} x, y, z", Loop, {}, kElement},
    Line{"  scale by {sx, sy, sz}", Do, {}, Begins::Step, {}, "transform/model transform"},
    Line{"  rotate about x, y, z by {αx, αy, αz}", Do, {}, Begins::Step, {}, "transform/model transform"},
    Line{"  translate by tx, ty, tz: {xw, yw, zw}", Do, {}, Begins::Step, {}, "transform/model transform"},
    Line{"  {xv} = −xw sin θ + yw cos θ", Do, {}, Begins::Step, "camera.kind=spherical"},
    Line{"  {yv} = −xw cos φ cos θ − yw cos φ sin θ + zw sin φ", Do, {}, Begins::Step, "camera.kind=spherical"},
    Line{"  {zv} = ρ − xw sin φ cos θ − yw sin φ sin θ − zw cos φ", Do, {}, Begins::Step, "camera.kind=spherical"},
    Line{"  {xv} = right · (w − eye)", Do, {}, Begins::Step, "camera.kind=look-at"},
    Line{"  {yv} = up · (w − eye)", Do, {}, Begins::Step, "camera.kind=look-at"},
    Line{"  {zv} = forward · (w − eye)", Do, {}, Begins::Step, "camera.kind=look-at"},
    Line{"  if {zv} ≥ {near} then", If, "in front", Begins::Step, "camera.projection=perspective"},
    Line{"    {xs} = W/2 + s d xv / zv", Do, {}, Begins::Step, "camera.projection=perspective"},
    Line{"    {ys} = H/2 − s d yv / zv", Do, {}, Begins::Step, "camera.projection=perspective"},
    Line{"  {xs} = W/2 + s xv", Do, {}, Begins::Step, "camera.projection=orthographic"},
    Line{"  {ys} = H/2 − s yv", Do, {}, Begins::Step, "camera.projection=orthographic"},
};

// L1: polys[j].visibility. The signed area is on the screen.
constexpr std::array kCullLines{
    Line{"for each {polygon}", Loop, {}, kElement},
    Line{"  if some vertex is inside each plane of the view then", If, "inside"},
    Line{"    {A} = ½ Σ (xi yi+1 − xi+1 yi)"},
    Line{"    if {A} < 0 then", If, "back-facing", Begins::Step, "cull=back"},
    Line{"      visibility = back-facing", Do, {}, Begins::Step, "cull=back"},
    Line{"    if no triangle of it has area then", If, "degenerate"},
    Line{"      visibility = degenerate"},
    Line{"  polys[j].visibility = {visibility}"},
};

// L1: CalcNormal, summed over the polygon's triangles.
constexpr std::string_view kNewell = "numerics.polygon_normal=newell",
                           kThreeCorners = "numerics.polygon_normal=three-corners",
                           kFromOrigin = "numerics.polygon_normal=from-origin";
constexpr std::array kCalcNormalLines{
    Line{"for each {polygon}", Loop, {}, kElement},
    Line{"  n = (0, 0, 0)", Do, {}, Begins::Step, "numerics.polygon_normal=newell|from-origin"},
    Line{"  a = v1 − v0: {a}", Do, {}, Begins::Step, kThreeCorners},
    Line{"  b = v2 − v0: {b}", Do, {}, Begins::Step, kThreeCorners},
    Line{"  n = a × b: {a × b}", Do, {}, Begins::Step, kThreeCorners},
    Line{"  for each triangle v0, vi, vi+1: {i}", Loop, "parts", Begins::Step, kNewell},
    Line{"    a = vi − v0: {a}", Do, {}, Begins::Step, kNewell},
    Line{"    b = vi+1 − v0: {b}", Do, {}, Begins::Step, kNewell},
    Line{"    c = a × b: {c}", Do, {}, Begins::Step, kNewell},
    Line{"  for each edge vi, vi+1: {i}", Loop, "parts", Begins::Step, kFromOrigin},
    Line{"    c = vi × vi+1: {c}", Do, {}, Begins::Step, kFromOrigin},
    Line{"    n = n + c: {n}", Do, {}, Begins::Step, "numerics.polygon_normal=newell|from-origin"},
    Line{"  length = sqrt(n·n): {length}"},
    Line{"  n = n / length: {n}"},
};

// L1: N_A = (N1 + N2 + N3 + N4) / 4.
constexpr std::array kVertexNormalsLines{
    Line{"for each {vertex}", Loop, {}, kElement},
    Line{"  if the mesh gives its {normal} then", If, "given", Begins::Step, "normal_weight=given"},
    Line{"    N = that, in world space", Do, {}, Begins::Step, "normal_weight=given"},
    Line{"  N = (0, 0, 0)", Do, {}, Begins::Step, {}, "normals/sums around vertices", "summed"},
    Line{"  for each {polygon} around it", Loop, "around", Begins::Step, {}, "normals/sums around vertices"},
    Line{"    N = N + {Ni}", Do, {}, Begins::Step, "normal_weight=mean|given"},
    Line{"    N = N + 2 area {Ni}", Do, {}, Begins::Step, "normal_weight=area"},
    Line{"    N = N + angle {Ni}", Do, {}, Begins::Step, "normal_weight=angle"},
    Line{"  N = N / |N|: {N}"},
};

// L1: "Shadow Z-Buffer", in its order of events.
constexpr std::array kShadowBufferLines{
    Line{"for each {light} that casts a shadow", Loop, {}, kOnce},
    Line{"  Z'[x'][y'] = infinity for all x', y'", Do, {}, kOnce},
    Line{"  for each {polygon}", Loop, {}, kElement},
    Line{"    for each pixel x', y' of it seen from the light"},
    Line{"      calculate z': {z'}"},
    Line{"      if z' < Z'[x'][y'] then Z'[x'][y'] = z'"},
    Line{"for each polygon, for each pixel x, y", Elsewhere, "in the z-buffer"},
    Line{"  calculate z", Elsewhere, "in the z-buffer"},
    Line{"  if z < Z-buf[x][y]", Elsewhere, "in the z-buffer"},
    Line{"    transform x, y, z to light coord space x', y', z'", Elsewhere, "in shading"},
    Line{"    if z' > Z'[x'][y']", Elsewhere, "in shading"},
    Line{"      reduce intensity (include only ambient)", Elsewhere, "in shading"},
    Line{"    Z-buf[x][y] = z; FB[x][y] = intensity", Elsewhere, "in shading"},
};

// L1: Lambertian flat, Gouraud and Phong shading, with the models of both lectures and OpenGL's. Polygons, vertices and
// pixels are evaluated by the same lines.
constexpr std::string_view kHere = "evaluated=here", kPixels = "element=polygon";
constexpr std::string_view kShadow = "shadow-buffer";
constexpr std::array kShadingLines{
    Line{"for each {object}", Loop, {}, kOnce, "element=polygon-terms|vertex-terms"},
    Line{"  for each {polygon}", Loop, {}, kElement, "element=polygon-terms"},
    Line{"  for each {vertex}", Loop, {}, kElement, "element=vertex-terms"},
    Line{"for each {polygon}", Loop, {}, kElement, kPixels},
    Line{"  for each pixel {x, y} that shows it", Loop, {}, Begins::Step, kPixels},
    Line{"    take {N} and {V}", Do, {}, Begins::Step, "element=polygon-terms|vertex-terms"},
    Line{"    I = {I} of the polygon", Do, {}, Begins::Step, "element=polygon shading=flat"},
    Line{"    take {λ} of the {vertices}",
         Do,
         {},
         Begins::Step,
         "element=polygon shading!=flat interpolation=perspective|affine"},
    Line{"    I = Σ λi Ii: {I}",
         Do,
         {},
         Begins::Step,
         "element=polygon shading=gouraud interpolation=perspective|affine"},
    Line{"    N = Σ λi Ni, normalised: {N}",
         Do,
         {},
         Begins::Step,
         "element=polygon shading=phong interpolation=perspective|affine"},
    Line{"    {Ia} = I1 + (I2 − I1) (ys − y1) / (y2 − y1)",
         Do,
         {},
         Begins::Step,
         "element=polygon shading=gouraud interpolation=scanline",
         {},
         "along the row"},
    Line{"    {Ib} = I1 + (I4 − I1) (ys − y1) / (y4 − y1)",
         Do,
         {},
         Begins::Step,
         "element=polygon shading=gouraud interpolation=scanline",
         {},
         "along the row"},
    Line{"    Is = Ia + (Ib − Ia) (xs − xa) / (xb − xa): {I}",
         Do,
         {},
         Begins::Step,
         "element=polygon shading=gouraud interpolation=scanline"},
    Line{"    {Na} = N1 + (N2 − N1) (ys − y1) / (y2 − y1)",
         Do,
         {},
         Begins::Step,
         "element=polygon shading=phong interpolation=scanline",
         {},
         "along the row"},
    Line{"    {Nb} = N1 + (N4 − N1) (ys − y1) / (y4 − y1)",
         Do,
         {},
         Begins::Step,
         "element=polygon shading=phong interpolation=scanline",
         {},
         "along the row"},
    Line{"    Ns = Na + (Nb − Na) (xs − xa) / (xb − xa): {N}",
         Do,
         {},
         Begins::Step,
         "element=polygon shading=phong interpolation=scanline"},
    Line{"    I = kd Ia: {ambient}", Do, {}, Begins::Step, "evaluated=here formula=phong", "shading/ambient term"},
    Line{"    c = ka ca: {ambient}",
         Do,
         {},
         Begins::Step,
         "evaluated=here formula=blinn-phong|cook-torrance",
         "shading/ambient term"},
    Line{"    I = {emission} + {ambient}", Do, {}, Begins::Step, "evaluated=here formula=other"},
    Line{"    I = {emission} + ka Ia: {ambient}", Do, {}, Begins::Step, "evaluated=here formula=opengl"},
    Line{"    for each {light}", Loop, "lights", Begins::Step, kHere},
    Line{"      I = I + {F} ka a: {light's ambient}", Do, {}, Begins::Step, "evaluated=here formula=opengl"},
    Line{"      if {N·L} > 0 then", If, "lit", Begins::Step, kHere},
    Line{"        transform x, y, z to light coord space: {x', y', z'}",
         Do,
         {},
         Begins::Step,
         "evaluated=here element=polygon shadows=on shadow=comparison",
         kShadow,
         "looked up"},
    Line{"        if {z'} > {Z'[x'][y']} + {bias} then", If, "in shadow", Begins::Step,
         "evaluated=here element=polygon shadows=on shadow=comparison", kShadow, "looked up"},
    Line{"          reduce intensity: S = {S}",
         Do,
         {},
         Begins::Step,
         "evaluated=here element=polygon shadows=on shadow=comparison",
         kShadow},
    Line{"        {S} = lit samples of the shadow z-buffer / all",
         Do,
         {},
         Begins::Step,
         "evaluated=here element=polygon shadows=on shadow=mean",
         kShadow},
    Line{"        I = I + S Ip kd (N·L): {diffuse}", Do, {}, Begins::Step, "evaluated=here formula=phong"},
    Line{"        c = c + S cl kd (L·n): {diffuse}", Do, {}, Begins::Step, "evaluated=here formula=blinn-phong"},
    Line{"        I = I + F d kd (N·L): {diffuse}", Do, {}, Begins::Step, "evaluated=here formula=opengl"},
    Line{"        c = c + S cl kd (1 − ks)² T (N·L): {diffuse}",
         Do,
         {},
         Begins::Step,
         "evaluated=here formula=cook-torrance"},
    Line{"        c = c + S cl F D G, H = (L + V) / |L + V|: {specular}",
         Do,
         {},
         Begins::Step,
         "evaluated=here formula=cook-torrance"},
    Line{"        I = I + S {diffuse} + S {specular}", Do, {}, Begins::Step, "evaluated=here formula=other"},
    Line{"        if {R·V} > 0, R = 2 (N·L) N − L, then", If, "mirrored", Begins::Step, "evaluated=here highlight=R",
         "shading/specular of light *"},
    Line{"        if {N·H} > 0, H = (L + V) / |L + V|, then", If, "mirrored", Begins::Step,
         "evaluated=here highlight=H", "shading/specular of light *"},
    Line{"        if {R·V or N·H} > 0, as the material says, then", If, "mirrored", Begins::Step,
         "evaluated=here highlight!=R|H|none", "shading/specular of light *"},
    Line{"          I = I + S Ip ks (R·V)^n: {specular}",
         Do,
         {},
         Begins::Step,
         "evaluated=here formula=phong|blinn-phong highlight=R"},
    Line{"          c = c + S cl ks (h·n)^s: {specular}",
         Do,
         {},
         Begins::Step,
         "evaluated=here formula=phong|blinn-phong highlight!=R"},
    Line{"          I = I + F s ks (N·H)^n: {specular}", Do, {}, Begins::Step, "evaluated=here formula=opengl"},
    Line{"    for each {light}", Loop, "lights", Begins::Step, "evaluated=before shadows=on", kShadow},
    Line{"      transform x, y, z to light coord space: {x', y', z'}",
         Do,
         {},
         Begins::Step,
         "evaluated=before shadows=on shadow=comparison",
         kShadow,
         "looked up"},
    Line{"      if {z'} > {Z'[x'][y']} + {bias} then", If, "in shadow", Begins::Step,
         "evaluated=before shadows=on shadow=comparison", kShadow, "looked up"},
    Line{"        reduce intensity: S = {S}",
         Do,
         {},
         Begins::Step,
         "evaluated=before shadows=on shadow=comparison",
         kShadow},
    Line{"      {S} = lit samples of the shadow z-buffer / all",
         Do,
         {},
         Begins::Step,
         "evaluated=before shadows=on shadow=mean",
         kShadow},
    Line{
        "    I = ambient + Σ S (diffuse + specular): {intensity}", Do, {}, Begins::Step, "evaluated=before shadows=on"},
    Line{"    I is within 0 and 1: {intensity}", Do, {}, Begins::Step, "evaluated=before shadows=off"},
    Line{"    store I, within 0 and 1: {intensity}",
         Do,
         {},
         Begins::Step,
         "element=polygon-terms|vertex-terms clamped=on"},
    Line{"    store I: {intensity}", Do, {}, Begins::Step, "element=polygon-terms|vertex-terms clamped=off"},
    Line{"    FB[x][y] = 255 I / Imax: {FB}", Do, {}, Begins::Step, kPixels},
};

constexpr std::array kWhiteLines{
    Line{"FB[x][y] = black for all x, y", Do, {}, kOnce},
    Line{"for each {polygon}", Loop, {}, kElement},
    Line{"  for each pixel {x, y} of its outline", Loop},
    Line{"    I = Imax: {intensity}"},
    Line{"    FB[x][y] = 255 I / Imax: {FB}"},
};

// L2, "Translucent Geometry".
constexpr std::array kBlendingLines{
    Line{"for each pixel {x, y}", Loop},
    Line{"  C = I of the opaque surface: {opaque}"},
    Line{"  sort its {layers} by depth", Do, {}, Begins::Step, "translucency=exact", "shading/sort of layers"},
    Line{"  take its {layers} by mean depth of their polygons", Do, {}, Begins::Step, "translucency=polygons"},
    Line{"  for each {polygon} of them, from back to front", Loop, "layers"},
    Line{"    C = {α} {I} + (1 − α) C: {C}"},
    Line{"  FB[x][y] = 255 C / Imax: {FB}"},
};

constexpr std::array kSampleLines{
    Line{"for each of the {samples} of a pixel"},     Line{"  move the picture to the sample"},
    Line{"  z-buffer: find what is seen there"},      Line{"  shading: compute its color c"},
    Line{"color(x, y) = mean of c over the samples"}, Line{"FB[x][y] = 255 color(x, y) / Imax"},
};

constexpr std::string_view kDeferred =
    "Shadescope shades after the z-buffer, once for each pixel that is seen. The result is the same.";
constexpr std::string_view kAtPixels = "Shadows come in at the pixels: here S = 1.";

constexpr std::array kTexts{
    AlgorithmText{"transform", "Transform, lecture 1", StageId::Transform, "vertex", "",
                  "Scale, rotation and translation are one matrix.", kTransformLines},
    AlgorithmText{"back-faces", "Back-face culling, lecture 1", StageId::Cull, "polygon", "", "", kCullLines},
    AlgorithmText{"calcnormal", "CalcNormal, lecture 1", StageId::Normals, "polygon", "", "", kCalcNormalLines},
    AlgorithmText{"vertex-normals", "Vertex normals, lecture 1", StageId::Normals, "vertex", "", "",
                  kVertexNormalsLines},
    AlgorithmText{"shadow-z-buffer", "Shadow z-buffer, lecture 1", StageId::ShadowBuffer, "polygon", "",
                  "A step draws all pixels of a polygon, into all faces of the light's buffer.", kShadowBufferLines},
    AlgorithmText{"outlines", "Outlines, lecture 1", StageId::ZBuffer, "polygon", "visibility=none",
                  "Nothing decides what is hidden.", kOutlineLines},
    AlgorithmText{"painter", "Painter's algorithm, lecture 2", StageId::ZBuffer, "piece", "",
                  "Colours are computed in shading, for the polygon that was painted last.", kPainterLines},
    AlgorithmText{"setpixel", "Depth test: setpixel, lecture 2", StageId::ZBuffer, "polygon", "",
                  "Colours are computed in shading, once for each pixel that is seen. The picture is the same.",
                  kSetpixelLines},
    AlgorithmText{"white", "Outlines in white", StageId::Shading, "polygon", "visibility=none", "", kWhiteLines},
    AlgorithmText{"illumination", "Illumination: OpenGL, lecture 1", StageId::Shading, "polygon-terms|vertex-terms",
                  "formula=opengl", "", kShadingLines},
    AlgorithmText{"illumination", "Illumination: Blinn-Phong, lecture 2", StageId::Shading,
                  "polygon-terms|vertex-terms", "formula=blinn-phong", kAtPixels, kShadingLines},
    AlgorithmText{"illumination", "Illumination: Cook-Torrance", StageId::Shading, "polygon-terms|vertex-terms",
                  "formula=cook-torrance", kAtPixels, kShadingLines},
    AlgorithmText{"illumination", "Illumination: Phong, lecture 1", StageId::Shading, "polygon-terms|vertex-terms",
                  "formula=phong", kAtPixels, kShadingLines},
    AlgorithmText{"illumination", "Illumination", StageId::Shading, "polygon-terms|vertex-terms", "formula=other",
                  kAtPixels, kShadingLines},
    AlgorithmText{"flat", "Flat shading, lecture 1", StageId::Shading, "polygon", "shading=flat", kDeferred,
                  kShadingLines},
    AlgorithmText{"double-interpolation", "Gouraud: double interpolation, lecture 1", StageId::Shading, "polygon",
                  "shading=gouraud interpolation=scanline", kDeferred, kShadingLines},
    AlgorithmText{"gouraud", "Gouraud shading, lecture 1", StageId::Shading, "polygon", "shading=gouraud", kDeferred,
                  kShadingLines},
    AlgorithmText{"phong", "Phong shading, lecture 1", StageId::Shading, "polygon", "formula=phong", kDeferred,
                  kShadingLines},
    AlgorithmText{"phong", "Phong shading with Blinn-Phong's model, lecture 2", StageId::Shading, "polygon",
                  "formula=blinn-phong", kDeferred, kShadingLines},
    AlgorithmText{"phong", "Phong shading with OpenGL's model, lecture 1", StageId::Shading, "polygon",
                  "formula=opengl", kDeferred, kShadingLines},
    AlgorithmText{"phong", "Phong shading with Cook-Torrance's model", StageId::Shading, "polygon",
                  "formula=cook-torrance", kDeferred, kShadingLines},
    AlgorithmText{"phong", "Phong shading", StageId::Shading, "polygon", "formula=other", kDeferred, kShadingLines},
    AlgorithmText{"blending", "Translucent surfaces, lecture 2", StageId::Shading, "layers", "",
                  "A step lays the layers over all pixels; the values are those of the first pixel with most layers.",
                  kBlendingLines},
    AlgorithmText{"samples", "Antialiasing", StageId::Shading, "samples", "", "", kSampleLines},
};

}  // namespace

std::span<const AlgorithmText> algorithmTable() { return kTexts; }

}  // namespace pipeline
