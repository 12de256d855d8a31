#include "pipeline/plan/stage_keys.h"

#include "pipeline/scene/area_light.h"
#include "pipeline/stages/shading_terms.h"

namespace pipeline {

StageKeys stageKeys(const Scene& scene, const Needs& needs, std::shared_ptr<const Topology> topology) {
    const Settings& settings = scene.settings;
    StageKeys keys{transformInputs(scene, std::move(topology), !needs[Part::ModelTransform]),
                   {settings.cull},
                   {settings.normalWeight, bool(needs[Part::PolygonNormals]), bool(needs[Part::VertexNormals]),
                    needs.ownNormals, settings.forms.polygonNormal, settings.forms.cornerAngle, settings.forms.unit,
                    needs[Part::VertexNormals] && !needs[Part::Normalisation]},
                   {{}, settings.shadowSize, settings.shadowCull},
                   {settings.visibility, settings.split, translucentSides(scene), needs.parts(StageId::ZBuffer)},
                   {settings.shading,
                    settings.shading == Shading::Flat ? Interpolation::Perspective : settings.interpolation,
                    settings.visibility == Visibility::None,
                    illuminationOf(settings),
                    {},
                    {},
                    {},
                    scene.ambient,
                    {settings.shadowBias, settings.shadowBiasValue, settings.shadowFilter},
                    needs.parts(StageId::Shading)}};
    keys.shading.illumination.detail = {
        bool(needs[Part::Reflection]), bool(needs[Part::Halfway]), !needs.rules[index(Rule::Specular)],
        needs[Part::Powers].isWhole(), settings.forms.power,       settings.forms.unit};
    if (needs[Part::Layers])
        keys.shading.layers = {true, bool(needs[Part::LayerSort]), settings.translucency,
                               settings.visibility == Visibility::ZBuffer, keys.zBuffer.translucent};
    keys.shading.firstVertexNormal = lightsFirstVertex(settings);
    keys.shading.colored = hasVertexColors(scene);
    keys.shading.samples = settings.antialiasing;
    keys.shading.samplePattern = settings.antialiasingPattern;
    for (const Object& object : scene.objects) {
        keys.shading.materials.push_back(object.material);
        keys.shading.backMaterials.push_back(object.backMaterial.value_or(object.material));
    }
    keys.shading.lights = lightsInWorldSpace(scene, keys.transform.view);
    if (!needs[Part::NegligiblePowers].isWhole())
        keys.shading.illumination.detail.logContrast = logContrast(keys.shading);
    const std::vector<Light>& lights = keys.shading.lights;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        if (needs.of(Part::ShadowBuffer, k))
            keys.shadowBuffer.casters.push_back({lights[k].kind, samplePlaces(lights[k])});
        else
            keys.shadowBuffer.casters.push_back({});
    }
    const bool planted = settings.isPlanted();
    if (planted) spoilGiven(scene, keys);
    return keys;
}

}  // namespace pipeline
