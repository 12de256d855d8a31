#include "app/core/changed_settings.h"

#include <QFileInfo>

#include "app/core/export_plan.h"
#include "app/core/text.h"
#include "pipeline/formats/scene_reader.h"

namespace app {

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
    for (const pipeline::SettingRef& setting : pipeline::settingsOf(scene)) {
        const double value = setting.get(scene);
        if (value != setting.get(*before))
            words << "--set" << shellWord(toQString(setting.key() + "=" + formatSetting(setting, value)));
    }
    return words;
}

}  // namespace app
