#pragma once
#include <QWidget>
#include <array>

#include "app/document/document.h"
#include "app/export/figure_order.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace app {

class BufferChooser;
class FigureSizeFields;

// The fields of a figure: buffer, part, range, what is drawn, caption, size and format.
class FigureFields : public QWidget {
    Q_OBJECT
public:
    // first: buffer, the part in view and the range to begin with.
    FigureFields(const Document& document, const FigureOrder& first, QWidget* parent = nullptr);

    FigureOrder order() const;
    // The range that the figure has, and its caption, in fields that leave them open.
    void show(const pipeline::Figure& figure);
    void remember() const;  // size and format, for the next figure

signals:
    void changed();

private:
    QWidget* makeContent();
    QWidget* makeLook();
    QWidget* makeCaption();
    QCheckBox* check(const char* name, const QString& text, bool on);
    void showBuffer();

    const Document& m_document;
    FigureOrder m_order;  // as begun, with the chosen buffer and the caption
    BufferChooser* m_buffer;
    QComboBox* m_part;
    std::array<QLineEdit*, 2> m_ends;  // the first and the last value of the palette
    QCheckBox *m_bar, *m_mark, *m_grid, *m_edges, *m_scale;
    QLabel *m_unit, *m_pixel;
    QPlainTextEdit* m_caption;
    QPushButton* m_asMade;
    FigureSizeFields* m_size;
};

}  // namespace app
