#include "app/desktop/view_area.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QDataStream>
#include <QFrame>
#include <QIODevice>
#include <QVBoxLayout>

#include "app/core/stage_buffer.h"
#include "app/desktop/even_splitter.h"
#include "app/panels/buffer_view.h"
#include "app/panels/follow_theme.h"
#include "app/panels/thumbnail_strip.h"
#include "app/view3d/view3d_panel.h"

namespace app {
namespace {

// What stands where in a named arrangement.
struct Arrangement {
    const char* name;
    bool first, second, space;
    Qt::Orientation buffers;
};
constexpr std::array<Arrangement, 5> kArrangements{{{"one", true, false, true, Qt::Vertical},
                                                    {"two", true, true, true, Qt::Vertical},
                                                    {"compare", true, true, false, Qt::Horizontal},
                                                    {"space", false, false, true, Qt::Vertical},
                                                    {"buffer", true, false, false, Qt::Vertical}}};

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
      m_columns(new EvenSplitter(Qt::Horizontal, this)),
      m_buffers(new EvenSplitter(Qt::Vertical)),
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
    for (EvenSplitter* splitter : {m_columns, m_buffers}) splitter->setChildrenCollapsible(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_columns, 1);
    column->addWidget(m_thumbnails);
    followTheme(this, [this, column] {
        column->setSpacing(Theme::current().px(8));
        for (EvenSplitter* splitter : {m_columns, m_buffers}) splitter->setHandleWidth(Theme::current().px(8));
    });

    connect(m_thumbnails, &ThumbnailStrip::chosen, this, &ViewArea::showBuffer);
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

void ViewArea::showBuffer(const pipeline::BufferName& buffer) {
    if (m_first->parentWidget()->isHidden()) setArrangement("one");
    m_first->setBuffer(buffer);
}

void ViewArea::showBuffers(const QStringList& names) {
    const std::array views{m_first, m_second};
    for (qsizetype i = 0; i < std::min(names.size(), qsizetype(views.size())); ++i)
        if (const auto name = pipeline::findAnyBuffer(names[i].toStdString())) views[std::size_t(i)]->setBuffer(*name);
    if (names.size() > 1 && height() > Theme::current().px(560)) setSecond(true);
}

void ViewArea::fill(WindowState& state) const {
    state.arrangement = arrangement();
    state.views = {m_first->state()};
    if (hasSecond()) state.views.push_back(m_second->state());
    state.space = m_view3d->state();
}

pipeline::Errors ViewArea::lookAt(const WindowState& state) {
    pipeline::Errors errors;
    const auto add = [&](const pipeline::Errors& more) { errors.insert(errors.end(), more.begin(), more.end()); };
    if (!setArrangement(state.arrangement)) {
        add({{{}, "there is no arrangement \"" + state.arrangement + '"', "one, two, compare, space or buffer"}});
        setArrangement("one");
    }
    if (!state.views.empty()) add(m_first->lookAt(state.views[0]));
    if (state.views.size() > 1) add(m_second->lookAt(state.views[1]));
    add(m_view3d->lookAt(state.space));
    return errors;
}

std::string ViewArea::arrangement() const {
    const auto isShown = [](const QWidget* view) { return !view->parentWidget()->isHidden(); };
    for (const Arrangement& a : kArrangements)
        if (a.first == isShown(m_first) && a.second == isShown(m_second) && a.space == isShown(m_view3d)) return a.name;
    return kArrangements[0].name;
}

bool ViewArea::setArrangement(const std::string& name) {
    const auto found = std::ranges::find(kArrangements, name, [](const Arrangement& a) { return std::string(a.name); });
    if (found == kArrangements.end()) return false;
    m_buffers->setOrientation(found->buffers);
    m_first->parentWidget()->setVisible(found->first);
    m_second->parentWidget()->setVisible(found->second);
    m_buffers->setVisible(found->first || found->second);
    m_view3d->parentWidget()->setVisible(found->space);
    return true;
}

bool ViewArea::hasSecond() const { return !m_second->parentWidget()->isHidden(); }
void ViewArea::setSecond(bool shown) {
    if (shown != hasSecond()) setArrangement(shown ? "two" : "one");
}

QByteArray ViewArea::sizes() const {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << m_columns->sizes() << m_buffers->sizes();
    return bytes;
}

void ViewArea::restoreSizes(const QByteArray& sizes) {
    QList<int> columns, buffers;
    QDataStream stream(sizes);
    stream >> columns >> buffers;
    if (stream.status() != QDataStream::Ok) return;
    m_columns->setSizes(columns);
    m_buffers->setSizes(buffers);
}

bool ViewArea::hasThumbnails() const { return !m_thumbnails->isHidden(); }
void ViewArea::setThumbnails(bool shown) { m_thumbnails->setVisible(shown); }

void ViewArea::resetSizes() {
    m_columns->makeEven();
    m_buffers->makeEven();
}

}  // namespace app
