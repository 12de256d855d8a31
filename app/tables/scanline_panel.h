#pragma once
#include <QWidget>

#include "app/document/document.h"
#include "app/jobs/background_job.h"
#include "pipeline/inspect/scanline.h"

class QLabel;
class QSpinBox;
class QToolButton;

namespace app {

class ScanlinePlotView;

// A section through the picture along one row: that of the picked pixel, or a chosen one. It follows the frame, and is
// computed off the GUI thread.
class ScanlinePanel : public QWidget {
    Q_OBJECT
public:
    explicit ScanlinePanel(Document& document, QWidget* parent = nullptr);

    int row() const { return m_row; }
    void setRow(int row);  // within the picture
    const std::shared_ptr<const pipeline::ScanlineSection>& section() const { return m_section; }
    ScanlinePlotView* plot() { return m_plot; }
    QString csv() const;
    QString svg() const;  // in the theme's colours

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void want();
    void goTo(int row);
    void compute();
    void showMarks();
    void save(const QString& title, const QString& ending, const QString& text);

    Document& m_document;
    QSpinBox* m_spin;
    QLabel *m_name, *m_said;
    QToolButton *m_csv, *m_svg;
    ScanlinePlotView* m_plot;
    int m_row = 0;
    bool m_isRowChosen = false;  // else it becomes one in which something is drawn
    std::shared_ptr<const pipeline::ScanlineSection> m_section;
    BackgroundJob m_job;
};

}  // namespace app
