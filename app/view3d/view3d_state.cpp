// How a 3D view is looked at, as a file has it.
#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "app/core/text.h"
#include "app/view3d/overlay.h"
#include "app/view3d/point_drawing.h"
#include "app/view3d/view3d_panel.h"

namespace app {
namespace {

struct OptionRow {
    const char* name;  // in files
    double (*get)(const ViewOptions& options);
    void (*set)(ViewOptions& options, double value);
    double min, max;
};

template <bool ViewOptions::*member>
constexpr OptionRow flag(const char* name) {
    return {name, [](const ViewOptions& o) { return o.*member ? 1.0 : 0.0; },
            [](ViewOptions& o, double value) { o.*member = value != 0; }, 0, 1};
}
template <double ViewOptions::*member>
constexpr OptionRow length(const char* name) {
    return {name, [](const ViewOptions& o) { return o.*member; },
            [](ViewOptions& o, double value) { o.*member = value; }, 4, 400};
}
template <auto member, class Value>
constexpr OptionRow choice(const char* name, double min, double max) {
    return {name, [](const ViewOptions& o) { return double(o.*member); },
            [](ViewOptions& o, double value) { o.*member = Value(int(value)); }, min, max};
}
template <pipeline::VectorCode code>
constexpr OptionRow vector(const char* name) {
    return {name, [](const ViewOptions& o) { return o.shown[std::size_t(code)] ? 1.0 : 0.0; },
            [](ViewOptions& o, double value) { o.shown[std::size_t(code)] = value != 0; }, 0, 1};
}

using Code = pipeline::VectorCode;
constexpr auto kOptions = std::to_array<OptionRow>({
    choice<&ViewOptions::normals, NormalsShown>("normals", 0, 2),
    length<&ViewOptions::normalLength>("normal_length"),
    choice<&ViewOptions::everyNormal, int>("every_normal", 1, kSparsestNormals),
    length<&ViewOptions::vectorLength>("vector_length"),
    flag<&ViewOptions::vectors>("vectors"),
    flag<&ViewOptions::lights>("lights"),
    flag<&ViewOptions::eye>("eye"),
    choice<&ViewOptions::faces, FacesShown>("faces", 0, 1),
    flag<&ViewOptions::boxes>("boxes"),
    flag<&ViewOptions::spheres>("spheres"),
    flag<&ViewOptions::frustum>("frustum"),
    flag<&ViewOptions::projection>("projection"),
    flag<&ViewOptions::reflection>("reflection"),
    choice<&ViewOptions::normalColors, NormalColors>("normal_colors", 0, 1),
    flag<&ViewOptions::lobe>("lobe"),
    flag<&ViewOptions::handles>("handles"),
    choice<&ViewOptions::objectTool, HandleTool>("object_tool", 0, 2),
    flag<&ViewOptions::lightFrusta>("light_frusta"),
    vector<Code::N>("vector_n"),
    vector<Code::L>("vector_l"),
    vector<Code::V>("vector_v"),
    vector<Code::R>("vector_r"),
    vector<Code::H>("vector_h"),
});

constexpr std::array<const char*, 6> kSpaces{"world", "eye", "clip", "screen", "light", "point"};

constexpr std::array<const char*, kLightFaces> kFaces{"+x", "-x", "+y", "-y", "+z", "-z"};  // in files

std::string keyOf(SpaceId id) {
    const std::string name = kSpaces[std::size_t(id.space)];
    if (id.space != ViewSpace::Light) return name;
    const std::string light = name + ' ' + std::to_string(id.light);
    return id.face < 0 ? light : light + ' ' + kFaces[std::size_t(id.face)];
}

std::optional<SpaceId> spaceNamed(std::string_view name) {
    for (std::size_t i = 0; i < kSpaces.size(); ++i)
        if (name == kSpaces[i] && ViewSpace(i) != ViewSpace::Light) return SpaceId{ViewSpace(i)};
    SpaceId light{ViewSpace::Light};
    if (!name.starts_with("light ")) return {};
    name.remove_prefix(6);
    if (const auto space = name.find(' '); space != std::string_view::npos) {
        const auto face =
            std::ranges::find(kFaces, name.substr(space + 1), [](const char* key) { return std::string_view(key); });
        if (face == kFaces.end()) return {};
        light.face = int(face - kFaces.begin());
        name = name.substr(0, space);
    }
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), light.light);
    const bool whole = error == std::errc() && end == name.data() + name.size() && light.light >= 0;
    return whole ? std::optional(light) : std::nullopt;
}

}  // namespace

// A camera that the user has not moved frames the picture as it does the view.
pipeline::Result<SpacePicture> SceneView::picture(QSize size, bool transparent) const {
    if (!shown()) return pipeline::Error{{}, "the 3D view has nothing to show", {}};
    constexpr double kUsualHeight = 600;  // of a view with letters in their own size
    const ViewShot shot{.size = {size.width(), size.height()},
                        .pixelRatio = std::max(0.2, size.height() / kUsualHeight),
                        .transparent = transparent,
                        .isPoint = isPoint(),
                        .hasGround = isWorld()};
    const glm::dvec2 logical = glm::dvec2(shot.size) / shot.pixelRatio;
    const auto framed = isPoint() ? pointCamera : presetCamera;
    const double foot = shown()->map.keepsLengths() && shown()->point ? logical.y - legendAt(logical).top() : 0;
    const OrbitCamera camera =
        m_touched ? m_camera : framed(ViewPreset::Iso, *shown(), m_options, logical, m_camera.orthographic, foot);
    return SpacePicture{shown(), m_options, camera, shot};
}

SpaceShown View3dPanel::state() const {
    if (m_wanted) return m_wanted->asked;
    SpaceShown state;
    state.space = keyOf(m_view->space());
    for (const OptionRow& row : kOptions) {
        const double value = row.get(m_view->options());
        if (value != row.get(ViewOptions())) state.options[row.name] = value;
    }
    if (!m_view->isTouched()) return state;
    const OrbitCamera& c = m_view->camera();
    state.camera = {c.target, c.right, c.up, c.forward, c.distance, c.fovY, c.orthographic};
    return state;
}

pipeline::Errors View3dPanel::lookAt(const SpaceShown& state) {
    pipeline::Errors errors;
    ViewOptions options;
    for (const auto& [name, value] : state.options) {
        const auto row = std::ranges::find(kOptions, name, [](const OptionRow& r) { return std::string(r.name); });
        if (row == kOptions.end())
            errors.push_back({{}, "the 3D view has no option \"" + name + '"'});
        else if (!(value >= row->min && value <= row->max))
            errors.push_back({{}, "the option \"" + name + "\" of the 3D view is out of its range"});
        else
            row->set(options, value);
    }
    const auto space = spaceNamed(state.space);
    if (!space)
        errors.push_back({{},
                          "the 3D view has no space \"" + state.space + '"',
                          "world, eye, clip, screen, light 0, light 0 -x or point"});
    m_wanted = Wanted{options, space.value_or(SpaceId()), state.camera, state};
    if (!m_newScene) showWanted();
    return errors;
}

// The first frame of a scene frames it anew, so that what was asked for before comes after.
void View3dPanel::showWanted() {
    const auto wanted = std::exchange(m_wanted, std::nullopt);
    if (!wanted) return;
    changeOptions(wanted->options);
    setSpace(wanted->space);
    if (m_awaited) {
        m_wanted = wanted;
        return;
    }
    takeCamera(wanted->camera);
}

void View3dPanel::takeCamera(const std::optional<SpaceShown::Camera>& camera) {
    if (!camera) return m_view->frameAnew();
    const auto& c = *camera;
    m_view->setCamera({c.target, c.distance, c.right, c.up, c.forward, c.fov, c.orthographic});
}

// What the view waits for, and may be told to give up.
void View3dPanel::observeWork() {
    WorkList& work = m_document.work();
    work.add(
        this, tr("the 3D view"),
        [this] {
            m_building.forget();
            m_moving.forget();
            m_view->cancelDrawing();
        },
        [this] {
            m_view->resumeDrawing();
            takeFrame();
        });
    connect(m_view, &SceneView::workingChanged, this, [this](bool works) { m_document.work().setBusy(this, works); });
    connect(&work, &WorkList::changed, this, [this] {
        const WorkList& now = m_document.work();
        m_view->setStopped(now.isStopped(this) || now.isStopped(&m_document));
    });
}

}  // namespace app
