// Pictures for slides, step films, and pictures that open what they show.
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <algorithm>
#include <set>

#include "app/buffer_view/buffer_flip.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/compare/buffer_compare.h"
#include "app/document/document_state.h"
#include "app/document/export_plan.h"
#include "app/export/film_dialog.h"
#include "app/export/slide_dialog.h"
#include "app/export/slide_picture.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/view_area.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

using What = SlideRequest::What;

class WindowSlide : public WindowTest {
protected:
    WindowSlide() {
        openPyramid();
        document().pointing().pick(glm::ivec2(268, 281));
    }
    QImage picture(const SlideRequest& request) {
        const auto image = slidePicture(document(), window.views(), request);
        EXPECT_TRUE(image) << format(image.errors());
        return image ? *image : QImage();
    }
    void settle() {
        EXPECT_TRUE(waitForFrame());
        EXPECT_TRUE(
            QTest::qWaitFor([this] { return !document().frames().busy() && document().stepper().isSettled(); }, 30000));
    }
};

TEST_F(WindowSlide, HasTheSizeAskedForAndNoGround) {
    for (const What what : {What::Buffer, What::Space, What::Beside}) {
        const QImage image = picture({what, {1000, 600}, true, false, false});
        ASSERT_EQ(image.size(), QSize(1000, 600));
        EXPECT_EQ(qAlpha(image.pixel(1, 1)), 0) << int(what);
        EXPECT_EQ(qAlpha(image.pixel(998, 2)), 0) << int(what);
        int opaque = 0;
        for (int y = 0; y < 600; y += 3)
            for (int x = 0; x < 1000; x += 3) opaque += qAlpha(image.pixel(x, y)) == 255 ? 1 : 0;
        EXPECT_GT(opaque, 2000) << int(what);
    }
    const QImage ground = picture({What::Buffer, {400, 300}, false, false, false});
    EXPECT_EQ(qAlpha(ground.pixel(1, 1)), 255);
}

// The pyramid's own colour stands in the picture as the frame buffer has it, on any ground.
TEST_F(WindowSlide, KeepsTheColoursOfTheBuffer) {
    const QColor own = frameColor({268, 281});
    for (const bool transparent : {false, true}) {
        const QImage image = picture({What::Buffer, {1280, 960}, transparent, false, false});
        int same = 0;
        for (int y = 0; y < image.height(); y += 5)
            for (int x = 0; x < image.width(); x += 5) same += image.pixelColor(x, y) == own ? 1 : 0;
        EXPECT_GT(same, 500);
    }
}

// At 4 screen pixels each there is no grid on the screen; 14 pixels each in a larger picture make none either.
TEST_F(WindowSlide, IsTheViewLargerAndNothingElse) {
    window.views().first().canvas()->placing().setZoom(4);
    const QImage image = picture({What::Buffer, {1920, 1080}, true, false, false});
    std::set<QRgb> colors;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (qAlpha(image.pixel(x, y)) == 255) colors.insert(image.pixel(x, y));
    EXPECT_LE(colors.size(), 3u) << "those of the three polygons";
}

TEST_F(WindowSlide, ACaptionStandsBelow) {
    const QImage without = picture({What::Buffer, {900, 540}, true, false, false});
    const QImage with = picture({What::Buffer, {900, 540}, true, true, false});
    const auto inked = [](const QImage& image) {
        int count = 0;
        for (int y = 540 - 28; y < 540; ++y)
            for (int x = 0; x < 400; ++x) count += qAlpha(image.pixel(x, y)) > 128 ? 1 : 0;
        return count;
    };
    EXPECT_EQ(inked(without), 0);
    EXPECT_GT(inked(with), 200);
}

TEST_F(WindowSlide, SaysWhereTheSizeIsOnesOwn) {
    SlideDialog dialog(document(), window.views(), *window.shown().now());
    const auto boxes = dialog.findChildren<QComboBox*>();
    const auto sizes = std::ranges::find_if(boxes, [](const QComboBox* box) { return box->findText("Own size") >= 0; });
    ASSERT_NE(sizes, boxes.end());
    const auto sides = dialog.findChildren<QSpinBox*>();
    ASSERT_EQ(sides.size(), 2);
    EXPECT_EQ((*sizes)->currentText(), "1920 × 1080");
    sides[0]->setValue(800);
    EXPECT_EQ((*sizes)->currentText(), "Own size");
    sides[0]->setValue(1280);
    sides[1]->setValue(720);
    EXPECT_EQ((*sizes)->currentText(), "1280 × 720");
    (*sizes)->setCurrentIndex(2);
    emit(*sizes)->activated(2);
    EXPECT_EQ((*sizes)->currentText(), "1600 × 1200");
    EXPECT_EQ(sides[0]->value(), 1600);
    EXPECT_EQ(sides[1]->value(), 1200);
}

TEST_F(WindowSlide, TheFileOpensTheSceneAndTheState) {
    document().change(*findSetting(document().scene(), "camera.theta"), 47.25);
    settle();
    document().stepper().goTo(*pipeline::parsePlace("z-buffer/polygon=2"));
    settle();
    window.views().first().setBuffer({pipeline::BufferId::ZView});
    window.views().first().canvas()->placing().setZoom(8, QPointF(50, 60));
    const auto shown = window.shown().now();
    SlideDialog dialog(document(), window.views(), *shown);
    dialog.show();
    const QString file = folder.filePath("slide.png");
    dialog.save(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.isWorking(); }, 60000));
    EXPECT_TRUE(dialog.message().startsWith("Saved as /")) << "names the folder";
    ASSERT_TRUE(dialog.message().endsWith("slide.png.")) << dialog.message().toStdString();
    document().history().stack()->setClean();
    ASSERT_TRUE(window.openFile(resourceScene("two_pyramids.scene")));
    settle();

    ASSERT_TRUE(window.openFile(file));
    settle();
    EXPECT_EQ(document().scene().camera.theta, 47.25);
    auto again = window.shown().now();
    ASSERT_TRUE(again);
    lessons::WindowState expected =
        *shown;  // the scene comes with the picture, not from the file that it was read from
    again->scene = expected.scene, again->set = expected.set, again->sceneText = expected.sceneText;
    EXPECT_EQ(toToml(*again), toToml(expected));
}

// B, the border between the two, and what differs: the picture is of what is seen.
TEST_F(WindowSlide, AComparisonIsPicturedAsItIsSeen) {
    BufferView& view = window.views().first();
    const SlideRequest request{What::Buffer, {800, 600}, false, false, false};
    const QImage a = picture(request);
    view.compare().compareWith(
        OtherSource{.kind = OtherSource::Kind::Buffer, .buffer = {pipeline::BufferId::PolygonId}});
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return !view.compare().difference().showing().busy() && !document().frames().busy(); }, 10000));
    view.compare().setMode(CompareMode::A);
    EXPECT_TRUE(test::waitUntilQuiet());
    EXPECT_EQ(picture(request), a) << "A alone is seen";
    view.compare().setMode(CompareMode::B);
    EXPECT_TRUE(test::waitUntilQuiet());
    const QImage b = picture(request);
    EXPECT_NE(b, a);
    view.compare().setMode(CompareMode::Wipe);
    EXPECT_TRUE(test::waitUntilQuiet());
    const QImage both = picture(request);
    const QRect left(0, 100, 380, 400), right(420, 100, 380, 400);
    EXPECT_EQ(both.copy(left), a.copy(left));
    EXPECT_EQ(both.copy(right), b.copy(right));
}

TEST_F(WindowSlide, AViewThatStandsUpsideDownIsPicturedSo) {
    BufferView& view = window.views().first();
    const SlideRequest request{What::Buffer, {800, 600}, true, false, false};
    const QImage upright = picture(request);
    view.features().flip->set(true);
    EXPECT_EQ(picture(request), upright.mirrored());
}

TEST_F(WindowSlide, APictureOfABufferIsNoPromiseOfAnother) {
    window.views().setSecond(false);
    EXPECT_FALSE(slidePicture(document(), window.views(), {What::Buffer, {400, 300}, true, false, false, 1}))
        << "there is one buffer view";
    QFile other(folder.filePath("other.png"));
    ASSERT_TRUE(QImage(4, 4, QImage::Format_RGB32).save(other.fileName()));
    const auto state = stateInPicture(other.fileName());
    ASSERT_TRUE(state);
    EXPECT_FALSE(state->has_value());
}

TEST_F(WindowSlide, ALargeSlideIsMadeAwayFromTheWindowAndCanBeCancelled) {
    const auto shown = window.shown().now();
    SlideDialog dialog(document(), window.views(), *shown);
    auto* what = dialog.findChild<QComboBox*>("slideWhat");
    what->setCurrentIndex(what->findData(int(What::Space)));
    for (QSpinBox* side : dialog.findChildren<QSpinBox*>()) side->setValue(3000);
    const QString file = folder.filePath("large.png");
    dialog.save(file);
    EXPECT_TRUE(dialog.isWorking());
    dialog.findChild<QPushButton*>("slideClose")->click();
    EXPECT_FALSE(dialog.isWorking());
    EXPECT_EQ(dialog.message(), "Cancelled. Nothing was written.");
    QTest::qWait(300);
    EXPECT_FALSE(QFile::exists(file));

    auto* progress = dialog.findChild<QProgressBar*>();
    int most = 0;
    QObject::connect(progress, &QProgressBar::valueChanged, &dialog, [&](int value) { most = std::max(most, value); });
    dialog.save(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.isWorking(); }, 120000));
    EXPECT_GT(most, 30) << "three by three tiles";
    EXPECT_EQ(QImage(file).size(), QSize(3000, 3000));
}

TEST_F(WindowSlide, AFilmsCommandWritesTheFilmOfTheSceneOnShow) {
    document().change(*findSetting(document().scene(), "material.0.n"), 4);
    FilmDialog dialog(document(), {pipeline::BufferId::ZView});
    dialog.findChild<QLineEdit*>("filmTarget")->setText("/tmp/my $HOME's film.gif");
    const QString command = dialog.findChild<QLineEdit*>("filmCommand")->text();
    EXPECT_TRUE(command.contains(" --set material.0.n=4 ")) << command.toStdString();
    EXPECT_TRUE(command.endsWith(" -o '/tmp/my $HOME'\\''s film.gif'")) << command.toStdString();
}

TEST_F(WindowSlide, AFilmIsWrittenWithProgressAndCanBeCancelled) {
    FilmDialog dialog(document(), {pipeline::BufferId::ZView});
    EXPECT_EQ(dialog.order().buffer.id, pipeline::BufferId::ZView);
    auto* target = dialog.findChild<QLineEdit*>("filmTarget");
    target->setText(folder.filePath("film.gif"));
    dialog.findChild<QPushButton*>("filmStart")->click();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog.message().isEmpty(); }, 60000));
    // The beginning, and the three polygons that face the eye.
    EXPECT_TRUE(dialog.message().startsWith("4 pictures")) << dialog.message().toStdString();
    QFile gif(folder.filePath("film.gif"));
    ASSERT_TRUE(gif.open(QIODevice::ReadOnly));
    EXPECT_EQ(gif.read(6), "GIF89a");
    EXPECT_EQ(dialog.message(), "4 pictures, " + sizeText(std::uint64_t(gif.size())) + ".");

    target->setText(folder.filePath("pictures"));
    dialog.findChild<QComboBox*>("filmLevel")->setCurrentText("pixel");
    dialog.findChild<QSpinBox*>("filmPictures")->setValue(2000);
    dialog.findChild<QPushButton*>("filmStart")->click();
    dialog.findChild<QPushButton*>("filmCancel")->click();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog.message().isEmpty(); }, 60000));
    EXPECT_EQ(dialog.message(), "Cancelled. Nothing was written.");
    EXPECT_FALSE(QFile::exists(folder.filePath("pictures/step_0001.png")));
}

QByteArray bytesOf(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TEST_F(WindowSlide, AFilmReplacesAnotherOnlyWhenAsked) {
    const QString old = folder.filePath("old.gif");
    QFile file(old);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
    file.close();
    FilmDialog dialog(document(), {pipeline::BufferId::ZView});
    dialog.show();
    dialog.findChild<QLineEdit*>("filmTarget")->setText(old);
    auto* start = dialog.findChild<QPushButton*>("filmStart");
    answer("Cancel", [start] { start->click(); });
    EXPECT_TRUE(start->isEnabled()) << "nothing runs";
    EXPECT_EQ(bytesOf(old), "mine");
    answer("Replace", [start] { start->click(); });
    EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.message().startsWith("4 pictures"); }, 60000));
    EXPECT_TRUE(bytesOf(old).startsWith("GIF89a"));
}

TEST_F(WindowSlide, AFilmReplacesPicturesInAFolderOnlyWhenAsked) {
    FilmDialog dialog(document(), {pipeline::BufferId::ZView});
    dialog.show();
    dialog.findChild<QLineEdit*>("filmTarget")->setText(folder.path());  // it is there, and has no film
    auto* start = dialog.findChild<QPushButton*>("filmStart");
    start->click();
    EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.message().startsWith("4 pictures"); }, 60000));
    EXPECT_TRUE(QFile::exists(folder.filePath("step_0004.png")));
    FilmDialog next(document(), {pipeline::BufferId::ZView});
    next.show();
    next.findChild<QLineEdit*>("filmTarget")->setText(folder.path());
    answer("Cancel", [&] { next.findChild<QPushButton*>("filmStart")->click(); });
    EXPECT_EQ(next.message(), "");
}

TEST_F(WindowSlide, AnEndingInCapitalsIsOneToo) {
    FilmDialog dialog(document(), {pipeline::BufferId::ZView});
    dialog.findChild<QLineEdit*>("filmTarget")->setText(folder.filePath("B.GIF"));
    EXPECT_TRUE(dialog.findChild<QLineEdit*>("filmCommand")->text().contains("--milliseconds"));
    dialog.findChild<QPushButton*>("filmStart")->click();
    EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.message().startsWith("4 pictures"); }, 60000));
    EXPECT_TRUE(bytesOf(folder.filePath("B.GIF")).startsWith("GIF89a"));
}

TEST_F(WindowSlide, EscapeCancelsAFilmAndSaysSoAndThenCloses) {
    FilmDialog dialog(document(), {pipeline::BufferId::ZView});
    dialog.show();
    dialog.findChild<QLineEdit*>("filmTarget")->setText(folder.filePath("pictures"));
    dialog.findChild<QComboBox*>("filmLevel")->setCurrentText("pixel");
    dialog.findChild<QSpinBox*>("filmPictures")->setValue(2000);
    dialog.findChild<QPushButton*>("filmStart")->click();
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_TRUE(dialog.isVisible());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog.message().isEmpty(); }, 60000));
    EXPECT_EQ(dialog.message(), "Cancelled. Nothing was written.");
    EXPECT_FALSE(QFile::exists(folder.filePath("pictures/step_0001.png")));
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog.isVisible());
}

TEST_F(WindowSlide, TheCrossCancelsASlideFirst) {
    SlideDialog dialog(document(), window.views(), *window.shown().now());
    dialog.show();
    auto* what = dialog.findChild<QComboBox*>("slideWhat");
    what->setCurrentIndex(what->findData(int(What::Space)));
    for (QSpinBox* side : dialog.findChildren<QSpinBox*>()) side->setValue(3000);
    dialog.save(folder.filePath("large.png"));
    ASSERT_TRUE(dialog.isWorking());
    EXPECT_FALSE(dialog.close());
    EXPECT_FALSE(dialog.isWorking());
    EXPECT_EQ(dialog.message(), "Cancelled. Nothing was written.");
    EXPECT_TRUE(dialog.close());
}

// "~" is not a folder that a program would make for it.
TEST_F(WindowSlide, AFilmsPlaceIsOneInTheHomeFolder) {
    FilmDialog dialog(document(), {pipeline::BufferId::ZView});
    auto* target = dialog.findChild<QLineEdit*>("filmTarget");
    for (const auto& [typed, place] : {std::pair<QString, QString>{"~/a/film.gif", QDir::home().filePath("a/film.gif")},
                                       {"film.gif", QDir::home().filePath("film.gif")},
                                       {"/tmp/film.gif", "/tmp/film.gif"}}) {
        target->setText(typed);
        EXPECT_EQ(dialog.order().target, place.toStdString()) << typed.toStdString();
        EXPECT_TRUE(dialog.findChild<QLineEdit*>("filmCommand")->text().endsWith(" -o " + place));
    }
}

}  // namespace
}  // namespace app
