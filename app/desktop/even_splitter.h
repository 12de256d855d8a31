#pragma once
#include <QSplitter>

namespace app {

// Where a splitter's handle is put that is dragged to `position`, in pixels from its beginning: at the next half or third
// of the room that `length` leaves beside the handle where that is within `reach`, else where it was dragged to.
int snappedPosition(int position, int length, int handle, int reach);

// A splitter whose handles stop at halves and thirds, and whose parts are even after a double click on one.
class EvenSplitter : public QSplitter {
    Q_OBJECT
public:
    using QSplitter::QSplitter;
    void makeEven();

protected:
    QSplitterHandle* createHandle() override;
};

}  // namespace app
