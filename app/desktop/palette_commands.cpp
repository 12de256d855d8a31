#include "app/desktop/palette_commands.h"

#include <QMenu>
#include <QPointer>

#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/commands/command_palette.h"
#include "app/compare/buffer_compare.h"
#include "app/compare/compare_menu.h"
#include "app/desktop/file_opening.h"
#include "app/desktop/shown_state.h"
#include "app/desktop/window_lessons.h"
#include "app/docks/layout_store.h"
#include "app/docks/layouts.h"
#include "app/docks/panel_docks.h"
#include "app/docks/window_layout.h"
#include "app/frames/equation_symbols.h"
#include "app/lesson/lesson_panel.h"
#include "app/lesson/lesson_shelf.h"
#include "app/look/text.h"
#include "app/start/start_order.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/view_area.h"
#include "lessons/state/shown_words.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/scene/settings_table.h"

namespace app {
namespace {

using pipeline::SettingKind;
using pipeline::SettingRef;

// A thousand objects' settings would fill the list.
constexpr std::size_t kFew = 16;
constexpr std::size_t kMostSideBySide = 8;

// The field's words for what has another name here.
struct FieldWords {
    const char* name;
    const char* words;
};
constexpr FieldWords kFieldWords[]{
    {"Compare", "side by side"},
    {"Clean view", "present talk lecture full screen"},
    {"Error against run time…", "study benchmark accuracy"},
    {"Find the error…", "wrong picture game bug quiz"},
    {"Pictures to name, on paper…", "drill spot the technique"},
    {"Stiff and extreme cases…", "check numerical stability"},
    {"Film…", "animation gif"},
    {"normal", "RGB normals"},
    {"overdraw", "fragments per pixel depth complexity"},
    {"polygons.verdict", "back-face culling"},
};

QString fieldWords(const QString& name) {
    for (const FieldWords& one : kFieldWords)
        if (name == QLatin1String(one.name)) return PaletteCommands::tr(one.words);
    return {};
}

struct SpaceSwitch {
    const char* option;
    const char* name;
    const char* words;
};
constexpr SpaceSwitch kSpaceSwitches[]{
    {"boxes", "Bounding boxes", ""},
    {"spheres", "Bounding spheres", ""},
    {"frustum", "Frustum of the camera", "debug camera view volume"},
    {"light_frusta", "Light frusta", "debug camera of a light"},
    {"projection", "Projection of L on N", "cosine"},
    {"reflection", "Law of reflection", "mirror"},
    {"lobe", "Specular lobe", "highlight"},
    {"faces", "Faces coloured by their normals", "RGB normals"},
    {"normal_colors", "Normals coloured by direction", "RGB normals"},
};
struct SpaceName {
    const char* space;
    const char* name;
    const char* words;
};
constexpr SpaceName kSpaces[]{{"world", "World space", ""},
                              {"eye", "Eye space", "camera view"},
                              {"clip", "Clip space", "normalised device coordinates"},
                              {"screen", "Screen space", "pixels"},
                              {"point", "At the point", "hemisphere unit vectors"}};

// Every choice of a menu that is made for the moment.
void addMenu(std::vector<PaletteEntry>& all, const QMenu& menu, const QString& place) {
    for (QAction* action : menu.actions()) {
        if (action->isSeparator()) continue;
        if (action->menu())
            addMenu(all, *action->menu(), place + QStringLiteral(" › ") + action->text());
        else
            all.push_back({action->text(),
                           place,
                           {},
                           action->isEnabled() ? QString() : action->toolTip(),
                           [action = QPointer(action)] {
                               if (action) action->trigger();
                           }});
    }
}

bool hasChoices(const pipeline::Setting& setting) {
    return setting.kind == SettingKind::Choice || setting.kind == SettingKind::Switch;
}

}  // namespace

PaletteCommands::PaletteCommands(QWidget& window, Document& document, Actions& actions, PanelDocks& docks,
                                 ViewArea& views, WindowLayout& layout, Layouts& layouts, ShownState& shown,
                                 WindowLessons& lessons, FileOpening& opening)
    : QObject(&window),
      m_window(window),
      m_document(document),
      m_actions(actions),
      m_docks(docks),
      m_views(views),
      m_layout(layout),
      m_layouts(layouts),
      m_shown(shown),
      m_lessons(lessons),
      m_opening(opening) {
    auto* palette = new CommandPalette(&window);
    actions.add({.id = ActionId::RunCommand,
                 .menu = "Help",
                 .text = "Run a command…",
                 .keys = "Ctrl+Shift+P",
                 .tip = "Find any action, buffer or scene by its name.",
                 .run = [this, palette] { palette->open(all()); },
                 .needsScene = false});
}

void PaletteCommands::addActionCommands(std::vector<PaletteEntry>& all) {
    for (const auto& [id, row] : m_actions.rows()) {
        QAction* action = m_actions[id];
        if (id == ActionId::RunCommand) continue;
        all.push_back({action->text(), QString(row.menu).replace('/', QStringLiteral(" › ")), keysText(*action),
                       m_actions.whyNot(id), [action] { action->trigger(); }});
    }
    for (PanelDock* dock : m_docks.all()) {
        QAction* action = dock->toggleViewAction();
        all.push_back({dock->windowTitle(), tr("Panel"), keysText(*action),
                       action->isEnabled()  ? QString()
                       : m_shown.hasScene() ? m_docks.whyHidden(dock->row().id)
                                            : tr("Open a scene first."),
                       [action] { action->trigger(); }});
    }
    const QString noLayout = m_actions.whyNot(ActionId::KeepLayout);
    for (const QString& name : keptLayouts())
        all.push_back({name, tr("View › Layout"), QString(), noLayout, [this, name] { m_layouts.applyKept(name); }});
}

// Of the active buffer view, and of the first 3D view.
void PaletteCommands::addViewCommands(std::vector<PaletteEntry>& all) {
    BufferView& view = m_views.activeBuffer();
    const std::size_t lights = m_document.scene().lights.size();
    for (const auto& names : {pipeline::allBuffers(lights), pipeline::allDerived(lights)})
        for (const pipeline::BufferName& name : names) {
            const bool isCosine = name.id == pipeline::BufferId::NDotL;
            all.push_back({toQString(name.text()),
                           tr("Buffer"),
                           {},
                           {},
                           [this, name] { m_views.showBuffer(name); },
                           isCosine ? tr("cosine Lambert") : QString()});
        }
    const pipeline::BufferInfo& info = bufferInfo(view.buffer().id);
    OverlayChoice& overlays = *view.features().overlays;
    for (const OverlayInfo& overlay : overlayTable())
        all.push_back({tr(overlay.name),
                       tr("Overlay"),
                       {},
                       whyNoOverlay(overlay.id, info, view.canvas()->placing().isFlipped()),
                       [&overlays, id = overlay.id] { overlays.set(id, !overlays.isOn(id)); },
                       tr("overlays")});
    delete m_compareMenu;
    m_compareMenu = new QMenu(&m_window);
    fillCompareMenu(*m_compareMenu, view.compare(), m_document, view.buffer());
    addMenu(all, *m_compareMenu, tr("Compare with"));
    const QString noB = view.compare().source() ? QString() : tr("Choose what to compare with first.");
    for (const auto& [name, mode] : {std::pair(tr("Wipe between A and B"), CompareMode::Wipe),
                                     std::pair(tr("Blink between A and B"), CompareMode::Blink),
                                     std::pair(tr("Difference of A and B"), CompareMode::Difference)})
        all.push_back({name, tr("Compare"), {}, noB, [&view, mode = mode] { view.compare().setMode(mode); }});

    const auto change = [this](auto alter) {
        return [this, alter] {
            lessons::SpaceShown state = m_views.view3d().state();
            alter(state);
            m_views.view3d().lookAt(state);
        };
    };
    for (const SpaceSwitch& one : kSpaceSwitches)
        all.push_back({tr(one.name),
                       tr("3D view"),
                       {},
                       {},
                       change([key = one.option](lessons::SpaceShown& state) {
                           if (state.options.erase(key) == 0) state.options[key] = 1;
                       }),
                       tr(one.words)});
    for (const SpaceName& one : kSpaces)
        all.push_back({tr(one.name),
                       tr("3D view"),
                       {},
                       {},
                       change([space = one.space](lessons::SpaceShown& state) { state.space = space; }),
                       tr(one.words)});
}

// Every setting, what it can be, and all of that side by side.
void PaletteCommands::addSettingCommands(std::vector<PaletteEntry>& all) {
    const pipeline::Scene& scene = m_document.scene();
    for (const SettingRef& setting : settingsOf(scene)) {
        if (setting.setting->count(scene) > kFew) continue;
        const QString key = toQString(setting.key()), label = labelOf(setting);
        all.push_back({label, tr("Setting › %1").arg(key), {}, {}, [this, key] { m_docks.showSetting(key); }});
        if (!hasChoices(*setting.setting)) continue;
        const QString why = toQString(setting.setting->idle(scene));
        for (std::size_t i = 0; i < setting.setting->choices.size(); ++i)
            all.push_back({tr("%1: %2").arg(label, toQString(setting.setting->choices[i])),
                           tr("Setting › %1").arg(key),
                           {},
                           why,
                           [this, setting, i] { m_document.change(setting, double(i)); }});
        if (setting.setting->choices.size() < 2 || setting.setting->choices.size() > kMostSideBySide) continue;
        all.push_back({tr("Side by side: all values of %1").arg(label),
                       tr("Compare"),
                       {},
                       why,
                       [this, setting] { showSideBySide(setting); },
                       key});
    }
}

// The active buffer once for every value of a setting, aligned at one zoom, each with the value's name.
void PaletteCommands::showSideBySide(const SettingRef& setting) {
    lessons::WindowState state;
    m_views.fill(state);
    lessons::BufferShown shown = m_views.activeBuffer().state();
    shown.zoom.reset();
    const std::size_t count = setting.setting->choices.size();
    const std::size_t columns = count < 4 ? count : (count + 1) / 2;
    state.arrangement.clear();
    state.views.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const bool begins = i % columns == 0;
        if (begins) state.arrangement += i == 0 ? "(" : ") / (";
        state.arrangement += begins ? "buffer" : " | buffer";
        shown.compared = {.with = "setting " + setting.key() + '=' + formatSetting(setting, double(i)), .mode = "b"};
        state.views.push_back(shown);
    }
    state.arrangement += ")";
    if (count < 4) state.arrangement = state.arrangement.substr(1, state.arrangement.size() - 2);
    state.linked = true;
    m_shown.lookAt(state);
    m_layout.giveViewsRoom();
    emit m_document.said(tr("Every view shows one value of %1.").arg(labelOf(setting)));
}

std::vector<PaletteEntry> PaletteCommands::all() {
    m_actions.refresh();
    std::vector<PaletteEntry> all;
    addActionCommands(all);
    if (m_shown.hasScene() && m_document.frames().shown()) addViewCommands(all);
    if (m_shown.hasScene()) addSettingCommands(all);
    const LessonShelf& shelf = m_docks.panels().lesson->shelf();
    for (int i = 0; i < shelf.rowCount(); ++i) {
        const lessons::Lesson& lesson = shelf.listed(i);
        const QString name = toQString(lesson.name);
        // By its lecture and its notions too: "lesson shadows".
        all.push_back({toQString(lesson.title), tr("Lesson"), QString(), QString(),
                       [this, name] { m_lessons.open(name); },
                       tr("lesson %1 %2 %3").arg(name, toQString(lesson.lecture), toQString(lesson.summary))});
    }
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes())
        all.push_back({toQString(scene.title), tr("Scene"), QString(), QString(),
                       [this, path = toQString(scene.file.string())] { m_opening.open(path); }, toQString(scene.look)});
    for (const StartLecture& lecture : startOrder())
        all.push_back({tr("%1 as a talk").arg(lecture.title), tr("Talk"), QString(), QString(),
                       [this, file = lecture.talk] { m_opening.giveTalk(file); }, lecture.about});
    all.push_back({tr("Talk of your own…"), tr("Talk"), QString(), QString(), [this] { m_opening.chooseTalk(); },
                   tr("cue list present")});
    for (PaletteEntry& entry : all)
        if (entry.words.isEmpty()) entry.words = fieldWords(entry.name);
    return all;
}

}  // namespace app
