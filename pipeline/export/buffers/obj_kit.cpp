#include "pipeline/export/buffers/obj_kit.h"

#include <fmt/format.h>

#include <cmath>

#include <numbers>

#include "pipeline/core/numerics.h"
#include "pipeline/core/text.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/scene/object_matrix.h"
#include "pipeline/scene/view.h"

namespace pipeline {

namespace {

std::string text(const Vec3d& v) {
    return fmt::format("{} {} {}", shortestText(v.x), shortestText(v.y), shortestText(v.z));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> objKit(const Scene& scene, const std::string& name) {
    std::string obj = fmt::format("# World space, right-handed; front faces run counter-clockwise.\nmtllib {}.mtl\n",
                                  name),
                mtl;
    std::size_t vertices = 1, normals = 1;  // OBJ counts from 1
    for (std::size_t k = 0; k < scene.objects.size(); ++k) {
        const Object& object = scene.objects[k];
        const ObjectMatrix matrix = makeObjectMatrix(object.transform);
        const glm::dmat3 ofNormals = normalMatrix(matrix);
        obj += fmt::format("o object{0}\nusemtl material{0}\n", k);
        for (const Vec3d& p : object.mesh->positions) obj += "v " + text(toWorld(matrix, p)) + '\n';
        for (const Vec3d& n : object.mesh->normals) obj += "vn " + text(normalized(ofNormals * n)) + '\n';
        const bool hasNormals = object.mesh->normals.size() == object.mesh->positions.size();
        for (std::size_t p = 0; p < object.mesh->polygonCount(); ++p) {
            const auto polygon = object.mesh->polygon(p);
            obj += 'f';
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const std::size_t corner = polygon[matrix.mirrors ? polygon.size() - 1 - i : i];
                obj += hasNormals ? fmt::format(" {}//{}", vertices + corner, normals + corner)
                                  : fmt::format(" {}", vertices + corner);
            }
            obj += '\n';
        }
        vertices += object.mesh->positions.size(), normals += object.mesh->normals.size();
        const Material& material = object.material;
        mtl += fmt::format("newmtl material{}\nKa {}\nKd {}\nKs {}\nNs {}\n", k,
                           text(ambientCoefficient(scene.settings.model, material)), text(material.diffuse),
                           text(material.specular), shortestText(material.exponent));
    }
    const View view = makeView(scene);
    std::string numbers = fmt::format(
        "size {} {}\neye {}\nright {}\nup {}\nforward {}\n# x = {} + {} x_v / z_v, y = {} - {} y_v / z_v from the "
        "top\n",
        view.size.x, view.size.y, text(view.eye), text(view.right), text(view.up), text(view.forward),
        shortestText(view.centre.x), shortestText(view.scale.x), shortestText(view.centre.y),
        shortestText(view.scale.y));
    if (view.perspective)
        numbers += fmt::format("fov_y {}\n",
                               shortestText(2 * std::atan(view.size.y / 2.0 / view.scale.y) * 180 / std::numbers::pi));
    numbers += fmt::format("near {}\nfar {}\nambient {}\n", shortestText(view.near), shortestText(view.far),
                           text(scene.ambient.lightIn(scene.settings.model)));
    for (const Light& light : scene.lights)
        numbers += fmt::format("{} {} intensity {} shadow {}\n",
                               light.kind == LightKind::AtInfinity ? "light towards" : "light at", text(light.position),
                               text(light.intensity * light.color), light.castsShadow ? "on" : "off");
    numbers += fmt::format("# 255 stands for this intensity, of this model:\nwhite {}\nmodel {}\n",
                           shortestText(maximumIntensity(scene)), modelFacts(scene.settings.model).name);
    return {{name + ".obj", obj}, {name + ".mtl", mtl}, {name + ".txt", numbers}};
}

}  // namespace pipeline
