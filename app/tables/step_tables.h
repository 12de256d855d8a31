#pragma once
#include <QWidget>
#include <optional>
#include <vector>

#include "pipeline/inspect/fragment_report.h"
#include "pipeline/steps/algorithm.h"

namespace app {

class Document;

// Below an algorithm: its variables with where they come from, and the fragments of the step's pixel in the order in which
// they came. Where there is no height for both, the variables go first.
class StepTables : public QWidget {
    Q_OBJECT
public:
    StepTables(const Document& document, QWidget* parent);

    // rows: those of the algorithm on show.
    void showStep(const std::vector<pipeline::AlgorithmRow>& rows);

    // The size of the letters where there is room for it, in the theme's units; 13 to begin with, and at least.
    void setLetters(double size);

    QSize sizeHint() const override { return {0, 0}; }  // the room that the code leaves

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Fragments {
        QString title;  // "Fragments at 250, 270"
        std::vector<pipeline::FragmentReport> rows;
        std::optional<std::size_t> tested;  // the row that the step is at
        pipeline::ComparisonText comparison(std::size_t row) const;
        QString verdict(std::size_t row) const;
    };
    std::optional<Fragments> fragmentsAtStep() const;
    void showFragments();
    static int lineHeight(double letters);
    static int tableHeight(std::size_t lines, double letters);
    int variablesHeight(double letters) const;
    int fragmentsHeight(double letters) const;
    int wanted(double letters) const { return variablesHeight(letters) + fragmentsHeight(letters); }
    int paintVariables(QPainter& painter, int y, double letters) const;
    void paintFragments(QPainter& painter, int y, double letters) const;

    const Document& m_document;
    std::vector<pipeline::AlgorithmValue> m_variables;
    std::optional<Fragments> m_fragments;
    double m_letters = 13;
};

}  // namespace app
