#include "app/document/scene_opener.h"

#include <QScopedValueRollback>

#include "app/look/shown_name.h"
#include "app/look/text.h"

namespace app {

SceneOpener::SceneOpener(QObject* parent) : QObject(parent) {
    connect(&m_job, &BackgroundJob::progressed, this, [this](double share) {
        m_share = share;
        if (!m_waits) emit changed();
    });
    connect(&m_job, &BackgroundJob::busyChanged, this, [this](bool busy) {
        if (!busy && !m_waits) emit changed();
    });
}

void SceneOpener::open(const QString& name, Read read, Take take) {
    m_name = name;
    m_share = 0;
    const long reading = ++m_reading;
    // A scene may name several files.
    const auto nameFile = [this, reading](const std::string& file) {
        QMetaObject::invokeMethod(
            this,
            [this, reading, file] {
                if (reading == m_reading) m_name = shownName(toQString(file));
            },
            Qt::QueuedConnection);
    };
    m_job.ask(
        [read = std::move(read), nameFile](const BackgroundJob::Control& control) {
            std::string last;
            const auto tell = [&](double share, std::string_view file) {
                if (file != last) nameFile(last = file);
                control.progress(share);
            };
            return read({tell, control.stop});
        },
        std::move(take));
    if (m_patience.count() > 0) {
        const QScopedValueRollback guard(m_waits, true);
        m_job.waitFor(m_patience);
    }
    emit changed();
}

void SceneOpener::cancel() { m_job.forget(); }

}  // namespace app
