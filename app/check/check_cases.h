#pragma once
#include <QTableWidget>
#include <optional>

#include "pipeline/check/case.h"

namespace app {

// A result for each row of pipeline::check::caseTable(); nothing for a case that has not run.
using CheckResults = std::vector<std::optional<pipeline::check::CaseResult>>;

// The cases of a group with their results, failed ones first; the selected row is the selected case.
class CheckCases : public QTableWidget {
    Q_OBJECT
public:
    explicit CheckCases(QWidget* parent = nullptr);

    // No group: all.
    void setCases(const CheckResults& results, std::optional<pipeline::check::Group> group);
    void setResult(std::size_t which, const pipeline::check::CaseResult& result);  // in its row, which stays
    void select(std::size_t which);                                                // says nothing
    bool contains(std::size_t which) const { return rowOf(which) >= 0; }

signals:
    void chosen(std::size_t which);     // into caseTable(), by the user
    void openAsked(std::size_t which);  // Enter, or a double click

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    std::size_t caseIn(int row) const;
    int rowOf(std::size_t which) const;
    void layOut();
    void fill(int row, const std::optional<pipeline::check::CaseResult>& result);
};

}  // namespace app
