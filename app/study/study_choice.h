#pragma once
#include <QWidget>

#include "pipeline/study/study.h"

class QComboBox;
class QLabel;

namespace app {

// Which error of which buffer the plot shows: those that the study has; and against what.
class StudyChoice : public QWidget {
    Q_OBJECT
public:
    explicit StudyChoice(QWidget* parent = nullptr);

    // Keeps the choice where the report has it, else takes the report's own.
    void setReport(const pipeline::StudyReport& report);
    const pipeline::ErrorChoice& choice() const { return m_choice; }

signals:
    void changed();  // by the user

private:
    void fillErrors();
    void showReference();

    pipeline::StudyReport m_report;
    pipeline::ErrorChoice m_choice;
    QComboBox *m_buffer, *m_error;
    QLabel* m_reference;
};

}  // namespace app
