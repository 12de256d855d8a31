#include "app/frames/equation_symbols.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "app/look/numbers.h"
#include "app/look/text.h"
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/illumination/illumination.h"

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
    if (pipeline::modelFacts(scene.settings.model).white == pipeline::White::One)
        return "I_max, the intensity that 255 stands for: 1 in this model, whose colours go from 0 to 1.";
    const pipeline::MaximumIntensity most = pipeline::maximumIntensityInParts(scene);
    QStringList terms{QStringLiteral("%1·%2").arg(fullPrecision(most.diffuse), fullPrecision(most.ambient))};
    for (const double light : most.lights)
        terms << QStringLiteral("%1·(%2 + %3)")
                     .arg(fullPrecision(light), fullPrecision(most.diffuse), fullPrecision(most.specular));
    const QString is = QStringLiteral(
        "I_max, the intensity that 255 stands for: the most that the scene's lights and materials can give, every dot "
        "product being 1. It follows from the scene and has no setting: "
        "max k_d · I_a + Σ I_k (max k_d + max k_s)");
    constexpr std::size_t kMostLights = 4;
    const bool tells = scene.lights.size() <= kMostLights;
    return is + (tells ? " = " + terms.join(" + ") : QString()) + " = " + fullPrecision(iMax) + '.';
}

}  // namespace app
