#include "tests/app/window/window_fixture.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFile>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <algorithm>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/document/scene_opener.h"
#include "app/views/view_area.h"
#include "pipeline/formats/scene_reader.h"
#include "tests/app/quiet.h"

namespace app {

QString resourceScene(const char* name) {
    return QString::fromStdString((pipeline::resourceFolder() / "scenes" / name).string());
}

QString ownScene(const char* name, const QString& folder) {
    for (const char* file : {name, "pyramid.des"}) QFile::copy(resourceScene(file), folder + '/' + file);
    return folder + '/' + name;
}

WindowTest::WindowTest() {
    window.opener().setPatience(std::chrono::minutes(1));
    window.setGeometry(0, 0, 1600, 900);
    window.show();
    // There may be no window manager to make it the active one.
    QApplication::setActiveWindow(&window);
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
}

void WindowTest::openPyramid() {
    ASSERT_TRUE(window.openFile(resourceScene("pyramid.scene")));
    ASSERT_TRUE(waitForFrame());
}

bool WindowTest::waitForFrame() {
    const auto isThere = [this] {
        const auto isNewest = [](const BufferView* view) { return view->isHidden() || view->isCurrent(); };
        return document().frames().shown() && !document().frames().busy() &&
               std::ranges::all_of(window.findChildren<BufferView*>(), isNewest);
    };
    const bool there = QTest::qWaitFor(isThere, 30000) && test::waitUntilQuiet();
    const auto isDone = [&] { return isThere() && document().stepper().isSettled(); };
    return there && QTest::qWaitFor(isDone, 30000);
}

void WindowTest::answer(const QString& button, const std::function<void()>& act) {
    bool asked = false;
    QTimer::singleShot(0, &window, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        asked = box != nullptr;
        for (QAbstractButton* one : box ? box->buttons() : QList<QAbstractButton*>())
            if (one->text() == button) return one->click();
        if (box) box->reject();
    });
    act();
    QCoreApplication::processEvents();
    window.activateWindow();  // not every platform gives a box's focus back
    QCoreApplication::processEvents();
    EXPECT_TRUE(asked);
}

void WindowTest::press(const char* keys) {
    QWidget* target = QApplication::focusWidget() ? QApplication::focusWidget() : &window;
    QTest::keySequence(target, QKeySequence(keys));
}

BufferCanvas* WindowTest::canvas() { return window.views().first().canvas(); }

QImage WindowTest::pictureOnScreen() { return window.views().first().grab().toImage(); }

QPoint WindowTest::onCanvas(glm::ivec2 pixel) {
    return canvas()->placing().placement().toWidget(QPointF(pixel.x + 0.5, pixel.y + 0.5)).toPoint();
}

QColor WindowTest::shownColor(const QImage& canvasPicture, glm::ivec2 pixel) {
    return canvasPicture.pixelColor(onCanvas(pixel));
}

QColor WindowTest::frameColor(glm::ivec2 pixel) {
    const auto color = *document().frames().shown()->buffer({pipeline::BufferId::Color});
    const auto channel = [&](int c) { return int(color.value(std::size_t(pixel.x), std::size_t(pixel.y), c)); };
    return QColor(channel(0), channel(1), channel(2));
}

}  // namespace app
