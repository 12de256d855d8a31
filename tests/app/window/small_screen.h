#pragma once
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QWidget>
#include <initializer_list>

#include "app/look/theme.h"
#include "app/widgets/folding_panes.h"

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

// Calls check() with the window in sizes of small screens and with text of these scales. Leaves the usual text.
template <class Check>
void onSmallScreens(QWidget& window, std::initializer_list<double> scales, Check check) {
    for (const double scale : scales)
        for (const QSize size : {QSize(1024, 640), QSize(1280, 720), QSize(1366, 768)}) {
            SCOPED_TRACE(testing::Message() << size.width() << " wide, text " << scale);
            app::Theme::current().setScale(scale);
            window.resize(size);
            QCoreApplication::processEvents();
            EXPECT_EQ(window.size(), size);
            check();
        }
    app::Theme::current().setScale(1);
}

// So small and with text so large that one of its parts is shown at a time: the second one.
inline void foldToSecondPart(QWidget& window) {
    app::Theme::current().setScale(2);
    window.resize(1024, 640);
    QCoreApplication::processEvents();
    auto& panes = *window.findChild<app::FoldingPanes*>();
    ASSERT_TRUE(panes.isFolded());
    panes.bringToFront(1);
}

}  // namespace test
