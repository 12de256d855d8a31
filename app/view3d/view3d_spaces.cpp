#include "app/view3d/view3d_spaces.h"

#include <algorithm>

#include "app/frames/large_frame.h"
#include "app/look/text.h"
#include "pipeline/plan/needs.h"

namespace app {

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
                                                                   : View3dSpaces::tr("This light casts no shadow.");
}

const LightFrustum* shownFrustum(const ShownSpace& space) {
    const auto& content = space.content();
    const SpaceId id = space.id();
    if (!content || id.space != ViewSpace::Light) return nullptr;
    const auto found = std::ranges::find_if(content->frusta, [&](const LightFrustum& frustum) {
        return frustum.light == id.light && (id.face < 0 || frustum.face == id.face);
    });
    return found == content->frusta.end() ? nullptr : &*found;
}

View3dSpaces::View3dSpaces(Document& document, SceneView& view) : m_document(document), m_view(view) {
    connect(&view.input(), &ViewInput::spaceAsked, this, &View3dSpaces::step);
    connect(&view.input(), &ViewInput::faceAsked, this, &View3dSpaces::stepFace);
    connect(&m_moving, &BackgroundJob::busyChanged, this, &View3dSpaces::busyChanged);
}

void View3dSpaces::forget() {
    m_moving.forget();
    m_awaited.reset();
}

void View3dSpaces::go(SpaceId space) {
    forget();
    const auto isThere = [&] {
        return space.space != ViewSpace::Light || (m_view.space().content() && mapOf(*m_view.space().content(), space));
    };
    if (!isThere()) addFrusta();
    if (!isThere()) {
        m_awaited = space;
        return emit awaits();
    }
    moveTo(space);
}

void View3dSpaces::goOn() {
    if (m_awaited && !isMoving() && mapOf(*m_view.space().content(), *m_awaited)) go(*m_awaited);
}

// A large mesh is moved there beside the window, and again where another frame has come meanwhile.
void View3dSpaces::moveTo(SpaceId space) {
    const auto& content = m_view.space().content();
    const bool isLarge = content && content->mesh->faces.size() > kManyTriangles;
    const auto map = isLarge && space != m_view.space().id() ? mapOf(*content, space) : std::nullopt;
    if (!map || map->space == ViewSpace::World) return enter(space, nullptr);
    m_awaited = space;
    m_moving.ask(
        [content, map = *map](const BackgroundJob::Control&) {
            return std::make_shared<const ViewContent>(inSpace(*content, map));
        },
        [this, space](const std::shared_ptr<const ViewContent>& moved) {
            moved->world == m_view.space().content()->mesh ? enter(space, moved) : moveTo(space);
        });
}

void View3dSpaces::enter(SpaceId space, std::shared_ptr<const ViewContent> moved) {
    m_awaited.reset();
    m_view.space().set(space, std::move(moved));
    emit entered();
}

// The frame may have the shadow buffers already, and then no other one comes.
void View3dSpaces::addFrusta() {
    const auto& frame = m_document.frames().shown();
    if (!frame || !m_view.space().content()) return;
    ViewContent content = *m_view.space().content();
    content.frusta = lightFrusta(*frame);
    m_view.space().setContent(std::make_shared<const ViewContent>(std::move(content)), false);
}

// Those that cannot be shown are passed over.
void View3dSpaces::step(int by) {
    const std::vector<SpaceId> spaces = spacesOf(m_document);
    SpaceId shown = m_awaited.value_or(m_view.space().id());
    shown.face = -1;
    const auto now = std::ranges::find(spaces, shown);
    auto i = now == spaces.end() ? 0 : std::size_t(now - spaces.begin());
    do i = (i + spaces.size() + std::size_t(by)) % spaces.size();
    while (spaces[i].space == ViewSpace::Light && !whyNotLight(m_document, spaces[i].light).isEmpty());
    emit chosen(spaces[i]);
}

void View3dSpaces::stepFace(int by) {
    const LightFrustum* shown = shownFrustum(m_view.space());
    if (!shown || shown->faces < 2) return;
    SpaceId id = m_view.space().id();
    id.face = (shown->face + shown->faces + by) % shown->faces;
    emit chosen(id);
}

}  // namespace app
