// Files of strangers in the real window: what they hold is shown as it is, and nothing that it names is touched.
#include <sys/stat.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QSet>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTimer>
#include <QToolTip>

#include "app/commands/actions.h"
#include "app/desktop/main_window.h"
#include "app/document/scene_opener.h"
#include "app/lesson/lesson_panel.h"
#include "app/lesson/prose_view.h"
#include "app/study/study_panel.h"
#include "app/talk/cue_panel.h"
#include "app/widgets/error_list.h"
#include "pipeline/export/export_frame.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/run/runner.h"
#include "tests/app/window/window_fixture.h"
#include "tests/support/scenes.h"
#include "tests/support/studies.h"

namespace app {
namespace {

// A picture that would be read for ever if anything read it as HTML, and an element whose letters would be gone.
constexpr const char* kHostile = "<img src='/dev/zero'><b>x</b>";
// What would begin a line of its own, and colour a terminal.
constexpr const char* kLines = "one\ntwo\x1b[31m";

void writeForeign(const QString& file, const QByteArray& text) {
    QFile out(file);
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(text);
}

class ForeignText : public WindowTest {
protected:
    // All texts that the window has somewhere, by where they are.
    void expectPlain(const char* after) {
        SCOPED_TRACE(after);
        int labels = 0;
        for (QWidget* widget : QApplication::allWidgets()) {
            if (auto* label = qobject_cast<QLabel*>(widget)) {
                label->ensurePolished();
                ++labels;
                EXPECT_NE(label->textFormat(), Qt::AutoText) << nameOf(widget) << label->text().toStdString();
                if (label->textFormat() == Qt::RichText) expectNoForeignMarkup(label->text(), widget);
            }
            if (auto* browser = qobject_cast<QTextBrowser*>(widget)) {
                for (QTextBlock block = browser->document()->begin(); block.isValid(); block = block.next())
                    for (auto it = block.begin(); !it.atEnd(); ++it) {
                        const QTextCharFormat format = it.fragment().charFormat();
                        EXPECT_FALSE(format.isImageFormat() && !format.toImageFormat().name().startsWith("picture:"))
                            << nameOf(widget) << format.toImageFormat().name().toStdString();
                        EXPECT_TRUE(!format.isAnchor() || format.anchorHref().startsWith("http")) << nameOf(widget);
                    }
            }
            expectPlainTip(widget->toolTip(), widget);
            for (QAction* action : widget->actions()) expectPlainTip(action->toolTip(), widget);
            if (auto* view = qobject_cast<QAbstractItemView*>(widget); view && view->model())
                expectPlainRows(*view->model(), {}, widget);
        }
        EXPECT_GT(labels, 50) << "the window has labels";
        expectOneLine();
    }

    // Names with line ends, by which part of a text could pass for a line of ours.
    static void expectOneLine() {
        for (QWidget* widget : QApplication::allWidgets()) {
            expectOneLine(widget->windowTitle(), widget);
            expectOneLine(widget->toolTip(), widget);
            for (const QAction* action : widget->actions()) expectOneLine(action->text(), widget);
            if (const auto* label = qobject_cast<QLabel*>(widget)) expectOneLine(label->text(), widget);
            if (const auto* button = qobject_cast<QAbstractButton*>(widget)) expectOneLine(button->text(), widget);
            if (const auto* view = qobject_cast<QAbstractItemView*>(widget); view && view->model())
                for (int row = 0; row < std::min(view->model()->rowCount(), 200); ++row)
                    for (int column = 0; column < view->model()->columnCount(); ++column)
                        expectOneLine(view->model()->index(row, column).data().toString(), widget);
        }
    }
    static void expectOneLine(const QString& text, const QWidget* of) {
        EXPECT_FALSE(text.contains("one\ntwo") || text.contains(QChar(0x1b))) << nameOf(of) << text.toStdString();
    }

    // What Qt shows of a tip is a label too.
    void expectPlainTip(const QString& tip, const QWidget* of) {
        if (tip.isEmpty() || m_seen.contains(tip)) return;
        m_seen.insert(tip);
        if (!Qt::mightBeRichText(tip)) return;
        QToolTip::showText(QPoint(10, 10), tip, &window);
        bool found = false;
        for (QWidget* top : QApplication::topLevelWidgets())
            if (auto* label = qobject_cast<QLabel*>(top);
                label && label->inherits("QTipLabel") && label->text() == tip) {
                found = true;
                EXPECT_EQ(label->textFormat(), Qt::PlainText) << nameOf(of) << tip.toStdString();
                ++m_tips;
            }
        EXPECT_TRUE(found) << tip.toStdString();
        QToolTip::hideText();
    }
    void expectPlainRows(const QAbstractItemModel& model, const QModelIndex& parent, const QWidget* of) {
        for (int row = 0; row < std::min(model.rowCount(parent), 200); ++row)
            for (int column = 0; column < model.columnCount(parent); ++column) {
                const QModelIndex index = model.index(row, column, parent);
                expectPlainTip(index.data(Qt::ToolTipRole).toString(), of);
                if (column == 0 && !qobject_cast<const QComboBox*>(of->parentWidget()))
                    expectPlainRows(model, index, of);
            }
    }
    // HTML of ours: a foreign text in it is escaped, so that its letters are there, and no picture is.
    static void expectNoForeignMarkup(const QString& html, const QWidget* of) {
        QTextDocument document;
        document.setHtml(html);
        const QString text = document.toPlainText();
        EXPECT_FALSE(text.contains(QChar::ObjectReplacementCharacter)) << nameOf(of) << html.toStdString();
        EXPECT_EQ(text.count("<b>x</b>"), html.count("x&lt;/b&gt;")) << nameOf(of) << html.toStdString();
        EXPECT_FALSE(html.contains("<b>x")) << nameOf(of) << html.toStdString();
    }
    static std::string nameOf(const QWidget* widget) {
        QString name;
        for (; widget; widget = widget->parentWidget())
            name += QString("%1 %2 < ").arg(widget->metaObject()->className(), widget->objectName());
        return name.toStdString();
    }
    void waitForReading() {
        EXPECT_TRUE(QTest::qWaitFor([this] { return !window.opener().busy(); }, 30000));
    }
    bool isShown(const QString& part) {
        for (QWidget* widget : QApplication::allWidgets())
            if (auto* label = qobject_cast<QLabel*>(widget); label && label->text().contains(part)) return true;
        return false;
    }
    QByteArray scene() const {
        return QByteArray(
                   "title = \"T\"\nlook = "
                   "\"T\"\n[camera]\nkind=\"look-at\"\neye=[0,-3,0]\n[[light]]\nposition=[0,-5,1]\n"
                   "intensity=100\n[[object]]\nname = \"T\"\nshape=\"box\"\n")
            .replace("\"T\"", QByteArray("\"") + kHostile + "\"");
    }

    QSet<QString> m_seen;
    int m_tips = 0;
};

TEST_F(ForeignText, OfASceneIsShownAsItIsEverywhere) {
    writeForeign(folder.filePath("s.toml"), scene());
    ASSERT_TRUE(window.openFile(folder.filePath("s.toml")));
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(document().scene().name, kHostile);
    EXPECT_TRUE(isShown(kHostile)) << "the title";
    EXPECT_TRUE(window.windowTitle().startsWith(kHostile));
    document().pointing().pick(
        glm::ivec2(document().scene().settings.width / 2, document().scene().settings.height / 2));
    ASSERT_TRUE(waitForFrame());
    for (ActionId id : {ActionId::CopyState}) window.actions()[id]->trigger();
    expectPlain("a scene, a pixel of its object picked");
    EXPECT_TRUE(isShown(QString(kHostile).toHtmlEscaped())) << "the object's name in why";
}

TEST_F(ForeignText, OfAModelIsShownAsItIsEverywhere) {
    writeForeign(folder.filePath("m.mtl"), QByteArray("newmtl ") + kHostile + "\nKd 1 0 0\nmap_Kd " + kHostile + "\n");
    writeForeign(folder.filePath("m.obj"), QByteArray("mtllib m.mtl\nmtllib ") + kHostile + "\no " + kHostile +
                                               "\nusemtl " + kHostile +
                                               "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl <b>x</b>\nf 3 2 1\n");
    ASSERT_TRUE(window.openFile(folder.filePath("m.obj")));
    ASSERT_TRUE(waitForFrame());
    document().pointing().pick(
        glm::ivec2(document().scene().settings.width / 2, document().scene().settings.height / 2));
    ASSERT_TRUE(waitForFrame());
    ASSERT_FALSE(document().scene().objects.empty());
    EXPECT_NE(document().scene().objects[0].name.find("<img"), std::string::npos);
    expectPlain("a model");
    writeForeign(folder.filePath("bad.obj"), QByteArray("o ") + kHostile + "\nv 0 0 " + kHostile + "\nf 1 2 3\n");
    window.openFile(folder.filePath("bad.obj"));
    waitForReading();
    expectPlain("a model that cannot be read");
}

TEST_F(ForeignText, OfAStudyIsShownAsItIs) {
    for (const char* text : {kHostile, kLines}) {
        pipeline::StudyReport report = test::sphereStudy();
        report.scene = text;
        report.references[0] = report.references[1] = report.whyNone[0] = report.errorWhy = text;
        writeForeign(folder.filePath("study.json"), QByteArray::fromStdString(studyFileText(report)));
        StudyPanel panel(document());
        panel.show();
        EXPECT_TRUE(panel.openStudy(folder.filePath("study.json")));
        expectPlain("a study");
        writeForeign(folder.filePath("study.json"), QByteArray("{\"format\": \"") + kHostile + "\"}");
        EXPECT_FALSE(panel.openStudy(folder.filePath("study.json")));
        expectPlain("no study");
    }
}

TEST_F(ForeignText, OfAPictureIsShownAsItIs) {
    pipeline::Scene scene = test::pyramid();
    scene.name = scene.objects[0].name = kHostile;
    pipeline::ExportRequest request;
    request.folder = folder.filePath("out").toStdString();
    request.formats = {"png"};
    request.buffers = {{pipeline::BufferId::Color}};
    request.state = "stage = \"shading\"\ncondition = \"<b>x</b>\"\n";
    ASSERT_TRUE(exportFrame(*test::frameOf(scene), request, {}));
    ASSERT_TRUE(window.openFile(folder.filePath("out/color.png")));
    ASSERT_TRUE(waitForFrame());
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().scene().name == kHostile; }, 30000));
    document().pointing().pick(glm::ivec2(scene.settings.width / 2, scene.settings.height / 2));
    ASSERT_TRUE(waitForFrame());
    expectPlain("a picture that carries its scene");
}

TEST_F(ForeignText, WithLineEndsStaysOnOneLine) {
    const QString name = QString("one\ntwo\x1b[31m.toml");
    writeForeign(folder.filePath(name), scene().mid(scene().indexOf("look")));  // its title is the file's name
    ASSERT_TRUE(window.openFile(folder.filePath(name)));
    ASSERT_TRUE(waitForFrame());
    document().pointing().pick(
        glm::ivec2(document().scene().settings.width / 2, document().scene().settings.height / 2));
    ASSERT_TRUE(waitForFrame());
    expectPlain("a scene of lines");
    EXPECT_TRUE(window.windowTitle().startsWith("one?two?[31m.toml")) << window.windowTitle().toStdString();
    ASSERT_TRUE(document().save(folder.filePath("saved " + name)));
    expectPlain("saved");
    writeForeign(folder.filePath("bad " + name), "x");
    window.openFile(folder.filePath("bad " + name));
    waitForReading();
    expectPlain("an error about a file of lines");
    writeForeign(folder.filePath(name + ".cues"), "[[cue]]\nname = \"one\\ntwo\"\nscene = \"pyramid\"\n");
    window.cues().open(folder.filePath(name + ".cues"));
    waitForReading();
    expectPlain("cues in a file of lines");
}

// Qt takes what looks like markup for markup wherever nobody says otherwise.
TEST_F(ForeignText, NoLabelGuesses) {
    for (const char* text : {kHostile, "<qt>x", "<table><tr><td>x", "<!DOCTYPE html>x", "a<br>b"}) {
        QLabel label(text);
        label.setWordWrap(true);
        EXPECT_GT(label.sizeHint().width(), 0);
        EXPECT_EQ(label.textFormat(), Qt::PlainText) << text;
        QToolTip::showText(QPoint(10, 10), text, &window);
        expectPlainTip(text, &window);
        m_seen.clear();
        QTimer::singleShot(0, &window, [text] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_NE(box, nullptr);
            const auto labels = box->findChildren<QLabel*>();
            bool found = false;
            for (const QLabel* one : labels)
                if (one->text() == text) {
                    found = true;
                    EXPECT_EQ(one->textFormat(), Qt::PlainText) << text;
                }
            EXPECT_TRUE(found);
            box->reject();
        });
        QMessageBox::warning(&window, text, text);
    }
}

TEST_F(ForeignText, OfACueListAndAPastedStateIsShownAsItIs) {
    const QByteArray text = QByteArray(
                                "title = \"T\"\nminutes = 10\n[[cue]]\nname = \"T\"\ncaption = \"T\"\nnote = \"T\"\n"
                                "scene = \"pyramid\"\nstage = \"shading\"\narrangement = \"buffer\"\n"
                                "condition = \"T\"\n[[cue.view]]\nbuffer = \"depth\"\nagainst = \"file T\"\n"
                                "compare = \"difference\"\n")
                                .replace("T\"", QByteArray(kHostile) + "\"");
    writeForeign(folder.filePath("c.cues"), text);
    window.cues().open(folder.filePath("c.cues"));
    waitForReading();
    if (document().hasScene()) waitForFrame();
    expectPlain("a cue list");
    QApplication::clipboard()->setText(
        QString("scene = \"%1\"\nstage = \"%1\"\ncondition = \"%1\"\nwhat = \"%1\"\n").arg(kHostile));
    window.actions()[ActionId::PasteState]->trigger();
    waitForReading();
    expectPlain("a pasted state");
    EXPECT_TRUE(find<ErrorList>("errorList")->text().contains("<img"))
        << find<ErrorList>("errorList")->text().toStdString();
}

TEST_F(ForeignText, OfFilesThatCannotBeReadIsShownAsItIs) {
    const QString name = QString("<img src=x><b>x<b>.toml");  // no / in a file's name
    writeForeign(folder.filePath(name), "two_sided = tr\nucmea[eraa]\n");
    window.openFile(folder.filePath(name));
    waitForReading();
    const QString said = find<ErrorList>("errorList")->text();
    EXPECT_TRUE(said.contains("<img")) << said.toStdString();
    EXPECT_TRUE(said.contains("tr\\x0a")) << "a message is one line: " << said.toStdString();
    expectPlain("an error");
}

class ForeignLesson : public ForeignText {
protected:
    void open(const QByteArray& body) {
        ASSERT_TRUE(QDir().mkpath(folder.filePath("lesson")));
        writeForeign(folder.filePath("lesson/lesson.md"),
                     QByteArray("title: ") + kHostile + "\nlecture: " + kHostile + "\nsummary: " + kHostile +
                         "\nscene: pyramid\n\n# H " + kHostile +
                         "\nstage: shading\nbuffers: color\npixel: 268, 281\n\n" + body);
        ASSERT_TRUE(window.openFile(folder.filePath("lesson")));
        ASSERT_TRUE(waitForFrame());
    }
    QTextBrowser& page() { return *find<QTextBrowser>("lessonText"); }
    std::string shown() { return page().toPlainText().toStdString(); }
};

// Reading /dev/zero never ends, and opening a FIFO waits for somebody who writes.
TEST_F(ForeignLesson, NamesPicturesThatNobodyReads) {
    const QString fifo = folder.filePath("fifo");
    ASSERT_EQ(mkfifo(fifo.toLocal8Bit().constData(), 0600), 0);
    open("Text ![one](/dev/zero) and ![two](" + fifo.toLocal8Bit() + ") and ![three](../fifo) end\n\n" + kHostile +
         "\n\nquestion: Why ![four](/dev/zero)?\nanswer: 1\nhint: " + kHostile + "\n");
    EXPECT_EQ(shown().rfind("Text one (not shown: \"/dev/zero\" is no file of the lesson's folder", 0), 0u) << shown();
    EXPECT_NE(shown().find("two (not shown: "), std::string::npos) << shown();
    EXPECT_NE(shown().find(kHostile), std::string::npos) << "HTML as it was typed: " << shown();
    expectPlain("a lesson");
    find<LessonPanel>("lesson")->close();
    expectPlain("the list of lessons");
}

TEST_F(ForeignLesson, ShowsItsOwnPictureNoWiderThanItsText) {
    ASSERT_TRUE(QDir().mkpath(folder.filePath("lesson")));
    QImage wide(3000, 600, QImage::Format_RGB32);
    wide.fill(QColor(200, 30, 90));
    ASSERT_TRUE(wide.save(folder.filePath("lesson/own.png")));
    open("![own](own.png) ![again](./own.png)\n");
    EXPECT_EQ(shown().find("not shown"), std::string::npos) << shown();
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return page().document()->idealWidth() <= page().viewport()->width() + 1.0; }, 5000));
    const QImage seen = page().grab().toImage();
    int widest = 0;  // of a row
    for (int y = 0; y < seen.height(); ++y) {
        int red = 0;
        for (int x = 0; x < seen.width(); ++x) red += seen.pixelColor(x, y) == QColor(200, 30, 90);
        widest = std::max(widest, red);
    }
    EXPECT_GT(widest, seen.width() * 8 / 10) << "the picture is as wide as the text";
    expectPlain("a lesson with a picture");
}

TEST_F(ForeignLesson, ALinkOfItsOpensNoFile) {
    open(
        "[a](file:///etc/passwd) [b](../x.md) [c](/dev/zero) [d](javascript:alert(1)) [e](lesson.md) "
        "[f](https://example.org/)\n");
    EXPECT_EQ(shown(), "a b c d e f");
    int anchors = 0;
    for (QTextBlock block = page().document()->begin(); block.isValid(); block = block.next())
        for (auto it = block.begin(); !it.atEnd(); ++it)
            if (it.fragment().charFormat().isAnchor()) {
                ++anchors;
                EXPECT_EQ(it.fragment().charFormat().anchorHref(), "https://example.org/");
            }
    EXPECT_EQ(anchors, 1);
    EXPECT_FALSE(page().openLinks()) << "a click is ours to follow";
}

}  // namespace
}  // namespace app
