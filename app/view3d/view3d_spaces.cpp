// The spaces of a View3dPanel, and the faces of a point light.
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/core/large_frame.h"
#include "app/core/numbers.h"
#include "app/core/text.h"
#include "app/view3d/normal_arrows.h"
#include "app/view3d/view3d_panel.h"
#include "pipeline/plan/needs.h"

namespace app {

namespace {

QString remarkOf(ViewSpace space) {
    switch (space) {
        case ViewSpace::World: return {};
        case ViewSpace::Eye: return View3dPanel::tr("x right, y up, z away from the eye");
        case ViewSpace::Clip: return View3dPanel::tr("after the division by w: −1 to 1");
        case ViewSpace::Screen: return View3dPanel::tr("x, y in pixels, z from 0 to 1");
        case ViewSpace::Light: return View3dPanel::tr("as its shadow buffer sees it");
        case ViewSpace::Point: break;
    }
    return View3dPanel::tr("unit hemisphere, N up");
}

std::vector<SpaceId> spacesOf(const Document& document) {
    std::vector<SpaceId> spaces{{ViewSpace::World}, {ViewSpace::Eye}, {ViewSpace::Clip}, {ViewSpace::Screen}};
    if (document.hasScene())
        for (std::size_t k = 0; k < document.scene().lights.size(); ++k) spaces.push_back({ViewSpace::Light, int(k)});
    spaces.push_back({ViewSpace::Point});
    return spaces;
}

QString whyNotLight(const Document& document, int light) {
    if (const auto why = whyUseless(document.scene(), pipeline::BufferId::ShadowBuffer); !why.empty())
        return toQString(why);
    return document.scene().lights[std::size_t(light)].castsShadow ? QString()
                                                                   : View3dPanel::tr("This light casts no shadow.");
}

}  // namespace

void View3dPanel::setSpace(SpaceId space) {
    m_moving.forget();
    m_awaited.reset();
    m_wanted.reset();
    const auto isThere = [&] {
        return space.space != ViewSpace::Light ||
               (m_view->space().content() && mapOf(*m_view->space().content(), space));
    };
    if (!isThere()) addFrusta();
    if (!isThere()) {
        m_awaited = space;
        wantBuffers();
        return;
    }
    goTo(space);
}

// A large mesh is moved there beside the window, and again where another frame has come meanwhile.
void View3dPanel::goTo(SpaceId space) {
    const auto& content = m_view->space().content();
    const bool isLarge = content && content->mesh->faces.size() > kManyTriangles;
    const auto map = isLarge && space != m_view->space().id() ? mapOf(*content, space) : std::nullopt;
    if (!map || map->space == ViewSpace::World) return enter(space, nullptr);
    m_awaited = space;
    m_moving.ask(
        [content, map = *map](const BackgroundJob::Control&) {
            return std::make_shared<const ViewContent>(inSpace(*content, map));
        },
        [this, space](const std::shared_ptr<const ViewContent>& moved) {
            moved->world == m_view->space().content()->mesh ? enter(space, moved) : goTo(space);
        });
}

void View3dPanel::enter(SpaceId space, std::shared_ptr<const ViewContent> moved) {
    m_awaited.reset();
    m_view->space().set(space, std::move(moved));
    showSpace();
    showHandles();
    wantBuffers();
    if (const auto wanted = std::exchange(m_wanted, std::nullopt)) takeCamera(wanted->camera);
}

// The frame may have the shadow buffers already, and then no other one comes.
void View3dPanel::addFrusta() {
    const auto& frame = m_document.frames().shown();
    if (!frame || !m_view->space().content()) return;
    ViewContent content = *m_view->space().content();
    content.frusta = lightFrusta(*frame);
    m_view->space().setContent(std::make_shared<const ViewContent>(std::move(content)), false);
}

void View3dPanel::showSpace() {
    const SpaceId id = m_view->space().id();
    const QString name = toQString(nameOf({id.space, id.light}));
    m_space->setText(name);
    m_space->setAccessibleName(tr("Space: %1").arg(name));
    m_space->setToolTip(tr("What this view shows: %1 (S the next space)").arg(name));
    showFace();
    m_remark->setText(remarkOf(id.space));
    arrangeHeader();
    showToggles();
}

// What is left out is said: of a dense mesh not every normal is shown.
QString View3dPanel::normalsTip() const {
    const auto& content = m_view->space().content();
    const ViewOptions& options = m_view->options();
    const std::size_t all = content ? normalArrows(*content->mesh, options.normals).size() : 0;
    const std::size_t shown = content ? shownNormals(*content, options).size() : 0;
    const QString tip = tr("Normals of the polygons or vertices");
    if (shown == all) return tip;
    return tip + tr(": %1 of %2 are shown").arg(count(qint64(shown)), count(qint64(all)));
}

// What each shows, or why it shows nothing in this space.
void View3dPanel::showToggles() {
    const ViewSpace space = m_view->space().id().space;
    const bool isPoint = space == ViewSpace::Point;
    const bool keepsLengths = space != ViewSpace::Clip && space != ViewSpace::Screen;
    const auto enable = [](QToolButton* button, const QString& tip, bool enabled, const QString& whyNot) {
        button->setEnabled(enabled);
        button->setToolTip(enabled ? tip : whyNot + ' ' + tip);
    };
    const QString flat = tr("Here lengths and angles mean nothing: the space is no picture of the world's."),
                  atPoint = tr("Not at the point.");
    const bool hasNormals = !isPoint && keepsLengths;
    enable(m_normals, hasNormals ? normalsTip() : tr("Normals of the polygons or vertices"), hasNormals,
           isPoint ? atPoint : flat);
    enable(m_vectors, tr("N, L, V, R and H at the picked point"), keepsLengths, flat);
    enable(m_lights, tr("Where the lights are"), !isPoint && keepsLengths, isPoint ? atPoint : flat);
    enable(m_eye, tr("The scene's eye, its picture plane, and the ray to the picked point"), !isPoint, atPoint);
}

void View3dPanel::fillSpaces(QMenu& menu) {
    menu.clear();
    for (const SpaceId& id : spacesOf(m_document)) {
        QAction* action = menu.addAction(toQString(nameOf(id)), this, [this, id] { setSpace(id); });
        action->setCheckable(true);
        action->setChecked(id.space == m_view->space().id().space && id.light == m_view->space().id().light);
        action->setToolTip(remarkOf(id.space));
        if (id.space != ViewSpace::Light) continue;
        const QString whyNot = whyNotLight(m_document, id.light);
        action->setEnabled(whyNot.isEmpty());
        if (!whyNot.isEmpty()) action->setToolTip(whyNot);
    }
}

// Those that cannot be shown are passed over.
void View3dPanel::stepSpace(int step) {
    const std::vector<SpaceId> spaces = spacesOf(m_document);
    SpaceId shown = m_awaited.value_or(m_view->space().id());
    shown.face = -1;
    const auto now = std::ranges::find(spaces, shown);
    auto i = now == spaces.end() ? 0 : std::size_t(now - spaces.begin());
    do i = (i + spaces.size() + std::size_t(step)) % spaces.size();
    while (spaces[i].space == ViewSpace::Light && !whyNotLight(m_document, spaces[i].light).isEmpty());
    setSpace(spaces[i]);
}

const LightFrustum* View3dPanel::shownFrustum() const {
    const auto& content = m_view->space().content();
    const SpaceId id = m_view->space().id();
    if (!content || id.space != ViewSpace::Light) return nullptr;
    const auto found = std::ranges::find_if(content->frusta, [&](const LightFrustum& frustum) {
        return frustum.light == id.light && (id.face < 0 || frustum.face == id.face);
    });
    return found == content->frusta.end() ? nullptr : &*found;
}

// A light at infinity has one face, which needs no name.
void View3dPanel::showFace() {
    const LightFrustum* frustum = shownFrustum();
    m_face->setVisible(frustum && frustum->faces > 1);
    if (!frustum) return arrangeHeader();
    const QString name = toQString(nameOfFace(frustum->face));
    m_face->setText(tr("face %1").arg(name));
    m_face->setAccessibleName(tr("Face %1 of the point light").arg(name));
    arrangeHeader();
}

void View3dPanel::fillFaces(QMenu& menu) {
    menu.clear();
    const LightFrustum* shown = shownFrustum();
    if (!shown) return;
    SpaceId id = m_view->space().id();
    const auto add = [&](const QString& text, int face, bool checked) {
        id.face = face;
        QAction* action = menu.addAction(text, this, [this, id] { setSpace(id); });
        action->setCheckable(true);
        action->setChecked(checked);
    };
    add(tr("The one that sees the most"), -1, id.face < 0);
    const int now = m_view->space().id().face;
    for (int face = 0; face < shown->faces; ++face) {
        const auto& frusta = m_view->space().content()->frusta;
        const auto found = std::ranges::find_if(
            frusta, [&](const LightFrustum& f) { return f.light == shown->light && f.face == face; });
        const bool isEmpty = found == frusta.end() || found->texels == 0;
        const QString name = tr("Face %1").arg(toQString(nameOfFace(face)));
        add(isEmpty ? tr("%1, sees nothing").arg(name) : name, face, now == face);
    }
}

void View3dPanel::stepFace(int step) {
    const LightFrustum* shown = shownFrustum();
    if (!shown || shown->faces < 2) return;
    SpaceId id = m_view->space().id();
    id.face = (shown->face + shown->faces + step) % shown->faces;
    setSpace(id);
}

}  // namespace app
