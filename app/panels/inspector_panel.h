#pragma once
#include <QWidget>
#include <optional>

#include "app/core/document.h"
#include "pipeline/inspect/pixel_report.h"

class QLabel;
class QScrollArea;

namespace app {

class EquationSection;
class FragmentsSection;
class Section;
class TermsSection;
class WhySection;

// Everything known about the picked pixel, following it live: what `inspect` prints.
class InspectorPanel : public QWidget {
    Q_OBJECT
public:
    explicit InspectorPanel(Document& document, QWidget* parent = nullptr);

    const std::optional<pipeline::PixelReport>& report() const { return m_report; }
    EquationSection& equation() { return *m_equation; }

signals:
    void bufferAsked(const pipeline::BufferName& name);  // show this buffer
    void settingAsked(const QString& key);               // and this setting

private:
    void build();
    void refresh();
    void showHeader(const pipeline::Frame& frame);
    void styleHeader();

    Document& m_document;
    std::optional<pipeline::PixelReport> m_report;
    QScrollArea* m_scroll;
    QLabel *m_empty, *m_swatch, *m_title, *m_place, *m_value, *m_unit;
    WhySection* m_why;
    EquationSection* m_equation;
    TermsSection* m_terms;
    FragmentsSection* m_fragments;
    Section *m_whyFold, *m_equationFold, *m_termsFold, *m_fragmentsFold;
};

}  // namespace app
