#pragma once
#include <QWidget>
#include <vector>

#include "pipeline/inspect/pixel_report.h"

namespace app {

// The terms of one channel's intensity as parts of their sum, and what the sum leaves over.
class TermsSection : public QWidget {
    Q_OBJECT
public:
    explicit TermsSection(QWidget* parent = nullptr);

    void show(const pipeline::PixelReport& report, int channel);
    QString sentence() const;
    double sum() const;
    double residual() const { return m_intensity - sum(); }  // must read 0

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Term {
        QString name;
        double value;
    };
    int rowHeight() const;

    std::vector<Term> m_terms;
    double m_intensity = 0;
};

}  // namespace app
