#pragma once
#include <QWidget>

#include "app/document/document.h"
#include "pipeline/steps/algorithm.h"

class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QSlider;
class QToolButton;

namespace app {

class AlgorithmView;
class StepTables;

// The lectures' algorithm of the stage on show: the line that the step is at, its values, and where its loop is.
class AlgorithmPanel : public QWidget {
    Q_OBJECT
public:
    explicit AlgorithmPanel(Document& document, QWidget* parent = nullptr);

    AlgorithmView& view() { return *m_view; }

protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showStep();
    void showList();
    void showLoop();
    void showLit();
    void stepLine(int direction);
    void runToLine(int number);
    void slideTo(int at);
    void copy(pipeline::AlgorithmFormat format);

    Document& m_document;
    QComboBox* m_list;
    QToolButton* m_copy;
    QScrollArea* m_scroll;
    AlgorithmView* m_view;
    QWidget* m_loop;
    QLabel *m_loopName, *m_first, *m_last, *m_note, *m_hint;
    StepTables* m_tables;
    QSlider* m_slider;
    QPushButton *m_back, *m_next;
};

// What an algorithm shows of where the stepper is; nothing before its steps are counted, or where the stage has none.
std::optional<pipeline::AlgorithmState> algorithmState(const Stepper& stepper, pipeline::StageId stage);

}  // namespace app
