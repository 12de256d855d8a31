#include "pipeline/compare/known_errors.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/core/text.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/scene/settings_table.h"

namespace pipeline::foreign {

namespace {

void each(Scene& scene, const std::function<void(Material&)>& change) {
    for (Object& object : scene.objects) {
        change(object.material);
        if (object.backMaterial) change(*object.backMaterial);
    }
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
    for (const double factor : {4.0, 0.25, 2.0, 0.5})
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
    add("no-scale", "the scale of the objects is left out", transform, "p = R v + t", "p = R S v + t", [](Scene& s) {
        for (Object& o : s.objects) o.transform.scale = Vec3d(1);
    });
    add("no-rotation", "the rotation of the objects is left out", transform, "p = S v + t", "p = R S v + t",
        [](Scene& s) {
            for (Object& o : s.objects) o.transform.rotation = Vec3d(0), o.transform.turns.clear();
        });
    add("rotation-sign", "objects turn the other way", transform, "R(−angle)", "R(angle)", [](Scene& s) {
        for (Object& o : s.objects) o.transform.rotation = -o.transform.rotation;
    });
    add("no-translation", "the translation of the objects is left out", transform, "p = R S v", "p = R S v + t",
        [](Scene& s) {
            for (Object& o : s.objects) o.transform.translation = Vec3d(0);
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
            error.plant = [id = row.id, way](Scene planted) { return plant(std::move(planted), id, way); };
            all.push_back(std::move(error));
        }
    for (KnownError& error : errorsOfReading(scene))
        if (!findDefect(error.id)) all.push_back(std::move(error));
    // What changes nothing, or cannot be drawn, explains nothing.
    std::erase_if(all, [&](const KnownError& error) {
        const Scene planted = error.plant(scene);
        return planted == scene || !checkScene(planted).empty();
    });
    return all;
}

}  // namespace pipeline::foreign
