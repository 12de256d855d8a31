#pragma once
#include <QImage>
#include <vector>

#include "app/core/start_order.h"
#include "app/panels/start_button.h"

namespace app {

// The first card of a lecture: its pictures in a row, each with its label, and below them what they open as.
class StartViewCard : public StartButton {
    Q_OBJECT
public:
    explicit StartViewCard(const StartView& view, QWidget* parent = nullptr);

    const StartView& view() const { return m_view; }
    void setPicture(std::size_t part, const QImage& picture);

    int heightForWidth(int width) const override;
    QSize sizeHint() const override;

protected:
    void paintInside(QPainter& painter, const QRectF& box, const QPainterPath& shape) const override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    double labelHeight(double width) const;
    void paintPicture(class QPainter& painter, const QRectF& place, std::size_t part) const;

    StartView m_view;
    std::vector<QImage> m_pictures;
};

}  // namespace app
