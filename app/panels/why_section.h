#pragma once
#include <QWidget>
#include <vector>

#include "app/core/document.h"
#include "pipeline/inspect/pixel_report.h"

class QGridLayout;
class QLabel;
class QToolButton;

namespace app {

// Why this colour: the chain from the pixel back to the file. Each row's button goes to the stage
// that it comes from.
class WhySection : public QWidget {
    Q_OBJECT
public:
    explicit WhySection(Document& document, QWidget* parent = nullptr);

    void show(const pipeline::Frame& frame, const pipeline::PixelReport& report);
    QString sentence() const { return m_sentence; }  // while folded

signals:
    void bufferAsked(const pipeline::BufferName& name);

private:
    struct Row {
        QLabel *label, *value;
        QToolButton* go;
    };
    Row& addRow(const QString& label, pipeline::StageId stage, pipeline::BufferId buffer);

    Document& m_document;
    QGridLayout* m_grid;
    std::vector<Row> m_rows;  // pixel, fragment, weights, polygon, object
    QString m_sentence;
};

}  // namespace app
