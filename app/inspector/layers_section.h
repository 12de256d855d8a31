#pragma once
#include <QWidget>
#include <vector>

#include "pipeline/inspect/pixel_report.h"

class QGridLayout;
class QLabel;

namespace app {

// The translucent layers over a pixel in the order of blending, farthest first: depth, opacity, own intensity, and the
// contribution of each to one channel of the pixel, weighted by the transmittance of the layers in front of it.
class LayersSection : public QWidget {
public:
    explicit LayersSection(QWidget* parent = nullptr);

    void show(const pipeline::PixelReport& report, int channel);
    QString sentence() const { return m_sentence; }

private:
    QGridLayout* m_grid;
    QLabel* m_sum;
    QString m_sentence;
    std::vector<QLabel*> m_cells;  // of the header and the rows
};

// What layer i adds: α_i I_i, times 1 − α of every layer laid after it.
double addedBy(const std::vector<pipeline::LayerReport>& layers, std::size_t i, int channel);

}  // namespace app
