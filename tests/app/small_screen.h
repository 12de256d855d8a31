#pragma once
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QWidget>

#include "app/core/theme.h"

namespace test {

// In every theme the window takes the size of a small laptop's screen. Leaves the light theme.
inline void expectFitsASmallScreen(QWidget& window) {
    for (const app::ThemeId theme : {app::ThemeId::Dark, app::ThemeId::Projector, app::ThemeId::Light}) {
        app::Theme::current().set(theme);
        QCoreApplication::sendPostedEvents();
        window.resize(1280, 720);
        QCoreApplication::processEvents();
        EXPECT_EQ(window.size(), QSize(1280, 720))
            << int(theme) << ": the least is " << window.minimumSizeHint().width() << " by "
            << window.minimumSizeHint().height();
    }
}

}  // namespace test
