#pragma once
#include <QWidget>
#include <array>

#include "pipeline/core/stage.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace app {

class RendererConventions;
class RendererError;
class RendererFinding;
class RendererValues;
class Section;
class StandingRow;

// How each stage stands. A click goes to the stage.
class RendererStages : public QWidget {
public:
    RendererStages(RendererFinding& finding, QWidget* parent);

    void showReport();

private:
    RendererFinding& m_finding;
    std::array<StandingRow*, pipeline::kStageCount> m_rows{};
};

// The hints that were given, the next one, and how much is given away at once.
class RendererHints : public QWidget {
public:
    RendererHints(RendererFinding& finding, QWidget* parent);

    void showReport();

private:
    RendererFinding& m_finding;
    QLabel* m_list;
    QPushButton* m_next;
    QComboBox* m_choice;
};

// The report below the head: the stages, the error's name, and sections about the pixel, contracts, conventions, files and
// hints.
class RendererBody : public QWidget {
    Q_OBJECT
public:
    RendererBody(RendererFinding& finding, QWidget* parent);

signals:
    void lessonAsked(const QString& lesson, const QString& heading);

private:
    void makeSections();
    void showReport();
    void showContracts();
    void showFiles();
    void showPlace();
    void stateRows(bool other);

    RendererFinding& m_finding;
    RendererStages* m_stages;
    RendererError* m_error;
    QPushButton* m_goToWorst;
    RendererValues* m_values;
    RendererConventions* m_conventions;
    RendererHints* m_hints;
    QLabel *m_contracts, *m_files;
    Section *m_place, *m_contractPart, *m_conventionPart, *m_filePart, *m_hintPart;
};

}  // namespace app
