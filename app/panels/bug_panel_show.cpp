// The pictures of a BugPanel, and its words.
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <algorithm>
#include <cmath>

#include "app/core/text.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/bug_box.h"
#include "app/panels/bug_panel.h"
#include "app/panels/follow_theme.h"
#include "app/panels/math_view.h"
#include "app/panels/shown_buffer.h"
#include "pipeline/inspect/compare.h"
#include "pipeline/inspect/pixel_report.h"

namespace app {

using lessons::WrongPicture;
using Phase = WrongPicture::Phase;
using pipeline::BufferId;
using pipeline::BufferName;

namespace {

// The channel of a pixel's colour that differs most.
int worstChannel(const pipeline::Frame& a, const pipeline::Frame& b, glm::ivec2 pixel) {
    const auto left = *a.buffer({BufferId::Color}), right = *b.buffer({BufferId::Color});
    const auto difference = [&](int c) {
        const auto x = std::size_t(pixel.x), y = std::size_t(pixel.y);
        return std::abs(left.value(x, y, c) - right.value(x, y, c));
    };
    int worst = 0;
    for (int c = 1; c < 3; ++c)
        if (difference(c) > difference(worst)) worst = c;
    return worst;
}

std::vector<pipeline::EquationLine> equationAt(const pipeline::Frame& frame, glm::ivec2 pixel, int channel) {
    const pipeline::PixelReport report = inspectPixel(frame, pixel);
    if (!report.covered || report.outline) return {};
    return equation(frame.scene(), report, channel);
}

}  // namespace

QWidget* BugPanel::makeBoxes() {
    auto* all = new QWidget(this);
    all->setAccessibleName(tr("What may be wrong"));
    auto* row = new QHBoxLayout(all);
    row->setContentsMargins(0, 0, 0, 0);
    for (int box = 0; box < lessons::kBoxes; ++box) {
        m_boxes[std::size_t(box)] = new BugBox(box, all);
        row->addWidget(m_boxes[std::size_t(box)]);
        connect(m_boxes[std::size_t(box)], &QAbstractButton::clicked, this, [this, box] { mark(box); });
    }
    followTheme(all, [row] { row->setSpacing(Theme::current().px(8)); });
    return all;
}

void BugPanel::fillBuffers() {
    m_buffers->clear();
    m_buffers->addItem(tr("no buffer yet"));
    if (!m_game) return;
    for (const pipeline::StageId stage : pipeline::kStages)
        for (const BufferName& name : pipeline::allBuffers(m_game->wrong()->scene().lights.size()))
            if (pipeline::bufferInfo(name.id).stage == stage && name.id != BufferId::Color &&
                m_game->wrong()->buffer(name))
                m_buffers->addItem(QStringLiteral("%1 %2").arg(index(stage) + 1).arg(toQString(name.text())),
                                   toQString(name.text()));
}

void BugPanel::showPicture() {
    for (BufferCanvas* canvas : {m_picture, m_opened}) {
        canvas->setContent({});
        canvas->setOther({}, {});
        canvas->setPicked({});
        canvas->setHovered({});
    }
    if (!m_game) return;
    const auto shown = app::showBuffer(*m_game->wrong(), {BufferId::Color}, lessons::ShownChannel::All, {});
    if (shown) m_picture->setContent(shown->content);
}

void BugPanel::showBuffer(const BufferName& buffer) {
    const auto shown = app::showBuffer(*m_game->wrong(), buffer, lessons::ShownChannel::All, {});
    m_buffers->setCurrentIndex(std::max(0, m_buffers->findData(toQString(buffer.text()))));
    m_opened->setOther({}, {});
    m_opened->setContent(shown ? shown->content : CanvasContent());
    m_opened->setAccessibleName(toQString(buffer.text()));
    if (m_lookedAt) m_opened->setPicked(QPoint(m_lookedAt->x, m_lookedAt->y));
}

// Right beside wrong, in the picture and in the buffer where it shows first.
void BugPanel::showReveal() {
    const pipeline::Frame &wrong = *m_game->wrong(), &right = *m_game->right();
    BufferName first{m_game->row().first};
    for (const BufferName& name : pipeline::allBuffers(right.scene().lights.size()))
        if (name.id == m_game->row().first && stageDifference(right, *m_game->wrong(), name).worst) {
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
    const auto pixel = lessons::worstPixel(right, wrong);
    if (pixel) {
        for (BufferCanvas* canvas : {m_picture, m_opened}) canvas->setPicked(QPoint(pixel->x, pixel->y));
        const int channel = worstChannel(right, wrong, *pixel);
        m_wrongEquation->setLines(equationAt(wrong, *pixel, channel));
        m_rightEquation->setLines(equationAt(right, *pixel, channel));
    }
    const QString place = pixel ? tr("pixel %1, %2").arg(pixel->x).arg(pixel->y) : QString();
    m_wrongName->setText(m_wrongEquation->lines().empty() ? tr("Wrong at %1: nothing is drawn.").arg(place)
                                                          : tr("Wrong at %1").arg(place));
    m_rightName->setText(m_rightEquation->lines().empty() ? tr("Right: nothing is drawn.") : tr("Right"));
    m_wrongEquation->setVisible(!m_wrongEquation->lines().empty());
    m_rightEquation->setVisible(!m_rightEquation->lines().empty());
}

void BugPanel::moveWipe(double by) {
    if (!m_game || m_game->phase() != Phase::Over) return;
    m_share = std::clamp(m_share + by, 0.0, 1.0);
    for (BufferCanvas* canvas : {m_picture, m_opened}) canvas->setWipe({m_share, true, tr("right"), tr("wrong")});
}

void BugPanel::showState() {
    const bool ready = m_game != nullptr;
    for (QWidget* part : std::initializer_list<QWidget*>{m_stagePart, m_causePart, m_overPart, m_hint, m_count, m_looks,
                                                         m_pixel, m_text, m_buffers})
        part->setVisible(ready);
    const bool idle = !m_job.busy();
    if (!ready) {
        m_heading->setText(m_error.isEmpty() ? tr("A picture is being computed") : tr("There is no picture"));
        m_what->setText(m_error);
        m_foot->setText(tr("Seed %1, level B").arg(m_seed));
        for (BugBox* box : m_boxes) box->show(BugBox::State::Open, 0, false), box->setEnabled(false);
        return;
    }
    const Phase phase = m_game->phase();
    const pipeline::DefectRow& row = m_game->row();
    const int blamed = lessons::boxOf(row);
    // A look at a pixel is one at what shading has left.
    std::array<int, lessons::kBoxes> looks{};
    for (const std::string& look : m_game->looks()) {
        const auto name = pipeline::findBuffer(look);
        ++looks[name ? 1 + index(pipeline::bufferInfo(name->id).stage) : std::size_t(lessons::kBoxes - 1)];
    }
    for (int box = 0; box < lessons::kBoxes; ++box) {
        const bool isWrong = phase != Phase::Stage && box == blamed;
        const bool isCleared = m_game->isCleared(box) || (phase == Phase::Over && box < blamed);
        m_boxes[std::size_t(box)]->show(isWrong     ? BugBox::State::Wrong
                                        : isCleared ? BugBox::State::Cleared
                                                    : BugBox::State::Open,
                                        looks[std::size_t(box)], box == m_marked);
        m_boxes[std::size_t(box)]->setEnabled(idle && phase == Phase::Stage && !m_game->isCleared(box));
    }
    m_heading->setText(phase == Phase::Stage   ? tr("Something is wrong")
                       : phase == Phase::Cause ? tr("What is the cause?")
                                               : toQString(row.name));
    m_what->setText(
        phase == Phase::Stage
            ? tr("This is %1. Which stage is the first that leaves something wrong?").arg(toQString(row.scene))
        : phase == Phase::Cause ? m_verdict
                                : toQString(row.symptom));
    m_stagePart->setVisible(phase == Phase::Stage);
    m_causePart->setVisible(phase == Phase::Cause);
    m_overPart->setVisible(phase == Phase::Over);
    m_hint->setVisible(phase != Phase::Over);
    m_hint->setEnabled(idle && m_game->hints() < 3);
    m_hint->setToolTip(tr("Costs 10 points"));
    m_pixel->setVisible(phase != Phase::Over);
    m_buffers->setEnabled(idle && phase != Phase::Over);
    m_count->setText(tr("Looks: %1 of %2 free").arg(m_game->looks().size()).arg(m_game->riddle().par));
    m_looks->clear();
    for (std::size_t i = 0; i < m_game->looks().size(); ++i)
        m_looks->addItem(QStringLiteral("%1  %2").arg(i + 1).arg(toQString(m_game->looks()[i])));
    m_looks->scrollToBottom();
    m_stageWords->setText(
        m_verdict.isEmpty() ? tr("Click a box, or press 0 to 6. The right picture is shown at the end.") : m_verdict);
    m_accuse->setEnabled(idle && m_marked >= 0);
    m_accuse->setToolTip(m_marked >= 0 ? QString() : tr("Mark a box first."));
    for (std::size_t i = 0; i < m_causes.size(); ++i) {
        const pipeline::DefectRow& cause = defectInfo(m_game->riddle().causes[i]);
        const QSignalBlocker quiet(m_causes[i]);
        m_causes[i]->setText(QStringLiteral("%1  %2").arg(i + 1).arg(toQString(cause.name)));
        m_causes[i]->setToolTip(toQString(cause.symptom));
        m_causes[i]->setAutoExclusive(false);
        m_causes[i]->setChecked(int(i) == m_cause);
        m_causes[i]->setAutoExclusive(true);
        m_causes[i]->setEnabled(idle && !m_game->isExcluded(i));
    }
    m_causeWords->setText(m_cause < 0 ? tr("Choose with ↑ and ↓, or press 1 to 5.")
                                      : toQString(defectInfo(m_game->riddle().causes[std::size_t(m_cause)]).symptom));
    m_nameCause->setEnabled(idle && m_cause >= 0);
    m_fix->setText(tr("Wrong: %1\nRight: %2").arg(toQString(row.wrong), toQString(row.fix)));
    m_lesson->setText(tr("Lesson: %1").arg(toQString(row.heading)));
    m_lesson->setVisible(!row.lesson.empty());
    QString foot = tr("%1 points; picture %2, seed %3, level B").arg(m_game->points()).arg(m_number + 1).arg(m_seed);
    if (m_solved > 0) foot += tr("\n%1 points in %2 pictures so far").arg(m_total).arg(m_solved);
    m_foot->setText(foot);
}

}  // namespace app
