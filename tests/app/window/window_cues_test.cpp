// Cues: kept, shown again exactly, ordered; and presenting them.
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPlainTextEdit>
#include <QPointer>
#include <QTest>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/condition_bar.h"
#include "app/commands/actions.h"
#include "app/inspector/math_view.h"
#include "app/look/theme.h"
#include "app/talk/caption_line.h"
#include "app/talk/clean_view.h"
#include "app/talk/cue_panel.h"
#include "app/talk/notes_window.h"
#include "app/talk/pen_layer.h"
#include "app/talk/presentation.h"
#include "app/views/view_area.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowCues : public WindowTest {
protected:
    WindowCues() {
        model().clear();
        EXPECT_TRUE(model().saveAs(folder.filePath("talk.cues")));
    }
    CueModel& model() { return window.cues().model(); }
    void settle() {
        EXPECT_TRUE(waitForFrame());
        EXPECT_TRUE(
            QTest::qWaitFor([this] { return !document().frames().busy() && document().stepper().isSettled(); }, 30000));
        EXPECT_TRUE(test::waitUntilQuiet());
    }
    // Three cues that differ in scene, setting, place, buffer, zoom and pixel.
    void makeThree() {
        openPyramid();
        document().pointing().pick(glm::ivec2(268, 281));
        press("Ctrl+B");
        document().change(*findSetting(document().scene(), "camera.theta"), 47.25);
        settle();
        document().stepper().goTo(*pipeline::parsePlace("z-buffer/polygon=2"));
        settle();
        window.views().first().canvas()->placing().setZoom(8, QPointF(50, 60));
        press("Ctrl+B");
        // Given to the talk: not what was changed in the scene is asked for.
        document().history().stack()->setClean();
        ASSERT_TRUE(window.openFile(resourceScene("two_pyramids.scene")));
        settle();
        document().setStage(pipeline::StageId::Normals);
        settle();
        press("Ctrl+B");
        ASSERT_EQ(model().size(), 3);
    }
    // Pressed until it ends: on a slow machine Esc first stops what is computed, and does not end the talk right after.
    bool isLeftByEscape(QWidget& with) {
        const QPointer<QWidget> focus = &with;
        return QTest::qWaitFor(
            [&] {
                if (window.presentation().isOn() && focus) QTest::keyClick(focus.data(), Qt::Key_Escape);
                return !window.presentation().isOn();
            },
            30000);
    }
    struct Seen {
        std::string state;
        QImage picture;
        pipeline::FramePtr frame;
    };
    Seen see() {
        return {toToml(*window.shown().now(model().folder())), pictureOnScreen(), document().frames().shown()};
    }
};

TEST_F(WindowCues, ForthAndBackIsTheSame) {
    makeThree();
    std::vector<Seen> first;
    for (int i = 0; i < 3; ++i) {
        if (i == 0)
            for (int k = 0; k < 2; ++k) press("PgUp"), settle();
        else
            press("PgDown"), settle();
        first.push_back(see());
    }
    for (int i = 1; i >= 0; --i) {
        press("PgUp");
        settle();
        const Seen again = see();
        EXPECT_EQ(again.state, first[std::size_t(i)].state);
        EXPECT_EQ(again.picture, first[std::size_t(i)].picture) << i;
        for (const auto& name : pipeline::allBuffers(again.frame->scene().lights.size())) {
            const auto a = again.frame->buffer(name), b = first[std::size_t(i)].frame->buffer(name);
            if (!a || !b) continue;
            EXPECT_TRUE(a->data.index() == b->data.index() && a->count() == b->count()) << name.text();
            for (std::size_t k = 0; k < a->count(); k += 7) ASSERT_EQ(a->flat(k), b->flat(k)) << name.text();
        }
    }
    EXPECT_EQ(model().current(), 0);
    EXPECT_FALSE(window.actions()[ActionId::PreviousCue]->isEnabled());
}

TEST_F(WindowCues, TheListIsAFileThatOpensAgain) {
    makeThree();
    EXPECT_TRUE(model().rename(1, "Two polygons"));
    EXPECT_FALSE(model().rename(0, "Two polygons")) << "names are told apart";
    model().setNote(1, "Ask first.");
    model().write();
    const auto list = lessons::readCueFile(folder.filePath("talk.cues").toStdString());
    ASSERT_TRUE(list) << format(list.errors());
    ASSERT_EQ(list->cues.size(), 3u);
    EXPECT_EQ(list->cues[1].name, "Two polygons");
    EXPECT_EQ(list->cues[1].note, "Ask first.");
    EXPECT_EQ(list->cues[1].state.set, std::vector<std::string>{"camera.theta=47.25"});
    EXPECT_EQ(list->cues[2].state.scene, "two_pyramids");
    model().clear();
    EXPECT_TRUE(window.openFile(folder.filePath("talk.cues")));
    EXPECT_EQ(model().size(), 3);
    EXPECT_EQ(model().current(), 0);
}

// In a file beside, however often: nothing that was kept goes without a word.
TEST_F(WindowCues, ANewListPutsTheOwnOneAside) {
    model().clear();
    const QString own = model().file();
    makeThree();
    ASSERT_TRUE(model().write());
    QStringList asides;
    QObject::connect(&model(), &CueModel::putAside, &window, [&](const QString& file) { asides += file; });
    ASSERT_TRUE(model().saveAs(folder.filePath("lecture.cues")));
    model().clear();
    EXPECT_EQ(model().file(), own);
    EXPECT_EQ(model().size(), 0);
    ASSERT_EQ(asides.size(), 1);
    const auto kept = lessons::readCueFile(asides.front().toStdString());
    ASSERT_TRUE(kept) << format(kept.errors());
    EXPECT_EQ(kept->cues.size(), 3u);
    model().clear();
    EXPECT_EQ(asides.size(), 1) << "an empty list is not worth a file";
    QFile::remove(asides.front());
}

TEST_F(WindowCues, CuesMoveAreRemovedAndPutBackByKeys) {
    makeThree();
    QListView& list = window.docks().panels().cues->list();
    for (int i = 0; i < 3; ++i) model().rename(i, QString("ABC").mid(i, 1));
    const auto order = [&] {
        QString text;
        for (int i = 0; i < model().size(); ++i) text += QString::fromStdString(model().cue(i).name);
        return text;
    };
    EXPECT_EQ(model().current(), 2);
    list.setCurrentIndex(model().index(0));
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Down, Qt::AltModifier);
    EXPECT_EQ(order(), "BAC");
    model().move(2, 0);
    EXPECT_EQ(order(), "CBA");
    EXPECT_EQ(model().current(), 0) << "it is still C";
    list.setCurrentIndex(model().index(1));
    QTest::keyClick(&list, Qt::Key_Delete);
    EXPECT_EQ(order(), "CA");
    model().putBack();
    EXPECT_EQ(order(), "CBA");
    EXPECT_FALSE(model().canPutBack());
}

TEST_F(WindowCues, NotesAreWrittenToTheCueOnShow) {
    makeThree();
    auto* note = find<QPlainTextEdit>("cueNote");
    note->setPlainText("third");
    model().setCurrent(0);
    EXPECT_EQ(note->toPlainText(), "");
    note->setPlainText("first");
    EXPECT_EQ(model().cue(0).note, "first");
    EXPECT_EQ(model().cue(2).note, "third");
}

TEST_F(WindowCues, ACueWhoseSceneIsGoneLeavesEverythingAsItIs) {
    makeThree();
    lessons::Cue cue = model().cue(0);
    cue.state.scene = "gone.scene";
    model().setCurrent(2);
    model().add(cue);
    model().setCurrent(2);
    press("PgDown");
    EXPECT_EQ(model().current(), 2);
    EXPECT_EQ(document().scene().name, "two_pyramids.scene");
}

TEST_F(WindowCues, ACueThatWasNeverNamedDoesNotSayItsStageTwice) {
    openPyramid();
    press("Ctrl+B");
    ASSERT_EQ(model().cue(0).name, "Shading");
    press("Ctrl+F11");
    const auto* line = window.presentation().cleanView()->findChild<CaptionLine*>();
    EXPECT_EQ(line->accessibleName(), "Shading");
    model().setCaption(0, "R leaves away from the eye.");
    EXPECT_TRUE(QTest::qWaitFor([&] { return line->accessibleName() == "Shading. R leaves away from the eye."; }));
}

TEST_F(WindowCues, PresentingShowsViewsEquationAndCaptionAndLeavesNoTrace) {
    makeThree();
    model().setCaption(0, "R leaves away from the eye.");
    const double scale = Theme::current().scale();
    press("PgUp"), settle();
    press("PgUp"), settle();
    press("Ctrl+F11");
    ASSERT_TRUE(window.presentation().isOn());
    CleanView& view = *window.presentation().cleanView();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    const auto* hint = view.findChild<QLabel*>("cleanHint");
    EXPECT_TRUE(hint->isVisible() && hint->text().endsWith("Esc leaves"));
    QApplication::setActiveWindow(&view);
    settle();
    EXPECT_EQ(view.caption(), "R leaves away from the eye.");
    EXPECT_TRUE(view.findChild<MathView*>()->isVisible());
    EXPECT_EQ(view.views().first().buffer().id, pipeline::BufferId::Color);
    // No letters under 2 % of the height.
    for (const QLabel* label : view.findChildren<QLabel*>())
        if (label->isVisible() && !label->text().isEmpty()) {
            EXPECT_GE(label->font().pixelSize(), int(0.02 * view.screen()->size().height()))
                << label->text().toStdString();
        }
    QTest::keyClick(&view, Qt::Key_PageDown);
    EXPECT_FALSE(hint->isVisible()) << "from the first key on, and after a while by itself";
    EXPECT_EQ(view.shownKey(), "PgDown");
    settle();
    EXPECT_EQ(model().current(), 1);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.shownKey().isEmpty(); }, 5000));
    emit document().failed({pipeline::Error{{"gone.toml", 0, 0}, "no such file", {}}});
    EXPECT_EQ(view.shownKey(), "gone.toml could not be read") << "the window's list of errors is behind";
    EXPECT_FALSE(document().save(folder.filePath("missing/mine.toml")));
    EXPECT_EQ(view.shownKey(), "mine.toml could not be written");
    QTest::keyClick(&view, Qt::Key_H);
    EXPECT_TRUE(hint->isVisible() && hint->text().contains("spotlight"));
    EXPECT_TRUE(view.rect().contains(hint->geometry()));
    QTest::keyClick(&view, Qt::Key_B);
    EXPECT_FALSE(hint->isVisible());
    EXPECT_EQ(view.grab().toImage().pixelColor(view.width() / 2, view.height() / 2), QColor(Qt::black));
    QTest::keyClick(&view, Qt::Key_W);
    EXPECT_EQ(view.grab().toImage().pixelColor(view.width() / 2, view.height() / 2), QColor(Qt::white));
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(window.presentation().isOn()) << "first what covers the views goes";
    QTest::keyClick(&view, Qt::Key_P);
    EXPECT_TRUE(view.pen().hasPen());
    QTest::mousePress(&view.pen(), Qt::LeftButton, {}, {100, 100});
    QTest::mouseMove(&view.pen(), {300, 200});
    QTest::mouseRelease(&view.pen(), Qt::LeftButton, {}, {300, 200});
    EXPECT_TRUE(view.pen().hasLines());
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(view.pen().hasLines());
    EXPECT_TRUE(isLeftByEscape(view));
    EXPECT_EQ(Theme::current().scale(), scale);
}

// The views go while one of them has the focus.
TEST_F(WindowCues, PresentingEndsAfterAClickOnAPicture) {
    openPyramid();
    press("Ctrl+F11");
    CleanView& view = *window.presentation().cleanView();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    QApplication::setActiveWindow(&view);
    settle();
    BufferCanvas& canvas = *view.views().first().canvas();
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.rect().center());
    ASSERT_EQ(QApplication::focusWidget(), &canvas);
    EXPECT_TRUE(isLeftByEscape(canvas));
    EXPECT_TRUE(document().pointing().pixel());
}

TEST_F(WindowCues, PresentingShowsTheViewsAsTheyStandForthAndBack) {
    openPyramid();
    document().pointing().pick(glm::ivec2(268, 281));
    const std::vector<std::string> arrangements{"four", "2: buffer | 1: (buffer / 3d)", "compare"};
    for (const std::string& arrangement : arrangements) {
        ASSERT_TRUE(window.views().setArrangement(arrangement));
        settle();
        if (arrangement == "compare") window.views().first().canvas()->placing().setZoom(6, QPointF(50, 60));
        press("Ctrl+B");
    }
    press("Ctrl+F11");
    ASSERT_TRUE(window.presentation().isOn());
    CleanView& view = *window.presentation().cleanView();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    QApplication::setActiveWindow(&view);
    const auto frameOf = [&](lessons::ViewLeaf leaf) { return view.views().grid().views().frameOf(leaf); };
    // What the audience's views show, and the pictures of those that are buffers.
    const auto seen = [&](int cue) {
        settle();
        lessons::WindowState state;
        view.views().fill(state);
        EXPECT_EQ(state.arrangement, model().cue(cue).state.arrangement);
        EXPECT_EQ(state.linked, model().cue(cue).state.linked);
        const auto& kept = model().cue(cue).state.views;
        EXPECT_EQ(state.views.size(), kept.size());
        for (std::size_t i = 0; i < std::min(state.views.size(), kept.size()); ++i) {
            lessons::BufferShown shown = state.views[i];
            shown.zoom = kept[i].zoom;  // of views of other sizes
            EXPECT_EQ(shown, kept[i]);
        }
        std::vector<QImage> pictures;
        for (const lessons::ViewLeaf leaf : leavesOf(view.views().grid().tree())) {
            EXPECT_TRUE(frameOf(leaf)->isVisible());
            if (leaf.kind == lessons::ViewLeaf::Kind::Buffer)
                pictures.push_back(frameOf(leaf)->findChild<BufferCanvas*>()->grab().toImage());
        }
        return pictures;
    };
    QTest::keyClick(&view, Qt::Key_PageUp);
    QTest::keyClick(&view, Qt::Key_PageUp);
    std::vector<std::vector<QImage>> first;
    for (int cue = 0; cue < 3; ++cue) {
        if (cue > 0) QTest::keyClick(&view, Qt::Key_PageDown);
        first.push_back(seen(cue));
    }
    EXPECT_EQ(first[0].size(), 3u);
    // Views that are there to be compared move together, here too.
    EXPECT_TRUE(view.views().links().isOn());
    EXPECT_EQ(view.views().second().canvas()->placing().zoom(), view.views().first().canvas()->placing().zoom());
    for (int cue = 1; cue >= 0; --cue) {
        QTest::keyClick(&view, Qt::Key_PageUp);
        EXPECT_EQ(seen(cue), first[std::size_t(cue)]) << cue;
    }
    QTest::keyClick(&view, Qt::Key_1);
    using Kind = lessons::ViewLeaf::Kind;
    const auto shown = [&](int buffer) { return frameOf({Kind::Buffer, buffer})->isVisible(); };
    EXPECT_TRUE(shown(0) && !shown(1));
    QTest::keyClick(&view, Qt::Key_2);
    EXPECT_TRUE(shown(0) && shown(1));
    QTest::keyClick(&view, Qt::Key_1);
    QTest::keyClick(&view, Qt::Key_PageDown);
    seen(1);  // a cue has its own views
}

TEST_F(WindowCues, NotesHaveTheNextCueThePlaceAndTheTime) {
    makeThree();
    model().setNote(0, "Ask first.");
    model().setCurrent(0);
    NotesWindow notes(model(), window);
    notes.resize(1280, 720);
    notes.show();
    EXPECT_EQ(notes.place(), "cue 1 of 3");
    EXPECT_EQ(notes.notes(), "Ask first.");
    EXPECT_TRUE(notes.timer().startsWith("0:0")) << notes.timer().toStdString();
    EXPECT_TRUE(QTest::qWaitFor([&] { return notes.hasNextPicture(); }, 30000));
    Theme::current().set(ThemeId::Projector);
    Theme::current().setScale(CleanView::scaleFor(720));
    EXPECT_LE(notes.minimumSizeHint().width(), 1280) << "it fits a screen of 720 lines";
    Theme::current().setScale(1.25);
    model().setCurrent(2);
    EXPECT_EQ(notes.place(), "cue 3 of 3");
    EXPECT_FALSE(notes.hasNextPicture());
}

// Presentation looks at the keys that reach the window.
TEST_F(WindowCues, KeysAfterAClickOnACueReachTheNotesWindow) {
    makeThree();
    struct Keys : QObject {
        int count = 0;
        bool eventFilter(QObject*, QEvent* event) override {
            count += event->type() == QEvent::KeyPress ? 1 : 0;
            return false;
        }
    } keys;
    NotesWindow notes(model(), window);
    notes.installEventFilter(&keys);
    notes.resize(1280, 720);
    notes.show();
    QApplication::setActiveWindow(&notes);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&notes));
    int asked = -1;
    QObject::connect(&notes, &NotesWindow::asked, &notes, [&](int cue) { asked = cue; });
    auto* list = notes.findChild<QListView*>();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(model().index(1)).center());
    EXPECT_EQ(asked, 1);
    QWidget* target = QApplication::focusWidget() ? QApplication::focusWidget() : &notes;
    for (const Qt::Key key : {Qt::Key_B, Qt::Key_1}) QTest::keyClick(target, key);
    EXPECT_EQ(keys.count, 2);
}

}  // namespace
}  // namespace app
