#pragma once
#include <QWidget>

#include "app/document/document.h"
#include "pipeline/compare/verdict.h"

class QGridLayout;
class QLabel;

namespace app {

// The values of another renderer and of this program at the picked pixel, or of the selected vertex or polygon, side by
// side. Buffers that were not handed in have no value.
class RendererValues : public QWidget {
    Q_OBJECT
public:
    explicit RendererValues(Document& document, QWidget* parent = nullptr);

    void show(const pipeline::foreign::Report& report);
    QString title() const { return m_titleText; }  // "Pixel 185, 105"
    bool isEmpty() const { return m_rows == 0; }

private:
    QLabel* cell(const QString& text, bool isMono, bool differs);

    Document& m_document;
    QGridLayout* m_grid;
    QLabel* m_first;
    QString m_titleText;
    int m_rows = 0;
};

}  // namespace app
