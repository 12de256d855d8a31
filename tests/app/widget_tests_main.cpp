#include <gtest/gtest.h>

#include <QApplication>

#include "app/core/theme.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    // Widgets without OpenGL draw the same without a display.
    if (qEnvironmentVariableIsEmpty("DISPLAY")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QApplication::setStyle("Fusion");
    app::Theme::current().apply();
    return RUN_ALL_TESTS();
}
