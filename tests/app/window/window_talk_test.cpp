// How a talk looks, and that the window behind it is what it was.
#include <QFile>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <map>

#include "app/buffer_view/buffer_page.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/condition_bar.h"
#include "app/canvas/thumbnail_strip.h"
#include "app/compare/buffer_compare.h"
#include "app/compare/compare_bar.h"
#include "app/desktop/shown_state.h"
#include "app/desktop/window_cues.h"
#include "app/docks/panel_dock.h"
#include "app/frames/derived_buffers.h"
#include "app/inspector/math_view.h"
#include "app/look/theme.h"
#include "app/tables/algorithm_view.h"
#include "app/talk/ask_panel.h"
#include "app/talk/caption_line.h"
#include "app/talk/clean_view.h"
#include "app/talk/cue_panel.h"
#include "app/talk/notes_window.h"
#include "app/talk/pen_layer.h"
#include "app/talk/presentation.h"
#include "app/talk/talk_keys.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/view_area.h"
#include "app/widgets/segmented.h"
#include "app/widgets/value_slider.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowTalk : public WindowTest {
protected:
    void SetUp() override { openPyramid(); }
    CleanView& present() {
        press("Ctrl+F11");
        CleanView& view = *window.presentation().cleanView();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
        EXPECT_TRUE(waitForFrame());
        return view;
    }
};

// Letters as large as a talk's need more room than the window behind has.
TEST_F(WindowTalk, PanelsHaveTheirSizesAgainAfterwards) {
    const auto places = [this] {
        std::map<std::string, std::array<int, 4>> all;
        for (const PanelDock* dock : window.findChildren<PanelDock*>())
            if (const QRect r = dock->geometry(); !dock->visibleRegion().isEmpty())
                all[dock->objectName().toStdString()] = {r.x(), r.y(), r.width(), r.height()};
        return all;
    };
    const auto before = places();
    ASSERT_GT(before.size(), 3u);
    present();
    window.presentation().end();
    EXPECT_TRUE(QTest::qWaitFor([&] { return places() == before; }, 5000));
    EXPECT_EQ(places(), before);
}

// On a small screen with a large equation the views give way, not the caption below the screen's edge.
TEST_F(WindowTalk, TheCleanViewStaysAsLargeAsTheScreen) {
    document().setStage(pipeline::StageId::Shading);
    document().pointing().pick(glm::ivec2(268, 281));
    CleanView& view = present();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.findChild<MathView*>()->isVisible(); }, 30000));
    const QSize small(view.width(), view.layout()->totalMinimumSize().height() - 20);
    view.showNormal();
    view.resize(small);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.findChild<ViewArea*>()->geometry().bottom() < small.height(); }));
    EXPECT_EQ(view.size(), small);
    const auto* caption = view.findChild<CaptionLine*>();
    EXPECT_TRUE(view.rect().contains(caption->geometry())) << caption->geometry().bottom();
}

// The last key is shown beside the dots of the cues, and moves neither them nor the sentence.
TEST_F(WindowTalk, TheDotsOfTheCuesEndAtTheMargin) {
    CaptionLine line(nullptr);
    line.resize(900, line.sizeHint().height());
    line.setText("Shading", "R leaves away from the eye.");
    const auto picture = [&line] { return line.grab().toImage(); };
    const auto lastDifference = [](const QImage& a, const QImage& b) {
        int last = -1;
        for (int y = 0; y < a.height(); ++y)
            for (int x = last + 1; x < a.width(); ++x)
                if (a.pixel(x, y) != b.pixel(x, y)) last = x;
        return last;
    };
    const QImage bare = picture();
    line.setCues(5, 4);
    const QImage dots = picture();
    const double ratio = dots.devicePixelRatio();
    EXPECT_GE(lastDifference(dots, bare), (900 - 2) * ratio);
    line.setKey("Shift+F10");
    const QImage withKey = picture();
    const int room = int(50 * ratio);  // five dots of 6 and a longer one, four gaps of 5: at most 64
    EXPECT_EQ(withKey.copy(withKey.width() - room, 0, room, withKey.height()),
              dots.copy(dots.width() - room, 0, room, dots.height()));
    EXPECT_GT(lastDifference(withKey, dots), 0) << "the key is shown";
}

// Letters and digits of a condition are no keys of the presentation; Esc closes the bar first.
TEST_F(WindowTalk, AConditionIsTypedWhilePresenting) {
    CleanView& view = present();
    QApplication::setActiveWindow(&view);
    const QString condition = "2.01 - 1 < 10.2 && (polygon_id == 2 || polygon_id == 1)";
    BufferView& buffer = view.views().first();
    QTest::keyClick(buffer.canvas(), Qt::Key_Slash);
    auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, condition);
    EXPECT_EQ(field->text(), condition);
    EXPECT_EQ(view.pen().cover(), PenLayer::Cover::None);
    EXPECT_FALSE(view.pen().hasPen() || view.pen().hasSpotlight());
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_FALSE(buffer.condition().isVisible());
    EXPECT_TRUE(window.presentation().isOn());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_B);
    EXPECT_EQ(view.pen().cover(), PenLayer::Cover::Black);
}

// In place of the equation; in the window behind it is the panel that comes to the front.
TEST_F(WindowTalk, AShowsTheAlgorithmWithTheLineOfTheStep) {
    ASSERT_TRUE(QTest::qWaitFor([this] { return document().stepper().steps() != nullptr; }, 30000));
    CleanView& view = present();
    auto* algorithm = view.findChild<AlgorithmView*>();
    EXPECT_FALSE(algorithm->isVisible());
    EXPECT_TRUE(view.keys().take(Qt::Key_A));
    document().stepper().goTo(*pipeline::parsePlace("z-buffer/polygon=2/row=270/x=258/line=5"));
    EXPECT_TRUE(algorithm->isVisible());
    EXPECT_FALSE(algorithm->currentRect().isEmpty());
    EXPECT_TRUE(view.caption().contains("line 5")) << view.caption().toStdString();
    ASSERT_TRUE(waitForFrame());
    // Letters in pixels are a fifth of them: 2 % of the height can be read from the last row.
    EXPECT_GE(view.views().first().canvas()->placing().zoom() / 5, 0.02 * view.height());
    EXPECT_TRUE(window.shown().now()->algorithm);
    EXPECT_TRUE(view.keys().take(Qt::Key_A));
    EXPECT_FALSE(algorithm->isVisible());
}

// Both sides bear the value in which they differ; the bar below is the lecturer's.
TEST_F(WindowTalk, AComparisonHasNamesAndNoBar) {
    BufferView& shown = present().views().first();
    const auto hasTitle = [&] {
        return std::ranges::any_of(shown.canvas()->findChildren<QLabel*>(),
                                   [](QLabel* label) { return label->isVisible() && label->text() == "color"; });
    };
    EXPECT_TRUE(hasTitle());
    const auto shading = *findSetting(document().scene(), "shading");
    shown.findChild<BufferCompare*>()->compareWith(
        OtherSource{.kind = OtherSource::Kind::Setting, .setting = shading, .value = 1});
    EXPECT_TRUE(waitForFrame());
    EXPECT_FALSE(hasTitle());
    EXPECT_FALSE(shown.findChild<CompareBar*>()->isVisible());
    EXPECT_TRUE(QTest::qWaitFor([&] { return shown.canvas()->wipe().nameB == "Gouraud"; }, 10000))
        << shown.canvas()->wipe().nameB.toStdString();
    EXPECT_EQ(shown.canvas()->wipe().nameA, "Flat");
}

// A cue whose picture is three times as large: what fits is known with its frame, which comes after the state.
TEST_F(WindowTalk, ACueOfAnotherScaleIsFittedToItsOwnFrame) {
    BufferView& shown = present().views().first();
    lessons::WindowState state = *window.shown().now();
    state.set = {"camera.scale=3"};
    state.views[0].zoom.reset();
    window.files().showState(state, {}, SceneChanges::Given);
    window.presentation().lookAt(state);
    EXPECT_TRUE(waitForFrame());
    const auto isFitted = [&] { return shown.canvas()->placing().look().focus == shown.canvas()->content().focus; };
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return shown.shown() && isFitted() && shown.canvas()->content().focus.width() > 150; }, 10000))
        << "drawn are some 90 columns at scale 1";
}

// Symbols, numbers, result and the frame buffer: with Gouraud shading the pixel's own, not the first vertex' symbols.
TEST_F(WindowTalk, TheEquationEndsWithTheFrameBufferAndHasNumbersToItsSymbols) {
    document().change(*findSetting(document().scene(), "shading"), 1);
    document().pointing().pick(glm::ivec2(268, 281));
    CleanView& view = present();
    auto* math = view.findChild<MathView*>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return math->isVisible() && math->lines().size() == 4; }, 10000));
    const char* const roles[]{"symbols", "numbers", "result", "frame buffer"};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(math->lines()[i].role, roles[i]) << i;
}

// The painter's algorithm that splits nothing: the reason stands below its lines.
TEST_F(WindowTalk, WhyLinesAreLeftOutStandsBelowTheAlgorithm) {
    document().change(*findSetting(document().scene(), "visibility"), double(pipeline::Visibility::Painter));
    document().change(*findSetting(document().scene(), "split"), 0);
    ASSERT_TRUE(waitForFrame());
    CleanView& view = present();
    view.keys().take(Qt::Key_A);
    document().setStage(pipeline::StageId::ZBuffer);
    const auto* why = view.findChild<QLabel*>("algorithmLeftOut");
    ASSERT_TRUE(QTest::qWaitFor([&] { return why->isVisible(); }, 30000));
    EXPECT_TRUE(why->text().contains("left out. ")) << why->text().toStdString();
    EXPECT_TRUE(why->text().contains("split = off")) << why->text().toStdString();
}

// Two cues: the first asks, the second is its answer.
class AskingTalk : public WindowTalk {
protected:
    void SetUp() override {
        const QString file = folder.filePath("ask.cues");
        QFile out(file);
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(
            "[[cue]]\nname = \"ask\"\nask = \"Which?\"\nchoices = [\"One\", \"<b>Two</b>\", \"Three\"]\nright = \"B\"\n"
            "scene = \"pyramid\"\npixel = [268, 281]\n[[cue]]\nname = \"answer\"\ncaption = \"It is <2>: k_r.\"\n"
            "scene = \"pyramid\"\npixel = [268, 281]\n[[cue]]\nname = \"other\"\nscene = \"pyramid\"\n");
        out.close();
        ASSERT_TRUE(window.openFile(file));
        ASSERT_TRUE(waitForFrame());
    }
    CueModel& model() { return window.cues().model(); }
};

TEST_F(AskingTalk, AQuestionHasItsChoicesAndNoNumbersThenComesTheAnswer) {
    CleanView& view = present();
    auto& title = *view.findChild<QLabel*>("cueTitle");
    EXPECT_EQ(title.text(), "Which?");
    EXPECT_TRUE(view.ask().isVisible());
    EXPECT_FALSE(view.ask().isAnswer());
    EXPECT_FALSE(view.findChild<MathView*>()->isVisible()) << "no equation beside a question";
    EXPECT_EQ(view.ask().accessibleName(), "Which?. A: One; B: <b>Two</b>; C: Three");
    press("PgDown");
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(title.text(), "It is &lt;2&gt;: k<sub>r</sub>.") << "the file's text is text; symbols are set";
    EXPECT_TRUE(view.ask().isAnswer());
    EXPECT_TRUE(view.ask().accessibleName().contains("B: <b>Two</b>, right"));
    press("PgDown");
    ASSERT_TRUE(waitForFrame());
    EXPECT_FALSE(title.isVisible());
    EXPECT_FALSE(view.ask().isVisible());
    press("PgUp");
    press("PgUp");
    EXPECT_EQ(title.text(), "Which?");
}

TEST_F(AskingTalk, VotesAreTypedAndStayWithTheirQuestion) {
    CleanView& view = present();
    EXPECT_TRUE(view.keys().take(Qt::Key_B)) << "a choice, not the black screen";
    EXPECT_EQ(view.ask().field(), 1);
    for (const int key : {Qt::Key_2, Qt::Key_1, Qt::Key_Tab, Qt::Key_9}) EXPECT_TRUE(view.keys().take(key));
    EXPECT_EQ(model().votes(0), (std::vector<int>{0, 21, 9}));
    EXPECT_EQ(view.caption(), "30 votes so far.");
    EXPECT_TRUE(view.keys().take(Qt::Key_B));
    EXPECT_TRUE(view.keys().take(Qt::Key_7));
    EXPECT_EQ(model().votes(0)[1], 7) << "typed anew it replaces";
    EXPECT_TRUE(view.keys().take(Qt::Key_Escape)) << "leaves the field, not the talk";
    EXPECT_EQ(view.ask().field(), -1);
    EXPECT_TRUE(window.presentation().isOn());
    press("PgDown");
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(view.caption(), "7 of 16 votes were right.");
    press("PgUp");
    EXPECT_EQ(model().votes(0), (std::vector<int>{0, 7, 9}));
}

// For one who measures there are chips with counts, buttons and a legend to press; a hall has the picture and its words.
TEST_F(WindowTalk, AHallSeesNoCountsAndNothingToPress) {
    CleanView& view = present();
    BufferView& buffer = view.views().first();
    buffer.setBuffer({pipeline::BufferId::Overdraw});
    ASSERT_TRUE(waitForFrame());
    ASSERT_TRUE(QTest::qWaitFor([&] { return buffer.shown() && buffer.isCurrent(); }, 10000));
    EXPECT_TRUE(buffer.shown()->notice.isEmpty()) << buffer.shown()->notice.toStdString();
    const auto* legend = view.views().view3d().view().findChild<QWidget*>("legend");
    ASSERT_TRUE(waitForFrame());
    EXPECT_FALSE(legend->isVisible()) << "no pixel is picked: no vector is drawn";
    document().pointing().pick(glm::ivec2(268, 281));
    EXPECT_TRUE(QTest::qWaitFor([&] { return legend->isVisible(); }, 10000));
    document().derived().setText("x < 300");
    buffer.condition().reveal();
    for (const QWidget* part : buffer.condition().findChildren<QToolButton*>()) EXPECT_FALSE(part->isVisible());
    EXPECT_FALSE(buffer.condition().findChild<QLineEdit*>()->isVisible());
    buffer.setBuffer({pipeline::BufferId::ShadowBuffer, 0});
    ASSERT_TRUE(QTest::qWaitFor([&] { return buffer.message().contains("left out"); }, 10000));
    const auto* page = buffer.findChild<BufferPage*>();
    EXPECT_FALSE(page->findChild<QPushButton*>()->isVisible());
    EXPECT_EQ(page->findChild<QLabel*>()->text(), "shadow_buffer.0");
    EXPECT_TRUE(page->findChild<QLabel*>()->isVisible());
}

namespace {

// Counts how often a hall would see what belongs to the desk.
class Flashes : public QObject {
public:
    Flashes() { qApp->installEventFilter(this); }
    int count = 0;
    bool eventFilter(QObject* object, QEvent* event) override {
        const bool isOfDesk = qobject_cast<CompareBar*>(object) || qobject_cast<ThumbnailStrip*>(object);
        if (event->type() == QEvent::Paint && isOfDesk)
            count += qobject_cast<CleanView*>(static_cast<QWidget*>(object)->window()) != nullptr;
        return false;
    }
};

}  // namespace

TEST_F(WindowTalk, BarsOfComparisonsAndThumbnailsNeverFlash) {
    const QString file = folder.filePath("talk.cues");
    QFile cues(file);
    ASSERT_TRUE(cues.open(QFile::WriteOnly));
    const char* compared =
        "arrangement = \"compare\"\n[[cue.view]]\nbuffer = \"color\"\n"
        "against = \"setting ambient.intensity=0\"\ncompare = \"b\"\n[[cue.view]]\nbuffer = \"color\"\n";
    for (const char* name : {"One", "Two", "Three"}) {
        cues.write(QByteArray("[[cue]]\nname = \"") + name + "\"\nscene = \"pyramid\"\n");
        if (name != std::string_view("Two")) cues.write(compared);
    }
    cues.close();
    ASSERT_TRUE(window.cues().open(file));
    const Flashes flashes;
    present();
    for (const char* key : {"PgDown", "PgDown", "PgUp", "PgUp"}) {
        press(key);
        ASSERT_TRUE(waitForFrame());
    }
    EXPECT_EQ(flashes.count, 0);
}

// A presenter moves it with the mouse; a clicker's keys go on turning the cues.
TEST_F(WindowTalk, APinnedSettingIsASliderThatLeavesTheKeysToTheTalk) {
    const QString file = folder.filePath("talk.cues");
    QFile cues(file);
    ASSERT_TRUE(cues.open(QFile::WriteOnly));
    cues.write(
        "[[cue]]\nname = \"One\"\nscene = \"pyramid\"\nsliders = [\"light.0.intensity\", \"shading\"]\n"
        "[[cue]]\nname = \"Two\"\nscene = \"pyramid\"\n");
    cues.close();
    ASSERT_TRUE(window.cues().open(file));
    CleanView& view = present();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.findChild<ValueSlider*>() != nullptr; }));
    EXPECT_EQ(window.shown().now()->sliders, (std::vector<std::string>{"light.0.intensity", "shading"}))
        << "kept again";
    auto* slider = view.findChild<ValueSlider*>();
    EXPECT_TRUE(slider->isVisible() && view.rect().contains(slider->geometry()));
    const double before = document().scene().lights[0].intensity;
    QTest::mouseClick(slider, Qt::LeftButton, Qt::NoModifier, slider->position(before + 10).toPoint());
    EXPECT_NEAR(document().scene().lights[0].intensity, before + 10, 2) << "within a pixel of the slider";
    QWidget* focus = QApplication::focusWidget();
    EXPECT_FALSE(focus && slider->parentWidget()->isAncestorOf(focus));
    press("PgDown");
    EXPECT_EQ(window.cues().model().current(), 1);
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.findChild<ValueSlider*>() == nullptr; }));
}

// On the lecturer's screen: light there would be light in the room.
TEST_F(WindowTalk, TheNotesWindowIsDarkInEveryTheme) {
    NotesWindow notes(window.cues().model(), window);
    notes.resize(1280, 720);
    notes.show();
    const ThemeColors& dark = Theme::colors(ThemeId::Dark);
    for (const ThemeId theme : {ThemeId::Light, ThemeId::Projector, ThemeId::Dark}) {
        Theme::current().set(theme);
        QCoreApplication::processEvents();
        const QImage shown = notes.grab().toImage();
        EXPECT_EQ(shown.pixelColor(2, 2), dark.bg) << int(theme);
        // Nothing is as light as the ground of the other themes, but letters and the audience's picture.
        const auto* list = notes.findChild<QListView*>();
        const QPoint corner = list->mapTo(&notes, QPoint(list->width() - 6, list->height() - 6));
        EXPECT_EQ(shown.pixelColor(corner), dark.surface) << int(theme);
    }
}

}  // namespace
}  // namespace app
