#pragma once
#include <QWidget>
#include <vector>

#include "app/document/document.h"
#include "pipeline/inspect/pixel_report.h"

class QGridLayout;
class QLabel;
class QToolButton;

namespace app {

// Why this colour: the chain from the pixel back to the line of its file. Each row's button goes to the stage that it comes
// from; a polygon, a vertex or an object is selected then, and a line of a file is shown.
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
        pipeline::StageId stage;
        pipeline::BufferId buffer;
    };
    Row& addRow(const QString& label, pipeline::StageId stage, pipeline::BufferId buffer);
    void go(std::size_t row);
    void goToShadow(int light);
    void follow(const QString& link);
    QString shadowsText(const pipeline::Frame& frame) const;

    Document& m_document;
    QGridLayout* m_grid;
    std::vector<Row> m_rows;  // pixel, fragment, weights, polygon, vertices, object, shadow
    std::optional<std::size_t> m_polygon, m_object;
    std::vector<int> m_blockers;  // per light
    QString m_file;               // that the polygon comes from
    int m_line = 0, m_column = 0;
    QString m_sentence;
};

}  // namespace app
