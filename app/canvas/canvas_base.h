#pragma once
#include <QPixmap>
#include <optional>

#include "app/canvas/buffer_painter.h"
#include "app/jobs/background_job.h"

namespace app {

// A canvas's picture without its marks, painted only when it has changed, because the pointer moves far more often. A
// picture of many polygons is painted in the background. Until it is done, the last one stays and moves with the view.
class CanvasBase : public QObject {
    Q_OBJECT
public:
    explicit CanvasBase(QObject* parent = nullptr);

    // How it is painted.
    struct Look {
        Placement placement;
        QSize size;        // of the canvas
        double ratio = 1;  // device pixels a logical one
        bool showsEdges = false, isFlipped = false;
        bool operator==(const Look&) const = default;
    };
    void change() { ++m_version; }  // the content, or the theme
    void draw(QPainter& painter, const CanvasContent& content, const Look& look);
    bool busy() const { return m_job.busy(); }
    void cancel() { m_job.forget(); }
    void retry() { m_asked.reset(); }  // when it is drawn next

signals:
    void painted();  // draw() shows something else
    void busyChanged(bool busy);

private:
    struct Painted {
        long version = 0;
        Look look;
        QSize picture;  // its pixels
        QPixmap pixmap;
    };
    void ask(const CanvasContent& content, const Look& look);
    void drawMoved(QPainter& painter, const CanvasContent& content, const Look& look) const;

    long m_version = 0;
    std::optional<Painted> m_painted;
    long m_askedVersion = -1;
    std::optional<Look> m_asked;  // what is being painted
    BackgroundJob m_job;
};

}  // namespace app
