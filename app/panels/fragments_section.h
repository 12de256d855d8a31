#pragma once
#include <QWidget>
#include <vector>

#include "pipeline/inspect/pixel_report.h"

namespace app {

// Every fragment that came to the pixel, in the order it was drawn, with the two depths compared
// and the verdict; then the polygons that would have covered it but were dropped before.
class FragmentsSection : public QWidget {
    Q_OBJECT
public:
    explicit FragmentsSection(QWidget* parent = nullptr);

    void show(const pipeline::PixelReport& report);
    QString sentence() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Widths {
        int polygon, fresh, relation, stored;
        bool fitsVerdict;  // beside the depths; else it stands on a second line
    };
    Widths widths() const;
    int rowHeight() const;
    int culledHeight(const pipeline::CulledReport& culled) const;

    std::vector<pipeline::FragmentReport> m_fragments;
    std::vector<pipeline::CulledReport> m_culled;
};

}  // namespace app
