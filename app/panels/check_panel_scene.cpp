#include <fmt/format.h>

#include <QLabel>

#include "app/core/text.h"
#include "app/panels/check_knob.h"
#include "app/panels/check_panel.h"
#include "app/panels/check_pictures.h"
#include "pipeline/check/check_json.h"
#include "pipeline/plan/memory_limit.h"

// What leaves the panel: the chosen case as a scene, and the report.
namespace app {

using pipeline::check::Case;
using pipeline::check::CaseResult;

std::optional<pipeline::Scene> CheckPanel::sceneAtKnob() const {
    const Case& which = chosenCase();
    if (!which.scene) return {};
    if (which.knob.scene) return which.knob.scene(m_knob->value());
    pipeline::Scene scene = which.scene();
    if (const auto setting = findSetting(scene, which.knob.setting); !which.knob.setting.empty() && setting)
        setting->set(scene, m_knob->value());
    return scene;
}

// As the case has it until the slider is moved.
void CheckPanel::showPictures() {
    std::optional<pipeline::Scene> scene;
    if (chosenCase().scene) scene = m_knob->moved() ? sceneAtKnob() : chosenCase().scene();
    const bool drawn = scene && checkSceneAndMemory(*scene).empty();
    m_pictures->setScene(chosenCase(), drawn ? std::make_shared<const pipeline::Scene>(*scene) : nullptr);
}

bool CheckPanel::openAsScene() {
    const auto tell = [this](const QString& words) {
        m_message->setText(words);
        m_message->show();
        return false;
    };
    const Case& which = chosenCase();
    auto scene = sceneAtKnob();
    if (!scene) return tell(tr("%1 is numbers or a file: it has no scene.").arg(toQString(which.id)));
    if (const auto errors = checkSceneAndMemory(*scene); !errors.empty())
        return tell(toQString(format(errors.front())));
    if (!m_mayLeave()) return false;
    if (scene->name.empty()) scene->name = fmt::format("{} {}", which.id, which.title);
    m_document.setScene(*std::move(scene));
    m_open = m_selected;
    tell(which.knob.setting.empty()
             ? tr("%1 is open in the main window.").arg(toQString(which.id))
             : tr("%1 is open in the main window and follows the slider.").arg(toQString(which.id)));
    return true;
}

// The scene of the case on show follows; a drag is one step of undo.
void CheckPanel::turnKnob(double value, bool done) {
    if (!chosenCase().knob.setting.empty() || chosenCase().knob.scene) showPictures();
    if (m_open != m_selected || chosenCase().knob.setting.empty()) return;
    if (const auto setting = findSetting(m_document.scene(), chosenCase().knob.setting))
        m_document.change(*setting, value, done ? Document::Change::Done : Document::Change::Live);
}

QString CheckPanel::report() const {
    std::vector<CaseResult> results;
    for (const auto& result : m_results)
        if (result) results.push_back(*result);
    const pipeline::Json json = toJson(results, m_seconds);
    return toQString(json.dump(2));
}

}  // namespace app
