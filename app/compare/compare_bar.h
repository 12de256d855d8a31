#pragma once
#include <QWidget>

#include "pipeline/inspect/compare.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace app {

class Segmented;

enum class CompareMode : unsigned char { A, B, Blink, Wipe, Difference };

// Below two compared buffers: which of them is on show, how much they differ, and a button that goes to the largest
// difference.
class CompareBar : public QWidget {
    Q_OBJECT
public:
    explicit CompareBar(QWidget* parent = nullptr);

    void setMode(CompareMode mode);
    void setMetric(pipeline::DifferenceMetric metric);
    // whyNoWorst: empty where there is a worst place to go to.
    void setFinding(const QString& sentence, const QString& whyNoWorst);
    enum class Offer : unsigned char { Nothing, Cancel, Compute };
    void setOffer(Offer offer);
    void fit(int height);  // of the view: in a low one without the words
    void show(bool compares);
    void setBare(bool bare);  // not shown at all: in a talk the pictures bear names, and the keys are the same
    bool isBare() const { return m_bare; }

signals:
    void modeChosen(CompareMode mode);
    void metricChosen(pipeline::DifferenceMetric metric);
    void worstChosen();
    void stagesChosen();
    void offerTaken();
    void closed();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();

    Segmented* m_modes;
    QComboBox* m_metric;
    QLabel* m_finding;
    QPushButton *m_worst, *m_stages, *m_offer;
    QToolButton* m_close;
    QHBoxLayout *m_first, *m_second;
    bool m_compares = false, m_bare = false, m_isLow = false;
};

}  // namespace app
