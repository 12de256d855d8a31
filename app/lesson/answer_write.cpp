#include <QDesktopServices>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "app/jobs/background_job.h"
#include "app/lesson/answer_body.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "lessons/pages/live_page.h"
#include "pipeline/export/folder/staging.h"

namespace app {

namespace {

struct WrittenPage {
    QString file;
    std::string failure;
};

// Lines are written in a browser: the window has no editor. The page is the lesson's live page, in a folder of this session.
class WriteBody : public AnswerBody {
public:
    WriteBody(const lessons::WriteQuestion& question, const LessonRun& run, QWidget* parent)
        : AnswerBody(parent),
          m_open(new QPushButton(tr("Write it in the browser"), this)),
          m_said(new QLabel(toQString(signatureOf(question.contract)), this)) {
        m_open->setObjectName("writeInBrowser");
        m_open->setProperty("kind", "primary");
        m_said->setWordWrap(true);
        m_said->setTextFormat(Qt::PlainText);
        m_column->addWidget(m_said);
        m_column->addWidget(m_open, 0, Qt::AlignLeft);
        connect(m_open, &QPushButton::clicked, this,
                [this, lesson = *run.lesson(), page = run.page() - int(returningPages(*run.lesson()))] {
                    open(lesson, page);
                });
        followTheme(this, [this] { m_said->setFont(Theme::current().text(12)); });
    }
    std::optional<lessons::Given> given() const override { return {}; }
    void takeFocus() override { m_open->setFocus(); }
    QString advice() const override { return tr("Enter opens the page in your browser."); }

private:
    void open(const lessons::Lesson& lesson, int page) {
        static const QTemporaryDir folder;  // of the session
        m_open->setEnabled(false);
        const QString file = folder.filePath(toQString(lessons::livePageFile(lesson.name)));
        m_job.ask(
            [lesson, file](const BackgroundJob::Control& control) -> WrittenPage {
                const auto parts = lessons::liveParts();
                if (!parts) return {file, parts.errors().front().found};
                const auto made = makeLivePage(lesson, *parts, control.stop);
                if (!made) return {file, made.errors().front().found};
                const auto written = pipeline::writeWhole(file.toStdString(), made->html);
                return {file, written ? std::string() : written.errors().front().found};
            },
            [this, page](const WrittenPage& written) {
                m_open->setEnabled(true);
                if (!written.failure.empty()) return m_said->setText(toQString(written.failure));
                QUrl url = QUrl::fromLocalFile(written.file);
                url.setQuery(QStringLiteral("page=%1").arg(std::max(0, page) + 1));
                QDesktopServices::openUrl(url);
            });
    }

    QPushButton* m_open;
    QLabel* m_said;
    BackgroundJob m_job;
};

}  // namespace

AnswerBody* makeWriteBody(const lessons::WriteQuestion& question, const LessonRun& run, QWidget* parent) {
    return new WriteBody(question, run, parent);
}

}  // namespace app
