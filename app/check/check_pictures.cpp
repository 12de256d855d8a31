#include "app/check/check_pictures.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/look/text.h"
#include "app/start/scene_gallery.h"
#include "app/study/study_pictures.h"
#include "app/widgets/follow_theme.h"

namespace app {

using pipeline::BufferId;
using pipeline::FramePtr;
using pipeline::Scene;

CheckPictures::CheckPictures(QWidget* parent) : QWidget(parent) {
    m_difference = styled(new QLabel(this), {.name = "checkDifference", .size = 13, .wraps = true});
    auto* row = spaced(new QHBoxLayout, {}, 12);
    for (PictureFrame*& frame : m_frames) {
        frame = new PictureFrame(this);
        row->addWidget(frame, 1);
    }
    auto* column = spaced(new QVBoxLayout(this), {12, 0, 12, 8}, 4);
    column->addLayout(row, 1);
    column->addWidget(m_difference);
    for (const Form form : {Naive, Ours}) {
        // On the worker's thread; what is delivered after this widget is gone is dropped by Qt.
        const auto deliver = [this, form](FramePtr frame, long ticket) {
            QMetaObject::invokeMethod(
                this, [this, form, frame = std::move(frame), ticket] { take(form, frame, ticket); },
                Qt::QueuedConnection);
        };
        m_workers[form] = std::make_unique<FrameWorker>(deliver, nullptr);
    }
}

CheckPictures::~CheckPictures() = default;

void CheckPictures::setScene(const pipeline::check::Case& which, std::shared_ptr<const Scene> scene) {
    m_tickets = {};
    m_shown = {};
    m_difference->clear();
    const auto naive = scene ? withNaiveForm(which, *scene) : std::nullopt;
    setVisible(scene != nullptr);
    // One picture alone compares nothing, and the plot has use for its room.
    for (PictureFrame* frame : m_frames) frame->setVisible(naive.has_value());
    if (!scene) return;
    if (!naive)
        return m_difference->setText(tr("No setting of the stages is the naive form: its numbers stand above."));
    const auto ask = [this](Form form, std::shared_ptr<const Scene> wanted) {
        pipeline::FrameRequest request;
        request.wanted = pipeline::setOf({BufferId::Color});
        request.threads = 1;  // both forms at the same time
        m_tickets[form] = m_workers[form]->request(std::move(wanted), request, FrameWorker::Running::Finish);
    };
    m_captions = {tr("Naive: %1").arg(toQString(which.naiveWith)), tr("Ours")};
    ask(Naive, std::make_shared<const Scene>(*naive));
    ask(Ours, std::move(scene));
}

bool CheckPictures::complete() const {
    for (const Form form : {Naive, Ours})
        if (m_tickets[form] != 0 && !m_shown[form]) return false;
    return true;
}

void CheckPictures::take(Form form, FramePtr frame, long ticket) {
    if (ticket != m_tickets[form]) return;
    m_shown[form] = std::move(frame);
    m_frames[form]->show(colorImage(*m_shown[form]), m_captions[form], {});
    compare();
}

void CheckPictures::compare() {
    if (!m_shown[Naive] || !m_shown[Ours]) return;
    const auto ours = m_shown[Ours]->buffer({BufferId::Color}), naive = m_shown[Naive]->buffer({BufferId::Color});
    std::size_t differ = 0;
    double largest = 0;
    for (std::size_t pixel = 0; pixel < ours->count() / 3; ++pixel) {
        double most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(ours->flat(3 * pixel + c) - naive->flat(3 * pixel + c)));
        differ += most > 0;
        largest = std::max(largest, most);
    }
    m_difference->setText(
        differ == 0
            ? tr("No pixel differs.")
            : tr("%1 of %2 pixels differ, the most by %3 of 255.").arg(differ).arg(ours->count() / 3).arg(largest));
}

}  // namespace app
