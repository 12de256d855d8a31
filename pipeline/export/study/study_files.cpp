#include "pipeline/export/study/study_files.h"

#include "pipeline/export/figure/plot_file.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/export/study/study_csv.h"

namespace pipeline {

std::vector<std::string> studyFiles() {
    return {"study.csv", "report.html", "plot.svg", "plot.png", "plot-dark.svg", "plot-dark.png", "study.json"};
}

Result<std::vector<std::string>> writeStudyFiles(const StudyReport& report, const StudyAnalysis& analysis,
                                                 const StudyLimits& limits, const std::vector<StudyPictures>& pictures,
                                                 const std::filesystem::path& folder) {
    const PlotDrawing plot = layOut(plotOf(report, analysis), {});
    std::vector<std::pair<std::string, std::string>> files{
        {"study.csv", studyCsv(report)},
        {"report.html", studyHtml(report, analysis, limits, pictures)},
        {"plot.svg", plotSvg(plot, PlotTheme::Light)},
        {"plot.png", plotPng(plot, PlotTheme::Light)},
        {"plot-dark.svg", plotSvg(plot, PlotTheme::Dark)},
        {"plot-dark.png", plotPng(plot, PlotTheme::Dark)}};
    files.emplace_back("study.json", studyFileText(report, contentsOf(files)));
    return writeFiles(files, folder);
}

}  // namespace pipeline
