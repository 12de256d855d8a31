#include "app/view3d/shown_space.h"

#include <utility>

#include "app/drawing3d/point_drawing.h"
#include "app/frames/large_frame.h"
#include "app/view3d/scene_view.h"

namespace app {

namespace {

constexpr int kMoveMilliseconds = 400;

}  // namespace

ShownSpace::ShownSpace(SceneView& view) : m_view(view) {
    m_move.setStartValue(0.0);
    m_move.setEndValue(1.0);
    m_move.setDuration(kMoveMilliseconds);
    m_move.setEasingCurve(QEasingCurve::OutCubic);
    connect(&m_move, &QVariantAnimation::valueChanged, this, [this](const QVariant& t) {
        if (!m_morph) return;
        OrbitCamera camera = m_view.camera().now();
        camera.fovY = m_morph->camera(t.toDouble()).fovY;
        m_view.camera().place(camera);
        m_view.render(std::make_shared<const ViewContent>(m_morph->content(t.toDouble())), {});
        m_view.refresh();
    });
    connect(&m_move, &QVariantAnimation::finished, this, &ShownSpace::endMove);
}

ShownSpace::~ShownSpace() { m_move.disconnect(this); }

void ShownSpace::setContent(std::shared_ptr<const ViewContent> content, bool newScene,
                            std::shared_ptr<const ViewContent> moved) {
    m_content = std::move(content);
    if (moved) m_moved = std::move(moved);
    if (newScene) m_view.camera().forget();
    endMove();
    show();
}

void ShownSpace::set(SpaceId space, std::shared_ptr<const ViewContent> moved) {
    if (space == m_space) return;
    endMove();
    const OrbitCamera before = m_view.camera().now();
    const auto from = m_content ? mapOf(*m_content, m_space) : std::nullopt;
    m_view.camera().changeSpace(m_space, space);
    m_space = space;
    if (moved) m_moved = std::move(moved);
    show();
    const bool isLarge = m_content && m_content->mesh->faces.size() > kManyTriangles;  // too many to move in time
    if (!from || !shown() || isPoint() || isLarge || !wantsMotion(m_view)) return;
    m_morph.emplace(*m_content, *from, before, shown()->map, m_view.camera().now());
    m_move.start();
}

void ShownSpace::endMove() {
    if (!m_morph) return;
    m_view.camera().place(m_morph->camera(1));
    m_morph.reset();
    m_move.stop();
    show();
}

void ShownSpace::show() {
    const auto before = std::exchange(m_moved, nullptr);
    if (m_content && isPoint()) m_moved = pointContent(*m_content);
    if (m_content && !isWorld() && !isPoint())
        if (const auto map = mapOf(*m_content, m_space))
            m_moved = std::make_shared<const ViewContent>(inSpace(*m_content, *map, before.get()));
    std::vector<InkedLine> ground;
    if (shown() && !isPoint() && shown()->map.keepsLengths()) ground = groundLines(*m_content);
    if (shown())
        for (InkedLine& line : ground) line.a = shown()->map.toSpace(line.a), line.b = shown()->map.toSpace(line.b);
    m_view.render(shown(), ground);
    m_view.camera().frameIfUntouched();
    m_view.refresh();
}

}  // namespace app
