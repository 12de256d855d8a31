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

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitColumns();
    int rowOf(std::size_t point) const;

    std::vector<int> m_widths;   // of the columns, by what is in them
    std::vector<int> m_least;    // of the columns, with a header that is cut
    std::vector<int> m_giveWay;  // the columns that go first where there is no room for all
};

}  // namespace app
