#include "app/lesson/handout_button.h"

#include <QDir>
#include <QFileInfo>

#include "app/look/text.h"
#include "app/widgets/save_dialog.h"
#include "lessons/pages/handout.h"

namespace app {
namespace {

constexpr char kEnding[] = ".html";

// Of a file that ends so, in letters of any size.
QString handoutName(const QString& file) { return QFileInfo(file).fileName().chopped(sizeof(kEnding) - 1); }

}  // namespace

HandoutButton::HandoutButton(std::function<const lessons::Lesson*()> lesson, QWidget* parent)
    : QPushButton(tr("Write this lesson as a handout…"), parent), m_lesson(std::move(lesson)) {
    setProperty("kind", "link");
    setObjectName("writeHandout");
    connect(this, &QPushButton::clicked, this, &HandoutButton::write);
    connect(&m_job, &BackgroundJob::busyChanged, this, [this](bool busy) {
        setEnabled(!busy);
        setToolTip(busy ? tr("A handout is being written.") : QString());
    });
}

void HandoutButton::write() {
    const lessons::Lesson* const lesson = m_lesson();
    if (!lesson) return;
    const QString name = QFileInfo(toQString(lesson->name)).fileName();  // of one's own: its folder
    const QString file =
        askWhereToSave(this, tr("Write a handout"), QDir::home().filePath(name + kEnding),
                       tr("Pages for a browser (*.html)"), kEnding + 1, [](const QString& named) {
                           QStringList files;
                           for (const std::string& one : lessons::handoutFiles(handoutName(named).toStdString()))
                               files += QFileInfo(named).dir().filePath(toQString(one));
                           return files;
                       });
    if (file.isEmpty()) return;
    struct Written {
        pipeline::Result<std::vector<std::string>> names;
        pipeline::Errors leftOut;
    };
    const auto make = [lesson = *lesson, to = QFileInfo(file)](const BackgroundJob::Control& control) -> Written {
        const auto handout = makeHandout(lesson, control.stop);
        if (!handout) return {handout.errors(), {}};
        return {writeHandout(*handout, handoutName(to.filePath()).toStdString(), to.path().toStdString()),
                handout->leftOut};
    };
    m_job.ask(make, [this, folder = QFileInfo(file).path()](const Written& done) {
        if (!done.names) return emit failed(tr("The handout could not be written."), done.names.errors());
        emit written(
            tr("%1 and %2 are in %3.").arg(toQString(done.names->front()), toQString(done.names->back()), folder));
        if (!done.leftOut.empty()) emit failed(tr("The handout has not all pictures of the lesson."), done.leftOut);
    });
}

}  // namespace app
