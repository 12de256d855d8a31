#pragma once
#include <QWidget>
#include <array>
#include <optional>

#include "pipeline/check/case.h"

class QLabel;
class QPushButton;

namespace app {

// One case: its input, both forms, their reference, and the result.
class CheckDetails : public QWidget {
    Q_OBJECT
public:
    explicit CheckDetails(QWidget* parent = nullptr);

    void setCase(const pipeline::check::Case& which, const std::optional<pipeline::check::CaseResult>& result);

signals:
    void openAsked();

private:
    enum Line { GoesIn, Measure, Reference, NaiveGives, OursGives, Bound, EndsIn, kLines };

    QLabel *m_id, *m_title, *m_verdict;
    QPushButton* m_open;
    std::array<QLabel*, 2> m_formTitles, m_forms;  // naive, ours
    std::array<QLabel*, kLines> m_names, m_lines;
};

}  // namespace app
