#pragma once
#include <stdexcept>
#include <string>

#include "app/buffer_view/buffer_holds.h"
#include "app/buffer_view/buffer_view.h"
#include "app/buffer_view/held_band.h"
#include "app/document/hand.h"
#include "app/holds/hold_grip.h"
#include "app/lesson/lesson_panel.h"
#include "app/views/view_area.h"
#include "lessons/library.h"
#include "pipeline/scene/settings_table.h"
#include "tests/app/window/window_fixture.h"

namespace app {

// The window with a lesson whose picture is held.
class HeldLesson : public WindowTest {
protected:
    void open(const char* lesson) {
        window.resize(1366, 768);
        ASSERT_TRUE(window.openFile(QString::fromStdString((lessons::lessonFolder() / lesson).string())));
        ASSERT_TRUE(waitForFrame());
        ASSERT_TRUE(QTest::qWaitFor([&] { return run().texts().has_value(); }, 10000));
    }
    LessonRun& run() { return window.findChild<LessonPanel*>()->run(); }
    Hand& hand() { return document().hand(); }
    HoldGrip& grip() {
        for (HoldGrip* grip : window.findChildren<HoldGrip*>())
            if (grip->isVisible()) return *grip;
        throw std::runtime_error("nothing is held");
    }
    HeldBand& band() { return window.views().first().features().holds->band(); }
    QPoint middle() { return grip().rect().center(); }
    QPoint placeOfGrip() { return grip().geometry().center(); }
    void dragTo(QPoint onCanvas) {
        QTest::mousePress(&grip(), Qt::LeftButton, {}, middle());
        const QPoint to = middle() + onCanvas - placeOfGrip();
        QTest::mouseMove(&grip(), to);
        // A moved grip takes its own place along.
        QTest::mouseRelease(&grip(), Qt::LeftButton, {}, middle() + onCanvas - placeOfGrip());
        ASSERT_TRUE(waitForFrame());
    }
    static std::string firstWord(const std::string& text) { return text.substr(0, text.find(' ')); }
    void type(const std::string& text) { QTest::keyClicks(QApplication::focusWidget(), QString::fromStdString(text)); }
    // n doubles with each Shift+Left: 8, 16, 32. Then (R·V)^n is a half at acos(2^(−1/32)) = 11.9° from the middle, and
    // above it on a quarter of the pixels of n = 8.
    void pullInwardsUntilRight() {
        for (int i = 0; i < 4 && !run().isSettled(); ++i) {
            ASSERT_TRUE(qobject_cast<HoldGrip*>(QApplication::focusWidget())) << "also after a wrong answer";
            press("Shift+Left");
            ASSERT_TRUE(waitForFrame());
            press("Return");
        }
    }
    double light(const char* axis) {
        return findSetting(document().scene(), std::string("light.0.") + axis)->get(document().scene());
    }
    pipeline::Vec3d L() { return {light("x"), light("y"), light("z")}; }
};

}  // namespace app
