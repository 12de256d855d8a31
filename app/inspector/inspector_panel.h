#pragma once
#include <QWidget>
#include <optional>

#include "app/document/document.h"
#include "app/frames/pixel_inspection.h"

class QLabel;
class QScrollArea;

namespace app {

class EquationSection;
class FragmentsSection;
class LayersSection;
class Section;
class TermsSection;
class WhySection;
class WorkingBar;

// Everything known about the picked pixel, following it live: what `inspect` prints.
class InspectorPanel : public QWidget {
    Q_OBJECT
public:
    explicit InspectorPanel(Document& document, QWidget* parent = nullptr);

    // Of the newest frame and the picked pixel, or of those before while that is on its way; null: no pixel.
    const pipeline::PixelReport* report() const { return m_shown ? &m_shown->report : nullptr; }
    EquationSection& equation() { return *m_equation; }

signals:
    void bufferAsked(const pipeline::BufferName& name);  // show this buffer
    void settingAsked(const QString& key);               // and this setting

private:
    void build();
    void refresh();
    void showHeader();
    void showLayers();
    void tellEmpty();
    void styleHeader();

    Document& m_document;
    std::shared_ptr<const InspectedPixel> m_shown;
    WorkingBar* m_working;
    QScrollArea* m_scroll;
    QLabel *m_empty, *m_swatch, *m_title, *m_place, *m_value, *m_unit;
    WhySection* m_why;
    EquationSection* m_equation;
    TermsSection* m_terms;
    LayersSection* m_layers;
    FragmentsSection* m_fragments;
    Section *m_whyFold, *m_equationFold, *m_termsFold, *m_layersFold, *m_fragmentsFold;
};

}  // namespace app
