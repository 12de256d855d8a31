#include "pipeline/compare/known_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "pipeline/core/angles.h"
#include "pipeline/core/elementary.h"
#include "pipeline/core/numerics.h"
#include "pipeline/core/text.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/defects/defect_ways.h"
#include "pipeline/scene/mesh/make_mesh.h"
#include "pipeline/scene/object_matrix.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/scene/view.h"

namespace pipeline::foreign {

namespace {

void each(Scene& scene, const std::function<void(Material&)>& change) {
    for (Object& object : scene.objects) {
        change(object.material);
        if (object.backMaterial) change(*object.backMaterial);
    }
}

// A mesh of the same polygons.
std::shared_ptr<const Mesh> reshaped(const Mesh& mesh, std::vector<Vec3d> positions, std::vector<Vec3d> normals,
                                     bool reversed) {
    Mesh out;
    for (const Vec3d& p : positions) out.positions.push_back(p);
    for (const Vec3d& n : normals) out.normals.push_back(n);
    out.colors = mesh.colors;
    for (std::size_t p = 0; p < mesh.polygonCount(); ++p) {
        const auto corners = mesh.polygon(p);
        std::vector<std::uint32_t> order(corners.begin(), corners.end());
        if (reversed) std::ranges::reverse(order);
        out.addPolygon(order);
    }
    return makeMesh(std::move(out));
}

// The scene with the vertices of each object where `place` puts them, and its given normals through the same matrix.
Scene placed(Scene scene, const std::function<ObjectMatrix(ObjectTransform)>& place) {
    for (Object& object : scene.objects) {
        const ObjectMatrix matrix = place(object.transform);
        const glm::dmat3 ofNormals = glm::transpose(glm::inverse(matrix.linear));
        std::vector<Vec3d> positions, normals;
        for (const Vec3d& p : object.mesh->positions) positions.push_back(matrix.linear * p + matrix.translation);
        for (const Vec3d& n : object.mesh->normals) normals.push_back(normalized(ofNormals * n));
        object.mesh = reshaped(*object.mesh, positions, normals, glm::determinant(matrix.linear) < 0);
        object.transform = {};
    }
    return scene;
}

// The scene with its vertices moved to whole pixels, at their depths. round: to the nearest, else to the left and up.
Scene atWholePixels(Scene scene, bool round) {
    const View view = makeView(scene);
    Scene moved = placed(scene, makeObjectMatrix);
    for (Object& object : moved.objects) {
        std::vector<Vec3d> positions(object.mesh->positions.begin(), object.mesh->positions.end());
        for (Vec3d& p : positions) {
            const Vec3d at = toView<double>(view, p);
            const double z = view.perspective ? at.z : 1;
            if (!(z > 0) || at.z < view.near) continue;
            glm::dvec2 pixel(view.centre.x + view.scale.x * at.x / z, view.centre.y - view.scale.y * at.y / z);
            pixel = round ? glm::round(pixel) : glm::floor(pixel);
            p = worldPoint(view, pixel, at.z);
        }
        object.mesh =
            reshaped(*object.mesh, positions, {object.mesh->normals.begin(), object.mesh->normals.end()}, false);
    }
    return moved;
}

// Errors of placing objects and camera.
void addErrorsOfPlacing(
    const Scene& scene,
    const std::function<void(std::string, std::string, std::string, std::string, std::function<void(Scene&)>)>& add) {
    const auto turnsOtherwise = [](Scene& s, const std::array<int, 3>& last) {
        for (Object& o : s.objects) {
            if (!o.transform.turns.empty()) continue;
            // The last that is written is the first to act.
            for (const int axis : last) {
                Vec3d about(0);
                about[axis] = 1;
                o.transform.turns.push_back({o.transform.rotation[axis], about});
            }
        }
    };
    const auto isTurned = [](const Object& o) {
        return (o.transform.rotation.x != 0) + (o.transform.rotation.y != 0) + (o.transform.rotation.z != 0) > 1;
    };
    if (std::ranges::any_of(scene.objects, isTurned))
        add("rotation-order", "rotations are made in the order z, y, x", "R = R_x R_y R_z", "R = R_z R_y R_x",
            [=](Scene& s) {
                turnsOtherwise(s, {0, 1, 2});
            });
    const auto isStretched = [](const Object& o) {
        const Vec3d scale = o.transform.scale;
        return (scale.x != scale.y || scale.y != scale.z) && o.transform.rotation != Vec3d(0);
    };
    if (std::ranges::any_of(scene.objects, isStretched))
        add("scale-last", "objects are scaled after they are turned", "p = S R v + t", "p = R S v + t", [](Scene& s) {
            s = placed(s, [](ObjectTransform t) {
                const Vec3d scale = t.scale;
                t.scale = Vec3d(1);
                ObjectMatrix matrix = makeObjectMatrix(t);
                matrix.linear = glm::dmat3(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z) * matrix.linear;
                return matrix;
            });
        });
    add("one-scale", "one factor of scale is taken for all axes", "s_x for x, y and z", "s_x, s_y, s_z", [](Scene& s) {
        for (Object& o : s.objects) o.transform.scale = Vec3d(o.transform.scale.x);
    });
    add("whole-pixels", "vertices are cut off to whole pixels", "x_s = int(…)", "x_s as it is",
        [](Scene& s) { s = atWholePixels(std::move(s), false); });
    add("rounded-pixels", "vertices are rounded to whole pixels", "x_s = round(…)", "x_s as it is",
        [](Scene& s) { s = atWholePixels(std::move(s), true); });
    if (scene.camera.kind == CameraKind::LookAt && scene.camera.projection == ProjectionKind::Perspective)
        add("horizontal-fov", "the field of view is taken across instead of up", "d = (w/2) / tan(fov/2)",
            "d = (h/2) / tan(fov/2)", [](Scene& s) {
                const double half = sinDegrees(s.camera.fovY / 2) / cosDegrees(s.camera.fovY / 2) * s.settings.height /
                                    s.settings.width;
                s.camera.fovY = pipeline::atan2(half, 1.0) * 360 / std::numbers::pi;
            });
}

// Ways of planting a defect that are errors of their own to those who have made them.
struct OwnName {
    Defect defect;
    int way;
    std::string_view id, name;  // name and right: empty where the row has them
    StageId stage;
    std::string_view wrong, right;
    int other = -1;                 // another way of making the same error, if there is one
    std::string_view otherWrong{};  // its line; empty: the same
};
constexpr std::string_view kPower = "k_s c (R·V)^n", kInterpolated = "N = Σ λ_i N_i, made unit",
                           kTowardsEye = "V = (eye − p) / |eye − p|", kFromMiddle = "x_s = w/2 + d x_v / z_v",
                           kDepth = "1 / z = Σ λ_i / z_i", kWeights = "the weights of two vertices are exchanged";
constexpr std::array kOwnNames{
    OwnName{Defect::TrsOrder, kTheOtherWay, "rotation-sign", "objects turn the other way", StageId::Transform,
            "R(−angle)", "R(angle)"},
    OwnName{Defect::CullAxis, kAlongTheLight, "cull-light", "the light's direction is used for culling", StageId::Cull,
            "drop where N·L < 0", "drop where N·(p − eye) > 0"},
    OwnName{Defect::NoMax, 2, "half-lambert", "half Lambert: light reaches the night side", StageId::Shading,
            "k_d c (N·L + 1) / 2", "k_d c max(0, N·L)", 3, "k_d c ((N·L + 1) / 2)²"},
    OwnName{Defect::AmbientInShadow, kHighlightInShadow, "spec-in-shadow", "the highlight is left in the shadow",
            StageId::Shading, "S k_d c N·L + k_s c (R·V)^n", "S (k_d c N·L + k_s c (R·V)^n)"},
    OwnName{Defect::Exponent, 2, "no-power", "the exponent is left out", StageId::Shading, "k_s c R·V", kPower},
    OwnName{Defect::Exponent, 3, "times-n", "times n instead of to the power n", StageId::Shading, "k_s c (R·V) n",
            kPower},
    OwnName{Defect::Exponent, kPowerOfNegative, "power-of-negative",
            "the power of a negative number is NaN: black pixels", StageId::Shading, "k_s c (R·V)^n also where R·V < 0",
            "k_s c max(0, R·V)^n"},
    OwnName{Defect::BlocksOfFour, kFourByFour, idOf(Defect::BlocksOfFour), "", StageId::Shading,
            "FB(x, y) = colour at 4 int(x/4), 4 int(y/4)", ""},
    OwnName{Defect::RFlip, 2, "r-parenthesis", "brackets in the mirror direction", StageId::Shading,
            "R = 2 (N·L) (N − L)", "R = 2 (N·L) N − L", 3, "R = unit(2 (N·L) (N − L))"},
    OwnName{Defect::EyeAtOrigin, 1, "v-reversed", "V from the eye to the surface", StageId::Shading,
            "V = (p − eye) / |p − eye|", kTowardsEye},
    OwnName{Defect::EyeAtOrigin, 2, "v-axis", "the viewing axis is taken for V", StageId::Shading, "V = −forward",
            kTowardsEye},
    OwnName{Defect::NoBias, 1, "bias-sign", "shadow bias with the wrong sign", StageId::Shading, "z' > Z' − b",
            "z' > Z' + b"},
    OwnName{Defect::NormalMatrix, kUntouched, "normals-untouched", "normals of the object are used in the world",
            StageId::Normals, "N of the file", "N' = (M⁻¹)ᵀ N", kGivenUntouched},
    OwnName{Defect::NormalShort, kOneVertex, "one-normal", "one vertex's normal for the whole polygon",
            StageId::Shading, "N = N_0", kInterpolated},
    OwnName{Defect::NormalShort, kMeanNotUnit, "mean-not-unit", "normals of vertices are left as means",
            StageId::Normals, "N_v = Σ N_p / m", "N_v = Σ N_p / |Σ N_p|"},
    OwnName{Defect::NormalShort, kAlike, "weights-alike", "the vertices of a triangle count alike at every pixel",
            StageId::Shading, "N = (N_0 + N_1 + N_2) / 3, made unit", kInterpolated},
    OwnName{Defect::NormalShort, kSortedAlone, "data-unsorted", "vertices are sorted by y without their normals",
            StageId::Shading, "N of the vertex that stood there before", kInterpolated},
    OwnName{Defect::NormalShort, kExchanged, "weights-swapped", kWeights, StageId::Shading,
            "N = λ_1 N_0 + λ_0 N_1 + λ_2 N_2, made unit", kInterpolated},
    OwnName{Defect::ZAffine, 1, "one-depth", "one depth for a triangle", StageId::ZBuffer, "z = (z_0 + z_1 + z_2) / 3",
            kDepth},
    OwnName{Defect::ZAffine, kExchangedDepths, "weights-swapped", kWeights, StageId::ZBuffer,
            "1 / z = λ_1 / z_0 + λ_0 / z_1 + λ_2 / z_2", kDepth},
    OwnName{Defect::ZAffine, kDividedTwice, "divided-twice", "the depth is divided by z twice", StageId::ZBuffer,
            "depth = z_clip / w²", "depth = z_clip / w", kNdcDividedTwice},
    OwnName{Defect::ZNoWrite, 1, "no-test", "painted without a depth test", StageId::ZBuffer, "FB(x, y) = colour",
            "if z < zbuffer(x, y): FB(x, y) = colour"},
    OwnName{Defect::YDown, 1, "view-transposed", "the viewing matrix is transposed", StageId::Transform, "p_v = Rᵀ p",
            "p_v = R p"},
    OwnName{Defect::HalfAngle, kOneDistance, "no-division", "divided by one distance instead of z", StageId::Transform,
            "x_s = w/2 + d x_v / ρ", kFromMiddle},
    OwnName{Defect::HalfAngle, 2, "double-angle", "half of the field of view is taken for the whole",
            StageId::Transform, "d = h / (2 tan (fov / 4))", "d = h / (2 tan (fov / 2))"},
    OwnName{Defect::HalfPixel, 4, "column", "the picture is moved by one column", StageId::Transform,
            "x_s = w/2 + d x_v / z_v + 1", kFromMiddle, 5, "x_s = w/2 + d x_v / z_v − 1"},
    OwnName{Defect::HalfPixel, 6, "row", "the picture is moved by one row", StageId::Transform,
            "y_s = h/2 − d y_v / z_v + 1", "y_s = h/2 − d y_v / z_v", 7, "y_s = h/2 − d y_v / z_v − 1"},
};
const OwnName* ownNameOf(Defect defect, int way) {
    const auto found = std::ranges::find_if(
        kOwnNames, [&](const OwnName& one) { return one.defect == defect && (one.way == way || one.other == way); });
    return found == kOwnNames.end() ? nullptr : &*found;
}

// Errors of those who write a renderer for a scene that is given: a number that is read wrongly, a term that is left out.
std::vector<KnownError> errorsOfReading(const Scene& scene) {
    std::vector<KnownError> out;
    const StageId shading = StageId::Shading, transform = StageId::Transform;
    const auto add = [&](std::string id, std::string name, StageId stage, std::string wrong, std::string right,
                         std::function<void(Scene&)> change) {
        KnownError error{std::move(id), std::move(name), stage, std::move(wrong), std::move(right), {}, {}, {}, {}};
        error.plant = [change = std::move(change)](Scene planted) {
            change(planted);
            return planted;
        };
        out.push_back(std::move(error));
    };
    add("no-ambient", "the ambient term is missing", shading, "I = diffuse + specular",
        "I = ambient + diffuse + specular", [](Scene& s) { s.ambient.intensity = 0; });
    add("no-specular", "the specular term is missing", shading, "I = ambient + diffuse",
        "I = ambient + diffuse + specular", [](Scene& s) { each(s, [](Material& m) { m.specular = Vec3d(0); }); });
    add("no-diffuse", "the diffuse term is missing", shading, "I = ambient + specular",
        "I = ambient + diffuse + specular", [](Scene& s) {
            each(s, [](Material& m) {
                m.ambient = m.diffuse;
                m.diffuse = Vec3d(0);
            });
        });
    for (const double factor : {2.0, 0.5})
        add(fmt::format("exponent-{}", shortestText(factor)),
            fmt::format("the exponent n is taken times {}", shortestText(factor)), shading,
            fmt::format("(R·V)^({} n)", shortestText(factor)), "(R·V)^n",
            [factor](Scene& s) { each(s, [&](Material& m) { m.exponent *= factor; }); });
    add("other-lobe", "the other highlight is computed: Phong's for Blinn's or the other way round", shading,
        "(N·H)^n for (R·V)^n, or (R·V)^n for (N·H)^n", "the scene's model", [](Scene& s) {
            for (Object& o : s.objects)
                o.material.highlight =
                    usesHalfway(s.settings.model, o.material) ? Highlight::Phong : Highlight::BlinnPhong;
        });
    add("no-shadow", "shadows are missing", shading, "S = 1", "S from the shadow buffer", [](Scene& s) {
        for (Light& light : s.lights) light.castsShadow = false;
    });
    add("white-light", "the colour of the lights is not used", shading, "I_p", "I_p c", [](Scene& s) {
        for (Light& light : s.lights) light.color = Vec3d(1);
    });
    add("flat-for-smooth", "polygons have one normal each", shading, "the normal of the polygon",
        "the interpolated normal", [](Scene& s) { s.settings.shading = Shading::Flat; });
    add("gouraud-for-phong", "intensities are interpolated instead of normals", shading, "I interpolated",
        "N interpolated, then I", [](Scene& s) { s.settings.shading = Shading::Gouraud; });
    add("no-cull", "back faces are drawn", StageId::Cull, "every polygon", "polygons with a positive area",
        [](Scene& s) { s.settings.cull = CullMode::None; });
    add("mean-normals", "vertex normals are the means of the polygons around instead of those given", StageId::Normals,
        "the mean", "the mesh's normals", [](Scene& s) { s.settings.normalWeight = NormalWeight::Mean; });
    if (scene.lights.size() > 1) {
        add("first-light", "only the first light shines", shading, "light 0", "the sum over the lights", [](Scene& s) {
            for (std::size_t k = 1; k < s.lights.size(); ++k) s.lights[k].intensity = 0;
        });
        add("last-light", "only the last light shines", shading, "the last light", "the sum over the lights",
            [](Scene& s) {
                for (std::size_t k = 0; k + 1 < s.lights.size(); ++k) s.lights[k].intensity = 0;
            });
    }
    add("at-infinity", "lights with a place are taken as directions", shading, "L = p / |p|", "L = (p − x) / |p − x|",
        [](Scene& s) {
            for (Light& light : s.lights)
                if (light.kind == LightKind::Point) light.kind = LightKind::AtInfinity;
        });
    add("as-point", "directions towards lights are taken as places", shading, "L = (p − x) / |p − x|", "L = p / |p|",
        [](Scene& s) {
            for (Light& light : s.lights)
                if (light.kind == LightKind::AtInfinity) light.kind = LightKind::Point;
        });
    add("unscaled", "the scale of the objects is left out", transform, "p = R v + t", "p = R S v + t", [](Scene& s) {
        for (Object& o : s.objects) o.transform.scale = Vec3d(1);
    });
    add("no-rotation", "the rotation of the objects is left out", transform, "p = S v + t", "p = R S v + t",
        [](Scene& s) {
            for (Object& o : s.objects) o.transform.rotation = Vec3d(0), o.transform.turns.clear();
        });
    add("no-translation", "the translation of the objects is left out", transform, "p = R S v", "p = R S v + t",
        [](Scene& s) {
            for (Object& o : s.objects) o.transform.translation = Vec3d(0);
        });
    addErrorsOfPlacing(scene, [&](std::string id, std::string name, std::string wrong, std::string right,
                                  std::function<void(Scene&)> change) {
        add(std::move(id), std::move(name), transform, std::move(wrong), std::move(right), std::move(change));
    });
    if (scene.camera.kind == CameraKind::Spherical) {
        add("elevation", "φ is measured from the ground", transform, "z = ρ sin φ", "z = ρ cos φ",
            [](Scene& s) { s.camera.phi = 90 - s.camera.phi; });
        add("theta-sign", "θ turns the other way", transform, "θ → −θ", "θ",
            [](Scene& s) { s.camera.theta = -s.camera.theta; });
    } else {
        add("half-angle", "the field of view is taken as half of itself", transform, "tan(fov)", "tan(fov / 2)",
            [](Scene& s) { s.camera.fovY = std::min(170.0, 2 * s.camera.fovY); });
    }
    add("orthographic", "the division by z is missing: a parallel projection", transform, "x_s = d x_v",
        "x_s = d x_v / z_v", [](Scene& s) { s.camera.projection = ProjectionKind::Orthographic; });
    return out;
}

}  // namespace

std::vector<KnownError> knownErrors(const Scene& scene) {
    std::vector<KnownError> all;
    for (const DefectRow& row : defectTable())
        for (int way = 0; way < row.wayCount(); ++way) {
            KnownError error;
            error.id = row.idText(), error.name = row.name, error.stage = row.stage;
            error.wrong = row.wrong, error.right = row.fix;
            error.lesson = row.lesson, error.heading = row.heading;
            if (way > 0) error.way = row.otherWays[std::size_t(way) - 1];
            if (row.id == Defect::NormalShort && way == 1) error.leaves = {BufferId::Normal};
            if (const OwnName* const own = ownNameOf(row.id, way)) {
                error.id = own->id, error.stage = own->stage, error.way.clear();
                if (!own->name.empty()) error.name = own->name;
                if (!own->right.empty()) error.right = own->right;
                error.wrong = way == own->way || own->otherWrong.empty() ? own->wrong : own->otherWrong;
            }
            error.plant = [id = row.id, way](Scene planted) { return plantToo(std::move(planted), id, way); };
            all.push_back(std::move(error));
        }
    for (KnownError& error : errorsOfReading(scene))
        if (!findDefect(error.id)) all.push_back(std::move(error));
    using enum BufferId;
    for (KnownError& error : all)
        if (error.id == "whole-pixels" || error.id == "rounded-pixels")
            error.leaves = {VerticesWorld, VerticesView, PolygonsNormal, VerticesNormal};
    // What changes nothing, or cannot be drawn, explains nothing.
    std::erase_if(all, [&](const KnownError& error) {
        if (error.id == "mean-not-unit" && scene.settings.normalWeight != NormalWeight::Mean) return true;
        if (error.id == "divided-twice" && scene.settings.depthFormat == DepthFormat::Linear) return true;
        const Scene planted = error.plant(scene);
        return planted == scene || !checkScene(planted).empty();
    });
    return all;
}

}  // namespace pipeline::foreign
