#include "app/docks/panel_table.h"

#include <algorithm>
#include <array>

#include "app/docks/panel_docks.h"
#include "app/inspector/inspector_panel.h"
#include "app/lesson/lesson_panel.h"
#include "app/my_renderer/renderer_panel.h"
#include "app/settings/scene_tree.h"
#include "app/settings/settings_panel.h"
#include "app/tables/algorithm_panel.h"
#include "app/tables/scanline_panel.h"
#include "app/tables/tables_panel.h"
#include "app/talk/cue_panel.h"
#include "app/views/view_area.h"

namespace app {
namespace {

using lessons::Part;

template <class Panel>
QWidget* make(const PanelNeeds& needs, QWidget* parent) {
    return new Panel(needs.document, parent);
}

// One that other parts of the window use.
template <class Panel, Panel* Panels::*name>
QWidget* makeNamed(const PanelNeeds& needs, QWidget* parent) {
    return needs.panels.*name = new Panel(needs.document, parent);
}

QWidget* makeSettings(const PanelNeeds& needs, QWidget* parent) {
    auto* panel = needs.panels.settings = new SettingsPanel(needs.document, parent);
    QObject::connect(needs.panels.scene, &SceneTree::selected, panel, &SettingsPanel::select);
    return panel;
}

QWidget* makeInspector(const PanelNeeds& needs, QWidget* parent) {
    auto* panel = needs.panels.inspector = new InspectorPanel(needs.document, parent);
    QObject::connect(panel, &InspectorPanel::bufferAsked, &needs.views, &ViewArea::showBuffer);
    QObject::connect(panel, &InspectorPanel::settingAsked, &needs.docks, &PanelDocks::showSetting);
    return panel;
}

constexpr Qt::DockWidgetArea kLeft = Qt::LeftDockWidgetArea, kRight = Qt::RightDockWidgetArea,
                             kBottom = Qt::BottomDockWidgetArea;

constexpr auto kPanelTable = std::to_array<PanelRow>({
    {PanelId::Scene, "scene", "Scene", "cube", "Ctrl+Alt+1", "settings.md", Part::Scene, false, kLeft,
     makeNamed<SceneTree, &Panels::scene>},
    {PanelId::Settings, "settings", "Settings", "sliders", "Ctrl+Alt+2", "settings.md", Part::Settings, false, kLeft,
     makeSettings},
    {PanelId::Lesson,
     "lesson",
     "Lesson",
     "book",
     "Ctrl+Alt+3",
     "lessons.md",
     {},
     false,
     kLeft,
     makeNamed<LessonPanel, &Panels::lesson>},
    {PanelId::Cues,
     "cues",
     "Cues",
     "film",
     "Ctrl+Alt+6",
     "present.md",
     {},
     false,
     kLeft,
     makeNamed<CuePanel, &Panels::cues>},
    {PanelId::Renderer,
     "renderer",
     "My renderer",
     "compare",
     "Ctrl+Alt+9",
     "check-my-renderer.md",
     {},
     false,
     kLeft,
     makeNamed<RendererPanel, &Panels::renderer>},
    {PanelId::Inspector, "inspector", "Inspector", "inspector", "Ctrl+Alt+4", "pixel.md", Part::Inspector, false,
     kRight, makeInspector},
    {PanelId::Algorithm, "algorithm", "Algorithm", "algorithm", "Ctrl+Alt+8", "steps.md", Part::Algorithm, false,
     kRight, make<AlgorithmPanel>},
    {PanelId::Tables, "tables", "Tables", "grid", "Ctrl+Alt+5", "tables.md", {}, true, kBottom, make<TablesPanel>},
    {PanelId::Section,
     "scanline",
     "Section along a row",
     "histogram",
     "Ctrl+Alt+7",
     "section.md",
     {},
     true,
     kBottom,
     make<ScanlinePanel>},
});
static_assert(std::ranges::is_sorted(kPanelTable, {}, &PanelRow::id) &&
              std::size_t(PanelId::Section) + 1 == kPanelTable.size());

}  // namespace

std::span<const PanelRow> panelTable() { return kPanelTable; }

}  // namespace app
