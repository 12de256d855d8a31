// What the window writes: nothing is lost without a question, and what cannot be written is told as that.
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <deque>

#include "app/buffer_view/buffer_view.h"
#include "app/check/check_panel.h"
#include "app/commands/actions.h"
#include "app/document/recent_files.h"
#include "app/document/session_file.h"
#include "app/lesson/lesson_panel.h"
#include "app/talk/cue_panel.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "app/widgets/save_dialog.h"
#include "pipeline/formats/built_in_scenes.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

QByteArray readAll(const QString& file) {
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

void write(const QString& file, const QByteArray& text) {
    QFile out(file);
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(text);
}

class WindowFiles : public WindowTest {
protected:
    QString reported() { return find<ErrorList>("errorList")->isVisible() ? find<ErrorList>("errorList")->text() : ""; }
    // A file that is no lesson's is open, and changed.
    void changeTwoPyramids() {
        ASSERT_TRUE(window.openFile(ownScene("two_pyramids.scene", folder.path())));
        ASSERT_TRUE(waitForFrame());
        document().change(*findSetting(document().scene(), "camera.theta"), 47.25);
        ASSERT_TRUE(document().isChanged());
    }
};

// By its folder and by its file; what is wrong in it is told with its place.
TEST_F(WindowFiles, ALessonOpensLikeAnyFile) {
    const QDir mine(folder.filePath("mine"));
    ASSERT_TRUE(QDir().mkpath(mine.path()));
    const auto write = [&](const QByteArray& page) {
        QFile file(mine.filePath("lesson.md"));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("title: Mine\nlecture: L\nsummary: S.\nscene: pyramid\n\n# First\n\n" + page);
    };
    auto* lessons = window.findChild<LessonPanel*>();
    write("2 + 3 is {2 + 3}.\n");
    for (const QString& file : {mine.path(), mine.filePath("lesson.md")}) {
        lessons->close();
        ASSERT_TRUE(window.openFile(file));
        ASSERT_TRUE(waitForFrame());
        ASSERT_NE(lessons->lesson(), nullptr);
        EXPECT_EQ(lessons->lesson()->title, "Mine");
        EXPECT_TRUE(lessons->isVisible());
    }
    write("{nothing}\n");
    EXPECT_FALSE(window.openFile(mine.path()));
    auto* errors = window.centralWidget()->findChild<ErrorList*>();
    EXPECT_TRUE(errors->isVisible());
    EXPECT_EQ(lessons->lesson()->title, "Mine") << "the one before is still open";
}

TEST_F(WindowFiles, ALessonOfASceneThatWasClosedIsShownAgain) {
    window.lessons().open("pyramid");
    ASSERT_TRUE(waitForFrame());
    window.actions()[ActionId::Close]->trigger();
    ASSERT_FALSE(window.views().isVisible());
    window.lessons().open("pyramid");
    EXPECT_TRUE(window.views().isVisible());
}

TEST_F(WindowFiles, ACaseAsASceneAsksBeforeChangesAreLost) {
    changeTwoPyramids();
    window.actions()[ActionId::Check]->trigger();
    auto* checks = window.findChild<CheckPanel*>();
    ASSERT_NE(checks, nullptr);
    std::size_t which = 0;
    while (!pipeline::check::caseTable()[which].scene) ++which;
    checks->select(which);
    answer("Cancel", [checks] { EXPECT_FALSE(checks->openAsScene()); });
    EXPECT_EQ(document().scene().camera.theta, 47.25);
    answer("Discard", [checks] { EXPECT_TRUE(checks->openAsScene()); });
    EXPECT_NE(document().scene().name, "two_pyramids.scene");
    checks->close();
}

TEST_F(WindowFiles, WhatCannotBeWrittenIsNotSaidToBeUnread) {
    changeTwoPyramids();
    EXPECT_FALSE(document().save(folder.filePath("missing/mine.toml")));
    EXPECT_TRUE(reported().startsWith("mine.toml could not be written. Nothing has changed."))
        << reported().toStdString();
    EXPECT_TRUE(document().isChanged());

    CueModel& model = window.cues().model();
    model.clear();
    write(folder.filePath("file"), "");
    press("Ctrl+B");
    const QString before = model.file();
    const std::string scene = model.cue(0).state.scene;
    EXPECT_FALSE(model.saveAs(folder.filePath("file/talk.cues")));  // a file is no folder
    EXPECT_TRUE(reported().startsWith("talk.cues could not be written. The cues are still here."))
        << reported().toStdString();
    EXPECT_EQ(model.file(), before) << "later changes still go to the file before";
    EXPECT_EQ(model.cue(0).state.scene, scene);
    EXPECT_TRUE(model.saveAs(folder.filePath("talk.cues")));
    EXPECT_EQ(model.file(), folder.filePath("talk.cues"));
    EXPECT_TRUE(readAll(folder.filePath("talk.cues")).contains("[[cue]]"));
}

// Somebody edits the list's file beside the window, or another window does.
TEST_F(WindowFiles, AListThatSomeoneElseHasWrittenToIsNotWrittenOver) {
    openPyramid();
    CueModel& model = window.cues().model();
    model.clear();
    const QString file = folder.filePath("talk.cues");
    ASSERT_TRUE(model.saveAs(file));
    press("Ctrl+B");
    ASSERT_TRUE(model.write());
    const QByteArray theirs = readAll(file).replace("[[cue]]", "# mine\n[[cue]]\ncaption = \"By hand\"");
    write(file, theirs);

    model.setNote(0, "In the window");
    EXPECT_TRUE(QTest::qWaitFor([&] { return reported().contains("someone else has written to it"); }, 5000));
    EXPECT_EQ(readAll(file), theirs);
    EXPECT_TRUE(reported().startsWith("talk.cues could not be written. The cues are still here."))
        << reported().toStdString();
    write(folder.filePath("other.cues"), "");
    EXPECT_FALSE(window.openFile(folder.filePath("other.cues")));
    model.clear();
    ASSERT_EQ(model.size(), 1) << "the list is neither left nor given up";
    EXPECT_EQ(model.cue(0).note, "In the window");
    answer("Cancel", [this] { EXPECT_FALSE(window.close()); });
    EXPECT_EQ(readAll(file), theirs);

    ASSERT_TRUE(model.saveAs(folder.filePath("mine.cues")));
    EXPECT_TRUE(readAll(folder.filePath("mine.cues")).contains("In the window"));
    EXPECT_EQ(readAll(file), theirs);
    ASSERT_TRUE(model.open(file));
    model.setCurrent(0);
    write(file, QByteArray(theirs).replace("By hand", "By hand again"));
    model.setNote(0, "Given up");
    ASSERT_TRUE(model.readAgain());
    EXPECT_EQ(model.current(), 0) << "the cue on show is still that";
    EXPECT_EQ(model.cue(0).caption, "By hand again");
    EXPECT_EQ(model.cue(0).note, "");
    model.setNote(0, "Kept");
    EXPECT_TRUE(model.write()) << "it is the file that was read";
    EXPECT_TRUE(readAll(file).contains("# mine") && readAll(file).contains("Kept"));
}

TEST_F(WindowFiles, AListThatCannotBeWrittenIsNotLeft) {
    openPyramid();
    CueModel& model = window.cues().model();
    model.clear();
    QDir(folder.path()).mkdir("talks");
    ASSERT_TRUE(model.saveAs(folder.filePath("talks/talk.cues")));
    ASSERT_TRUE(QDir(folder.filePath("talks")).removeRecursively());
    write(folder.filePath("talks"), "");  // a file is no folder
    press("Ctrl+B");
    write(folder.filePath("other.cues"), "");
    EXPECT_FALSE(model.open(folder.filePath("other.cues")));
    model.clear();
    EXPECT_EQ(model.size(), 1);
    EXPECT_TRUE(model.saveAs(folder.filePath("other.cues")));
}

// Types names into the dialogs where to save, and answers what is asked then.
class WindowSaves : public WindowFiles {
protected:
    WindowSaves() {
        QObject::connect(&user, &QTimer::timeout, &window, [this] {
            QWidget* modal = QApplication::activeModalWidget();
            if (auto* box = qobject_cast<QMessageBox*>(modal)) {
                asked << box->text();
                const auto button = answers.empty() ? QMessageBox::Yes : answers.front();
                if (!answers.empty()) answers.pop_front();
                box->button(button)->click();
            } else if (auto* dialog = qobject_cast<QFileDialog*>(modal)) {
                dialog->findChild<QLineEdit*>()->setText(folder.filePath(names.takeFirst()));
                QMetaObject::invokeMethod(dialog, "accept", Qt::DirectConnection);
            }
        });
        user.start(20);
    }
    QString ask(const QString& suffix) { return askWhereToSave(&window, "Save", "", "*." + suffix, suffix); }

    QStringList asked, names;
    std::deque<QMessageBox::StandardButton> answers;
    QTimer user;
};

TEST_F(WindowSaves, ANameWithoutItsEndingReplacesNoFileUnasked) {
    write(folder.filePath("talk.cues"), "mine");
    names = {"talk", "talk", "talk 2"};
    answers = {QMessageBox::No, QMessageBox::Yes};
    EXPECT_EQ(ask("cues"), folder.filePath("talk.cues")) << "after No and, asked anew, Yes";
    ASSERT_EQ(asked.size(), 2);
    EXPECT_TRUE(asked[0].startsWith("talk.cues already exists.")) << asked[0].toStdString();
    EXPECT_EQ(ask("cues"), folder.filePath("talk 2.cues"));
    EXPECT_EQ(asked.size(), 2) << "there is none of that name";
    names = {"talk 3"};
    EXPECT_EQ(askWhereToSave(&window, "Save", folder.path(), "Folders (*);;Cue lists (*.cues)", "cues"),
              folder.filePath("talk 3"))
        << "what was chosen is no list";
}

TEST_F(WindowSaves, ANameWithAnotherEndingGetsItsOwn) {
    write(folder.filePath("Fig. 3.png"), "mine");
    names = {"cube.obj", "lecture 1.2", "Fig. 3", "Talk.CUES"};
    EXPECT_EQ(ask("toml"), folder.filePath("cube.obj.toml"));
    EXPECT_EQ(ask("cues"), folder.filePath("lecture 1.2.cues"));
    EXPECT_EQ(asked.size(), 0);
    EXPECT_EQ(ask("png"), folder.filePath("Fig. 3.png"));
    ASSERT_EQ(asked.size(), 1);
    EXPECT_TRUE(asked[0].startsWith("Fig. 3.png already exists.")) << asked[0].toStdString();
    EXPECT_EQ(ask("cues"), folder.filePath("Talk.CUES"));
    ASSERT_TRUE(window.cues().model().saveAs(folder.filePath("Talk.CUES")));
    EXPECT_TRUE(window.openFile(folder.filePath("Talk.CUES"))) << "and it is a list when it is opened";
}

TEST_F(WindowSaves, ASceneSavedUnderAnotherNameIsARecentFile) {
    openPyramid();
    names = {"mine"};
    window.actions()[ActionId::SaveAs]->trigger();
    ASSERT_FALSE(recentFiles().empty());
    EXPECT_EQ(recentFiles().front().file, folder.filePath("mine.toml"));
}

TEST_F(WindowSaves, AHandoutAsksAboutBothOfItsFiles) {
    window.lessons().open("pyramid");
    ASSERT_TRUE(waitForFrame());
    write(folder.filePath("week1.v2-answers.html"), "mine");
    names = {"week1.v2"};
    auto* button = find<QPushButton>("writeHandout");
    button->click();
    ASSERT_EQ(asked.size(), 1);
    EXPECT_TRUE(asked[0].startsWith("week1.v2-answers.html already exists.")) << asked[0].toStdString();
    EXPECT_TRUE(QTest::qWaitFor([&] { return button->isEnabled(); }, 60000));
    EXPECT_TRUE(readAll(folder.filePath("week1.v2.html")).contains("<html"));
    EXPECT_NE(readAll(folder.filePath("week1.v2-answers.html")), "mine");
}

// Where the window finds a list of cues that somebody has written into, wrongly.
QString wrongListFile() { return SessionFile::usualFolder() + "/talk.cues"; }
constexpr char kWrongList[] = "[[cue]\nname = 'mine'\n";
struct WrongList {
    WrongList() {
        QDir().mkpath(SessionFile::usualFolder());
        for (const QString& name : QDir(SessionFile::usualFolder()).entryList({"talk*.cues"}))
            QFile::remove(SessionFile::usualFolder() + '/' + name);
        write(wrongListFile(), kWrongList);
    }
    ~WrongList() {
        QFile::remove(wrongListFile());
        QFile::remove(SessionFile::usualFolder() + "/talk 2.cues");
    }
};
class WindowWithAWrongList : private WrongList, public WindowFiles {};

TEST_F(WindowWithAWrongList, TheListIsToldAndNeverWrittenOver) {
    const QString words = "talk.cues could not be read. It stays as it is; new cues go into talk 2.cues.";
    EXPECT_TRUE(reported().startsWith(words)) << reported().toStdString();
    openPyramid();
    EXPECT_TRUE(reported().startsWith(words))
        << "a scene that opens hides it, the first time only: " << reported().toStdString();
    press("Ctrl+B");
    EXPECT_TRUE(QTest::qWaitFor([] { return QFile::exists(SessionFile::usualFolder() + "/talk 2.cues"); }, 5000));
    window.cues().model().clear();
    EXPECT_EQ(readAll(wrongListFile()), kWrongList);
    ASSERT_TRUE(window.openFile(resourceScene("two_pyramids.scene")));
    EXPECT_EQ(reported(), "");
}

// Its file is the program's: nothing is lost, and "Save as" is there.
TEST_F(WindowFiles, AMovedSliderInASceneOfTheProgramAsksNothing) {
    openPyramid();
    document().change(*findSetting(document().scene(), "camera.theta"), 47.25);
    EXPECT_TRUE(document().history().isEdited());
    EXPECT_TRUE(window.openFile(resourceScene("two_pyramids.scene")));
    EXPECT_EQ(document().scene().name, "two_pyramids.scene");
    document().change(*findSetting(document().scene(), "camera.theta"), 47.25);
    press("Ctrl+W");
    EXPECT_FALSE(window.views().isVisible());
}

// Not always the picture: the point of two pyramids is which of them the z-buffer keeps.
TEST_F(WindowFiles, ASceneOfTheProgramOpensWithWhatMakesItsPoint) {
    ASSERT_TRUE(window.openFile(resourceScene("two_pyramids.scene")));
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(document().stage(), pipeline::StageId::ZBuffer);
    EXPECT_EQ(window.views().first().buffer().text(), "polygon_id");
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes()) {
        EXPECT_FALSE(scene.look.empty()) << scene.name;
        EXPECT_EQ(scene.buffers.size(), scene.name == "pyramid" ? 0u : 2u) << scene.name;
    }
    ASSERT_TRUE(window.openFile(ownScene("two_pyramids.scene", folder.path())));
    EXPECT_EQ(window.views().first().buffer().text(), "z_view") << "one of the user's: the stage's own";
}

TEST_F(WindowFiles, AsksBeforeChangesAreLost) {
    ASSERT_TRUE(window.openFile(ownScene("pyramid.scene", folder.path())));
    ASSERT_TRUE(waitForFrame());
    document().change(*findSetting(document().scene(), "camera.theta"), 47.25);
    answer("Cancel", [this] { press("Ctrl+W"); });
    EXPECT_TRUE(document().isChanged());
    EXPECT_TRUE(window.views().isVisible());
    answer("Cancel", [this] { EXPECT_FALSE(window.openFile(resourceScene("two_pyramids.scene"))); });
    EXPECT_EQ(document().scene().name, "pyramid.scene");
    answer("Cancel", [this] { EXPECT_FALSE(window.close()); });
    answer("Discard", [this] { EXPECT_TRUE(window.openFile(resourceScene("two_pyramids.scene"))); });
    EXPECT_EQ(document().scene().name, "two_pyramids.scene");
    press("Ctrl+W");  // nothing has changed, and nothing is asked
    EXPECT_FALSE(window.views().isVisible());
}

TEST(RecentFiles, OfOneNameAreToldApartByTheirFolder) {
    EXPECT_EQ(recentNames({{"/a/scene.toml", {}}, {"/a/cube.obj", {}}, {"/b/scene.toml", {}}}),
              QStringList({"scene.toml  –  /a", "cube.obj", "scene.toml  –  /b"}));
}

}  // namespace
}  // namespace app
