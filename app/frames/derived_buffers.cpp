#include "app/frames/derived_buffers.h"

#include "app/frames/frame_feed.h"
#include "app/frames/mix_model.h"
#include "app/look/text.h"

namespace app {

using pipeline::BufferName;

DerivedBuffers::DerivedBuffers(FrameFeed& frames, const MixModel& mixer) : m_frames(frames), m_mixer(mixer) {
    connect(&frames, &FrameFeed::frameReady, this, &DerivedBuffers::ask);
    connect(&mixer, &MixModel::changed, this, &DerivedBuffers::ask);
}

void DerivedBuffers::setScene(ScenePtr scene) {
    m_scene = std::move(scene);
    settle();
}

void DerivedBuffers::begin(ScenePtr scene) {
    m_scene = std::move(scene);
    for (const auto& [name, job] : m_jobs) job->forget();
    setText({});
    settle();
}

void DerivedBuffers::setText(const QString& text) {
    if (text == m_text) return;
    m_text = text;
    emit textChanged();
    settle();
}

lessons::DerivedRecipe DerivedBuffers::recipe() const { return {m_text.trimmed().toStdString(), m_mixer.mix()}; }

void DerivedBuffers::want(const QObject* who, std::vector<BufferName> names) {
    const auto known = m_wanted.find(who);
    if (known == m_wanted.end() ? names.empty() : known->second == names) return;
    if (known == m_wanted.end())
        connect(who, &QObject::destroyed, this, [this, who] {
            m_wanted.erase(who);
            // Not at once: what hears of it may be going too.
            QMetaObject::invokeMethod(this, &DerivedBuffers::settle, Qt::QueuedConnection);
        });
    m_wanted[who] = std::move(names);
    settle();
}

void DerivedBuffers::settle() {
    std::map<std::string, std::unique_ptr<DerivedJob>> kept;
    pipeline::BufferSet needed;
    for (const auto& [who, names] : m_wanted) {
        for (const BufferName& name : names) {
            std::unique_ptr<DerivedJob>& job = kept[name.text()];
            if (job) continue;
            if (auto known = m_jobs.find(name.text()); known != m_jobs.end()) job = std::move(known->second);
            if (!job) {
                job = std::make_unique<DerivedJob>();
                connect(job.get(), &DerivedJob::changed, this, [this, name] { emit changed(name); });
            }
            if (!m_scene) continue;
            if (const auto buffers = buffersFor(name, recipe(), *m_scene)) needed |= *buffers;
        }
    }
    m_jobs.swap(kept);
    m_frames.want(this, needed);
    ask();
    for (const auto& [text, job] : kept)
        if (job) emit changed(*pipeline::findDerived(text));  // it went
}

void DerivedBuffers::ask() {
    const pipeline::FramePtr& frame = m_frames.shown();
    if (!frame) return;
    for (const auto& [text, job] : m_jobs) job->ask(frame, *pipeline::findDerived(text), recipe());
}

DerivedJob* DerivedBuffers::find(const BufferName& name) const {
    const auto job = m_jobs.find(name.text());
    return job == m_jobs.end() ? nullptr : job->second.get();
}

const lessons::DerivedBuffer* DerivedBuffers::made(const BufferName& name) const {
    const DerivedJob* job = find(name);
    const pipeline::FramePtr& frame = m_frames.shown();
    if (!job || !job->made() || !frame) return nullptr;
    const pipeline::Settings& settings = frame->scene().settings;
    const pipeline::AnyBuffer& buffer = job->made()->buffer;
    const bool fits = buffer.columns() == std::size_t(settings.width) && buffer.rows() == std::size_t(settings.height);
    return fits ? &*job->made() : nullptr;
}

QString DerivedBuffers::sentenceOf(const pipeline::Error& error) {
    const QString sentence = tr("Column %1: %2").arg(error.where.column).arg(toQString(error.found));
    return error.expected.empty() ? sentence : sentence + tr(", expected %1").arg(toQString(error.expected));
}

QString DerivedBuffers::whyNot(const BufferName& name) const {
    const DerivedJob* job = find(name);
    if (!job || made(name)) return {};
    if (!job->errors().empty() && job->errors().front().where.column > 0) return sentenceOf(job->errors().front());
    if (!job->why().isEmpty()) return job->why();
    if (name.id == pipeline::BufferId::ShadowVerdict && job->busy())
        return tr("Rays to light %1: %2 %").arg(name.light).arg(int(100 * job->share()));
    return tr("The buffer is being computed.");
}

}  // namespace app
