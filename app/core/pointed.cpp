#include "app/core/pointed.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "app/core/numbers.h"
#include "app/core/text.h"
#include "pipeline/buffers/buffer_table.h"

namespace app {

using pipeline::BufferId;
using pipeline::VectorCode;

std::vector<VectorCode> vectorsOf(const QString& refers) {
    const auto name = pipeline::findBuffer(refers.toStdString());
    if (!name) return {};
    switch (name->id) {
        case BufferId::Normal: return {VectorCode::N};
        case BufferId::LightVector: return {VectorCode::L};
        case BufferId::ViewVector: return {VectorCode::V};
        case BufferId::ReflectionVector: return {VectorCode::R};
        case BufferId::HalfwayVector: return {VectorCode::H};
        case BufferId::NDotL: return {VectorCode::N, VectorCode::L};
        case BufferId::RDotV: return {VectorCode::R, VectorCode::V};
        case BufferId::NDotH: return {VectorCode::N, VectorCode::H};
        default: return {};
    }
}

std::vector<pipeline::SettingRef> differingSettings(const pipeline::Scene& a, const pipeline::Scene& b) {
    std::vector<pipeline::SettingRef> differing;
    for (const pipeline::SettingRef& setting : settingsOf(a))
        if (setting.index < setting.setting->count(b) && setting.get(a) != setting.get(b)) differing.push_back(setting);
    return differing;
}

QString labelOf(const pipeline::SettingRef& setting) {
    QString label = toQString(setting.setting->label);
    if (label.startsWith("I_p ")) label.replace(2, 1, QString::number(setting.index));
    return label;
}

QString symbolOf(const pipeline::SettingRef& setting) {
    const QString label = labelOf(setting);
    static const QRegularExpression symbol("^\\p{L}(_\\w+)?( [xyz]$|(?= |$))",
                                           QRegularExpression::UseUnicodePropertiesOption);
    const auto match = symbol.match(label);
    return match.hasMatch() ? match.captured() : label;
}

QString maximumText(const pipeline::Scene& scene, double iMax) {
    if (scene.settings.model != pipeline::Model::Phong)
        return "I_max, the intensity that 255 stands for: 1 in this model, whose colours go from 0 to 1.";
    double diffuse = 0, specular = 0;
    for (const pipeline::Object& object : scene.objects)
        for (int c = 0; c < 3; ++c) {
            diffuse = std::max(diffuse, object.material.diffuse[c]);
            specular = std::max(specular, object.material.specular[c]);
        }
    QStringList most;
    double sum = 0;
    for (int c = 0; c < 3; ++c) {  // the channel in which it is largest
        const double ambient = std::max(0.0, scene.ambient.lightIn(scene.settings.model)[c]);
        QStringList terms{QStringLiteral("%1·%2").arg(fullPrecision(diffuse), fullPrecision(ambient))};
        double total = diffuse * ambient;
        for (const pipeline::Light& light : scene.lights) {
            const double intensity = std::max(0.0, light.intensity * light.color[c]);
            total += intensity * (diffuse + specular);
            terms << QStringLiteral("%1·(%2 + %3)")
                         .arg(fullPrecision(intensity), fullPrecision(diffuse), fullPrecision(specular));
        }
        if (most.isEmpty() || total > sum) most = terms, sum = total;
    }
    const QString is = QStringLiteral(
        "I_max, the intensity that 255 stands for: the most that the scene's lights and materials can give, every dot "
        "product being 1. It follows from the scene and has no setting: "
        "max k_d · I_a + Σ I_k (max k_d + max k_s)");
    // Objects that are wholly transparent count for nothing: the sum is told where it is the one that was taken.
    constexpr std::size_t kMostLights = 4;
    const bool tells = std::abs(sum - iMax) <= 1e-12 * sum && scene.lights.size() <= kMostLights;
    return is + (tells ? " = " + most.join(" + ") : QString()) + " = " + fullPrecision(iMax) + '.';
}

}  // namespace app
