#pragma once
#include <QWidget>
#include <functional>
#include <memory>

#include "app/check/check_cases.h"
#include "app/check/check_job.h"
#include "app/document/document.h"

class QLabel;
class QPushButton;

namespace app {

class CheckDetails;
class CheckKnob;
class CheckPictures;
class CheckBar;

// The stiff and extreme cases. Top: how many pass. Left: all cases with their results. Right: the selected case with
// the slider that makes it stiff. They run when the panel is first shown.
class CheckPanel : public QWidget {
    Q_OBJECT
public:
    explicit CheckPanel(Document& document, QWidget* parent = nullptr);
    ~CheckPanel() override;

    void run(pipeline::check::Filter filter);  // nothing while something runs
    bool running() const { return m_job != nullptr; }
    // Called before a case replaces the scene on show; false keeps the scene.
    void setMayLeave(std::function<bool()> mayLeave) { m_mayLeave = std::move(mayLeave); }
    void select(std::size_t which);  // into pipeline::check::caseTable()
    std::size_t selected() const { return m_selected; }
    void setGroup(std::optional<pipeline::check::Group> group);
    // The selected case as the document's scene, with the slider's value where the knob is one of its settings.
    bool openAsScene();
    const CheckPictures& pictures() const { return *m_pictures; }
    QString report() const;  // JSON, as the command check prints it

protected:
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeLeft();
    QWidget* makeRight();
    const pipeline::check::Case& chosenCase() const;
    void fitGroups();
    void take(const pipeline::check::CaseResult& result);
    void finish(double seconds, bool cancelled);
    void showSelected();
    void showState();
    // The selected case as a scene; nothing where it has none.
    std::optional<pipeline::Scene> sceneAtKnob() const;
    void showPictures();
    void turnKnob(double value, bool done);

    Document& m_document;
    std::function<bool()> m_mayLeave = [] { return true; };
    CheckResults m_results;
    double m_seconds = 0;       // of the newest run of all
    std::size_t m_arrived = 0;  // of the cases that run now
    std::size_t m_asked = 0;
    std::unique_ptr<CheckJob> m_job;
    std::optional<pipeline::check::Group> m_group;
    std::size_t m_selected = 0;
    std::optional<std::size_t> m_open;  // the case that is the document's scene
    QLabel *m_command, *m_message, *m_noKnob;
    CheckBar* m_bar;
    QPushButton* m_runOne;
    CheckCases* m_cases;
    CheckDetails* m_details;
    CheckKnob* m_knob;
    CheckPictures* m_pictures;
};

}  // namespace app
