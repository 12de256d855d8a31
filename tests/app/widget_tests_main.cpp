#include <gtest/gtest.h>

#include "app/core/application.h"
#include "app/core/theme.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    // Widgets without OpenGL draw the same without a display.
    if (qEnvironmentVariableIsEmpty("DISPLAY")) qputenv("QT_QPA_PLATFORM", "offscreen");
    app::Application application(argc, argv);
    QApplication::setStyle("Fusion");
    app::Theme::current().apply();
    return RUN_ALL_TESTS();
}
