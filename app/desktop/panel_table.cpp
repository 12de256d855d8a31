#include "app/desktop/panel_table.h"

#include <array>

#include "app/panels/inspector_panel.h"
#include "app/panels/lesson_panel.h"
#include "app/panels/scene_tree.h"
#include "app/panels/settings_panel.h"

namespace app {
namespace {

template <class Panel>
QWidget* make(Document& document, QWidget* parent) {
    return new Panel(document, parent);
}

}  // namespace

std::span<const PanelRow> panelTable() {
    static constexpr auto kTable = std::to_array<PanelRow>({
        {"scene", "Scene", "cube", "Ctrl+Shift+S", Qt::LeftDockWidgetArea, make<SceneTree>},
        {"settings", "Settings", "sliders", "Ctrl+Shift+T", Qt::LeftDockWidgetArea, make<SettingsPanel>},
        {"lesson", "Lesson", "book", "Ctrl+Shift+L", Qt::LeftDockWidgetArea, make<LessonPanel>},
        {"inspector", "Inspector", "inspector", "Ctrl+I", Qt::RightDockWidgetArea, make<InspectorPanel>},
    });
    return kTable;
}

}  // namespace app
