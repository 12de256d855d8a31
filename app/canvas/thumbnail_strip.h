#pragma once
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "app/document/document.h"
#include "app/jobs/background_job.h"

namespace app {

// The buffers worth a look at a stage: its own, and the main ones of the other stages, in their order.
std::vector<pipeline::BufferName> thumbnailBuffers(pipeline::StageId stage, const pipeline::Scene& scene);

// Buffers as small pictures, nine in a row, derived ones that a view shows at the end; the ones left out are hatched, with the reason as tooltip.
// Only what is in sight is asked for.
class ThumbnailStrip : public QWidget {
    Q_OBJECT
public:
    explicit ThumbnailStrip(Document& document, QWidget* parent = nullptr);

    void setCurrent(const pipeline::BufferName& name);  // the one that a view shows
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

signals:
    void chosen(const pipeline::BufferName& name);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Item {
        pipeline::BufferName name;
        QImage picture;
        QString why;  // it is left out; empty when it is there or on its way
        bool isInSight = false;
    };
    struct Picture {
        pipeline::BufferName name;
        QImage image;  // null where the frame has no such buffer
    };
    std::vector<pipeline::BufferName> derivedOnShow() const;
    void takeDerived();
    void rebuild();
    void refresh();
    void take(const std::vector<Picture>& pictures);
    void want();
    void describe();
    void scrollTo(int offset);
    void reveal(int item);
    int itemWidth() const;
    int itemAt(QPoint at) const;
    QRect itemRect(int item) const;
    void paintItem(QPainter& painter, const Item& item, const QRect& rect, bool isCurrent, bool isMarked) const;

    Document& m_document;
    std::vector<Item> m_items;
    std::vector<pipeline::BufferName> m_derived;  // of them, at the end
    pipeline::BufferName m_current{pipeline::BufferId::Color};
    int m_marked = 0;  // by the keyboard
    int m_offset = 0;  // pixels that stand left of the strip
    QTimer m_later;
    BackgroundJob m_drawing;
};

}  // namespace app
