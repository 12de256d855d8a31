#include "app/compare/buffer_compare.h"
#include "app/compare/compare_menu.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>

#include "app/buffer_view/buffer_channels.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/compare/stage_differences.h"
#include "app/frames/picture_file.h"
#include "app/look/luminance.h"
#include "pipeline/export/buffers/exr_file.h"
#include "pipeline/export/buffers/npy_file.h"
#include "tests/support/scenes.h"

// A real view on a real document, compared with frames that the tests compute by themselves.
namespace {

using app::BufferView;
using app::CompareMode;
using app::Document;
using app::OtherSource;
using pipeline::BufferId;
using Kind = app::OtherSource::Kind;

// A sphere, so that Gouraud and Phong shading differ inside the polygons.
pipeline::Scene ball(pipeline::Shading shading) {
    pipeline::Scene scene = test::pyramid();
    scene.objects[0].mesh = test::sphere(150, 8, 12);
    scene.objects[0].transform = {};
    scene.settings.width = 160, scene.settings.height = 120;
    scene.settings.shading = shading;
    return scene;
}

// As an audience reads them, which sees no setting's name.
TEST(CaptionOf, ChoicesAreInWords) {
    pipeline::Scene scene = test::pyramid();
    scene.settings.visibility = pipeline::Visibility::Painter;
    const auto caption = [&](const char* key, const char* value) {
        auto changed = withSetting(scene, std::string(key) + "=" + value);
        EXPECT_TRUE(changed) << key;
        return app::captionOf(*findSetting(scene, key), *changed).toStdString();
    };
    scene.settings.shadowBiasValue = 0;
    EXPECT_EQ(caption("shadow.bias", "constant"), "No bias");
    EXPECT_EQ(caption("shadow.bias", "automatic"), "Automatic bias");
    scene.settings.shadowBiasValue = 5;
    EXPECT_EQ(caption("shadow.bias", "constant"), "Constant bias");
    EXPECT_EQ(caption("numerics.polygon_normal", "three-corners"), "Three corners");
    EXPECT_EQ(caption("numerics.power", "pow"), "(R·V)ⁿ");
    EXPECT_EQ(caption("shading", "phong"), "Phong");
    EXPECT_EQ(caption("visibility", "none"), "Visibility: none");
    scene.settings.visibility = pipeline::Visibility::ZBuffer;
    EXPECT_EQ(caption("visibility", "z-buffer"), "Z-buffer");
    scene.settings.depthFormat = pipeline::DepthFormat::Float;
    EXPECT_EQ(caption("depth_format", "fixed16"), "16 bits");
}

struct BufferCompareTest : testing::Test {
    Document document;
    BufferView view{document};
    app::BufferCompare& compare = view.compare();

    BufferCompareTest() {
        view.resize(640, 560);
        view.show();
        document.setScene(ball(pipeline::Shading::Gouraud));
        EXPECT_TRUE(QTest::qWaitFor([&] { return view.shown().has_value(); }, 10000));
    }
    OtherSource setting(const char* key, double value) {
        const auto ref = findSetting(document.scene(), key);
        EXPECT_TRUE(ref);
        return {.kind = Kind::Setting, .setting = *ref, .value = value};
    }
    void compareWith(const OtherSource& source) {
        compare.compareWith(source);
        EXPECT_TRUE(found());
    }
    bool found() {
        return QTest::qWaitFor([&] { return compare.difference().found().has_value() && !document.frames().busy(); },
                               10000);
    }
    app::BufferCanvas& canvas() { return *view.canvas(); }
};

constexpr double kPhong = double(pipeline::Shading::Phong);

}  // namespace

TEST_F(BufferCompareTest, TheFrameOfBIsGivenUpAndGoneOnWith) {
    compare.compareWith(setting("shading", kPhong));
    ASSERT_TRUE(compare.other().busy());
    document.work().cancel();
    EXPECT_TRUE(document.work().stopped().contains("the B of a comparison"));
    EXPECT_FALSE(compare.other().busy());
    QTest::qWait(300);
    EXPECT_FALSE(compare.other().frame());
    const auto said = compare.bar()->findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(said, [](const QLabel* label) { return label->text() == "B was stopped."; }));
    document.work().resume();
    EXPECT_TRUE(found());
    EXPECT_TRUE(document.work().stopped().isEmpty());
    // Another B is asked for anew.
    compare.compareWith(setting("camera.fov", 50));
    document.work().cancel();
    compareWith(setting("shading", kPhong));
    EXPECT_TRUE(document.work().stopped().isEmpty());
}

TEST_F(BufferCompareTest, AnotherPipelineDiffersByWhatTwoFramesDiffer) {
    compareWith(setting("shading", kPhong));
    compare.setMode(CompareMode::Difference);
    const auto a = *test::frameOf(ball(pipeline::Shading::Gouraud))->buffer({BufferId::Color});
    const auto b = *test::frameOf(ball(pipeline::Shading::Phong))->buffer({BufferId::Color});
    std::size_t differing = 0;
    for (std::size_t y = 0; y < a.rows(); ++y)
        for (std::size_t x = 0; x < a.columns(); ++x) {
            double largest = 0;
            for (int c = 0; c < 3; ++c) {
                const double e = a.value(x, y, c) - b.value(x, y, c);
                if (std::abs(e) > std::abs(largest)) largest = e;
            }
            differing += largest != 0;
            ASSERT_EQ(view.shown()->buffer.value(x, y), largest) << x << ", " << y;
        }
    EXPECT_GT(differing, 100u);
    EXPECT_EQ(compare.difference().found()->differing, differing);
    EXPECT_TRUE(isDifference(*view.shown()->buffer.info));
}

// The difference of the luminances is found once: nothing asks for it again while the frames stay.
TEST_F(BufferCompareTest, EachSideSaysWhichValueItHas) {
    compareWith(setting("shading", double(pipeline::Shading::Phong)));
    EXPECT_EQ(view.canvas()->wipe().nameA, "A  color, gouraud (shading)");
    EXPECT_EQ(view.canvas()->wipe().nameB, "B  color, phong (shading)");
}

TEST_F(BufferCompareTest, LuminanceIsComparedWithLuminance) {
    compareWith(setting("shading", kPhong));
    compare.setMode(CompareMode::Difference);
    view.features().channel->set(lessons::ShownChannel::Luminance);
    ASSERT_TRUE(found());
    const auto a = app::luminanceOf(*test::frameOf(ball(pipeline::Shading::Gouraud))->buffer({BufferId::Color}));
    const auto b = app::luminanceOf(*test::frameOf(ball(pipeline::Shading::Phong))->buffer({BufferId::Color}));
    double largest = 0;
    for (std::size_t i = 0; i < a.count(); ++i) largest = std::max(largest, std::abs(a.flat(i) - b.flat(i)));
    ASSERT_GT(largest, 0);
    EXPECT_EQ(std::abs(compare.difference().found()->largest), largest);
    QSignalSpy again(&compare, &app::BufferCompare::changed);
    QTest::qWait(200);
    EXPECT_EQ(again.count(), 0);
}

TEST_F(BufferCompareTest, TheWorstPixelIsPicked) {
    compareWith(setting("shading", kPhong));
    compare.goToWorst();
    ASSERT_TRUE(document.pointing().pixel());
    const auto& values = compare.difference().found()->values;
    const auto at = *document.pointing().pixel();
    EXPECT_EQ(std::abs(values.value(std::size_t(at.x), std::size_t(at.y))), compare.difference().found()->largest);
}

TEST_F(BufferCompareTest, ShiftShowsBWhileItIsHeld) {
    compareWith(setting("shading", kPhong));
    compare.setMode(CompareMode::A);
    const QImage a = canvas().seen().image;
    QTest::keyPress(&canvas(), Qt::Key_Shift);
    EXPECT_NE(canvas().seen().image, a);
    QTest::keyRelease(&canvas(), Qt::Key_Shift);
    EXPECT_EQ(canvas().seen().image, a);
}

TEST_F(BufferCompareTest, TheWipeFollowsItsHandle) {
    compareWith(setting("shading", kPhong));  // wipes at first
    ASSERT_TRUE(canvas().wipe().hasHandle);
    const QPoint handle(canvas().wipe().border(canvas().width()), 100);
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, handle);
    QMouseEvent move(QEvent::MouseMove, QPointF(80, 100), canvas().mapToGlobal(QPointF(80, 100)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&canvas(), &move);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, QPoint(80, 100));
    EXPECT_EQ(canvas().wipe().border(canvas().width()), 80);
    EXPECT_FALSE(document.pointing().pixel());  // dragging the handle picks nothing
}

// Whoever chooses B in a menu goes on with T, W and D, wherever the keys were before.
TEST_F(BufferCompareTest, TheViewTakesTheKeysWhenBIsChosen) {
    QMenu menu;
    app::fillCompareMenu(menu, compare, document, view.buffer());
    const auto inMenus = menu.findChildren<QAction*>() + menu.actions();
    const auto action = std::ranges::find_if(inMenus, [](const QAction* one) {
        return !one->menu() && !one->isSeparator() && one->isEnabled() && one->isCheckable();
    });
    ASSERT_NE(action, inMenus.end());
    view.activateWindow();
    ASSERT_TRUE(QTest::qWaitFor([&] { return QApplication::activeWindow() == &view; }, 5000));
    view.setFocusPolicy(Qt::StrongFocus);
    view.setFocus();
    ASSERT_FALSE(canvas().hasFocus());
    (*action)->trigger();
    EXPECT_TRUE(canvas().hasFocus());
}

TEST_F(BufferCompareTest, BBeforeTheLastChangeIsTheFrameOfTheSceneBefore) {
    document.change(*findSetting(document.scene(), "shading"), kPhong);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy(); }, 10000));
    compareWith({.kind = Kind::Before});
    const auto before = *test::frameOf(ball(pipeline::Shading::Gouraud))->buffer({BufferId::Color});
    const auto shown = *compare.other().frame()->buffer({BufferId::Color});
    for (std::size_t i = 0; i < before.count(); ++i) ASSERT_EQ(shown.flat(i), before.flat(i));
    EXPECT_GT(compare.difference().found()->differing, 0u);
}

TEST_F(BufferCompareTest, BFollowsWhenTheSceneChanges) {
    compareWith(setting("shading", kPhong));
    document.change(*findSetting(document.scene(), "shading"), kPhong);  // now A is the same
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return compare.difference().found() && compare.difference().found()->differing == 0; }, 10000));
}

TEST_F(BufferCompareTest, AnExportedArrayIsTheSameAsItsBuffer) {
    QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("color.npy").toStdString();
    const auto color = *document.frames().shown()->buffer({BufferId::Color});
    ASSERT_TRUE(pipeline::writeNpy({color, statistics(color), {}}, file));
    compareWith({.kind = Kind::File, .file = folder.filePath("color.npy")});
    EXPECT_EQ(compare.difference().found()->differing, 0u);
}

TEST_F(BufferCompareTest, AnExportedExrIsTheSameAsItsBuffer) {
    QTemporaryDir folder;
    for (const BufferId id : {BufferId::Color, BufferId::ZView, BufferId::Position}) {
        const QString file = folder.filePath(QString("%1.exr").arg(int(id)));
        pipeline::Scene scene = ball(pipeline::Shading::Gouraud);
        const auto buffer = *test::frameOf(scene, pipeline::setOf({id}))->buffer({id});
        ASSERT_TRUE(pipeline::writeExr({buffer, statistics(buffer), {}}, file.toStdString()));
        const auto read = app::readPicture(file, buffer);
        ASSERT_TRUE(read) << format(read.errors().front());
        ASSERT_EQ(read->shape, buffer.shape);
        for (std::size_t i = 0; i < buffer.count(); ++i) ASSERT_EQ(read->flat(i), buffer.flat(i)) << i;
    }
    const auto color = *document.frames().shown()->buffer({BufferId::Color});
    const auto wrong = app::readPicture(folder.filePath(QString("%1.exr").arg(int(BufferId::Position))), color);
    ASSERT_FALSE(wrong) << "a vector is no colour";
    EXPECT_NE(format(wrong.errors().front()).find("its channels are X Y Z"), std::string::npos);
    QFile out(folder.filePath("broken.exr"));
    EXPECT_TRUE(out.open(QIODevice::WriteOnly) && out.write("nothing") == 7);
    out.close();
    const auto broken = app::readPicture(folder.filePath("broken.exr"), color);
    ASSERT_FALSE(broken);
    EXPECT_NE(format(broken.errors().front()).find("broken.exr"), std::string::npos);
    ASSERT_TRUE(pipeline::writeExr({color, statistics(color), {}}, folder.filePath("color.exr").toStdString()));
    compareWith({.kind = Kind::File, .file = folder.filePath("color.exr")});
    EXPECT_EQ(compare.difference().found()->differing, 0u);
}

TEST_F(BufferCompareTest, AFileThatIsNoArrayIsRefusedWithItsName) {
    QTemporaryDir folder;
    const QString file = folder.filePath("broken.npy");
    const auto refusal = [&](const QByteArray& bytes) {
        QFile out(file);
        EXPECT_TRUE(out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size());
        out.close();
        const auto read = app::readPicture(file, *document.frames().shown()->buffer({BufferId::Color}));
        return read ? std::string("read") : format(read.errors().front());
    };
    EXPECT_NE(refusal("nothing").find("broken.npy: no NumPy array"), std::string::npos);
    const QByteArray magic("\x93NUMPY\x01\x00\xff\x00", 10);
    EXPECT_NE(refusal(magic + "{}").find("ends within its header"), std::string::npos);
    QByteArray header("{'descr': '<f4', 'fortran_order': False, 'shape': (99999999999, 99999999999, 3), }\n");
    const QByteArray sized = QByteArray("\x93NUMPY\x01\x00", 8) + char(header.size()) + '\0' + header;
    EXPECT_NE(refusal(sized + "1234").find("4 bytes of numbers"), std::string::npos);
    // Of fewer dimensions than the buffer: nobody may ask for its columns.
    for (const char* shape : {"", "1,"}) {
        const QByteArray head = QByteArray("{'descr': '<f4', 'fortran_order': False, 'shape': (") + shape + "), }\n";
        const QByteArray few = QByteArray("\x93NUMPY\x01\x00", 8) + char(head.size()) + '\0' + head + "1234";
        EXPECT_NE(refusal(few).find("expected 3"), std::string::npos) << refusal(few);
    }
}

// Numbers of any type may be compared with verdicts, which are whole ones.
TEST_F(BufferCompareTest, VerdictsAreDrawnWhateverTheirTypeIs) {
    const std::vector<float> numbers{-1, 0, 3, -1};
    pipeline::AnyBuffer verdicts{{BufferId::ShadowVerdict, 0},
                                 &bufferInfo(BufferId::ShadowVerdict),
                                 {2, 2},
                                 std::span<const float>(numbers),
                                 {}};
    const std::vector<std::int32_t> ids{0, 0, 0, 0};
    const pipeline::AnyBuffer polygons{
        {BufferId::PolygonId}, &bufferInfo(BufferId::PolygonId), {2, 2}, std::span<const std::int32_t>(ids), {}};
    EXPECT_EQ(app::drawnElements(verdicts, polygons, {}), (std::vector<bool>{false, true, true, false}));
}

TEST_F(BufferCompareTest, EveryStageIsListedWithWhatDiffers) {
    compareWith(setting("shading", kPhong));
    auto& stages = *view.findChild<app::StageDifferences*>();
    stages.open({600, 500});
    const auto buffersBelow = [&](const QString& title, const QString& name) {
        const auto tops = stages.list().findItems(title, Qt::MatchExactly);
        for (int i = 0; !tops.isEmpty() && i < tops[0]->childCount(); ++i)
            if (tops[0]->child(i)->text(0) == name) return tops[0]->child(i)->text(1);
        return QString();
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return buffersBelow("6 Shading", "color").contains(" of "); }, 10000));
    EXPECT_EQ(buffersBelow("1 Transform", "vertices.screen"), "the same");  // shading moves no vertex
    EXPECT_EQ(buffersBelow("5 Z-buffer", "z_view"), "the same");
}

// The shape of B is made of its tessellation: made anew at every look it would be another mesh, and its frame never there.
TEST_F(BufferCompareTest, AnotherTessellationComesToAnEnd) {
    pipeline::Scene scene = ball(pipeline::Shading::Gouraud);
    scene.objects[0].shape = pipeline::Shape{pipeline::ShapeKind::Sphere, 4};
    scene.objects[0].mesh = makeShape(*scene.objects[0].shape);
    scene.objects[0].transform.scale = pipeline::Vec3d(150);
    document.setScene(scene);
    compareWith(setting("object.0.tessellation", 8));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !compare.other().busy(); }, 10000));
    EXPECT_GT(compare.difference().found()->differing, 0u);
    // Nor is it made anew for a change that leaves it as it is.
    const pipeline::FramePtr before = compare.other().frame();
    scene.lights[0].intensity = 60;
    document.replace(scene, "darker");
    EXPECT_TRUE(QTest::qWaitFor([&] { return found() && !compare.other().busy() && compare.other().frame() != before; },
                                10000));
    EXPECT_EQ(compare.other().frame()->scene().objects[0].mesh, before->scene().objects[0].mesh);
}

TEST_F(BufferCompareTest, AFileIsListedByStageWithTheOneBufferThatItHas) {
    QTemporaryDir folder;
    const QString file = folder.filePath("color.npy");
    const auto color = *document.frames().shown()->buffer({BufferId::Color});
    ASSERT_TRUE(pipeline::writeNpy({color, statistics(color), {}}, file.toStdString()));
    compareWith({.kind = Kind::File, .file = file});
    auto& stages = *view.findChild<app::StageDifferences*>();
    stages.open({600, 500});
    const QTreeWidget& list = stages.list();
    ASSERT_TRUE(QTest::qWaitFor([&] { return list.topLevelItemCount() == 1; }, 10000));
    EXPECT_EQ(list.topLevelItem(0)->text(0), "6 Shading");
    ASSERT_EQ(list.topLevelItem(0)->childCount(), 1);
    EXPECT_EQ(list.topLevelItem(0)->child(0)->text(0), "color");
    EXPECT_EQ(list.topLevelItem(0)->child(0)->text(1), "the same");
}

TEST(OtherChoices, OfferOtherValuesOfChoicesThatHaveAnEffectAndNoOther) {
    const auto frame = test::frameOf(test::pyramid());
    QStringList texts;
    for (const app::OtherChoice& choice : app::otherChoices(*frame, {BufferId::ZView}, false, {})) {
        if (choice.group.isEmpty() && choice.source.kind == Kind::Before) {
            EXPECT_FALSE(choice.whyNot.isEmpty());  // nothing has been changed
        }
        texts << (choice.group + ' ' + choice.text);
    }
    EXPECT_TRUE(texts.contains("Another pipeline/Shading gouraud"));
    EXPECT_FALSE(texts.contains("Another pipeline/Shading flat"));  // the pyramid's own
    EXPECT_TRUE(texts.contains("Another pipeline/Visibility painter"));
    EXPECT_TRUE(texts.contains("Another buffer n_dot_l.0"));
    EXPECT_FALSE(texts.contains("Another buffer color"));  // three channels against one
}

TEST(OtherBuffer, OfThePreviousStageStandsOnThePicture) {
    const auto before = [](BufferId id) {
        return app::otherBuffer({.kind = Kind::PreviousStage}, {id}, test::pyramid());
    };
    EXPECT_EQ(before(BufferId::Color), (pipeline::BufferName{BufferId::ZView}));
    EXPECT_EQ(before(BufferId::ZView), (pipeline::BufferName{BufferId::PolygonsNormal}));  // not the texels of stage 4
    EXPECT_EQ(before(BufferId::VerticesScreen), std::nullopt);
}
