#pragma once
#include <QObject>
#include <QString>
#include <set>

#include "app/frames/scene_step.h"
#include "pipeline/inspect/term_mix.h"

namespace app {

// How the terms of the illumination are mixed. Another scene begins with every term as it is. The picture that they
// make is the derived buffer `mix`.
class MixModel : public QObject {
    Q_OBJECT
public:
    void setScene(ScenePtr scene);  // a new state of the same scene
    void begin(ScenePtr scene);     // another scene
    const pipeline::TermMix& mix() const { return m_mix; }
    bool isPlain() const { return pipeline::isPlain(m_mix); }
    void set(const pipeline::TermMix& mix);
    void reset();  // every term as it is
    // While a view shows the buffer `mix`, the frame buffer stands beside it as it is.
    void setShownAlone(const QObject* view, bool shown);
    bool isShownAlone() const { return !m_views.empty(); }
    QString sentence() const;  // "Mix of terms: specular 0 alone"; or why there is no picture

signals:
    void changed();

private:
    ScenePtr m_scene;
    pipeline::TermMix m_mix;
    std::set<const QObject*> m_views;  // of the buffer `mix`
};

}  // namespace app
