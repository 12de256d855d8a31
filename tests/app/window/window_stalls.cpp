// How long a single event holds the window's thread while a large model is opened, picked from, changed and turned.
// Needs a display. window_stalls FILE: any scene or model. Of each act: the longest event by the clock, the processor's
// time of the window's thread in it, and what it was; how many took longer than 100 ms; and how many frames and pictures
// of the 3D view came meanwhile.
#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <cstdio>
#include <ctime>
#include <functional>

#include "app/buffer_view/buffer_loupe.h"
#include "app/buffer_view/buffer_region.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/compare/buffer_compare.h"
#include "app/desktop/main_window.h"
#include "app/desktop/window_main.h"
#include "app/docks/panel_dock.h"
#include "app/document/scene_opener.h"
#include "app/view3d/scene_view.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/view_area.h"
#include "pipeline/core/memory.h"

namespace {

double windowCpu() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

constexpr double kFreeze = 100;  // ms

// Knows the longest event since it was last asked.
class Watched : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override {
        if (m_depth > 0) return QApplication::notify(receiver, event);
        const QByteArray what =
            QByteArray(receiver->metaObject()->className()) + ", event " + QByteArray::number(int(event->type()));
        QElapsedTimer clock;
        clock.start();
        const double before = windowCpu();
        ++m_depth;
        const bool done = QApplication::notify(receiver, event);
        --m_depth;
        const double took = double(clock.nsecsElapsed()) * 1e-6;
        m_frozen += took > kFreeze;
        if (took > m_longest) m_longest = took, m_cpu = windowCpu() - before, m_what = what;
        return done;
    }
    int frames = 0, pictures3d = 0;
    void report(const char* act) {
        std::printf("%-36s %8.0f %8.0f %8d %7d %4d  %s\n", act, m_longest, m_cpu, m_frozen, frames, pictures3d,
                    m_what.constData());
        std::fflush(stdout);
        frames = pictures3d = 0;
        m_longest = m_cpu = 0;
        m_frozen = 0;
        m_what.clear();
    }

private:
    int m_depth = 0, m_frozen = 0;
    double m_longest = 0, m_cpu = 0;
    QByteArray m_what;
};

// Until nothing is left to compute and to draw.
void settle(app::MainWindow& window) {
    const app::Document& document = window.document();
    const auto& view3d = window.views().view3d().view();
    QTest::qWait(100);
    const bool done = QTest::qWaitFor(
        [&] {
            return !window.opener().busy() && document.frames().shown() && !document.frames().busy() &&
                   view3d.isDrawn();
        },
        60000);
    if (!done) std::printf("(not done within a minute)\n");
    QTest::qWait(400);  // and what is begun when it rests
}

void drag(QWidget* widget, Qt::MouseButton button, Qt::KeyboardModifiers keys) {
    QPoint at = widget->rect().center();
    QTest::mousePress(widget, button, keys, at);
    for (int i = 0; i < 100; ++i) {
        at += QPoint(i < 50 ? 3 : -3, i % 2);
        QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, button, keys);
        QCoreApplication::sendEvent(widget, &move);
        QTest::qWait(8);
    }
    QTest::mouseRelease(widget, button, keys, at);
}

void changeLive(app::Document& document, const char* key) {
    const auto setting = *findSetting(document.scene(), key);
    const double begin = setting.get(document.scene());
    for (int i = 0; i < 200; ++i) {
        document.change(setting, begin + 0.02 * (1 + i % 50), app::Document::Change::Live);
        QTest::qWait(8);
    }
    document.change(setting, begin, app::Document::Change::Done);
}

}  // namespace

int main(int argc, char** argv) {
    pipeline::keepFreedMemory();  // as the program does
    const QTemporaryDir settings;
    qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
    app::prepareApplication();
    Watched application(argc, argv);
    if (application.arguments().size() != 2) {
        std::fputs("usage: window_stalls FILE\n", stderr);
        return 2;
    }
    app::MainWindow window;
    window.setGeometry(0, 0, 1920, 1080);
    window.show();
    QTest::qWait(200);
    std::printf("%-36s %8s %8s %8s %7s %4s  %s\n", "", "longest", "cpu ms", "> 100 ms", "frames", "3D",
                "the longest event's receiver");
    application.report("start");
    app::Document& document = window.document();
    QObject::connect(&document.frames(), &app::FrameFeed::frameReady, [&] { ++application.frames; });
    QObject::connect(&window.views().view3d().view(), &app::SceneView::drawn, [&] { ++application.pictures3d; });
    const auto act = [&](const char* name, const std::function<void()>& does) {
        does();
        settle(window);
        application.report(name);
    };
    act("the model is opened", [&] { window.openFile(application.arguments()[1]); });
    pipeline::Scene sized = document.scene();
    sized.settings.width = 1920, sized.settings.height = 1080;
    act("its picture becomes 1920 × 1080", [&] { document.replace(sized, "size"); });

    app::BufferCanvas* canvas = window.views().first().canvas();
    app::SceneView& view3d = window.views().view3d().view();
    act("the pointer moves over the picture", [&] { drag(canvas, Qt::NoButton, {}); });
    act("pixels are picked", [&] {
        for (int i = 0; i < 10; ++i) {
            QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->rect().center() + QPoint(8 * i, 5 * i));
            QTest::qWait(300);
        }
    });
    act("the picked pixel follows the pointer", [&] { drag(canvas, Qt::LeftButton, Qt::ControlModifier); });
    act("the camera's angle is dragged", [&] { changeLive(document, "camera.fov"); });
    act("a light is dragged", [&] { changeLive(document, "light.0.x"); });
    act("the 3D view is turned", [&] { drag(&view3d, Qt::LeftButton, {}); });
    act("the 3D view is pointed at", [&] { drag(&view3d, Qt::NoButton, {}); });
    act("the picture is magnified 16 times", [&] { canvas->placing().setZoom(16); });
    act("the picture is moved at 16 times", [&] { drag(canvas, Qt::LeftButton, {}); });
    act("the picture is shown whole", [&] { canvas->placing().fit(true); });
    act("the picture is moved", [&] { drag(canvas, Qt::LeftButton, {}); });
    using Kind = lessons::Selection::Kind;
    act("a polygon is selected", [&] { document.pointing().select(lessons::Selection{Kind::Polygon, 1000}); });
    act("an object is selected", [&] { document.pointing().select(lessons::Selection{Kind::Object, 0}); });
    act("... and the camera's angle dragged", [&] { changeLive(document, "camera.fov"); });
    act("a vertex is selected", [&] { document.pointing().select(lessons::Selection{Kind::Vertex, 1000}); });
    act("nothing is selected", [&] { document.pointing().select({}); });
    for (const char* name : {"depth", "z_view", "overdraw", "polygon_id", "normal", "n_dot_l.0", "polygons.verdict"})
        if (const auto buffer = pipeline::findBuffer(name))
            act(qPrintable(QString("the view shows %1").arg(name)), [&] { window.views().showBuffer(*buffer); });
    act("the pointer moves over its polygons", [&] { drag(canvas, Qt::NoButton, {}); });
    act("... under the loupe", [&] {
        window.views().first().features().loupe->set(true);
        drag(canvas, Qt::NoButton, {});
    });
    act("the loupe is over the frame buffer", [&] {
        window.views().showBuffer({pipeline::BufferId::Color});
        drag(canvas, Qt::NoButton, {});
    });
    window.views().first().features().loupe->set(false);
    app::BufferView& view = window.views().first();
    act("it is compared with the stage before", [&] {
        view.compare().compareWith(app::OtherSource{.kind = app::OtherSource::Kind::PreviousStage});
        view.compare().setMode(app::CompareMode::Wipe);
    });
    act("... and the camera's angle dragged", [&] { changeLive(document, "camera.fov"); });
    act("... over a buffer of polygons", [&] {
        window.views().showBuffer({pipeline::BufferId::PolygonsVerdict});
        QTest::qWait(2000);
        changeLive(document, "camera.fov");
    });
    act("... which is left", [&] { window.views().showBuffer({pipeline::BufferId::Color}); });
    view.compare().compareWith({});
    act("the whole picture is a region", [&] { view.features().region->set(app::Region{{0, 0}, {1919, 1079}}); });
    act("... and the camera's angle dragged", [&] { changeLive(document, "camera.fov"); });
    view.features().region->set({});
    act("all panels are open", [&] {
        for (auto* dock : window.findChildren<app::PanelDock*>()) dock->show(), dock->raise();
    });
    act("... and the camera's angle dragged", [&] { changeLive(document, "camera.fov"); });
    act("polygons are stepped", [&] {
        document.setStage(pipeline::StageId::ZBuffer);
        for (int i = 0; i < 20; ++i) {
            document.stepper().step(i < 10 ? 1 : -1);
            QTest::qWait(100);
        }
    });
    document.history().stack()->setClean();
    return 0;
}
