#include "app/desktop/panel_table.h"

#include <array>

#include "app/panels/algorithm_panel.h"
#include "app/panels/cue_panel.h"
#include "app/panels/inspector_panel.h"
#include "app/panels/lesson_panel.h"
#include "app/panels/renderer_panel.h"
#include "app/panels/scanline_panel.h"
#include "app/panels/scene_tree.h"
#include "app/panels/settings_panel.h"
#include "app/panels/tables_panel.h"

namespace app {
namespace {

template <class Panel>
QWidget* make(Document& document, QWidget* parent) {
    return new Panel(document, parent);
}

}  // namespace

std::span<const PanelRow> panelTable() {
    static constexpr auto kTable = std::to_array<PanelRow>({
        {"scene", "Scene", "cube", "Ctrl+Alt+1", "settings.md", false, Qt::LeftDockWidgetArea, make<SceneTree>},
        {"settings", "Settings", "sliders", "Ctrl+Alt+2", "settings.md", false, Qt::LeftDockWidgetArea,
         make<SettingsPanel>},
        {"lesson", "Lesson", "book", "Ctrl+Alt+3", "lessons.md", false, Qt::LeftDockWidgetArea, make<LessonPanel>},
        {"cues", "Cues", "film", "Ctrl+Alt+6", "present.md", false, Qt::LeftDockWidgetArea, make<CuePanel>},
        {"renderer", "My renderer", "compare", "Ctrl+Alt+9", "check-my-renderer.md", false, Qt::LeftDockWidgetArea,
         make<RendererPanel>},
        {"inspector", "Inspector", "inspector", "Ctrl+Alt+4", "pixel.md", false, Qt::RightDockWidgetArea,
         make<InspectorPanel>},
        {"algorithm", "Algorithm", "book", "Ctrl+Alt+8", "steps.md", false, Qt::RightDockWidgetArea,
         make<AlgorithmPanel>},
        {"tables", "Tables", "grid", "Ctrl+Alt+5", "tables.md", true, Qt::BottomDockWidgetArea, make<TablesPanel>},
        {"scanline", "Section along a row", "histogram", "Ctrl+Alt+7", "section.md", true, Qt::BottomDockWidgetArea,
         make<ScanlinePanel>},
    });
    return kTable;
}

}  // namespace app
