#pragma once
#include <QTableWidget>

#include "pipeline/study/analysis.h"

class QLabel;

namespace app {

// Shares as bars, one a stage; below 0 as an empty bar with its number.
class BlameBars : public QWidget {
    Q_OBJECT
public:
    explicit BlameBars(QWidget* parent = nullptr);
    void setBlame(std::vector<pipeline::StageBlame> blame);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<pipeline::StageBlame> m_blame;
};

// Of one setting: which stage is to blame, and every error of every buffer.
class StudyDetails : public QWidget {
    Q_OBJECT
public:
    explicit StudyDetails(QWidget* parent = nullptr);

    // null: nothing is chosen.
    void setPoint(const pipeline::StudyPoint* point, const std::string& label);
    // Its two parts, for a place with room for one at a time; unite() takes both back.
    QWidget& blame() { return *m_blamePart; }
    QWidget& errors() { return *m_errorPart; }
    void unite();

private:
    QWidget *m_blamePart, *m_errorPart;
    QLabel *m_blameTitle, *m_blameText, *m_errorTitle;
    BlameBars* m_blame;
    QTableWidget* m_errors;
};

}  // namespace app
