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
        {"scene", "Scene", "cube", "Ctrl+Alt+1", Qt::LeftDockWidgetArea, make<SceneTree>},
        {"settings", "Settings", "sliders", "Ctrl+Alt+2", Qt::LeftDockWidgetArea, make<SettingsPanel>},
        {"lesson", "Lesson", "book", "Ctrl+Alt+3", Qt::LeftDockWidgetArea, make<LessonPanel>},
        {"cues", "Cues", "film", "Ctrl+Alt+6", Qt::LeftDockWidgetArea, make<CuePanel>},
        {"renderer", "My renderer", "compare", "Ctrl+Alt+9", Qt::LeftDockWidgetArea, make<RendererPanel>},
        {"inspector", "Inspector", "inspector", "Ctrl+Alt+4", Qt::RightDockWidgetArea, make<InspectorPanel>},
        {"algorithm", "Algorithm", "book", "Ctrl+Alt+8", Qt::RightDockWidgetArea, make<AlgorithmPanel>},
        {"tables", "Tables", "grid", "Ctrl+Alt+5", Qt::BottomDockWidgetArea, make<TablesPanel>},
        {"scanline", "Section along a row", "histogram", "Ctrl+Alt+7", Qt::BottomDockWidgetArea, make<ScanlinePanel>},
    });
    return kTable;
}

}  // namespace app
