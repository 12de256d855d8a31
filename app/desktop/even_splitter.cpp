#include "app/desktop/even_splitter.h"

#include <QMouseEvent>
#include <cmath>

#include "app/core/theme.h"

namespace app {
namespace {

class Handle : public QSplitterHandle {
public:
    explicit Handle(EvenSplitter* splitter) : QSplitterHandle(splitter->orientation(), splitter) {
        setToolTip(EvenSplitter::tr("Drag: stops at halves and thirds. Double-click: equal parts"));
    }

protected:
    void mousePressEvent(QMouseEvent* event) override {
        m_grip = along(event->position());
        QSplitterHandle::mousePressEvent(event);
    }
    void mouseMoveEvent(QMouseEvent* event) override {
        if (!(event->buttons() & Qt::LeftButton)) return;
        const bool across = orientation() == Qt::Horizontal;
        const int at = int(along(splitter()->mapFromGlobal(event->globalPosition())) - m_grip);
        const int length = across ? splitter()->width() : splitter()->height();
        const int snapped = snappedPosition(at, length, splitter()->handleWidth(), Theme::current().px(10));
        moveSplitter(closestLegalPosition(snapped));
    }
    void mouseDoubleClickEvent(QMouseEvent*) override { static_cast<EvenSplitter*>(splitter())->makeEven(); }

private:
    double along(QPointF p) const { return orientation() == Qt::Horizontal ? p.x() : p.y(); }
    double m_grip = 0;  // where the handle was pressed, from its own beginning
};

}  // namespace

int snappedPosition(int position, int length, int handle, int reach) {
    const double room = length - handle;
    for (const double share : {1 / 2.0, 1 / 3.0, 2 / 3.0}) {
        const int at = int(std::lround(share * room));
        if (std::abs(position - at) <= reach) return at;
    }
    return position;
}

void EvenSplitter::makeEven() {
    constexpr int kEqual = 1000;  // shares: the splitter scales them to its length
    setSizes(QList<int>(count(), kEqual));
}

QSplitterHandle* EvenSplitter::createHandle() { return new Handle(this); }

}  // namespace app
