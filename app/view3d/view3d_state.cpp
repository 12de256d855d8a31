// How a 3D view is looked at, as a file has it.
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/look/text.h"
#include "app/view3d/space_picture.h"
#include "app/view3d/view3d_panel.h"
#include "app/view3d/view3d_spaces.h"
#include "lessons/state/shown_words.h"

namespace app {
namespace {

// In the order of kSpaceOptions, which have their ranges.
struct OptionRow {
    std::string_view name;
    double (*get)(const ViewOptions& options);
    void (*set)(ViewOptions& options, double value);
};

template <bool ViewOptions::*member>
constexpr OptionRow flag(const char* name) {
    return {name, [](const ViewOptions& o) { return o.*member ? 1.0 : 0.0; },
            [](ViewOptions& o, double value) { o.*member = value != 0; }};
}
template <double ViewOptions::*member>
constexpr OptionRow length(const char* name) {
    return {name, [](const ViewOptions& o) { return o.*member; },
            [](ViewOptions& o, double value) { o.*member = value; }};
}
template <auto member, class Value>
constexpr OptionRow choice(const char* name) {
    return {name, [](const ViewOptions& o) { return double(o.*member); },
            [](ViewOptions& o, double value) { o.*member = Value(int(value)); }};
}
template <pipeline::VectorCode code>
constexpr OptionRow vector(const char* name) {
    return {name, [](const ViewOptions& o) { return o.shown[std::size_t(code)] ? 1.0 : 0.0; },
            [](ViewOptions& o, double value) { o.shown[std::size_t(code)] = value != 0; }};
}

using Code = pipeline::VectorCode;
constexpr auto kOptions = std::to_array<OptionRow>({
    choice<&ViewOptions::normals, NormalsShown>("normals"),
    length<&ViewOptions::normalLength>("normal_length"),
    choice<&ViewOptions::everyNormal, int>("every_normal"),
    length<&ViewOptions::vectorLength>("vector_length"),
    flag<&ViewOptions::vectors>("vectors"),
    flag<&ViewOptions::lights>("lights"),
    flag<&ViewOptions::eye>("eye"),
    choice<&ViewOptions::faces, FacesShown>("faces"),
    flag<&ViewOptions::boxes>("boxes"),
    flag<&ViewOptions::spheres>("spheres"),
    flag<&ViewOptions::frustum>("frustum"),
    flag<&ViewOptions::projection>("projection"),
    flag<&ViewOptions::reflection>("reflection"),
    choice<&ViewOptions::normalColors, NormalColors>("normal_colors"),
    flag<&ViewOptions::lobe>("lobe"),
    flag<&ViewOptions::handles>("handles"),
    choice<&ViewOptions::objectTool, HandleTool>("object_tool"),
    flag<&ViewOptions::lightFrusta>("light_frusta"),
    vector<Code::N>("vector_n"),
    vector<Code::L>("vector_l"),
    vector<Code::V>("vector_v"),
    vector<Code::R>("vector_r"),
    vector<Code::H>("vector_h"),
});
constexpr bool haveSameNames() {
    return std::ranges::equal(kOptions, lessons::kSpaceOptions, {}, &OptionRow::name, &lessons::SpaceOption::name);
}
static_assert(haveSameNames());
static_assert(lessons::kSpaceOptions[2].max == kSparsestNormals);

std::string keyOf(SpaceId id) {
    const std::string name(lessons::kSpaceNames[std::size_t(id.space)]);
    if (id.space != ViewSpace::Light) return name;
    const std::string light = name + ' ' + std::to_string(id.light);
    return id.face < 0 ? light : light + ' ' + std::string(lessons::kFaceNames[std::size_t(id.face)]);
}

}  // namespace

std::optional<SpaceId> spaceNamed(std::string_view name) {
    const auto words = lessons::parseSpace(name);
    return words ? std::optional(SpaceId{ViewSpace(words->space), words->light, words->face}) : std::nullopt;
}

ViewOptions optionsOf(const lessons::SpaceShown& shown, pipeline::Errors& errors, ViewOptions options) {
    for (const auto& [name, value] : shown.options) {
        const auto row = std::ranges::find(kOptions, name, &OptionRow::name);
        if (row == kOptions.end()) {
            errors.push_back({{}, "the 3D view has no option \"" + name + '"'});
            continue;
        }
        const lessons::SpaceOption& range = lessons::kSpaceOptions[std::size_t(row - kOptions.begin())];
        if (!(value >= range.min && value <= range.max))
            errors.push_back({{}, "the option \"" + name + "\" of the 3D view is out of its range"});
        else
            row->set(options, value);
    }
    return options;
}

lessons::SpaceShown View3dPanel::state() const {
    if (m_wanted) return m_wanted->asked;
    lessons::SpaceShown state;
    state.space = keyOf(m_view->space().id());
    for (const OptionRow& row : kOptions) {
        const double value = row.get(m_view->options());
        if (value != row.get(m_firstOptions)) state.options[std::string(row.name)] = value;
    }
    if (!m_view->camera().isTouched()) return state;
    const OrbitCamera& c = m_view->camera().now();
    state.camera = {c.target, c.right, c.up, c.forward, c.distance, c.fovY, c.orthographic};
    return state;
}

pipeline::Errors View3dPanel::lookAt(const lessons::SpaceShown& state) {
    pipeline::Errors errors;
    optionsOf(state, errors);
    const auto space = spaceNamed(state.space);
    if (!space) errors.push_back({{}, "the 3D view has no space \"" + state.space + '"', lessons::kSpaceExpected});
    m_wanted = Wanted{space.value_or(SpaceId()), state.camera, state};
    if (m_made.frame) showWanted();
    return errors;
}

// The first frame of a scene frames it anew, so that what was asked for before comes after.
void View3dPanel::showWanted() {
    const auto wanted = std::exchange(m_wanted, std::nullopt);
    if (!wanted) return;
    pipeline::Errors told;  // when it was asked for
    changeOptions(optionsOf(wanted->asked, told, m_firstOptions));
    setSpace(wanted->space);
    if (m_spaces->awaited()) {
        m_wanted = wanted;
        return;
    }
    takeCamera(wanted->camera);
}

void View3dPanel::takeCamera(const std::optional<lessons::SpaceShown::Camera>& camera) {
    if (!camera) return m_view->camera().frameAnew();
    const auto& c = *camera;
    m_view->camera().set({c.target, c.distance, c.right, c.up, c.forward, c.fov, c.orthographic});
}

// What the view waits for, and may be told to give up.
void View3dPanel::observeWork() {
    WorkList& work = m_document.work();
    work.add(
        this, tr("the 3D view"),
        [this] {
            m_building.forget();
            m_spaces->stopMoving();
            m_view->progress().cancel();
        },
        [this] {
            m_view->progress().resume();
            takeFrame();
        });
    connect(&m_view->progress(), &ViewProgress::workingChanged, this,
            [this](bool works) { m_document.work().setBusy(this, works); });
    connect(&work, &WorkList::changed, this, [this] {
        const WorkList& now = m_document.work();
        m_view->progress().setStopped(now.isStopped(this) || now.isStopped(&m_document.frames()));
    });
}

}  // namespace app
