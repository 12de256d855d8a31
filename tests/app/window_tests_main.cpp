#include <gtest/gtest.h>

#include <QSettings>
#include <QTemporaryDir>

#include "app/core/application.h"
#include "app/core/theme.h"
#include "app/desktop/window_main.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (qEnvironmentVariableIsEmpty("DISPLAY")) qputenv("QT_QPA_PLATFORM", "offscreen");
    app::prepareApplication();
    // The user's own settings, session, cues and results of lessons stay as they are.
    QTemporaryDir settings;
    qputenv("XDG_DATA_HOME", settings.path().toUtf8());
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    app::Application application(argc, argv);
    app::Theme::current().set(app::ThemeId::Light);
    return RUN_ALL_TESTS();
}
