// How long the window takes to start, and how it follows a slider and a click. Needs a display.
// window_bench [SCENE …]: built-in scenes by name, or files; without any, all built-in ones, each at 640 × 480 and at
// 1280 × 720. A step
// is one change until every view has painted it, a click one until the equation and the vectors are those of the pixel.
// While a hand drags on, the next frame is computed as the one before is painted: frames a second are the median of the
// times between two frames that the buffer view has painted, beside it the 95th percentile, and the frames a second of
// the 3D view. Other work on the machine makes the times longer; the CPU time of the window's thread and of all
// threads for a frame of the drag, which it hardly changes, stands beside.
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QSet>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "app/canvas/buffer_canvas.h"
#include "app/desktop/main_window.h"
#include "app/desktop/window_main.h"
#include "app/docks/layout_store.h"
#include "app/document/scene_opener.h"
#include "app/frames/pixel_inspection.h"
#include "app/views/view_area.h"
#include "app/vtk/vtk_widget.h"
#include "pipeline/core/memory.h"
#include "pipeline/formats/built_in_scenes.h"

namespace {

constexpr int kSteps = 40;
constexpr int kDragMilliseconds = 2000, kMouseMilliseconds = 8;  // a mouse reports so often

QByteArray load() {
    QFile file("/proc/loadavg");
    return file.open(QIODevice::ReadOnly) ? file.readAll().split(' ').value(0) : QByteArray("unknown");
}

double cpu(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}
double windowCpu() { return cpu(CLOCK_THREAD_CPUTIME_ID); }
double wholeCpu() { return cpu(CLOCK_PROCESS_CPUTIME_ID); }

// Turns the event loop until `done` or so many milliseconds, asleep while nothing comes: what waits must not take the
// processor from what it waits for.
template <class Done>
void runUntil(Done done, qint64 most) {
    QElapsedTimer since;
    since.start();
    QTimer wake;
    wake.start(2);
    while (!done() && since.elapsed() < most) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

void settle(app::MainWindow& window) {
    const app::Document& document = window.document();
    runUntil([&] { return !window.opener().busy() && document.frames().shown() && !document.frames().busy(); }, 60000);
    QCoreApplication::processEvents();
}

// Whether the views on show have painted the newest frame.
class Painted : public QObject {
public:
    explicit Painted(app::MainWindow& window) {
        m_views = {window.views().findChild<app::BufferCanvas*>(), window.views().findChild<app::VtkWidget*>()};
        for (QWidget* view : m_views) view->installEventFilter(this);
        connect(&window.document().frames(), &app::FrameFeed::frameReady, this, [this] { m_fresh.clear(); });
    }
    bool all() const {
        return std::ranges::all_of(m_views,
                                   [this](QWidget* view) { return !view->isVisible() || m_fresh.contains(view); });
    }

protected:
    // The picture of a 3D view comes from elsewhere: what it paints before that shows the frame before.
    bool eventFilter(QObject* watched, QEvent* event) override {
        const auto* view3d = qobject_cast<app::VtkWidget*>(watched);
        if (event->type() == QEvent::Paint && (!view3d || view3d->isNewest())) m_fresh.insert(watched);
        return false;
    }

private:
    QList<QWidget*> m_views;
    QSet<QObject*> m_fresh;
};

pipeline::SettingRef draggedSetting(const pipeline::Scene& scene) {
    return *findSetting(scene, scene.camera.kind == pipeline::CameraKind::Spherical ? "camera.theta" : "camera.fov");
}

// Turns the camera: as soon as the picture of one step is on the screen, the next. Milliseconds a step, ascending.
std::vector<double> stepByStep(app::MainWindow& window, int steps) {
    app::Document& document = window.document();
    const auto setting = draggedSetting(document.scene());
    const double begin = setting.get(document.scene());
    std::vector<double> times;
    const Painted painted(window);
    for (int i = 1; i <= steps; ++i) {
        QElapsedTimer step;
        step.start();
        document.change(setting, begin + 0.25 * (i <= steps / 2 ? i : steps - i), app::Document::Change::Live);
        const auto isShown = [&] {
            return document.frames().shown() &&
                   document.frames().shown()->sharedScene()->camera == document.scene().camera && painted.all();
        };
        runUntil(isShown, 10000);
        times.push_back(double(step.nsecsElapsed()) / 1e6);
    }
    document.change(setting, begin, app::Document::Change::Done);
    std::ranges::sort(times);
    return times;
}

// When the buffer view has painted a frame that it had not before, and how many the 3D view has.
class PaintedFrames : public QObject {
public:
    explicit PaintedFrames(app::MainWindow& window)
        : m_document(window.document()),
          m_canvas(window.views().findChild<app::BufferCanvas*>()),
          m_view3d(window.views().findChild<app::VtkWidget*>()) {
        for (QWidget* view : {static_cast<QWidget*>(m_canvas), static_cast<QWidget*>(m_view3d)})
            view->installEventFilter(this);
        m_since.start();
    }
    int count() const { return int(m_times.size()); }
    int count3d() const { return m_contents; }
    // Milliseconds between two frames, ascending.
    std::vector<double> intervals() const {
        std::vector<double> between;
        for (std::size_t i = 1; i < m_times.size(); ++i) between.push_back(m_times[i] - m_times[i - 1]);
        std::ranges::sort(between);
        return between;
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Paint) return false;
        if (watched == m_canvas && m_frame != m_document.frames().shown()) {
            m_frame = m_document.frames().shown();
            m_times.push_back(double(m_since.nsecsElapsed()) / 1e6);
        }
        // It may show the frame before.
        const auto& shown = m_view3d->shown();
        if (watched == m_view3d && shown && m_content != shown->content) m_content = shown->content, ++m_contents;
        return false;
    }

private:
    const app::Document& m_document;
    app::BufferCanvas* m_canvas;
    app::VtkWidget* m_view3d;
    pipeline::FramePtr m_frame;
    std::shared_ptr<const app::ViewContent> m_content;
    QElapsedTimer m_since;
    std::vector<double> m_times;
    int m_contents = 0;
};

double quantile(const std::vector<double>& ascending, double share) {
    return ascending.empty() ? NAN : ascending[std::size_t(share * double(ascending.size() - 1))];
}

struct Drag {
    double framesPerSecond = 0, slow = 0, frames3dPerSecond = 0;  // slow: of 95 % of the intervals the longest
    double windowCpu = 0, wholeCpu = 0;                           // milliseconds a frame
};

// Turns the camera as a hand does that does not wait for pictures.
Drag drag(app::MainWindow& window) {
    app::Document& document = window.document();
    const auto setting = draggedSetting(document.scene());
    const double begin = setting.get(document.scene());
    const PaintedFrames painted(window);
    int moves = 0;
    QTimer mouse;
    QObject::connect(&mouse, &QTimer::timeout,
                     [&] { document.change(setting, begin + 0.1 * (1 + moves++ % 50), app::Document::Change::Live); });
    mouse.start(kMouseMilliseconds);
    QElapsedTimer time;
    time.start();
    const double windowBefore = windowCpu(), wholeBefore = wholeCpu();
    runUntil([] { return false; }, kDragMilliseconds);
    mouse.stop();
    const std::vector<double> intervals = painted.intervals();
    const Drag found{1000 / quantile(intervals, 0.5), quantile(intervals, 0.95),
                     1000.0 * painted.count3d() / double(time.elapsed()),
                     (windowCpu() - windowBefore) / painted.count(), (wholeCpu() - wholeBefore) / painted.count()};
    document.change(setting, begin, app::Document::Change::Done);
    settle(window);
    return found;
}

// Clicks pixels one after the other, until equation and vectors are on the screen. Milliseconds a click, ascending.
std::vector<double> click(app::MainWindow& window) {
    constexpr int kClicks = 12;
    app::Document& document = window.document();
    const app::VtkWidget& view3d = *window.views().findChild<app::VtkWidget*>();
    const int width = document.scene().settings.width, height = document.scene().settings.height;
    std::vector<double> times;
    for (int i = 1; i <= kClicks; ++i) {
        const glm::ivec2 pixel(width * i / (kClicks + 1), height * (1 + i % 3) / 4);
        QElapsedTimer time;
        time.start();
        document.pointing().pick(pixel);
        runUntil(
            [&] {
                const auto& inspected = document.inspection().newest();
                return inspected && inspected->report.pixel == pixel && view3d.isNewest();
            },
            10000);
        QCoreApplication::sendPostedEvents();
        window.repaint();
        times.push_back(double(time.nsecsElapsed()) / 1e6);
    }
    document.pointing().pick({});
    settle(window);
    std::ranges::sort(times);
    return times;
}

struct NamedScene {
    QString name, file;
};
// Built-in scenes and files; all built-in ones where none are wanted.
QList<NamedScene> scenesOf(QStringList wanted) {
    QList<NamedScene> scenes;
    const bool areAll = wanted.isEmpty();
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes()) {
        const QString name = QString::fromStdString(scene.name);
        if (wanted.removeAll(name) > 0 || areAll) scenes.append({name, QString::fromStdString(scene.file.string())});
    }
    for (const QString& file : wanted) scenes.append({QFileInfo(file).fileName(), file});
    return scenes;
}

}  // namespace

int main(int argc, char** argv) {
    QElapsedTimer start;
    start.start();
    pipeline::keepFreedMemory();  // as the program does
    const QTemporaryDir settings;
    qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
    app::prepareApplication();
    QApplication application(argc, argv);
    app::restoreTheme();
    const double ready = double(start.nsecsElapsed()) / 1e6;
    app::MainWindow window;
    window.setGeometry(0, 0, 1680, 1000);
    const double made = double(start.nsecsElapsed()) / 1e6;
    window.show();
    QCoreApplication::processEvents();
    const double shown = double(start.nsecsElapsed()) / 1e6;
    std::printf(
        "load %s\nstart page usable after %.0f ms (processor, window's thread: %.0f ms): Qt %.0f, window made %.0f, "
        "shown %.0f\n",
        load().constData(), shown, windowCpu(), ready, made - ready, shown - made);
    std::printf("%-28s %9s %8s %8s %8s %9s %8s %8s %11s %8s\n", "scene", "picture", "opens ms", "step ms", "click ms",
                "frames/s", "95 % ms", "3D/s", "window cpu", "all cpu");
    for (const auto& [name, file] : scenesOf(application.arguments().mid(1))) {
        QElapsedTimer opening;
        opening.start();
        if (!window.openFile(file)) continue;
        settle(window);
        const double opened = double(opening.nsecsElapsed()) / 1e6;
        for (const auto& [width, height] : {std::pair(640, 480), std::pair(1280, 720)}) {
            pipeline::Scene sized = window.document().scene();
            sized.settings.width = width, sized.settings.height = height;
            window.document().replace(sized, "size");
            settle(window);
            stepByStep(window, 8);
            const std::vector<double> steps = stepByStep(window, kSteps);
            settle(window);
            const std::vector<double> clicks = click(window);
            const Drag dragged = drag(window);
            std::printf("%-28s %4d×%-4d %8.0f %8.1f %8.1f %9.1f %8.1f %8.1f %11.1f %8.1f\n", qPrintable(name), width,
                        height, opened, quantile(steps, 0.5), quantile(clicks, 0.5), dragged.framesPerSecond,
                        dragged.slow, dragged.frames3dPerSecond, dragged.windowCpu, dragged.wholeCpu);
            std::fflush(stdout);
        }
        window.document().history().stack()->setClean();
    }
    std::printf("load %s\n", load().constData());
    return 0;
}
