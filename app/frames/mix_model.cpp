#include "app/frames/mix_model.h"

#include "app/look/text.h"

namespace app {

void MixModel::setScene(ScenePtr scene) {
    m_scene = std::move(scene);
    // The strips are those of the scene's lights.
    if (m_mix.size() != pipeline::plainMix(m_scene->lights.size()).size()) reset();
}

void MixModel::begin(ScenePtr scene) {
    m_scene = std::move(scene);
    reset();
}

void MixModel::reset() { set(pipeline::plainMix(m_scene ? m_scene->lights.size() : 0)); }

void MixModel::set(const pipeline::TermMix& mix) {
    if (mix == m_mix) return;
    m_mix = mix;
    emit changed();
}

void MixModel::setShownAlone(const QObject* view, bool shown) {
    const bool before = isShownAlone();
    if (shown && m_views.insert(view).second)
        connect(view, &QObject::destroyed, this, [this, view] {
            // Not at once: the view would still hear of it.
            if (m_views.erase(view) > 0 && m_views.empty())
                QMetaObject::invokeMethod(this, &MixModel::changed, Qt::QueuedConnection);
        });
    if (!shown && m_views.erase(view) > 0) disconnect(view, &QObject::destroyed, this, nullptr);
    if (isShownAlone() != before) emit changed();
}

QString MixModel::sentence() const {
    const QString why = m_scene ? toQString(whyNoMix(*m_scene)) : QString();
    return why.isEmpty() ? tr("Mix of terms: %1").arg(toQString(describe(m_mix))) : why;
}

}  // namespace app
