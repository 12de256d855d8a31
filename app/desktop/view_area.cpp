#include "app/desktop/view_area.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QFrame>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/core/stage_buffer.h"
#include "app/panels/buffer_view.h"
#include "app/panels/follow_theme.h"
#include "app/panels/thumbnail_strip.h"
#include "app/view3d/view3d_panel.h"

namespace app {
namespace {

QFrame* framed(QWidget* view, const char* name) {
    auto* frame = new QFrame;
    frame->setObjectName(name);
    frame->setProperty("kind", "panel");
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(1, 1, 1, 1);
    column->addWidget(view);
    frame->setMinimumSize(240, 180);
    return frame;
}

}  // namespace

ViewArea::ViewArea(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_columns(new QSplitter(Qt::Horizontal, this)),
      m_buffers(new QSplitter(Qt::Vertical)),
      m_first(new BufferView(document)),
      m_second(new BufferView(document)),
      m_view3d(new View3dPanel(document)),
      m_thumbnails(new ThumbnailStrip(document)) {
    setObjectName("viewArea");
    m_first->setObjectName("firstBufferView");
    m_second->setObjectName("secondBufferView");
    m_buffers->addWidget(framed(m_first, "firstFrame"));
    m_buffers->addWidget(framed(m_second, "secondFrame"));
    m_columns->addWidget(m_buffers);
    m_columns->addWidget(framed(m_view3d, "view3dFrame"));
    for (QSplitter* splitter : {m_columns, m_buffers}) splitter->setChildrenCollapsible(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_columns, 1);
    column->addWidget(m_thumbnails);
    followTheme(this, [this, column] {
        column->setSpacing(Theme::current().px(8));
        for (QSplitter* splitter : {m_columns, m_buffers}) splitter->setHandleWidth(Theme::current().px(8));
    });

    connect(m_thumbnails, &ThumbnailStrip::chosen, m_first, &BufferView::setBuffer);
    connect(m_first, &BufferView::bufferChanged, m_thumbnails, &ThumbnailStrip::setCurrent);
    connect(&document, &Document::stageChanged, this, &ViewArea::showStage);
    // Going inside, or out again, shows buffers that are there.
    connect(&document.stepper(), &Stepper::changed, this, [this] {
        if (std::exchange(m_inside, m_document.stepper().isInside()) != m_document.stepper().isInside()) showInside();
    });
    connect(&document, &Document::sceneOpened, this, &ViewArea::showStage);
    setSecond(false);
    resetSizes();
}

void ViewArea::showStage() {
    if (!m_document.hasScene()) return;
    const pipeline::StageId stage = m_document.stage();
    const pipeline::Scene& scene = m_document.scene();
    m_inside = m_document.stepper().isInside();
    m_first->setBuffer(m_inside ? mainBufferInside(stage, scene) : mainBuffer(stage, scene));
    m_second->setBuffer(m_inside ? secondBufferInside(stage, scene) : secondBuffer(stage, scene));
}

void ViewArea::showInside() {
    if (!m_document.hasScene() || !m_inside) return;
    const auto comesLater = [this](const BufferView* view) {
        return bufferInfo(view->buffer().id).stage > m_document.stage();
    };
    if (comesLater(m_first)) m_first->setBuffer(mainBufferInside(m_document.stage(), m_document.scene()));
    if (comesLater(m_second)) m_second->setBuffer(secondBufferInside(m_document.stage(), m_document.scene()));
}

void ViewArea::showBuffer(const pipeline::BufferName& buffer) { m_first->setBuffer(buffer); }

void ViewArea::showBuffers(const QStringList& names) {
    const std::array views{m_first, m_second};
    for (qsizetype i = 0; i < std::min(names.size(), qsizetype(views.size())); ++i)
        if (const auto name = pipeline::findBuffer(names[i].toStdString())) views[std::size_t(i)]->setBuffer(*name);
    if (names.size() > 1 && height() > Theme::current().px(560)) setSecond(true);
}

// "one" and "two": buffer views, beside the 3D view.
void ViewArea::fill(WindowState& state) const {
    state.arrangement = hasSecond() ? "two" : "one";
    state.views = {m_first->state()};
    if (hasSecond()) state.views.push_back(m_second->state());
    state.space = m_view3d->state();
}

pipeline::Errors ViewArea::lookAt(const WindowState& state) {
    pipeline::Errors errors;
    const auto add = [&](const pipeline::Errors& more) { errors.insert(errors.end(), more.begin(), more.end()); };
    if (state.arrangement != "one" && state.arrangement != "two")
        add({{{}, "there is no arrangement \"" + state.arrangement + '"', "one or two"}});
    setSecond(state.arrangement == "two");
    if (!state.views.empty()) add(m_first->lookAt(state.views[0]));
    if (state.views.size() > 1) add(m_second->lookAt(state.views[1]));
    add(m_view3d->lookAt(state.space));
    return errors;
}

bool ViewArea::hasSecond() const { return !m_second->parentWidget()->isHidden(); }
void ViewArea::setSecond(bool shown) { m_second->parentWidget()->setVisible(shown); }
bool ViewArea::hasThumbnails() const { return !m_thumbnails->isHidden(); }
void ViewArea::setThumbnails(bool shown) { m_thumbnails->setVisible(shown); }

void ViewArea::resetSizes() {
    m_columns->setSizes({1000, 1000});
    m_buffers->setSizes({1000, 1000});
}

}  // namespace app
