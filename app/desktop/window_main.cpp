#include "app/desktop/window_main.h"

#include <QSettings>

#include "app/desktop/main_window.h"
#include "app/desktop/window_cues.h"
#include "app/docks/layout_store.h"
#include "app/document/session_file.h"
#include "app/jobs/application.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "pipeline/core/version.h"

namespace app {

void prepareApplication() {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QCoreApplication::setOrganizationName("shadescope");
    QCoreApplication::setApplicationName("shadescope");
    QCoreApplication::setApplicationVersion(toQString(pipeline::programVersion()));
    QGuiApplication::setApplicationDisplayName("Shadescope");
}

int runWindow(int argc, char** argv, const WindowStart& start) {
    prepareApplication();
    Application application(argc, argv);
    keepPointInNumbers();
    restoreTheme();
    restoreNumbers();
    MainWindow window;
    window.show();
    if (start.session) window.startSession(SessionFile::usualFolder(), start.file.isEmpty() && start.cues.isEmpty());
    if (!start.file.isEmpty()) window.openFile(start.file);
    if (!start.cues.isEmpty()) window.cues().open(start.cues, start.cue, [&window] { window.cues().present(); });
    return application.exec();
}

}  // namespace app
