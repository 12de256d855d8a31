#pragma once
#include <QWidget>

#include "app/canvas/canvas_base.h"

namespace app {

class BufferCanvas;

// The 9 × 9 pixels around the cursor, else around the picked pixel, enlarged in the canvas' corner.
// It moves to the left when the cursor comes near.
class Loupe : public QWidget {
    Q_OBJECT
public:
    explicit Loupe(BufferCanvas* canvas);
    void follow();  // after any change of the canvas

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    BufferCanvas* m_canvas;
    CanvasBase m_base;
    bool m_onLeft = false;
};

}  // namespace app
