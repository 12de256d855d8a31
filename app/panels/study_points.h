#pragma once
#include <QTableWidget>

#include "pipeline/study/analysis.h"

namespace app {

// The settings of a study, the fastest first, those that failed last; the chosen row is the chosen setting.
class StudyPoints : public QTableWidget {
    Q_OBJECT
public:
    explicit StudyPoints(QWidget* parent = nullptr);

    void setStudy(const pipeline::StudyReport& report, const pipeline::StudyAnalysis& analysis);
    void select(std::optional<std::size_t> point);  // says nothing

signals:
    void chosen(std::size_t point);  // into StudyReport::points, by the user

private:
    int rowOf(std::size_t point) const;
};

}  // namespace app
