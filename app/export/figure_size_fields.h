#pragma once
#include <QWidget>

#include "app/export/figure_order.h"

class QComboBox;
class QDoubleSpinBox;

namespace app {

class Segmented;

// How large a figure is on paper, and in what format. Begins with what the last figure had.
class FigureSizeFields : public QWidget {
    Q_OBJECT
public:
    explicit FigureSizeFields(QWidget* parent = nullptr);

    void addTo(FigureOrder& order) const;
    void remember() const;  // for the next figure

signals:
    void changed();

private:
    void makeWidth(QWidget* row);
    void showDots();

    QComboBox* m_widths;
    QDoubleSpinBox *m_width, *m_letters, *m_dots;
    Segmented *m_format, *m_colors;
};

}  // namespace app
