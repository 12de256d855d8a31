#include "app/bug_game/bug_pictures.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>

#include "app/bug_game/bug_round.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/shown_buffer.h"
#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/surface.h"
#include "pipeline/inspect/compare.h"

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;
using Phase = BugRound::Phase;

BugPictures::BugPictures(BugRound& round, QWidget* parent) : QSplitter(Qt::Horizontal, parent), m_round(round) {
    setChildrenCollapsible(false);
    m_picture = makeCanvas(tr("The wrong picture"), "bugPicture");
    connect(&m_picture->input(), &CanvasInput::picked, this, &BugPictures::look);
    addWidget(surface(m_picture, this));
    addWidget(surface(makeOpened(), this));
    setStretchFactor(0, 3);
    setStretchFactor(1, 2);
    for (BufferCanvas* one : {m_picture, m_opened})
        connect(&one->input(), &CanvasInput::wiped, this, [this](double share) { moveWipe(share - m_share); });
    connect(&round, &BugRound::begun, this, &BugPictures::begin);
    connect(&round, &BugRound::bufferOpened, this, [this] { showBuffer(*m_round.turn().opened); });
    connect(&round, &BugRound::pixelLookedAt, this, &BugPictures::showPixel);
    connect(&round, &BugRound::revealed, this, &BugPictures::showReveal);
    connect(&round, &BugRound::changed, this, &BugPictures::showState);
    followTheme(this, [this] { setHandleWidth(Theme::current().px(8)); });
    showState();
}

BufferCanvas* BugPictures::makeCanvas(const QString& name, const char* object) {
    auto* made = new BufferCanvas(this);
    made->setObjectName(object);
    made->setAccessibleName(name);
    made->setFocusPolicy(Qt::StrongFocus);
    connect(&made->input(), &CanvasInput::nudged, this, &BugPictures::moveCursor);
    return made;
}

QWidget* BugPictures::makeOpened() {
    auto* all = new QWidget(this);
    auto* column = spaced(new QVBoxLayout(all), {0, 4, 0, 0}, 4);
    m_buffers = new QComboBox(all);
    m_buffers->setObjectName("bugBuffers");
    nameComboBox(*m_buffers, tr("Open a buffer: it counts as a look"));
    m_buffers->setToolTip(tr("Opening a buffer is a look. Alt+1 to Alt+6 open the main buffer of a stage."));
    connect(m_buffers, &QComboBox::activated, this, [this](int row) {
        const auto name = pipeline::findBuffer(m_buffers->itemData(row).toString().toStdString());
        if (name) m_round.look(*name);
    });
    m_opened = makeCanvas(tr("The buffer that was opened"), "bugOpened");
    connect(&m_opened->input(), &CanvasInput::picked, this, [this](QPoint at) {
        const auto& opened = m_round.turn().opened;
        if (opened && bufferInfo(opened->id).domain == pipeline::Domain::Pixel) look(at);
    });
    column->addWidget(m_buffers);
    column->addWidget(m_opened, 1);
    return all;
}

void BugPictures::takeKeys() { m_picture->setFocus(); }

void BugPictures::begin() {
    m_cursor.reset();
    m_share = 0.5;
    fillBuffers();
    for (BufferCanvas* canvas : {m_picture, m_opened}) {
        canvas->setContent({});
        canvas->setOther({}, {});
        canvas->setPicked({});
        canvas->setHovered({});
    }
    if (!m_round.game()) return;
    const auto shown = app::showBuffer(*m_round.game()->wrong(), {BufferId::Color}, lessons::ShownChannel::All, {});
    if (shown) m_picture->setContent(shown->content);
    takeKeys();
}

void BugPictures::fillBuffers() {
    m_buffers->clear();
    m_buffers->addItem(tr("no buffer yet"));
    if (!m_round.game()) return;
    const pipeline::Frame& wrong = *m_round.game()->wrong();
    for (const pipeline::StageId stage : pipeline::kStages)
        for (const BufferName& name : pipeline::allBuffers(wrong.scene().lights.size()))
            if (pipeline::bufferInfo(name.id).stage == stage && name.id != BufferId::Color && wrong.buffer(name))
                m_buffers->addItem(QStringLiteral("%1 %2").arg(index(stage) + 1).arg(toQString(name.text())),
                                   toQString(name.text()));
}

void BugPictures::showBuffer(const BufferName& buffer) {
    const auto shown = app::showBuffer(*m_round.game()->wrong(), buffer, lessons::ShownChannel::All, {});
    m_buffers->setCurrentIndex(std::max(0, m_buffers->findData(toQString(buffer.text()))));
    m_opened->setOther({}, {});
    m_opened->setContent(shown ? shown->content : CanvasContent());
    m_opened->setAccessibleName(toQString(buffer.text()));
    if (const auto& pixel = m_round.turn().lookedAt) m_opened->setPicked(QPoint(pixel->x, pixel->y));
}

void BugPictures::showPixel() {
    m_cursor = m_round.turn().lookedAt;
    for (BufferCanvas* canvas : {m_picture, m_opened}) canvas->setPicked(QPoint(m_cursor->x, m_cursor->y));
}

// In the picture, and in the buffer where it shows first.
void BugPictures::showReveal() {
    const lessons::WrongPicture& game = *m_round.game();
    const pipeline::Frame &wrong = *game.wrong(), &right = *game.right();
    BufferName first{game.row().first};
    for (const BufferName& name : pipeline::allBuffers(right.scene().lights.size()))
        if (name.id == game.row().first && stageDifference(right, wrong, name).worst) {
            first = name;
            break;
        }
    showBuffer(first);
    for (const auto& [canvas, name] : {std::pair(m_picture, BufferName{BufferId::Color}), std::pair(m_opened, first)}) {
        const auto bad = app::showBuffer(wrong, name, lessons::ShownChannel::All, {});
        if (!bad) continue;
        const auto good = app::showBuffer(right, name, lessons::ShownChannel::All, bad->look.range);
        if (!good) continue;
        canvas->setContent(good->content);
        if (good->content.size == bad->content.size)
            canvas->setOther(bad->content, {m_share, true, tr("right"), tr("wrong")});
    }
    if (const auto& pixel = m_round.turn().worst)
        for (BufferCanvas* canvas : {m_picture, m_opened}) canvas->setPicked(QPoint(pixel->x, pixel->y));
    takeKeys();
}

void BugPictures::showState() {
    m_buffers->setVisible(m_round.game());
    m_buffers->setEnabled(!m_round.busy() && !m_round.isIn(Phase::Over));
}

void BugPictures::look(QPoint pixel) {
    if (!m_round.isIn(Phase::Over)) m_round.look(glm::ivec2(pixel.x(), pixel.y()));
}

// Without a look, as a finger on the picture.
void BugPictures::moveCursor(QPoint by) {
    if (!m_round.game()) return;
    if (m_round.isIn(Phase::Over)) return moveWipe(0.02 * by.x());
    const pipeline::Settings& settings = m_round.game()->wrong()->scene().settings;
    const glm::ivec2 from = m_cursor.value_or(glm::ivec2(settings.width / 2, settings.height / 2));
    m_cursor = glm::ivec2(std::clamp(from.x + by.x(), 0, settings.width - 1),
                          std::clamp(from.y + by.y(), 0, settings.height - 1));
    m_picture->setHovered(QPoint(m_cursor->x, m_cursor->y));
    emit cursorMoved(QPoint(m_cursor->x, m_cursor->y));
}

void BugPictures::moveWipe(double by) {
    if (!m_round.isIn(Phase::Over)) return;
    m_share = std::clamp(m_share + by, 0.0, 1.0);
    for (BufferCanvas* canvas : {m_picture, m_opened}) canvas->setWipe({m_share, true, tr("right"), tr("wrong")});
}

void BugPictures::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && m_cursor && m_picture->hasFocus()) return m_round.look(*m_cursor);
    QSplitter::keyPressEvent(event);
}

}  // namespace app
