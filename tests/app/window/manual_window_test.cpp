// The manual in its window.
#include <QApplication>
#include <QDockWidget>
#include <QScrollBar>
#include <QTest>
#include <QTextBlock>

#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/desktop/manual_window.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/view_area.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowManual : public WindowTest {
protected:
    ManualPage& page() { return *find<ManualWindow>("manual")->page(); }
};

TEST_F(WindowManual, OpensAtThePageOfWhatOneIsAt) {
    window.actions()[ActionId::Manual]->trigger();
    EXPECT_EQ(page().source().fileName(), "README.md") << "on the start page";
    openPyramid();
    QApplication::setActiveWindow(&window);
    canvas()->setFocus();
    press("F1");
    EXPECT_EQ(page().source().fileName(), "buffers.md");
    EXPECT_TRUE(page().toPlainText().startsWith("Look into a buffer"));
    EXPECT_TRUE(find<ManualWindow>("manual")->isVisible());
    EXPECT_EQ(manualPageOf(&window.views().view3d()), "view3d.md");
    EXPECT_EQ(manualPageOf(find<QWidget>("material.0.kr")), "settings.md");
    EXPECT_EQ(manualPageOf(find<QDockWidget>("algorithm")->widget()), "steps.md");
    EXPECT_EQ(manualPageOf(find<QDockWidget>("renderer")->widget()), "check-my-renderer.md");
    EXPECT_EQ(manualPageOf(nullptr), "window.md");
}

TEST_F(WindowManual, LinksLeadToHeadingsAndPicturesFit) {
    window.actions()[ActionId::Manual]->trigger();
    QUrl url = page().source().resolved(QUrl("buffers.md#the-histogram"));
    page().setSource(url);
    EXPECT_EQ(page().textCursor().block().text(), "The histogram");
    EXPECT_GT(page().verticalScrollBar()->value(), 0);
    page().setSource(page().source().resolved(QUrl("window.md")));
    EXPECT_TRUE(test::waitUntilQuiet());
    EXPECT_EQ(page().horizontalScrollBar()->maximum(), 0) << "a picture is wider than the page";
}

TEST_F(WindowManual, EscapeClosesIt) {
    window.actions()[ActionId::Manual]->trigger();
    auto* manual = find<ManualWindow>("manual");
    ASSERT_TRUE(manual->isVisible());
    QApplication::setActiveWindow(manual);
    QTest::keyClick(&page(), Qt::Key_Escape);
    EXPECT_FALSE(manual->isVisible());
}

TEST_F(WindowManual, WhatIsNotInstalledIsNamed) {
    window.actions()[ActionId::Manual]->trigger();
    find<ManualWindow>("manual")->open("nothing.md");
    EXPECT_TRUE(page().toPlainText().startsWith("The manual is not installed: ")) << page().toPlainText().toStdString();
    EXPECT_TRUE(page().toPlainText().endsWith("manual/nothing.md is missing."));
    find<ManualWindow>("manual")->open("pixel.md");
    EXPECT_TRUE(page().toPlainText().size() > 1000) << "another page is there";
}

TEST(Manual, HeadingsAreNamedAsLinksNameThem) {
    EXPECT_EQ(headingName("A condition over all pixels"), "a-condition-over-all-pixels");
    EXPECT_EQ(headingName("What the files say"), "what-the-files-say");
    EXPECT_EQ(headingName("Acne, and leaks"), "acne-and-leaks");
}

}  // namespace
}  // namespace app
