#include "app/view3d/view3d_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/core/icons.h"
#include "app/core/large_frame.h"
#include "app/core/pixel_inspection.h"
#include "app/core/pointed.h"
#include "app/core/press_watch.h"
#include "app/core/put_away.h"
#include "app/core/text.h"
#include "app/core/theme.h"
#include "app/view3d/normal_arrows.h"
#include "app/view3d/picture_turns.h"
#include "app/view3d/view_settings.h"
#include "pipeline/plan/needs.h"

namespace app {

View3dPanel::View3dPanel(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    setAccessibleName(tr("3D view"));
    m_view = new SceneView(this);
    m_view->setObjectName("sceneView");
    m_view->setEmptyText(tr("No scene yet. Open a file, or begin with the pyramid."));
    buildHeader();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_header);
    column->addWidget(m_view, 1);
    setFocusProxy(m_view);

    connect(&m_view->input(), &ViewInput::clicked, this, &View3dPanel::pick);
    connect(&m_view->input(), &ViewInput::hovered, this, &View3dPanel::hover);
    connect(&m_view->input(), &ViewInput::left, this, [this] { m_document.pointing().hover({}); });
    connect(&m_view->handles(), &ViewHandles::dragged, this, &View3dPanel::drag);
    connect(&m_view->handles(), &ViewHandles::cancelled, this, &View3dPanel::cancelDrag);
    connect(&m_view->handles(), &ViewHandles::hovered, this, &View3dPanel::showNumbers);
    connect(&m_view->input(), &ViewInput::spaceAsked, this, &View3dPanel::stepSpace);
    connect(&m_view->input(), &ViewInput::faceAsked, this, &View3dPanel::stepFace);
    connect(m_view, &SceneView::optionsChanged, this, [this] {
        showOptions();
        showHandles();
    });
    connect(&m_view->camera(), &ViewCamera::orthographicChanged, m_orthographic, &QToolButton::setChecked);
    m_turns = new PictureTurns(document, *m_view, this);
    connect(m_turns, &PictureTurns::due, this, &View3dPanel::takeFrame);
    for (const BackgroundJob* job : {&m_building, &m_moving})
        connect(job, &BackgroundJob::busyChanged, this,
                [this] { m_view->progress().setBuilding(m_building.busy() || m_moving.busy()); });
    observeWork();
    connect(&document, &Document::sceneOpened, this, [this] {
        m_made = {};
        m_building.forget();
        m_moving.forget();
        m_awaited.reset();
        m_beforeDrag.reset();  // of the scene before: nothing goes back to it
        m_view->space().setContent(nullptr, true);
        m_view->input().cancelDrag();
        m_view->setEmptyText({});
        if (m_view->space().id().space == ViewSpace::Light) setSpace({});
    });
    connect(&document, &Document::sceneChanged, this, &View3dPanel::wantBuffers);
    connect(&document, &Document::sceneChanged, this, &View3dPanel::dropDrag);
    connect(&document.frames(), &FrameFeed::frameReady, this, &View3dPanel::takeFrame);
    connect(&document.inspection(), &PixelInspection::changed, this, &View3dPanel::takePixel);
    connect(&document.pointing(), &Pointing::selectionChanged, this, &View3dPanel::takeSelection);
    connect(&document.pointing(), &Pointing::hoverChanged, this, &View3dPanel::takeHover);
    connect(&document.pointing(), &Pointing::symbolChanged, this,
            [this] { m_view->pointAt(vectorsOf(m_document.pointing().symbol())); });
    connect(&Theme::current(), &Theme::changed, this, &View3dPanel::applyTheme);
    showSpace();
    applyTheme();
    showOptions();
    wantBuffers();
    takeFrame();
}

void View3dPanel::setBare(bool bare) { m_header->setVisible(!bare); }

void View3dPanel::buildHeader() {
    m_header = new QWidget(this);
    auto* row = new QHBoxLayout(m_header);
    row->setSpacing(2);
    m_space = addMenuButton("chevron-down", tr("Space"), tr("What this view shows"));
    m_space->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_space->setLayoutDirection(Qt::RightToLeft);  // the arrow after the name
    m_space->setPopupMode(QToolButton::InstantPopup);
    auto* spaces = new QMenu(m_space);
    spaces->setLayoutDirection(Qt::LeftToRight);
    spaces->setToolTipsVisible(true);
    connect(spaces, &QMenu::aboutToShow, this, [this, spaces] { fillSpaces(*spaces); });
    m_space->setMenu(spaces);
    m_face = addMenuButton("chevron-down", tr("Face"),
                           tr("Which of the six faces around the light: the axis that it looks along (F the next one, "
                              "Shift+F the one before)"));
    m_face->setObjectName("face");
    m_face->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_face->setLayoutDirection(Qt::RightToLeft);
    m_face->setPopupMode(QToolButton::InstantPopup);
    auto* faces = new QMenu(m_face);
    faces->setLayoutDirection(Qt::LeftToRight);
    faces->setToolTipsVisible(true);
    connect(faces, &QMenu::aboutToShow, this, [this, faces] { fillFaces(*faces); });
    m_face->setMenu(faces);
    m_remark = new QLabel(m_header);
    m_remark->setProperty("tone", "3");
    row->addWidget(m_remark);
    row->addStretch(1);

    m_orthographic =
        addToggle("orthographic", tr("Orthographic"), tr("Orthographic (5): parallel lines stay parallel"));
    connect(m_orthographic, &QToolButton::clicked, &m_view->camera(), &ViewCamera::setOrthographic);
    // What these four are for stands in showToggles().
    m_normals = addToggle("normals", tr("Normals"), {});
    connect(m_normals, &QToolButton::clicked, this, [this](bool on) {
        ViewOptions options = m_view->options();
        options.normals = on ? m_lastNormals : NormalsShown::Off;
        changeOptions(options);
    });
    m_vectors = addToggle("vectors", tr("Vectors"), {});
    m_lights = addToggle("light", tr("Lights"), {});
    m_eye = addToggle("eye", tr("Eye and frustum"), {});
    const auto flip = [this](QToolButton* button, bool ViewOptions::*shown) {
        connect(button, &QToolButton::clicked, this, [this, shown](bool on) {
            ViewOptions options = m_view->options();
            options.*shown = on;
            changeOptions(options);
        });
    };
    flip(m_vectors, &ViewOptions::vectors);
    flip(m_lights, &ViewOptions::lights);
    flip(m_eye, &ViewOptions::eye);

    m_cameras = addMenuButton("cube", tr("Camera"), tr("Views from named directions"));
    auto* menu = new QMenu(m_cameras);
    const auto addView = [&](const QString& text, ViewPreset preset) {
        connect(menu->addAction(text), &QAction::triggered, m_view, [this, preset] { m_view->camera().go(preset); });
    };
    addView(tr("Front\t1"), ViewPreset::Front);
    addView(tr("Side\t3"), ViewPreset::Side);
    addView(tr("Top\t7"), ViewPreset::Top);
    addView(tr("Iso\t9"), ViewPreset::Iso);
    menu->addSeparator();
    addView(tr("From the eye\t0"), ViewPreset::Eye);
    addView(tr("Everything, the eye too\tA"), ViewPreset::Everything);
    connect(menu->addAction(tr("Zoom out of the eye\tZ")), &QAction::triggered, &m_view->camera(),
            &ViewCamera::zoomOut);
    m_cameras->setMenu(menu);
    m_cameras->setPopupMode(QToolButton::InstantPopup);

    QToolButton* more = addMenuButton("sliders", tr("Arrows and aids"), tr("Arrows, bounds, frustum, constructions"));
    auto* settings = new ViewSettings(more);
    connect(settings, &ViewSettings::changed, this, &View3dPanel::changeOptions);
    connect(more, &QToolButton::clicked, this, [this, more, settings] {
        settings->setOptions(m_view->options());
        settings->setSpace(m_view->space().id().space);
        settings->adjustSize();
        settings->move(more->mapToGlobal(QPoint(more->width() - settings->width(), more->height())));
        settings->show();
    });
    QToolButton* rest = addMenuButton("more", tr("More"), tr("Other views"));
    m_menu = new QMenu(rest);
    rest->setMenu(m_menu);
    rest->setPopupMode(QToolButton::InstantPopup);
    new PressWatch(*m_header, [this] { m_view->setFocus(); });  // whoever clicks there goes on with the view's keys
}

QToolButton* View3dPanel::addToggle(const QString& iconName, const QString& name, const QString& tip) {
    QToolButton* button = addMenuButton(iconName, name, tip);
    button->setCheckable(true);
    return button;
}

QToolButton* View3dPanel::addMenuButton(const QString& iconName, const QString& name, const QString& tip) {
    auto* button = new QToolButton(m_header);
    button->setIcon(icon(iconName));
    button->setAccessibleName(name);
    button->setToolTip(tip);
    button->setObjectName(iconName);
    button->setFocusPolicy(Qt::TabFocus);
    m_header->layout()->addWidget(button);
    return button;
}

void View3dPanel::applyTheme() {
    const Theme& theme = Theme::current();
    m_header->setFixedHeight(theme.px(32));
    m_header->layout()->setContentsMargins(theme.px(6), 0, theme.px(4), 0);
    m_space->setFont(theme.text(13, 600));
    m_face->setFont(theme.text(13, 600));
    m_remark->setFont(theme.text(12));
    for (auto* button : m_header->findChildren<QToolButton*>()) button->setIconSize(QSize(theme.px(16), theme.px(16)));
    arrangeHeader();
}

// What a narrow view can do without: the remark, then the buttons whose keys, or the cube in the corner, do the same.
void View3dPanel::arrangeHeader() {
    const auto widthOf = [this](const QToolButton* button) {
        return button->sizeHint().width() + m_header->layout()->spacing();
    };
    int buttons = 0;
    for (const auto* button : m_header->findChildren<QToolButton*>())
        if (!button->isHidden() || button == m_cameras || button == m_orthographic) buttons += widthOf(button);
    const int room = width() - Theme::current().px(16);
    m_remark->setVisible(m_remark->sizeHint().width() + buttons <= room);
    for (QToolButton* spare : {m_cameras, m_orthographic}) {
        spare->setVisible(buttons <= room);
        if (buttons > room) buttons -= widthOf(spare);
    }
}

void View3dPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrangeHeader();
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

void View3dPanel::changeOptions(const ViewOptions& options) {
    m_view->setOptions(options);
    showOptions();
    showHandles();
    wantBuffers();
}

void View3dPanel::showOptions() {
    const ViewOptions& options = m_view->options();
    if (options.normals != NormalsShown::Off) m_lastNormals = options.normals;
    m_normals->setChecked(options.normals != NormalsShown::Off);
    m_vectors->setChecked(options.vectors);
    m_lights->setChecked(options.lights);
    m_eye->setChecked(options.eye);
    showToggles();
}

bool View3dPanel::wantsFrusta() const {
    const bool awaitsLight = m_awaited && m_awaited->space == ViewSpace::Light;
    return m_view->options().lightFrusta || awaitsLight || m_view->space().id().space == ViewSpace::Light;
}

void View3dPanel::wantBuffers() {
    if (!m_document.hasScene()) return;
    if (isPutAway(*this)) return m_document.frames().want(this, {});
    auto wanted = contentBuffers(m_document.scene(), m_view->options().normals == NormalsShown::Vertices);
    const bool useful = whyUseless(m_document.scene(), pipeline::BufferId::ShadowBuffer).empty();
    if (wantsFrusta() && useful) wanted |= pipeline::setOf({pipeline::BufferId::ShadowBuffer});
    m_document.frames().want(this, wanted);
}

bool View3dPanel::misses() {
    m_missed = m_missed || isPutAway(*this);
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
        ViewOptions options = m_view->options();
        makeNormalsReadable(*content, options);  // the sliders show more or fewer, longer or shorter ones
        changeOptions(options);
    }
    m_view->space().setContent(content, newScene, built.moved);
    showToggles();
    showFace();
    showHandles();
    // What a file asks for has a camera too; the space alone is gone to where a user waits for it.
    if (m_wanted)
        showWanted();
    else if (m_awaited && !m_moving.busy() && mapOf(*content, *m_awaited))
        setSpace(*m_awaited);
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
    showHandles();
}

void View3dPanel::takeSelection() {
    if (!m_view->space().content() || misses() || m_building.busy()) return;
    m_made.selection = m_document.pointing().selection();
    m_view->space().setContent(
        std::make_shared<const ViewContent>(withSelection(*m_view->space().content(), *m_made.frame, m_made.selection)),
        false);
    showHandles();
}

void View3dPanel::takeHover() {
    const auto& content = m_view->space().content();
    const auto pixel = m_document.pointing().hovered();
    m_view->setProbe(content && pixel && !isPutAway(*this) ? pointShownBy(*content, *pixel) : std::nullopt);
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
