#include "app/view3d/view3d_panel.h"

#include <QVBoxLayout>
#include <utility>

#include "app/drawing3d/normal_arrows.h"
#include "app/frames/equation_symbols.h"
#include "app/frames/large_frame.h"
#include "app/frames/pixel_inspection.h"
#include "app/look/hidden_in_window.h"
#include "app/look/text.h"
#include "app/view3d/picture_turns.h"
#include "app/view3d/view3d_handles.h"
#include "app/view3d/view3d_header.h"
#include "app/view3d/view3d_spaces.h"
#include "pipeline/plan/needs.h"

namespace app {

View3dPanel::View3dPanel(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    setAccessibleName(tr("3D view"));
    m_view = new SceneView(this);
    m_view->setObjectName("sceneView");
    m_view->setEmptyText(tr("No scene yet. Open a file, or begin with the pyramid."));
    m_spaces = std::make_unique<View3dSpaces>(document, *m_view);
    m_handles = std::make_unique<View3dHandles>(document, *m_view);
    m_header = new View3dHeader(document, *m_view, this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_header);
    column->addWidget(m_view, 1);
    setFocusProxy(m_view);

    connect(&m_view->input(), &ViewInput::clicked, this, &View3dPanel::pick);
    connect(&m_view->input(), &ViewInput::hovered, this, &View3dPanel::hover);
    connect(&m_view->input(), &ViewInput::left, this, [this] { m_document.pointing().hover({}); });
    connect(m_header, &View3dHeader::spaceChosen, this, &View3dPanel::setSpace);
    connect(m_header, &View3dHeader::optionsChosen, this, &View3dPanel::changeOptions);
    connect(m_spaces.get(), &View3dSpaces::chosen, this, &View3dPanel::setSpace);
    connect(m_spaces.get(), &View3dSpaces::awaits, this, &View3dPanel::wantBuffers);
    connect(m_spaces.get(), &View3dSpaces::entered, this, &View3dPanel::takeSpace);
    connect(m_view, &SceneView::optionsChanged, this, [this] {
        m_header->showOptions();
        m_handles->show();
    });
    m_turns = new PictureTurns(document, *m_view, this);
    connect(m_turns, &PictureTurns::due, this, &View3dPanel::takeFrame);
    const auto showBuilding = [this] { m_view->progress().setBuilding(m_building.busy() || m_spaces->isMoving()); };
    connect(&m_building, &BackgroundJob::busyChanged, this, showBuilding);
    connect(m_spaces.get(), &View3dSpaces::busyChanged, this, showBuilding);
    observeWork();
    connect(&document, &Document::sceneOpened, this, [this] {
        m_made = {};
        m_building.forget();
        m_spaces->forget();
        m_handles->forget();  // of the scene before: nothing goes back to it
        m_view->space().setContent(nullptr, true);
        m_view->input().cancelDrag();
        m_view->setEmptyText({});
        if (m_view->space().id().space == ViewSpace::Light) setSpace({});
    });
    connect(&document, &Document::sceneChanged, this, &View3dPanel::wantBuffers);
    connect(&document.frames(), &FrameFeed::frameReady, this, &View3dPanel::takeFrame);
    connect(&document.inspection(), &PixelInspection::changed, this, &View3dPanel::takePixel);
    connect(&document.pointing(), &Pointing::selectionChanged, this, &View3dPanel::takeSelection);
    connect(&document.pointing(), &Pointing::hoverChanged, this, &View3dPanel::takeHover);
    connect(&document.pointing(), &Pointing::symbolChanged, this,
            [this] { m_view->pointAt(vectorsOf(m_document.pointing().symbol())); });
    wantBuffers();
    takeFrame();
}

View3dPanel::~View3dPanel() = default;

QMenu* View3dPanel::menu() const { return m_header->menu(); }

void View3dPanel::setBare(bool bare) {
    m_header->setVisible(!bare);
    m_view->corners().setBare(bare);
}

void View3dPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_header->arrange();
}

void View3dPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    wantBuffers();
    if (std::exchange(m_missed, false)) takeFrame();
}

void View3dPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_view->input().cancelDrag();  // the button's release goes elsewhere
    wantBuffers();
}

void View3dPanel::setSpace(SpaceId space) {
    m_wanted.reset();
    m_spaces->go(space);
}

void View3dPanel::takeSpace() {
    m_header->showSpace();
    m_handles->show();
    wantBuffers();
    if (const auto wanted = std::exchange(m_wanted, std::nullopt)) takeCamera(wanted->camera);
}

void View3dPanel::changeOptions(const ViewOptions& options) {
    m_view->setOptions(options);
    m_header->showOptions();
    m_handles->show();
    wantBuffers();
}

bool View3dPanel::wantsFrusta() const {
    const auto& awaited = m_spaces->awaited();
    const bool awaitsLight = awaited && awaited->space == ViewSpace::Light;
    return m_view->options().lightFrusta || awaitsLight || m_view->space().id().space == ViewSpace::Light;
}

void View3dPanel::wantBuffers() {
    if (!m_document.hasScene()) return;
    if (isHiddenInWindow(*this)) return m_document.frames().want(this, {});
    auto wanted = contentBuffers(m_document.scene(), m_view->options().normals == NormalsShown::Vertices);
    const bool useful = whyUseless(m_document.scene(), pipeline::BufferId::ShadowBuffer).empty();
    if (wantsFrusta() && useful) wanted |= pipeline::setOf({pipeline::BufferId::ShadowBuffer});
    m_document.frames().want(this, wanted);
}

bool View3dPanel::misses() {
    m_missed = m_missed || isHiddenInWindow(*this);
    return m_missed;
}

void View3dPanel::takeFrame() {
    if (!m_document.frames().shown() || m_turns->skips() || misses()) return;
    const Stepper& stepper = m_document.stepper();
    const bool inside = stepper.isInside() && stepper.steps();
    const pipeline::FramePtr& frame = m_document.frames().shown();
    const bool inTransform = inside && frame->until() == pipeline::StageId::Transform;
    const Made made{frame, m_document.pointing().pixel(), m_document.pointing().selection()};
    const auto& inspected = m_document.inspection().newest();
    const bool isKnown = made.pixel && inspected && inspected->frame == frame && inspected->report.pixel == *made.pixel;
    const auto build = [made, before = m_view->space().content(), known = isKnown ? inspected : nullptr,
                        frusta = wantsFrusta(), steps = inside ? stepper.steps() : nullptr, inTransform,
                        space = m_view->space().id(), moment = stepper.moment()](const std::stop_token& stop) {
        const pipeline::Frame& of = *made.frame;
        const pipeline::Frame* placed = inTransform ? steps->frame().get() : nullptr;
        ViewContent shown = contentOf(of, known ? std::nullopt : made.pixel, before.get(), stop, placed);
        if (stop.stop_requested()) return Built();  // nobody takes it
        if (known) shown = withReport(shown, of, &known->report);
        shown = withSelection(shown, of, made.selection);
        if (frusta) shown.frusta = lightFrusta(of);
        if (steps) shown = withProgress(shown, *steps, *moment);
        Built built{std::make_shared<const ViewContent>(std::move(shown)), nullptr};
        const auto map = mapOf(*built.content, space);
        if (map && map->space != ViewSpace::World)
            built.moved = std::make_shared<const ViewContent>(inSpace(*built.content, *map));
        return built;
    };
    if (!isLarge(*frame)) {
        m_building.forget();
        return showContent(build({}), made);
    }
    // While a slider moves what is under way may finish: it is better than none until the hand rests.
    m_building.ask([build](const BackgroundJob::Control& control) { return build(control.stop); },
                   [this, made](const Built& built) { showContent(built, made); }, BackgroundJob::Running::Finish);
}

void View3dPanel::showContent(const Built& built, const Made& made) {
    const auto& content = built.content;
    const bool newScene = !m_made.frame;
    m_made = made;
    if (newScene) {
        m_firstOptions = ViewOptions();
        makeNormalsReadable(*content, m_firstOptions);  // the sliders show more or fewer, longer or shorter ones
        ViewOptions options = m_view->options();
        options.everyNormal = m_firstOptions.everyNormal, options.normalLength = m_firstOptions.normalLength;
        changeOptions(options);
    }
    m_view->space().setContent(content, newScene, built.moved);
    m_header->showToggles();
    m_header->showFace();
    m_handles->show();
    // What a file asks for has a camera too; the space alone is gone to where a user waits for it.
    if (m_wanted)
        showWanted();
    else
        m_spaces->goOn();
    // Picked and selected meanwhile.
    if (m_document.pointing().selection() != made.selection) takeSelection();
    if (m_document.pointing().pixel() != made.pixel) takePixel();
}

void View3dPanel::takePixel() {
    if (!m_view->space().content() || misses() || m_building.busy()) return;  // what is built then takes it up
    const auto& inspected = m_document.inspection().newest();
    const pipeline::PixelReport* report = inspected ? &inspected->report : nullptr;
    const auto pixel = report ? std::optional(report->pixel) : std::nullopt;
    if (pixel == m_made.pixel) return;
    if (inspected && inspected->frame != m_made.frame) return takeFrame();
    m_made.pixel = pixel;
    m_view->space().setContent(
        std::make_shared<const ViewContent>(withReport(*m_view->space().content(), *m_made.frame, report)), false);
    m_handles->show();
}

void View3dPanel::takeSelection() {
    if (!m_view->space().content() || misses() || m_building.busy()) return;
    m_made.selection = m_document.pointing().selection();
    m_view->space().setContent(
        std::make_shared<const ViewContent>(withSelection(*m_view->space().content(), *m_made.frame, m_made.selection)),
        false);
    m_handles->show();
}

void View3dPanel::takeHover() {
    const auto& content = m_view->space().content();
    const auto pixel = m_document.pointing().hovered();
    m_view->setProbe(content && pixel && !isHiddenInWindow(*this) ? pointShownBy(*content, *pixel) : std::nullopt);
}

// By the frame that the view was made of: another one may be there before the view is.
void View3dPanel::pick(const Hit& hit) {
    if (!m_made.frame || !m_view->space().content()) return;
    const Shown shown = pixelShowing(*m_made.frame, *m_view->space().content(), hit);
    if (shown.pixel)
        m_document.pointing().pick(shown.pixel);
    else
        emit m_document.said(toQString(shown.whyNot));
}

void View3dPanel::hover(const std::optional<Hit>& hit) {
    if (!m_made.frame || !m_view->space().content()) return;
    m_document.pointing().hover(hit ? pixelShowing(*m_made.frame, *m_view->space().content(), *hit).pixel
                                    : std::nullopt);
}

}  // namespace app
