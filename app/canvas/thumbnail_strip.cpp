#include "app/canvas/thumbnail_strip.h"

#include <QHelpEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>

#include "app/canvas/buffer_painter.h"
#include "app/canvas/thumbnail.h"
#include "app/frames/derived_buffers.h"
#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/look/theme.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/plan/needs.h"

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;

ThumbnailStrip::ThumbnailStrip(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleRole(*this, QAccessible::List);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Thumbnails of the buffers"));
    // While a slider moves the views come first; frames follow each other more quickly than this.
    m_later.setSingleShot(true);
    m_later.setInterval(160);
    connect(&m_later, &QTimer::timeout, this, &ThumbnailStrip::refresh);
    connect(&document.frames(), &FrameFeed::frameReady, this, [this] { m_later.start(); });
    connect(&document, &Document::stageChanged, this, &ThumbnailStrip::rebuild);
    connect(&document, &Document::sceneOpened, this, &ThumbnailStrip::rebuild);
    connect(&document, &Document::hiddenChanged, this, &ThumbnailStrip::rebuild);
    connect(&document.derived(), &DerivedBuffers::changed, this, &ThumbnailStrip::takeDerived);
    connect(&document.pointing(), &Pointing::symbolChanged, this, qOverload<>(&ThumbnailStrip::update));
    followTheme(this, [this] {
        updateGeometry();
        refresh();
    });
    rebuild();
}

QSize ThumbnailStrip::sizeHint() const { return {Theme::current().px(860), Theme::current().px(87)}; }

int ThumbnailStrip::itemWidth() const {
    const int room = width() - 2 * Theme::current().px(6);
    return std::max(room / 9, Theme::current().px(84));
}

QRect ThumbnailStrip::itemRect(int item) const {
    const int padding = Theme::current().px(6);
    return {padding + item * itemWidth() - m_offset, padding, itemWidth() - padding, height() - 2 * padding};
}

int ThumbnailStrip::itemAt(QPoint at) const {
    for (int i = 0; i < int(m_items.size()); ++i)
        if (itemRect(i).contains(at)) return i;
    return -1;
}

void ThumbnailStrip::setCurrent(const BufferName& name) {
    m_current = name;
    for (int i = 0; i < int(m_items.size()); ++i)
        if (m_items[std::size_t(i)].name == name) {
            m_marked = i;
            reveal(i);
        }
    describe();
    update();
}

void ThumbnailStrip::scrollTo(int offset) {
    const int all = int(m_items.size()) * itemWidth() + Theme::current().px(6);
    m_offset = std::clamp(offset, 0, std::max(0, all - width()));
    want();
    m_later.start();
    update();
}

void ThumbnailStrip::reveal(int item) {
    const QRect rect = itemRect(item);
    if (rect.left() < 0) scrollTo(m_offset + rect.left() - Theme::current().px(6));
    if (rect.right() > width()) scrollTo(m_offset + rect.right() - width() + Theme::current().px(6));
}

void ThumbnailStrip::paintEvent(QPaintEvent*) {
    const ThemeColors& c = Theme::current().colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(c.line);
    painter.setBrush(c.surface);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.setClipRect(rect().adjusted(1, 1, -1, -1));
    for (int i = 0; i < int(m_items.size()); ++i)
        paintItem(painter, m_items[std::size_t(i)], itemRect(i), m_items[std::size_t(i)].name == m_current,
                  hasFocus() && i == m_marked);
}

void ThumbnailStrip::paintItem(QPainter& painter, const Item& item, const QRect& rect, bool isCurrent,
                               bool isMarked) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const QRectF box = QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5);
    if (isCurrent) {
        painter.setPen(c.accent);
        painter.setBrush(c.tint);
        painter.drawRoundedRect(box, 4, 4);
    }
    QRect picture = rect.adjusted(3, 3, -3, -theme.px(21));
    if (!item.picture.isNull()) {
        // One that was drawn for a larger strip stays inside its place until the next one comes.
        const QSize own = item.picture.deviceIndependentSize().toSize();
        const bool fits = own.width() <= picture.width() && own.height() <= picture.height();
        QRect target(QPoint(), fits ? own : own.scaled(picture.size(), Qt::KeepAspectRatio));
        target.moveCenter(picture.center());
        painter.fillRect(picture, c.view);
        paintChecker(painter, target);
        painter.setRenderHint(QPainter::SmoothPixmapTransform, !fits);
        painter.drawImage(target, item.picture);
    } else {
        QPainterPath clip;
        clip.addRect(picture);
        painter.save();
        painter.setClipPath(clip, Qt::IntersectClip);
        painter.setPen(c.hatch);
        for (int x = picture.left() - picture.height(); x < picture.right(); x += 8)
            painter.drawLine(x, picture.bottom(), x + picture.height(), picture.top());
        painter.restore();
        painter.setPen(QPen(c.line, 1, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(picture);
        if (m_document.hidden().hides(item.name)) {
            painter.setFont(theme.text(11));
            painter.setPen(c.text2);
            painter.drawText(picture, Qt::AlignCenter | Qt::TextWordWrap, tr("after your answer"));
        }
    }
    painter.setFont(theme.mono(12));
    painter.setPen(isCurrent ? c.text : c.text2);
    const QRect label(rect.left() + 2, rect.bottom() - theme.px(20), rect.width() - 4, theme.px(19));
    painter.drawText(label, Qt::AlignCenter,
                     painter.fontMetrics().elidedText(toQString(item.name.text()), Qt::ElideMiddle, label.width()));
    const bool isPointed = toQString(item.name.text()) == m_document.pointing().symbol();
    if (isMarked || isPointed) {
        painter.setPen(QPen(isPointed ? c.accent : c.focus, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(box.adjusted(1, 1, -1, -1), 4, 4);
    }
}

void ThumbnailStrip::resizeEvent(QResizeEvent*) {
    scrollTo(m_offset);
    reveal(m_marked);  // which was scrolled to for another width
}

void ThumbnailStrip::showEvent(QShowEvent*) { scrollTo(m_offset); }

void ThumbnailStrip::hideEvent(QHideEvent*) { want(); }

void ThumbnailStrip::wheelEvent(QWheelEvent* event) {
    const QPoint turn = event->angleDelta();
    scrollTo(m_offset - (turn.x() != 0 ? turn.x() : turn.y()) * itemWidth() / 120);
    event->accept();
}

void ThumbnailStrip::mouseReleaseEvent(QMouseEvent* event) {
    const int item = event->button() == Qt::LeftButton ? itemAt(event->position().toPoint()) : -1;
    if (item < 0) return;
    setCurrent(m_items[std::size_t(item)].name);
    emit chosen(m_current);
}

void ThumbnailStrip::keyPressEvent(QKeyEvent* event) {
    const int step = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (m_items.empty()) return;
    if (step != 0) {
        m_marked = std::clamp(m_marked + step, 0, int(m_items.size()) - 1);
        reveal(m_marked);
        describe();
        update();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        setCurrent(m_items[std::size_t(m_marked)].name);
        emit chosen(m_current);
    } else {
        QWidget::keyPressEvent(event);
    }
}

bool ThumbnailStrip::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const int i = itemAt(help->pos());
    if (i < 0) {
        QToolTip::hideText();
        return true;
    }
    const Item& item = m_items[std::size_t(i)];
    const QString meaning = toQString(bufferInfo(item.name.id).meaning);
    QToolTip::showText(help->globalPos(),
                       item.why.isEmpty()                     ? meaning
                       : m_document.hidden().hides(item.name) ? item.why
                                                              : tr("Left out: %1\n%2").arg(item.why, meaning),
                       this);
    return true;
}

namespace {

struct Wanted {
    BufferName name;
    std::optional<pipeline::AnyBuffer> buffer;
    QSize size;
};

}  // namespace

std::vector<BufferName> thumbnailBuffers(pipeline::StageId stage, const pipeline::Scene& scene) {
    static const pipeline::BufferSet landmarks =
        pipeline::setOf({BufferId::VerticesScreen, BufferId::PolygonsVerdict, BufferId::ZView, BufferId::PolygonId,
                         BufferId::Normal, BufferId::ShadowBuffer, BufferId::Color});
    std::vector<BufferName> names;
    for (const BufferName& name : pipeline::allBuffers(scene.lights.size())) {
        const pipeline::BufferInfo& info = bufferInfo(name.id);
        const bool isOthers = info.stage != stage && !(landmarks[index(name.id)] && name.light <= 0);
        // H is of another model, and a buffer of zeros teaches nothing.
        const bool isNever =
            name.id == BufferId::Emission || name.id == BufferId::NDotH || name.id == BufferId::HalfwayVector;
        if (!isOthers && !isNever) names.push_back(name);
    }
    return names;
}

// Those that somebody looks at, and that are there.
std::vector<BufferName> ThumbnailStrip::derivedOnShow() const {
    std::vector<BufferName> names;
    if (!m_document.hasScene()) return names;
    for (const BufferName& name : pipeline::allDerived(m_document.scene().lights.size()))
        if (m_document.derived().made(name)) names.push_back(name);
    return names;
}

void ThumbnailStrip::takeDerived() {
    if (!m_document.hasScene()) return;
    if (derivedOnShow() == m_derived) return m_later.start();
    const int offset = m_offset;
    rebuild();
    scrollTo(offset);
}

void ThumbnailStrip::rebuild() {
    m_items.clear();
    if (m_document.hasScene())
        for (const BufferName& name : thumbnailBuffers(m_document.stage(), m_document.scene()))
            m_items.push_back({name, {}, {}, false});
    m_derived = derivedOnShow();
    for (const BufferName& name : m_derived) m_items.push_back({name, {}, {}, false});
    m_offset = 0;
    setCurrent(m_current);
    want();
    refresh();
}

// Left-out buffers are not computed for a thumbnail.
void ThumbnailStrip::want() {
    pipeline::BufferSet wanted;
    if (m_document.hasScene() && isVisible())
        for (int i = 0; i < int(m_items.size()); ++i) {
            const BufferId id = m_items[std::size_t(i)].name.id;
            const bool isOwn = !pipeline::isDerived(id);  // a derived buffer is computed once a view shows it
            if (isOwn && itemRect(i).intersects(rect()) && whyUseless(m_document.scene(), id).empty())
                wanted.set(index(id));
        }
    m_document.frames().want(this, wanted, FrameFeed::When::AtRest);
}

// Drawn away from the window: a million polygons take their time.
void ThumbnailStrip::refresh() {
    const pipeline::FramePtr& frame = m_document.frames().shown();
    if (!frame || !isVisible()) return update();
    std::vector<Wanted> wanted;
    for (int i = 0; i < int(m_items.size()); ++i) {
        Item& item = m_items[std::size_t(i)];
        const bool isDerived = pipeline::isDerived(item.name.id);
        item.why = isDerived ? QString() : toQString(whyUseless(frame->scene(), item.name.id));
        const QRect rect = itemRect(i);
        item.isInSight = rect.intersects(this->rect());
        if (!item.isInSight) continue;
        if (m_document.hidden().hides(item.name)) {
            item.picture = {};
            item.why = tr("after your answer");
            continue;
        }
        if (frame->until() < bufferInfo(item.name.id).stage) {  // while stepping inside an earlier stage
            item.picture = {};
            item.why = toQString(frame->whyAbsent(item.name));
            continue;
        }
        const lessons::DerivedBuffer* made = isDerived ? m_document.derived().made(item.name) : nullptr;
        wanted.push_back({item.name,
                          made        ? std::optional(made->buffer)
                          : isDerived ? std::nullopt
                                      : frame->buffer(item.name),
                          QSize(rect.width() - 6, rect.height() - Theme::current().px(24))});
    }
    m_drawing.ask(
        [frame, wanted, ratio = devicePixelRatioF()](const BackgroundJob::Control& control) {
            std::vector<Picture> pictures;
            const auto polygons = frame->buffer({BufferId::PolygonId});
            for (const auto& [name, buffer, size] : wanted)
                if (!control.stop.stop_requested())
                    pictures.push_back({name, buffer ? thumbnail(*frame, *buffer, size, polygons, ratio) : QImage()});
            return pictures;
        },
        [this](const std::vector<Picture>& pictures) { take(pictures); });
    update();
}

void ThumbnailStrip::take(const std::vector<Picture>& pictures) {
    for (const Picture& drawn : pictures)
        for (Item& item : m_items) {
            if (item.name != drawn.name || m_document.hidden().hides(item.name)) continue;
            // One that is on its way leaves the picture before it.
            if (!drawn.image.isNull() || !item.why.isEmpty()) item.picture = drawn.image;
            if (!item.picture.isNull()) item.why.clear();
        }
    describe();
    update();
}

// The one that the arrows have come to, then what is left out of those in sight.
void ThumbnailStrip::describe() {
    QStringList texts;
    if (m_marked >= 0 && m_marked < int(m_items.size())) {
        const Item& item = m_items[std::size_t(m_marked)];
        const QString name = toQString(item.name.text());
        texts << (item.name == m_current ? tr("%1, on show.") : tr("%1, Enter shows it.")).arg(name);
    }
    for (const Item& item : m_items)
        if (item.isInSight && !item.why.isEmpty()) texts << toQString(item.name.text()) + ": " + item.why;
    setAccessibleDescription(texts.join(' '));
}

}  // namespace app
