#pragma once
#include <QTimer>
#include <QWidget>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "app/inspector/math_page.h"

namespace app {

// A typeset equation. Hovering a part, or going to it with the arrow keys, names the buffer or setting that it stands
// for; a click or Enter asks to show that. The view is as high as the equation needs at its width.
class MathView : public QWidget {
    Q_OBJECT
public:
    explicit MathView(QWidget* parent = nullptr);

    // What differs from the lines before is tinted for a moment, if `showChange` is on.
    void setLines(std::vector<pipeline::EquationLine> lines, bool showChange = false);
    const std::vector<pipeline::EquationLine>& lines() const { return m_lines; }
    void setBaseSize(double logicalPixels);  // 18 to begin with; scaled with the theme

    QString asText() const;
    QString asMarkdown() const;
    QString asLatex() const;
    QString asJson() const;

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    // The buffer or setting under the cursor or the keyboard's mark; empty when there is none.
    void pointedAt(const QString& refers);
    void activated(const QString& refers);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    const MathPage& pageAt(int width) const;
    void layOut();
    void point(int part);
    int partAt(QPointF position) const;  // the smallest that refers to something; -1
    void walk(int step);
    void walkLine(int step);

    std::vector<pipeline::EquationLine> m_lines;
    std::set<std::pair<int, int>> m_changed;  // line, leaf
    // By width: a layout asks for the same heights many times before it settles.
    mutable std::map<int, MathPage> m_pages;
    double m_baseSize = 18;
    int m_pointed = -1;  // index into the parts of the page at this width
    QTimer m_fade;
};

}  // namespace app
