#include "app/core/pointed.h"

#include <QRegularExpression>

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

QString symbolOf(const pipeline::SettingRef& setting) {
    const QString label = toQString(setting.setting->label);
    static const QRegularExpression symbol("^\\p{L}(_\\w)?(?= |$)", QRegularExpression::UseUnicodePropertiesOption);
    const auto match = symbol.match(label);
    return match.hasMatch() ? match.captured() : label;
}

}  // namespace app
