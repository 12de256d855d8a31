#include "app/view3d/view3d_header.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "app/drawing3d/normal_arrows.h"
#include "app/look/icons.h"
#include "app/look/numbers.h"
#include "app/look/press_watch.h"
#include "app/look/text.h"
#include "app/look/theme.h"
#include "app/view3d/view3d_spaces.h"
#include "app/view3d/view_settings.h"

namespace app {

namespace {

QString remarkOf(ViewSpace space) {
    switch (space) {
        case ViewSpace::World: return {};
        case ViewSpace::Eye: return View3dHeader::tr("x right, y up, z away from the eye");
        case ViewSpace::Clip: return View3dHeader::tr("after the division by w: −1 to 1");
        case ViewSpace::Screen: return View3dHeader::tr("x, y in pixels, z from 0 to 1");
        case ViewSpace::Light: return View3dHeader::tr("as its shadow buffer sees it");
        case ViewSpace::Point: break;
    }
    return View3dHeader::tr("unit hemisphere, N up");
}

}  // namespace

View3dHeader::View3dHeader(const Document& document, SceneView& view, QWidget* panel)
    : QWidget(panel), m_document(document), m_view(view) {
    auto* row = new QHBoxLayout(this);
    row->setSpacing(2);
    addSpace();
    m_remark = new QLabel(this);
    m_remark->setProperty("tone", "3");
    row->addWidget(m_remark);
    row->addStretch(1);
    addToggles();
    addCameras();
    addMenus();
    new PressWatch(*this, [this] { m_view.setFocus(); });  // a click there returns the keys to the view
    connect(&Theme::current(), &Theme::changed, this, &View3dHeader::applyTheme);
    showSpace();
    applyTheme();
    showOptions();
}

QMenu* View3dHeader::addChoice(QToolButton* button) {
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setLayoutDirection(Qt::RightToLeft);  // the arrow after the name
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button);
    menu->setLayoutDirection(Qt::LeftToRight);
    menu->setToolTipsVisible(true);
    button->setMenu(menu);
    return menu;
}

void View3dHeader::addSpace() {
    m_space = addButton("chevron-down", tr("Space"), tr("What this view shows"));
    QMenu* spaces = addChoice(m_space);
    connect(spaces, &QMenu::aboutToShow, this, [this, spaces] { fillSpaces(*spaces); });
    m_face = addButton("chevron-down", tr("Face"),
                       tr("Which of the six faces around the light: the axis that it looks along (F the next one, "
                          "Shift+F the one before)"));
    m_face->setObjectName("face");
    QMenu* faces = addChoice(m_face);
    connect(faces, &QMenu::aboutToShow, this, [this, faces] { fillFaces(*faces); });
}

void View3dHeader::addToggles() {
    m_orthographic =
        addToggle("orthographic", tr("Orthographic"), tr("Orthographic (5): parallel lines stay parallel"));
    connect(&m_view.camera(), &ViewCamera::orthographicChanged, m_orthographic, &QToolButton::setChecked);
    connect(m_orthographic, &QToolButton::clicked, &m_view.camera(), &ViewCamera::setOrthographic);
    // What these four are for stands in showToggles().
    m_normals = addToggle("normals", tr("Normals"), {});
    connect(m_normals, &QToolButton::clicked, this, [this](bool on) {
        ViewOptions options = m_view.options();
        options.normals = on ? m_lastNormals : NormalsShown::Off;
        emit optionsChosen(options);
    });
    m_vectors = addToggle("vectors", tr("Vectors"), {});
    m_lights = addToggle("light", tr("Lights"), {});
    m_eye = addToggle("eye", tr("Eye and frustum"), {});
    const auto flip = [this](QToolButton* button, bool ViewOptions::*shown) {
        connect(button, &QToolButton::clicked, this, [this, shown](bool on) {
            ViewOptions options = m_view.options();
            options.*shown = on;
            emit optionsChosen(options);
        });
    };
    flip(m_vectors, &ViewOptions::vectors);
    flip(m_lights, &ViewOptions::lights);
    flip(m_eye, &ViewOptions::eye);
}

void View3dHeader::addCameras() {
    m_cameras = addButton("cube", tr("Camera"), tr("Views from named directions"));
    auto* menu = new QMenu(m_cameras);
    const auto addView = [&](const QString& text, ViewPreset preset) {
        connect(menu->addAction(text), &QAction::triggered, &m_view, [this, preset] { m_view.camera().go(preset); });
    };
    addView(tr("Front\t1"), ViewPreset::Front);
    addView(tr("Side\t3"), ViewPreset::Side);
    addView(tr("Top\t7"), ViewPreset::Top);
    addView(tr("Iso\t9"), ViewPreset::Iso);
    menu->addSeparator();
    addView(tr("From the eye\t0"), ViewPreset::Eye);
    addView(tr("Everything, the eye too\tA"), ViewPreset::Everything);
    connect(menu->addAction(tr("Zoom out of the eye\tZ")), &QAction::triggered, &m_view.camera(), &ViewCamera::zoomOut);
    m_cameras->setMenu(menu);
    m_cameras->setPopupMode(QToolButton::InstantPopup);
}

void View3dHeader::addMenus() {
    QToolButton* more = addButton("sliders", tr("Arrows and aids"), tr("Arrows, bounds, frustum, constructions"));
    auto* settings = new ViewSettings(more);
    connect(settings, &ViewSettings::changed, this, &View3dHeader::optionsChosen);
    connect(more, &QToolButton::clicked, this, [this, more, settings] {
        settings->setOptions(m_view.options());
        settings->setSpace(m_view.space().id().space);
        settings->adjustSize();
        settings->move(more->mapToGlobal(QPoint(more->width() - settings->width(), more->height())));
        settings->show();
    });
    QToolButton* rest = addButton("more", tr("More"), tr("Other views"));
    m_menu = new QMenu(rest);
    rest->setMenu(m_menu);
    rest->setPopupMode(QToolButton::InstantPopup);
    addSpares();
}

// The first ones have keys, or the cube in the corner, that do the same.
void View3dHeader::addSpares() {
    for (QToolButton* button : {m_cameras, m_orthographic, m_eye, m_lights, m_vectors, m_normals}) {
        QAction* entry = m_menu->addAction(button->accessibleName());
        entry->setMenu(button->menu());
        entry->setCheckable(button->isCheckable());
        connect(entry, &QAction::triggered, button, &QToolButton::click);
        m_spares.push_back({button, entry});
    }
    connect(m_menu, &QMenu::aboutToShow, this, [this] {
        for (const auto& [button, entry] : m_spares) {
            entry->setChecked(button->isChecked());
            entry->setEnabled(button->isEnabled());
            entry->setToolTip(button->toolTip());
        }
    });
}

QToolButton* View3dHeader::addToggle(const QString& iconName, const QString& name, const QString& tip) {
    QToolButton* button = addButton(iconName, name, tip);
    button->setCheckable(true);
    return button;
}

QToolButton* View3dHeader::addButton(const QString& iconName, const QString& name, const QString& tip) {
    auto* button = new QToolButton(this);
    button->setIcon(icon(iconName));
    button->setAccessibleName(name);
    button->setToolTip(tip);
    button->setObjectName(iconName);
    button->setFocusPolicy(Qt::TabFocus);
    layout()->addWidget(button);
    return button;
}

void View3dHeader::applyTheme() {
    const Theme& theme = Theme::current();
    setFixedHeight(theme.px(32));
    layout()->setContentsMargins(theme.px(6), 0, theme.px(4), 0);
    m_space->setFont(theme.text(13, 600));
    m_face->setFont(theme.text(13, 600));
    m_remark->setFont(theme.text(12));
    for (auto* button : findChildren<QToolButton*>()) button->setIconSize(QSize(theme.px(16), theme.px(16)));
    arrange();
}

// What a narrow view can do without: the remark, the names' second words, then buttons, which are in the menu instead.
// Nothing is set but to what it is in the end: every frame comes here, and what changes is laid out anew.
void View3dHeader::arrange() {
    const auto widthOf = [this](const QToolButton* button) { return button->sizeHint().width() + layout()->spacing(); };
    const auto longerBy = [](const QToolButton* button, const QString& text) {
        const QFontMetrics metrics = button->fontMetrics();
        return metrics.horizontalAdvance(text) - metrics.horizontalAdvance(button->text());
    };
    const auto needed = [&](const Names& names) {
        int sum = longerBy(m_space, names.space) + (m_face->isHidden() ? 0 : longerBy(m_face, names.face));
        for (const auto* button : findChildren<QToolButton*>())
            if (!button->isHidden() || std::ranges::count(m_spares, button, &Spare::button) > 0) sum += widthOf(button);
        return sum;
    };
    const int room = parentWidget()->width() - Theme::current().px(16);
    Names names = namesIn(false);
    int buttons = needed(names);
    m_remark->setVisible(m_remark->sizeHint().width() + buttons <= room);
    if (buttons > room) {
        names = namesIn(true);
        buttons = needed(names);
    }
    m_space->setText(names.space);
    m_face->setText(names.face);
    for (const auto& [button, entry] : m_spares) {
        const bool fits = buttons <= room;
        button->setVisible(fits);
        entry->setVisible(!fits);
        if (!fits) buttons -= widthOf(button);
    }
}

View3dHeader::Names View3dHeader::namesIn(bool areShort) const {
    const SpaceId id = m_view.space().id();
    Names names{toQString(areShort ? shortNameOf(id) : nameOf({id.space, id.light})), {}};
    if (const LightFrustum* frustum = shownFrustum(m_view.space())) {
        const QString face = toQString(nameOfFace(frustum->face));
        names.face = areShort ? face : tr("face %1").arg(face);
    }
    return names;
}

void View3dHeader::showOptions() {
    const ViewOptions& options = m_view.options();
    if (options.normals != NormalsShown::Off) m_lastNormals = options.normals;
    m_normals->setChecked(options.normals != NormalsShown::Off);
    m_vectors->setChecked(options.vectors);
    m_lights->setChecked(options.lights);
    m_eye->setChecked(options.eye);
    showToggles();
}

void View3dHeader::showSpace() {
    const SpaceId id = m_view.space().id();
    const QString name = toQString(nameOf({id.space, id.light}));
    m_space->setAccessibleName(tr("Space: %1").arg(name));
    m_space->setToolTip(tr("What this view shows: %1 (S the next space)").arg(name));
    showFace();
    m_remark->setText(remarkOf(id.space));
    arrange();
    showToggles();
}

// What is left out is said: of a dense mesh not every normal is shown.
QString View3dHeader::normalsTip() const {
    const auto& content = m_view.space().content();
    const ViewOptions& options = m_view.options();
    const std::size_t all = content ? normalCount(*content->mesh, options.normals) : 0;
    const std::size_t shown = content ? shownNormals(*content, options).size() : 0;
    const QString tip = tr("Normals of the polygons or vertices");
    if (shown == all) return tip;
    return tip + tr(": %1 of %2 are shown").arg(count(qint64(shown)), count(qint64(all)));
}

// What each shows, or why it shows nothing in this space.
void View3dHeader::showToggles() {
    const ViewSpace space = m_view.space().id().space;
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

void View3dHeader::fillSpaces(QMenu& menu) {
    menu.clear();
    for (const SpaceId& id : spacesOf(m_document)) {
        QAction* action = menu.addAction(toQString(nameOf(id)), this, [this, id] { emit spaceChosen(id); });
        action->setCheckable(true);
        action->setChecked(id.space == m_view.space().id().space && id.light == m_view.space().id().light);
        action->setToolTip(remarkOf(id.space));
        if (id.space != ViewSpace::Light) continue;
        const QString whyNot = whyNotLight(m_document, id.light);
        action->setEnabled(whyNot.isEmpty());
        if (!whyNot.isEmpty()) action->setToolTip(whyNot);
    }
}

// A light at infinity has one face, which needs no name.
void View3dHeader::showFace() {
    const LightFrustum* frustum = shownFrustum(m_view.space());
    m_face->setVisible(frustum && frustum->faces > 1);
    if (!frustum) return arrange();
    const QString name = toQString(nameOfFace(frustum->face));
    m_face->setAccessibleName(tr("Face %1 of the point light").arg(name));
    arrange();
}

void View3dHeader::fillFaces(QMenu& menu) {
    menu.clear();
    const LightFrustum* shown = shownFrustum(m_view.space());
    if (!shown) return;
    SpaceId id = m_view.space().id();
    const auto add = [&](const QString& text, int face, bool checked) {
        id.face = face;
        QAction* action = menu.addAction(text, this, [this, id] { emit spaceChosen(id); });
        action->setCheckable(true);
        action->setChecked(checked);
    };
    add(tr("The one that sees the most"), -1, id.face < 0);
    const int now = m_view.space().id().face;
    for (int face = 0; face < shown->faces; ++face) {
        const auto& frusta = m_view.space().content()->frusta;
        const auto found = std::ranges::find_if(
            frusta, [&](const LightFrustum& f) { return f.light == shown->light && f.face == face; });
        const bool isEmpty = found == frusta.end() || found->texels == 0;
        const QString name = tr("Face %1").arg(toQString(nameOfFace(face)));
        add(isEmpty ? tr("%1, sees nothing").arg(name) : name, face, now == face);
    }
}

}  // namespace app
