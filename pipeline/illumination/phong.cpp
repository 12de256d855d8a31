#include "pipeline/illumination/phong.h"

namespace pipeline {

double maximumIntensity(const std::vector<Material>& materials, const std::vector<Light>& lights,
                        const AmbientLight& ambient) {
    double diffuse = 0, specular = 0;
    for (const Material& material : materials) {
        diffuse = std::max(diffuse, largestComponent(material.diffuse));
        specular = std::max(specular, largestComponent(material.specular));
    }
    double maximum = diffuse * ambient.intensity * largestComponent(ambient.color);
    for (const Light& light : lights) maximum += light.intensity * largestComponent(light.color) * (diffuse + specular);
    return maximum;
}

}  // namespace pipeline
