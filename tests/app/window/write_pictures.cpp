// write_pictures TOUR.cues FOLDER: the manual's pictures of the window, taken at the cues of the tour. Needs a display
// with OpenGL.
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTimer>
#include <cstdio>

#include "app/desktop/main_window.h"
#include "app/desktop/window_cues.h"
#include "app/desktop/window_main.h"
#include "app/document/scene_opener.h"
#include "app/look/theme.h"
#include "app/talk/clean_view.h"
#include "app/talk/presentation.h"

namespace {

// A picture of a part of the window, by its object name; of all of it without one. A panel that is hidden is shown first.
struct ManualPicture {
    const char *file, *cue;
    const char* part = "";
    QSize window{1440, 900};
};
constexpr ManualPicture kPictures[]{
    {"window", "window"},
    {"steps", "steps"},
    {"buffer", "buffer", "viewArea"},
    {"pixel-numbers", "pixel-numbers", "viewArea"},
    {"view3d", "view3d", "viewArea"},
    {"light-space", "light-space", "viewArea"},
    {"compare", "compare", "viewArea"},
    {"inspector", "window", "inspector", {1440, 1300}},
    {"settings", "window", "settings", {1440, 1300}},
    {"tables", "window", "tables"},
    {"section", "window", "scanline"},
    {"cues", "clean-view", "cues", {1440, 1300}},
};

// The event loop turns so long after a frame is there: what comes at rest (smooth edges, the check of a frame, small
// pictures) is in the picture too.
constexpr int kRestMilliseconds = 2500;
// The line that says how to go on has gone from the clean view.
constexpr int kCleanMilliseconds = 7000;

void rest(const app::Document& document, int milliseconds = kRestMilliseconds) {
    QElapsedTimer still;
    still.start();
    QTimer wake;
    wake.start(10);
    while (still.elapsed() < milliseconds) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        if (!document.frames().shown() || document.frames().busy()) still.restart();
    }
}

bool write(const QImage& picture, const QString& file) {
    const bool written = picture.save(file, "PNG", 0);  // 0: as small as it gets
    if (!written) std::fprintf(stderr, "write_pictures: could not write %s\n", qPrintable(file));
    return written;
}

bool take(app::MainWindow& window, const QString& tour, const ManualPicture& picture, const QString& folder) {
    window.resize(picture.window);
    auto* part = *picture.part ? window.findChild<QWidget*>(picture.part) : &window;
    if (!part || !window.cues().open(tour, picture.cue)) {
        std::fprintf(stderr, "write_pictures: no cue %s, or no part %s of the window\n", picture.cue, picture.part);
        return false;
    }
    auto* panel = qobject_cast<QDockWidget*>(part);
    const bool wasHidden = panel && !panel->isVisible();
    if (panel) panel->show(), panel->raise();
    rest(window.document());
    const bool written = write(part->grab().toImage(), folder + "/" + picture.file + ".png");
    if (wasHidden) panel->hide();
    return written;
}

bool takeCleanView(app::MainWindow& window, const QString& tour, const QString& folder) {
    if (!window.cues().open(tour, "clean-view")) return false;
    window.cues().present();
    app::CleanView* const clean = window.presentation().cleanView();
    if (!clean) return false;
    rest(window.document(), kCleanMilliseconds);
    const QImage picture = clean->grab().toImage().scaledToWidth(1280, Qt::SmoothTransformation);
    window.cues().present();  // ends it
    return write(picture, folder + "/clean-view.png");
}

}  // namespace

int main(int argc, char** argv) {
    const QTemporaryDir settings;  // nobody's own layout or recent files are in the pictures
    qputenv("XDG_CONFIG_HOME", settings.path().toUtf8());
    app::prepareApplication();
    QApplication application(argc, argv);
    if (argc != 3) {
        std::fputs("write_pictures TOUR.cues FOLDER\n", stderr);
        return 2;
    }
    app::Theme::current().set(app::ThemeId::Light);
    const QString tour = application.arguments()[1], folder = application.arguments()[2];
    app::MainWindow window;
    window.opener().setPatience(std::chrono::minutes(1));
    window.show();
    bool good = true;
    for (const ManualPicture& picture : kPictures) good = take(window, tour, picture, folder) && good;
    good = takeCleanView(window, tour, folder) && good;
    window.document().history().stack()->setClean();
    return good ? 0 : 1;
}
