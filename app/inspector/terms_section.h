#pragma once
#include <QWidget>
#include <vector>

#include "app/document/document.h"
#include "pipeline/inspect/pixel_report.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace app {

class GainBar;

// The terms of one channel's intensity as strips of a mixing desk, their sum, and its difference from the intensity
// that the stage has computed. The mix applies to every pixel: pictures of the frame buffer show it.
class TermsSection : public QWidget {
    Q_OBJECT
public:
    explicit TermsSection(Document& document, QWidget* parent = nullptr);

    void show(const pipeline::PixelReport& report, int channel);
    QString sentence() const;
    double sum() const;                                      // of the terms as they are
    double mixed() const;                                    // with their gains
    double residual() const { return m_intensity - sum(); }  // must read 0

private:
    struct Strip {
        QToolButton *solo, *mute;
        QLabel *name, *gain, *value;
        GainBar* bar;
    };
    void build(std::size_t count);
    void showMix();
    void styleRows();

    Document& m_document;
    QGridLayout* m_grid;
    QLabel *m_sum, *m_words;
    QPushButton* m_reset;
    std::vector<Strip> m_strips;   // as the mix has them
    std::vector<double> m_values;  // likewise
    double m_intensity = 0, m_iMax = 0;
    bool m_isShaded = true;
};

}  // namespace app
