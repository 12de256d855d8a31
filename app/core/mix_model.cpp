#include "app/core/mix_model.h"

#include "app/core/document.h"
#include "app/core/text.h"

namespace app {

MixModel::MixModel(Document& document) : m_document(document) {
    connect(&document, &Document::sceneOpened, this, &MixModel::reset);
    connect(&document, &Document::sceneChanged, this, [this] {
        // The strips are those of the scene's lights.
        if (m_mix.size() != pipeline::plainMix(m_document.scene().lights.size()).size()) reset();
    });
    connect(&document, &Document::frameReady, this, &MixModel::compute);
}

void MixModel::reset() { set(pipeline::plainMix(m_document.hasScene() ? m_document.scene().lights.size() : 0)); }

void MixModel::set(const pipeline::TermMix& mix) {
    if (mix == m_mix) return;
    m_mix = mix;
    emit changed();
    m_document.want(this, isPlain() ? pipeline::BufferSet() : pipeline::mixBuffers());
    compute();
}

QString MixModel::sentence() const {
    return m_why.isEmpty() ? tr("Mix of terms: %1").arg(toQString(describe(m_mix))) : m_why;
}

void MixModel::compute() {
    const pipeline::FramePtr frame = m_document.frame();
    m_why = frame ? toQString(whyNoMix(frame->scene())) : QString();
    if (isPlain() || !frame || !m_why.isEmpty()) {
        m_job.forget();
        const bool had = m_picture.has_value();
        m_picture.reset();
        if (had || !m_why.isEmpty()) emit pictureReady();
        return;
    }
    if (m_mix.size() != pipeline::plainMix(frame->scene().lights.size()).size()) return;  // the frame lags behind
    m_job.ask(
        [frame, mix = m_mix](const BackgroundJob::Control& control) {
            const auto mixed = mixTerms(*frame, mix, control.stop);
            return mixed ? std::optional(*mixed) : std::nullopt;
        },
        [this](const std::optional<pipeline::MixedPicture>& mixed) {
            if (!mixed) return;  // its buffers are on their way: another frame follows
            m_picture = mixed;
            emit pictureReady();
        },
        BackgroundJob::Running::Finish);
}

}  // namespace app
