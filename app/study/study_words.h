#pragma once
#include <QTableWidget>

#include "pipeline/study/analysis.h"

class QLabel;
class QLineEdit;

namespace app {

// The two answers of a study, with the limits that they are given for, and the observed orders.
class StudyWords : public QWidget {
    Q_OBJECT
public:
    explicit StudyWords(QWidget* parent = nullptr);

    // Limits that nobody typed follow the study's middle.
    void setStudy(const pipeline::StudyReport& report, pipeline::StudyAnalysis analysis);
    pipeline::StudyLimits limits() const { return m_limits; }
    QStringList sentences() const;  // both answers

signals:
    void answered();  // a limit was typed, or there is another study

private:
    void take(QLineEdit* field, double& limit, bool& typed);
    void showAnswers();

    pipeline::StudyAnalysis m_analysis;
    pipeline::StudyLimits m_limits;
    bool m_errorTyped = false, m_timeTyped = false;
    QLineEdit *m_error, *m_time;
    QLabel *m_title, *m_cheapest, *m_best, *m_orderTitle, *m_meaning;
    QTableWidget* m_orders;
};

}  // namespace app
