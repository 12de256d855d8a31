#include "app/desktop/opening_menus.h"

#include <fmt/format.h>

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QPushButton>
#include <QRandomGenerator>

#include "app/commands/actions.h"
#include "app/desktop/file_opening.h"
#include "app/desktop/scene_files.h"
#include "app/desktop/window_lessons.h"
#include "app/document/document.h"
#include "app/document/recent_files.h"
#include "app/lesson/lesson_shelf.h"
#include "app/look/text.h"
#include "app/start/start_order.h"
#include "app/start/start_page.h"
#include "app/widgets/save_dialog.h"
#include "lessons/games/drill.h"
#include "lessons/state/cue_list.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/gltf/gltf_views.h"
#include "pipeline/scene/mesh/shape.h"

namespace app {
namespace {

void popUpBelow(QMenu& menu, const QWidget& below) { menu.popup(below.mapToGlobal(QPoint(0, below.height()))); }

// A text that a menu does not read for keys.
QString plain(QString text) { return text.replace('&', QStringLiteral("&&")); }

}  // namespace

OpeningMenus::OpeningMenus(QWidget& window, Actions& actions, Document& document, StartPage& start,
                           FileOpening& opening, SceneFiles& files, WindowLessons& lessons, const LessonShelf& shelf)
    : QObject(&window),
      m_window(window),
      m_document(document),
      m_opening(opening),
      m_files(files),
      m_lessons(lessons),
      m_shelf(shelf),
      m_talks(new QMenu(tr("Give a talk"), &window)) {
    actions.add({.id = ActionId::Drill,
                 .menu = "Learn",
                 .text = "Pictures to name, on paper…",
                 .keys = "",
                 .tip = "Write pictures that differ in one technique, for a class to name, and a page of answers.",
                 .run = [this] { makeDrill(); },
                 .whyNot = [this] { return m_drill.busy() ? tr("The pages are being written.") : QString(); },
                 .needsScene = false});
    connect(&actions, &Actions::menusFilled, this, [this, &actions, &start] {
        fillMenus(actions);
        addTools(start, actions);
    });
}

void OpeningMenus::fillMenus(const Actions& actions) {
    QMenu* const file = actions.menu("File");
    const auto insert = [&](QMenu* menu) {
        file->insertMenu(actions[ActionId::Save], menu);
        return menu;
    };
    QMenu* const recent = insert(new QMenu(tr("Open recent"), file));
    QMenu* const scenes = insert(new QMenu(tr("Scenes"), file));
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes())
        scenes->addAction(toQString(scene.title), this,
                          [this, path = toQString(scene.file.string())] { m_opening.open(path); });
    fillShapes(*insert(new QMenu(tr("New"), file)));
    QMenu* const cameras = insert(new QMenu(tr("Camera of the model's file"), file));
    insert(m_talks);
    connect(file, &QMenu::aboutToShow, this, [this, recent, cameras] {
        fillRecent(*recent), fillTalks(*m_talks);
        const QString ending = QFileInfo(m_document.kept().file).suffix();
        cameras->setEnabled(m_document.hasScene() && m_document.scene().framed &&
                            ending.startsWith(QStringLiteral("gl"), Qt::CaseInsensitive));
    });
    connect(cameras, &QMenu::aboutToShow, this, [this, cameras] { fillCameras(*cameras); });
    QMenu* const learn = actions.menu("Learn");
    const std::vector<StartLecture> lectures = startOrder();
    for (std::size_t i = 0; i < lectures.size(); ++i) {
        auto* menu = new QMenu(tr("Lessons of %1").arg(lectures[i].title), learn);
        menu->setToolTipsVisible(true);
        learn->insertMenu(actions[ActionId::Drill], menu);
        fillLessons(*menu, i);
        connect(learn, &QMenu::aboutToShow, this, [this, menu, i] { fillLessons(*menu, i); });
    }
    learn->insertSeparator(actions[ActionId::Drill]);
}

void OpeningMenus::fillRecent(QMenu& menu) {
    menu.clear();
    const std::vector<RecentFile> files = recentFiles();
    const QStringList names = recentNames(files);
    for (std::size_t i = 0; i < files.size(); ++i)
        menu.addAction(plain(names[qsizetype(i)]), this, [this, path = files[i].file] { m_opening.openRecent(path); });
    menu.setEnabled(!menu.isEmpty());
}

// Both lectures, the lists that were opened last, and any other.
void OpeningMenus::fillTalks(QMenu& menu) {
    menu.clear();
    QStringList lectures;
    const auto add = [&](const QString& name, const QString& file) {
        menu.addAction(plain(name), this, [this, file] { m_opening.giveTalk(file); });
    };
    for (const StartLecture& lecture : startOrder()) {
        lectures += lecture.talk;
        add(QStringLiteral("%1: %2").arg(lecture.title, lecture.about), lecture.talk);
    }
    menu.addSeparator();
    for (const RecentFile& recent : recentFiles())
        if (recent.file.endsWith(lessons::kCueEnding, Qt::CaseInsensitive) && !lectures.contains(recent.file))
            add(nameOf(recent), recent.file);
    menu.addAction(tr("A list of your own…"), this, [this] { m_opening.chooseTalk(); });
}

// One object under a lamp and some ambient light, in the middle of the picture and as large as fits: the eye is at four
// times the radius of the shape's box.
void OpeningMenus::fillShapes(QMenu& menu) {
    for (std::size_t i = 0; i < pipeline::kShapeCount; ++i) {
        const auto kind = static_cast<pipeline::ShapeKind>(i);
        const std::string shape(name(kind));
        QString title = toQString(shape);
        title[0] = title[0].toUpper();
        menu.addAction(title, this, [this, kind, shape, title] {
            if (!m_files.mayLeave()) return;
            const pipeline::MeshFacts facts = pipeline::makeShape({kind})->facts;
            const pipeline::Vec3d middle = 0.5 * (facts.low + facts.high);
            const double radius = glm::length(facts.high - middle);
            const auto at = [&](const pipeline::Vec3d& offset) {
                const pipeline::Vec3d place = middle + radius * offset;
                return fmt::format("[{:.3f}, {:.3f}, {:.3f}]", place.x, place.y, place.z);
            };
            lessons::WindowState state;
            state.sceneText = fmt::format(
                "title = \"{}\"\nshading = \"phong\"\nnormal_weight = \"given\"\n"
                "[camera]\nkind = \"look-at\"\neye = {}\ntarget = {}\nfov = 30\n"
                "[ambient]\nintensity = 40\n[[light]]\nposition = {}\nintensity = 160\n"
                "[[object]]\nshape = \"{}\"\n[object.material]\ndiffuse = [0.2, 0.45, 0.9]\nks = 0.4\nn = 30\n",
                title.toStdString(), at(4.0 * glm::normalize(pipeline::Vec3d(2, -3, 2))), at({}), at({0.6, -1.8, 2.4}),
                shape);
            m_files.showState(state, {}, SceneChanges::Given);
        });
    }
}

// A large file takes its time, so the names come when they are read.
void OpeningMenus::fillCameras(QMenu& menu) {
    using Names = pipeline::Result<std::vector<std::string>>;
    const auto say = [&menu](const QString& text) { menu.clear(), menu.addAction(text)->setEnabled(false); };
    say(tr("Reading the file…"));
    const std::filesystem::path file = m_document.kept().file.toStdString();
    const auto take = [this, file](std::size_t number, const QString& name) {
        m_cameras.ask(
            [=, scene = m_document.scene()](const BackgroundJob::Control& control) {
                return withGltfViews(scene, file, {.camera = number}, {{}, control.stop});
            },
            [this, name](const pipeline::Result<pipeline::Scene>& seen) {
                if (!seen) return void(emit m_document.failed(seen.errors()));
                pipeline::Scene scene = m_document.scene();
                scene.camera = seen->camera;
                m_document.replace(std::move(scene), tr("Camera %1").arg(name));
            });
    };
    m_cameras.ask(
        [=](const BackgroundJob::Control& control) {
            return pipeline::gltfCameras(file, {{}, control.stop});
        },
        [this, &menu, say, take](const Names& names) {
            if (!names) return say(toQString(format(names.errors())));
            if (names->empty()) return say(tr("The file has no camera."));
            menu.clear();
            for (std::size_t i = 0; i < names->size(); ++i)
                menu.addAction(plain(toQString((*names)[i])), this,
                               [take, i, name = toQString((*names)[i])] { take(i, name); });
        });
}

void OpeningMenus::fillLessons(QMenu& menu, std::size_t lecture) {
    menu.clear();
    for (int i = 0; i < m_shelf.rowCount(); ++i) {
        const QModelIndex row = m_shelf.index(i);
        const QString name = row.data(LessonShelf::NameRole).toString();
        if (lectureOf(m_shelf.listed(i).lecture).value_or(lecture) != lecture) continue;
        QAction* const action = menu.addAction(plain(row.data(LessonShelf::TitleRole).toString()), this,
                                               [this, name] { m_lessons.open(name); });
        action->setCheckable(true);
        action->setChecked(row.data(LessonShelf::PageRole) == row.data(LessonShelf::PagesRole));
        action->setToolTip(row.data(LessonShelf::SummaryRole).toString());
    }
}

void OpeningMenus::addTools(StartPage& start, const Actions& actions) {
    const auto addAction = [&](const char* icon, ActionId id) {
        start.addTool(icon, actions[id]->text(), tr(actions.rows().at(id).tip),
                      [action = actions[id]](QWidget&) { action->trigger(); });
    };
    addAction("file", ActionId::CheckRenderer);
    addAction("eye-off", ActionId::WrongPicture);
    start.addTool("film", tr("Give a talk…"), tr("Lecture 1, lecture 2, or a list of cues of your own."),
                  [this](QWidget& line) {
                      fillTalks(*m_talks);
                      popUpBelow(*m_talks, line);
                  });
    start.addTool("histogram", actions[ActionId::Study]->text(),
                  tr("Opens the scene Flat, Gouraud, Phong, and varies its settings: how wrong is the picture, and how "
                     "long does it take?"),
                  [this, study = actions[ActionId::Study]](QWidget&) {
                      const auto scene = pipeline::builtInScene("flat_gouraud_phong");
                      if (scene) m_opening.open(toQString(scene->file.string()), [study] { study->trigger(); });
                  });
    addAction("check", ActionId::Check);
    auto* shapes = new QMenu(&start);
    fillShapes(*shapes);
    connect(&start.newButton(), &QPushButton::clicked, this,
            [shapes, &start] { popUpBelow(*shapes, start.newButton()); });
}

void OpeningMenus::makeDrill() {
    const QString folder = QFileDialog::getExistingDirectory(&m_window, tr("The folder for the pages"));
    if (folder.isEmpty()) return;
    QStringList there;
    for (const char* file : {"drill.html", "drill-answers.html"})
        if (QFileInfo::exists(folder + '/' + file)) there += file;
    if (!there.isEmpty() && !askToReplace(&m_window, tr("Write pictures to name"), there)) return;
    using Written = pipeline::Result<std::vector<std::string>>;
    constexpr std::size_t kRounds = 10;
    const std::uint64_t seed = QRandomGenerator::global()->generate();
    m_drill.ask(
        [=](const BackgroundJob::Control& control) -> Written {
            const auto rounds = lessons::makeDrill(seed, kRounds, {}, control.stop, [&](std::size_t round) {
                control.progress(double(round) / double(kRounds));
            });
            if (!rounds) return rounds.errors();
            return writeDrill(lessons::drillPages(seed, *rounds), folder.toStdString());
        },
        [this, folder](const Written& written) {
            if (!written) return void(emit m_document.failed(written.errors()));
            emit m_document.said(tr("drill.html and drill-answers.html are in %1.").arg(folder));
        });
}

}  // namespace app
