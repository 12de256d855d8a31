#pragma once
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>

#include "app/lesson/lesson_panel.h"

namespace app {

// The real panel on a real document: pages set the window, numbers come from frames.
class LessonPanelTest : public testing::Test {
protected:
    LessonPanelTest() {
        // Progress of its own, which goes with the folder.
        qputenv("XDG_DATA_HOME", settingsFolder.path().toUtf8());
        panel = std::make_unique<LessonPanel>(document);
        panel->resize(420, 700);
        panel->show();
        QApplication::setActiveWindow(panel.get());
    }

    template <class Widget>
    Widget& part(const char* name) {
        auto* found = panel->findChild<Widget*>(name);
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    void click(const char* button) { QTest::mouseClick(&part<QAbstractButton>(button), Qt::LeftButton); }
    QString text() { return part<QTextBrowser>("lessonText").toPlainText(); }
    QString comment() { return part<QTextBrowser>("comment").toPlainText(); }
    // The page's numbers are there when nothing stands for them any more.
    bool isFilled() {
        return QTest::qWaitFor(
            [this] {
                return !document.frames().busy() && document.frames().shown() && panel->run().texts() &&
                       !text().contains(u'…');
            },
            10000);
    }
    void goTo(int page) {
        panel->goTo(page);
        ASSERT_TRUE(isFilled()) << text().toStdString();
    }
    void answer(const char* typed) {
        part<QLineEdit>("answer").setText(typed);
        click("check");
    }

    QTemporaryDir settingsFolder;
    Document document;
    std::unique_ptr<LessonPanel> panel;
};

}  // namespace app
