#pragma once
#include <QWidget>
#include <algorithm>
#include <optional>
#include <vector>

#include "pipeline/steps/algorithm.h"

namespace app {

// An algorithm with the line that a step is at: numbers, code, values at the right end. The comparison of a branch has a
// line of its own below it. Code and values that are too long are folded. Arrow keys ask for the line before and after,
// Ctrl+click for the one that is clicked.
class AlgorithmView : public QWidget {
    Q_OBJECT
public:
    explicit AlgorithmView(QWidget* parent = nullptr);

    void setState(std::optional<pipeline::AlgorithmState> state);
    const std::optional<pipeline::AlgorithmState>& state() const { return m_state; }
    const std::vector<pipeline::AlgorithmRow>& rows() const { return m_rows; }
    // Points at font scale 1. Letters become smaller, down to `least`, where the longest line would not fit.
    void setLetters(double size, double least);
    QFont codeFont() const { return layOut(width()).code; }
    QStringList codeLines(int number) const;  // of a line of the algorithm, from 1: its parts that have a line each
    void setShowsLoop(bool shows);            // below the lines: where the innermost loop is
    void setMostLines(int lines);             // with more of them those around the current one; 0: all
    QRect currentRect() const;                // empty where no line is lit

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void stepAsked(int direction);
    void lineAsked(int number);  // from 1
    void copyAsked(pipeline::AlgorithmFormat format);

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Placed {
        std::size_t row = 0;
        QRect rect;
        int line = 0;              // height of one line of text
        QStringList code, values;  // in lines
        bool valuesBelow = false;  // else at the right end of the code
        bool wayBelow = false;     // of a branch, below its comparison
    };
    struct Sheet {
        QFont code, words;
        int numbers = 0, indent = 0;                // widths, pixels
        int hanging() const { return 2 * indent; }  // of code that goes on in the next line
        int valuesLeft(const pipeline::AlgorithmRow& row) const {
            return numbers + (row.taken ? std::min(row.indent, 2) * indent : 0);
        }
        std::vector<Placed> placed;
        std::size_t above = 0, below = 0;  // lines that are not shown
        QRect loop;                        // empty where none is shown
        int height = 0;
    };
    Sheet layOut(int width) const;
    Placed place(const Sheet& sheet, std::size_t row, QRect line) const;
    static QString wayOf(const pipeline::AlgorithmRow& row);     // of a branch
    bool showsNumbers(const pipeline::AlgorithmRow& row) const;  // as values, else words
    void paintRow(QPainter& painter, const Sheet& sheet, const Placed& placed) const;
    void paintLoop(QPainter& painter, const Sheet& sheet) const;
    void paintValues(QPainter& painter, const Sheet& sheet, const Placed& placed) const;
    QString valuesOf(const pipeline::AlgorithmRow& row) const;

    std::optional<pipeline::AlgorithmState> m_state;
    std::vector<pipeline::AlgorithmRow> m_rows;
    double m_letters = 13, m_least = 13;  // as the theme's text
    int m_most = 0;
    bool m_showsLoop = false;
};

}  // namespace app
