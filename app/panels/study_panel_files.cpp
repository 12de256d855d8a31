#include <QDir>
#include <QFileDialog>
#include <QLabel>

#include "app/core/text.h"
#include "app/panels/study_choice.h"
#include "app/panels/study_panel.h"
#include "app/panels/study_tabs.h"
#include "app/panels/study_words.h"
#include "pipeline/export/study_files.h"
#include "pipeline/export/study_json.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/key_places.h"

// Studies from and to files.
namespace app {

void StudyPanel::tell(const QString& words) {
    m_message->setText(words);
    m_message->setVisible(!words.isEmpty());
}

void StudyPanel::openFile() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Open a study"), QString(), tr("Studies (*.json)"));
    if (!file.isEmpty()) openStudy(file);
}

bool StudyPanel::openStudy(const QString& file) {
    const std::string name = file.toStdString();
    const auto text = pipeline::readFile(name);
    auto report = text ? pipeline::studyFromJson(*text, name)
                       : pipeline::Result<pipeline::StudyReport>(pipeline::namedAt({name}, text.errors()));
    if (!report) {
        tell(toQString(format(report.errors())));
        return false;
    }
    tell({});
    setReport(std::move(report).value());
    return true;
}

void StudyPanel::exportFiles() {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Export the study to a folder"), QDir::homePath());
    if (!folder.isEmpty()) exportTo(folder);
}

bool StudyPanel::exportTo(const QString& folder) {
    const auto written = writeStudyFiles(m_report, m_analysis, m_tabs->words().limits(), {}, folder.toStdString());
    tell(written ? tr("%1 files are in %2.").arg(written->size()).arg(folder) : toQString(format(written.errors())));
    return bool(written);
}

}  // namespace app
