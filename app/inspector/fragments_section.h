#pragma once
#include <QWidget>
#include <optional>
#include <vector>

#include "pipeline/inspect/pixel_report.h"

namespace app {

// Every fragment that came to the pixel, in the order it was drawn, with the two depths compared
// and the verdict; then the polygons that would have covered it but were dropped before. A click on a row, or Enter,
// asks for its polygon.
class FragmentsSection : public QWidget {
    Q_OBJECT
public:
    explicit FragmentsSection(QWidget* parent = nullptr);

    void show(const pipeline::Frame& frame, const pipeline::PixelReport& report);
    QString sentence() const;
    void setSelected(std::optional<std::uint32_t> polygon);  // its rows are marked
    std::vector<QRect> rows() const;                         // in their order

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

signals:
    void polygonAsked(std::uint32_t polygon);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    struct Widths {
        int polygon, fresh, relation, stored;
        bool fitsVerdict;  // beside the depths; else it stands on a second line
    };
    Widths widths() const;
    int rowHeight() const;
    std::uint32_t polygonOf(int row) const;
    void paintRows(QPainter& painter) const;
    int culledHeight(const pipeline::CulledReport& culled) const;

    std::vector<pipeline::FragmentReport> m_fragments;
    std::vector<pipeline::CulledReport> m_culled;
    std::optional<std::uint32_t> m_selected;
    bool m_isDrawn = true;  // false: the z-buffer stage is still to come
    int m_current = 0;      // by the keyboard
};

}  // namespace app
