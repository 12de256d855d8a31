#pragma once
#include <QObject>
#include <chrono>

#include "app/core/background_job.h"
#include "app/core/opened_scene.h"

namespace app {

// Reads scenes away from the window's thread: the newest that was asked for. A small one is there within the call.
class SceneOpener : public QObject {
    Q_OBJECT
public:
    using Read = std::function<pipeline::Result<OpenedScene>(const pipeline::ReadProgress&)>;
    using Take = std::function<void(const pipeline::Result<OpenedScene>&)>;

    explicit SceneOpener(QObject* parent = nullptr);

    // name: of what is read, until it says more. `take` runs in the thread of this object, unless the reading is
    // cancelled or another is asked for.
    void open(const QString& name, Read read, Take take);
    void cancel();
    bool busy() const { return m_job.busy(); }
    const QString& name() const { return m_name; }  // of the file that is being read
    double share() const { return m_share; }        // of it, 0 to 1

    // How long open() waits: what comes so soon needs no progress, and nothing flickers. 0: not at all.
    void setPatience(std::chrono::milliseconds patience) { m_patience = patience; }

signals:
    void changed();  // busy, what is read, or how far

private:
    QString m_name;
    double m_share = 0;
    long m_reading = 0;
    bool m_waits = false;  // in open(): whether it takes long is not known yet
    std::chrono::milliseconds m_patience{80};
    BackgroundJob m_job;
};

}  // namespace app
