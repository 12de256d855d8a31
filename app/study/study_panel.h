#pragma once
#include <QWidget>

#include "app/document/document.h"
#include "app/study/study_images.h"
#include "pipeline/study/analysis.h"

class QLabel;
class QPushButton;

namespace app {

class StudyChoice;
class StudyBar;
class StudyPicturesView;
class StudyPlot;
class StudyPoints;
class StudyRun;
class StudySweep;
class StudyTabs;

// Error against run time: on top what to measure and how far it is, below that the plot, all numbers at its right, and
// the answers in a line. The settings are those of the document's scene.
class StudyPanel : public QWidget {
    Q_OBJECT
public:
    explicit StudyPanel(Document& document, QWidget* parent = nullptr);

    // The report on show.
    void setReport(pipeline::StudyReport report);
    const pipeline::StudyReport& report() const { return m_report; }
    void select(std::optional<std::size_t> point);
    std::optional<std::size_t> selected() const { return m_selected; }
    bool openStudy(const QString& file);   // a study.json; what is wrong in it stands in the panel
    bool exportTo(const QString& folder);  // its tables, plots and page
    void use();                            // takes the settings of the selected point over, in one step of undo

protected:
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QLayout* makeBar();
    QWidget* makeSetUp();
    QWidget* makePlot();
    QWidget* makeNumbers();
    void placePictures();
    void analyse();
    void showSelected();
    void tell(const QString& words);
    void openFile();
    void exportFiles();
    pipeline::Result<pipeline::Scene> selectedScene() const;

    Document& m_document;
    pipeline::StudyReport m_report;
    pipeline::StudyAnalysis m_analysis;
    std::optional<std::size_t> m_selected;
    StudyImages m_images;
    StudySweep* m_sweep;
    StudyRun* m_run;
    StudyChoice* m_choice;
    StudyPlot* m_plot;
    StudyPicturesView* m_pictures;
    StudyPoints* m_points;
    StudyTabs* m_tabs;  // below the points
    StudyBar* m_foot;
    QLabel* m_message;
    QPushButton* m_export;
};

}  // namespace app
