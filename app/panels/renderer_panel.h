#pragma once
#include <QWidget>
#include <array>

#include "app/core/renderer_check.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace app {

class Document;
class RendererConventions;
class RendererError;
class RendererValues;
class Section;
class StandingMark;
class StandingRow;

// Somebody else's renderer beside this one: which stage is the first that is wrong, what the error is called, and where to
// look. As much of that as the hints give away.
class RendererPanel : public QWidget {
    Q_OBJECT
public:
    explicit RendererPanel(Document& document, QWidget* parent = nullptr);

    RendererCheck& renderer() { return m_renderer; }
    void goToWorst();      // of the pixels that differ; again: the next one
    void copyFinding();    // as text, as the command prints it
    QString text() const;  // likewise
    int hints() const { return m_hints; }
    static int keptHints();
    void setHints(int hints);  // 0 to 3, kept in the program's settings

signals:
    void folderAsked();
    void filesAsked();
    void showAsked(const pipeline::BufferName& buffer);  // with mine as B
    void begun();                                        // the first report of a folder: views can be set to it
    void lessonAsked(const QString& lesson, const QString& heading);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    // renderer_panel_parts.cpp: what it is made of
    void makeHead(QVBoxLayout& column);
    void makeEmpty(QVBoxLayout& column);
    void makeParts(QVBoxLayout& column);
    QLabel* makeText(const char* name, double size, int weight = 400);
    // renderer_panel.cpp: what it shows
    void take();
    void showAll();
    void showState();
    void showWork();
    void showStages();
    void showContracts();
    void showFiles();
    void showHints();
    void showPlace();
    void goToStage(StandingRow& row);

    Document& m_document;
    RendererCheck& m_renderer;
    // The newest, with no more given away than the hints say.
    std::shared_ptr<const pipeline::foreign::Report> m_report;
    int m_hints = 3;
    bool m_begins = false;  // the next report is the first of its folder
    std::vector<glm::ivec2> m_worst;
    std::size_t m_nextWorst = 0;

    QScrollArea* m_scroll;
    QWidget *m_empty, *m_parts, *m_work, *m_body;
    QLabel *m_source, *m_heading, *m_evidence, *m_errors, *m_working, *m_contracts, *m_files, *m_hintList;
    StandingMark* m_mark;
    QProgressBar* m_bar;
    QPushButton *m_cancel, *m_goToWorst, *m_nextHint, *m_copy;
    std::array<StandingRow*, pipeline::kStageCount> m_rows{};
    RendererError* m_error;
    RendererValues* m_values;
    RendererConventions* m_conventions;
    Section *m_place, *m_contractPart, *m_conventionPart, *m_filePart, *m_hintPart;
    QComboBox* m_hintChoice;
};

}  // namespace app
