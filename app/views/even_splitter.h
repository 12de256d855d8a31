#pragma once
#include <QSplitter>

namespace app {

// Where a splitter's handle is put that is dragged to `position`, in pixels from its beginning: at the next half or third
// of the room that `length` leaves beside the handle where that is within `reach`, else where it was dragged to.
int snappedPosition(int position, int length, int handle, int reach);

// A splitter whose handles stop at halves and thirds, and whose parts are even after a double click on one. Its parts keep
// their shares of its length in every size: the same shares in the same size are the same pixels.
class EvenSplitter : public QSplitter {
    Q_OBJECT
public:
    explicit EvenSplitter(Qt::Orientation orientation, QWidget* parent = nullptr);
    void makeEven();
    // In proportion to each other; all 1 where the parts are even.
    void setShares(const QList<int>& shares);
    const QList<int>& shares() const { return m_shares; }

signals:
    void sharesChanged();  // by the user

protected:
    QSplitterHandle* createHandle() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QList<int> m_shares;
};

}  // namespace app
