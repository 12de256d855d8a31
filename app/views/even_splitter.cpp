#include "app/views/even_splitter.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "app/look/theme.h"

namespace app {
namespace {

class EvenHandle : public QSplitterHandle {
public:
    explicit EvenHandle(EvenSplitter* splitter) : QSplitterHandle(splitter->orientation(), splitter) {
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

EvenSplitter::EvenSplitter(Qt::Orientation orientation, QWidget* parent) : QSplitter(orientation, parent) {
    connect(this, &QSplitter::splitterMoved, this, [this] {
        setShares(sizes());
        emit sharesChanged();
    });
}

void EvenSplitter::makeEven() {
    setShares(QList<int>(count(), 1));
    emit sharesChanged();
}

void EvenSplitter::setShares(const QList<int>& shares) {
    m_shares = shares;
    // What differs by the pixel that cannot be shared is even.
    const auto [least, most] = std::minmax_element(m_shares.begin(), m_shares.end());
    if (!m_shares.isEmpty() && *most - *least <= 1) m_shares.fill(1);
    if (m_shares.isEmpty()) return;
    // Large, so that no part's least size stands for its share before the splitter scales them.
    constexpr int kLarge = 10'000'000;
    const int scale = std::max(1, kLarge / *std::max_element(m_shares.begin(), m_shares.end()));
    QList<int> scaled = m_shares;
    for (int& share : scaled) share *= scale;
    setSizes(scaled);
}

void EvenSplitter::resizeEvent(QResizeEvent* event) {
    QSplitter::resizeEvent(event);
    if (!m_shares.isEmpty()) setShares(QList<int>(m_shares));  // a copy: it is given to itself
}

QSplitterHandle* EvenSplitter::createHandle() { return new EvenHandle(this); }

}  // namespace app
