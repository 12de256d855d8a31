#pragma once
#include <QObject>
#include <chrono>

#include "app/document/opened_scene.h"
#include "app/jobs/background_job.h"

namespace app {

// Reads scenes off the GUI thread, always the newest request. A small scene arrives within the call.
class SceneOpener : public QObject {
    Q_OBJECT
public:
    using Read = std::function<pipeline::Result<OpenedScene>(const pipeline::ReadProgress&)>;
    using Take = std::function<void(const pipeline::Result<OpenedScene>&)>;

    explicit SceneOpener(QObject* parent = nullptr);

    // name: shown until the reader reports more. `take` runs in the thread of this object, unless the reading is
    // cancelled or replaced.
    void open(const QString& name, Read read, Take take);
    void cancel();
    bool busy() const { return m_job.busy(); }
    const QString& name() const { return m_name; }  // of the file being read
    double share() const { return m_share; }        // its progress, 0 to 1

    // How long open() waits: a scene that arrives so soon needs no progress bar, and nothing flickers. 0: not at all.
    void setPatience(std::chrono::milliseconds patience) { m_patience = patience; }

signals:
    void changed();  // busy, name or progress

private:
    QString m_name;
    double m_share = 0;
    long m_reading = 0;
    bool m_waits = false;  // inside open(), before it is known to take long
    std::chrono::milliseconds m_patience{80};
    BackgroundJob m_job;
};

}  // namespace app
