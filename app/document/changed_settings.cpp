#include "app/document/changed_settings.h"

#include <QFileInfo>

#include "app/document/export_plan.h"
#include "app/look/text.h"
#include "pipeline/formats/scene_reader.h"

namespace app {

std::vector<pipeline::SettingRef> differingSettings(const pipeline::Scene& a, const pipeline::Scene& b) {
    std::vector<pipeline::SettingRef> differing;
    for (const pipeline::SettingRef& setting : settingsOf(a))
        if (setting.index < setting.setting->count(b) && setting.get(a) != setting.get(b)) differing.push_back(setting);
    return differing;
}

const pipeline::Scene* ChangedSettings::original(const pipeline::Scene& scene) {
    const KeptScene& kept = m_document.kept();
    // A scene that was saved keeps the name of the file that it came from.
    if (kept.scene && kept.file == QFileInfo(toQString(scene.file)).absoluteFilePath()) return kept.scene.get();
    if (!m_read) m_read = pipeline::readScene(scene.file);
    return *m_read ? &**m_read : nullptr;
}

QStringList ChangedSettings::words(const pipeline::Scene& scene) {
    const pipeline::Scene* before = original(scene);
    if (!before || before->objects.size() != scene.objects.size() || before->lights.size() != scene.lights.size())
        return {};
    QStringList words;
    for (const pipeline::SettingRef& setting : differingSettings(scene, *before))
        words << "--set" << shellWord(toQString(setting.key() + "=" + formatSetting(setting, setting.get(scene))));
    return words;
}

}  // namespace app
