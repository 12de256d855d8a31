#include "app/view3d/view_corners.h"

#include <algorithm>

#include "app/look/theme.h"
#include "app/view3d/scene_view.h"
#include "app/view3d/view_corner.h"

namespace app {

namespace {

Vec3d directionOf(CubeFace face) {
    switch (face) {
        case CubeFace::X: return {-1, 0, 0};
        case CubeFace::Y: return {0, -1, 0};
        case CubeFace::Z: return {0, 0, -1};
        case CubeFace::MinusX: return {1, 0, 0};
        case CubeFace::MinusY: return {0, 1, 0};
        default: return {0, 0, 1};
    }
}

}  // namespace

ViewCorners::ViewCorners(SceneView& view)
    : m_view(view),
      m_legend(new ViewCorner(ViewCorner::Kind::Legend, &view)),
      m_cube(new ViewCorner(ViewCorner::Kind::Cube, &view)) {
    m_legend->setObjectName("legend");
    m_cube->setObjectName("cube");
    connect(m_legend, &ViewCorner::vectorClicked, this, [this](VectorCode code) {
        ViewOptions options = m_view.options();
        bool& shown = options.shown[static_cast<std::size_t>(code)];
        shown = !(shown && options.vectors);
        options.vectors = true;
        m_view.changeOptions(options);
    });
    connect(m_legend, &ViewCorner::vectorHovered, this, [this](VectorCode code) {
        m_view.pointAt(code == VectorCode::None ? std::vector<VectorCode>{} : std::vector{code});
    });
    connect(m_cube, &ViewCorner::faceClicked, this, [this](CubeFace face) {
        ShownSpace& space = m_view.space();
        if (!space.shown() || space.isPoint()) return;
        space.endMove();
        face == CubeFace::Middle ? m_view.camera().go(ViewPreset::Iso) : m_view.camera().goAlong(directionOf(face));
    });
}

std::vector<VectorCode> ViewCorners::drawn() const {
    std::vector<VectorCode> codes;
    const auto& shown = m_view.space().shown();
    if (!shown) return codes;
    for (const VectorArrow& vector : shown->vectors)
        if (m_view.options().shows(vector.code) && std::ranges::count(codes, vector.code) == 0)
            codes.push_back(vector.code);
    return codes;
}

// A low view has its room for the scene; the letters stand at their vectors.
bool ViewCorners::showsLegend() const {
    const auto& shown = m_view.space().shown();
    return m_view.problem().isEmpty() && shown && shown->map.keepsLengths() && !(m_isBare && drawn().empty()) &&
           5 * m_legend->height() <= m_view.height();
}

double ViewCorners::takenFoot() const { return showsLegend() ? m_view.height() - m_legend->y() : 0; }

std::vector<QRectF> ViewCorners::places() const {
    std::vector<QRectF> places;
    for (const QWidget* corner : {m_legend, m_cube})
        if (corner->isVisible()) places.emplace_back(corner->geometry());
    return places;
}

void ViewCorners::show(bool works) {
    if (m_isBare) m_legend->setOnly(drawn());
    const bool hasLegend = showsLegend(), hadLegend = m_legend->isVisibleTo(&m_view);
    m_legend->setVisible(hasLegend);
    if (hasLegend != hadLegend || m_legend->size() != m_legend->sizeHint()) place();
    m_cube->setVisible(works && !m_view.space().isPoint());
    m_legend->setOptions(m_view.options());
    m_cube->setCamera(m_view.camera().now(), m_view.space().id().space);
}

void ViewCorners::place() {
    const int margin = Theme::current().px(8), width = m_view.width(), height = m_view.height();
    m_legend->setRoom(width - 2 * margin);
    m_legend->resize(m_legend->sizeHint());
    m_legend->move(margin, height - margin - m_legend->height());
    m_cube->resize(m_cube->sizeHint());
    // If the two would meet, the cube stands above.
    const bool narrow = m_legend->isVisibleTo(&m_view) && width < m_legend->width() + m_cube->width() + 3 * margin;
    m_cube->move(width - margin - m_cube->width(),
                 height - margin - m_cube->height() - (narrow ? m_legend->height() + margin : 0));
    m_legend->update();
    m_cube->update();
}

}  // namespace app
