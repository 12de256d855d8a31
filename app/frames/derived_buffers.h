#pragma once
#include <map>
#include <vector>

#include "app/frames/derived_job.h"
#include "app/frames/scene_step.h"

namespace app {

class FrameFeed;
class MixModel;

// The derived buffers of a scene that somebody looks at, computed for each newest frame. Also the text of the
// condition and the expression. Another scene begins without a text.
class DerivedBuffers : public QObject {
    Q_OBJECT
public:
    DerivedBuffers(FrameFeed& frames, const MixModel& mixer);

    void setScene(ScenePtr scene);  // a new state of the same scene
    void begin(ScenePtr scene);     // another scene

    const QString& text() const { return m_text; }
    void setText(const QString& text);
    lessons::DerivedRecipe recipe() const;

    // The buffers that `who` looks at; others are not computed. Forgotten when `who` is deleted.
    void want(const QObject* who, std::vector<pipeline::BufferName> names);
    // Null if nobody wants it.
    DerivedJob* find(const pipeline::BufferName& name) const;
    // The buffer in the size of the newest frame, or null.
    const lessons::DerivedBuffer* made(const pipeline::BufferName& name) const;
    // Why a view cannot show it now, or how far it is; empty if it can.
    QString whyNot(const pipeline::BufferName& name) const;

    // "Column 3: found x, expected y": the error in the text.
    static QString sentenceOf(const pipeline::Error& error);

signals:
    void textChanged();
    void changed(const pipeline::BufferName& name);  // arrived, gone, or further on its way

private:
    void settle();  // after a change of what is wanted
    void ask();

    FrameFeed& m_frames;
    const MixModel& m_mixer;
    ScenePtr m_scene;
    QString m_text;
    std::map<const QObject*, std::vector<pipeline::BufferName>> m_wanted;
    std::map<std::string, std::unique_ptr<DerivedJob>> m_jobs;  // by name
};

}  // namespace app
